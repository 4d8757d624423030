// What is ground at the boundary vertices of a tile.
#ifndef TILEMEND_COMMON_RECORDS_RIM_GROUND_H_
#define TILEMEND_COMMON_RECORDS_RIM_GROUND_H_

#include <vector>

namespace tilemend {

// Columns with a value for each boundary vertex.
struct RimGround {
  std::vector<bool> on_object;  // it stands on a tree, a house, a wall
  std::vector<float> ground;    // metres: the height of the ground there; NaN: not known
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_RIM_GROUND_H_
