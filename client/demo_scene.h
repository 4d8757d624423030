// The small scene of `tilemend demo`: hills, a lake over several tiles, and small holes.
#ifndef TILEMEND_CLIENT_DEMO_SCENE_H_
#define TILEMEND_CLIENT_DEMO_SCENE_H_

#include <string>

#include "absl/status/status.h"

namespace tilemend {

inline constexpr int kDemoCols = 3, kDemoRows = 2;
inline constexpr double kDemoCell = 100;       // metres
inline constexpr double kDemoLakeLevel = 412;  // metres

// Writes scene.json and six PLY tiles to `folder`, which is made. The same bytes each time. Errors of MakeFolders and
// WriteFileAtomically.
absl::Status WriteDemoScene(const std::string& folder);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_DEMO_SCENE_H_
