#include <string>

#include "absl/strings/str_format.h"
#include "common/grid/scene.h"

namespace tilemend {

std::string ToString(CellId id) { return absl::StrFormat("%+04d_%+04d", id.col, id.row); }

}  // namespace tilemend
