// What must hold of whatever ReadVectors gives.
#ifndef TILEMEND_TESTS_FUZZ_VECTOR_CHECKS_H_
#define TILEMEND_TESTS_FUZZ_VECTOR_CHECKS_H_

#include <cstdlib>
#include <string>
#include <string_view>

#include "common/gis/vector_file.h"

namespace tilemend {

// Features with finite coordinates and rings of at least three points, or an error that names the file.
inline void ReadAndCheck(VectorFormat format, const std::string& opened, std::string_view bytes) {
  VectorRequest request;
  request.format = format;
  request.name = "lakes";
  request.opened = opened;
  request.parts = {{opened, bytes}};
  const VectorFile file = ReadVectors(request);
  if (!file.error.empty() && (!file.features.empty() || !file.error.starts_with("lakes: "))) std::abort();
  for (const VectorFeature& feature : file.features) {
    for (const auto& ring : feature.polygon.rings) {
      if (ring.size() < 3) std::abort();
      for (const Point2& p : ring) {
        if (!p.allFinite()) std::abort();
      }
    }
  }
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_FUZZ_VECTOR_CHECKS_H_
