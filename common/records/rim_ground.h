// What is ground at the boundary vertices of a tile, and around its holes.
#ifndef TILEMEND_COMMON_RECORDS_RIM_GROUND_H_
#define TILEMEND_COMMON_RECORDS_RIM_GROUND_H_

#include <cstdint>
#include <vector>

namespace tilemend {

// How far from a rim its surroundings reach, metres: half the width of a street.
inline constexpr double kSurroundingsReach = 15;

// A square of a lattice with its low corner at the scene's origin.
struct GroundSquare {
  int32_t col = 0, row = 0;
  float height = 0;  // metres: the lowest ground in it

  bool operator==(const GroundSquare&) const = default;
};

struct RimGround {
  // Columns with a value for each boundary vertex.
  std::vector<bool> on_object;  // it stands on a tree, a house, a wall
  std::vector<float> ground;    // metres: the height of the ground there; NaN: not known

  // Squares with ground within kSurroundingsReach of the rims of holes, and some farther off; row by row.
  double side = 0;  // metres, of the squares
  std::vector<GroundSquare> around = {};
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_RIM_GROUND_H_
