// Along which axes something was cut, by the lines that it left.
#ifndef TILEMEND_COMMON_MESH_MAIN_TURN_H_
#define TILEMEND_COMMON_MESH_MAIN_TURN_H_

#include <optional>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// The direction that most of the length of lines has, to a quarter turn: radians in [-pi/4, pi/4]. None if that is no
// more than `least_share` of the length. Long lines tell it best. O(n log n).
std::optional<double> MainTurn(const std::vector<Point2>& ways, double least_share);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_MAIN_TURN_H_
