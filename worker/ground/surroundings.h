// Which squares of a raster lie around holes.
#ifndef TILEMEND_WORKER_GROUND_SURROUNDINGS_H_
#define TILEMEND_WORKER_GROUND_SURROUNDINGS_H_

#include <cstdint>
#include <vector>

#include "common/records/ground_raster.h"
#include "common/records/rim_ground.h"
#include "worker/ground/ground_filter.h"

namespace tilemend {

// Squares along a side of those that Surroundings tells of.
inline constexpr int32_t kSquaresAlongSide = 3;

// The squares within kSurroundingsReach of rims of holes. Columns and rows are those of the lattice.
class Surroundings {
 public:
  //   lowest  no surface: a hole; must stay as it is
  explicit Surroundings(const GroundRaster& lowest);

  // Adds what is around a square of the raster that has a boundary vertex, unless there is surface all around it. O(1),
  // or 1,000 squares of a metre.
  void AddRim(int32_t col, int32_t row);

  // Calls `use` with each square, row by row.
  void ForEach(const auto& use) const {
    for (int32_t row = lowest_.row; row < lowest_.row + lowest_.rows; ++row) {
      for (int32_t col = lowest_.col; col < lowest_.col + lowest_.cols; ++col) {
        if (is_near_[lowest_.IndexOf(col, row)]) use(col, row);
      }
    }
  }

  // The ground in them, in squares of kSquaresAlongSide squares.
  std::vector<GroundSquare> GroundIn(const FilteredGround& filtered) const;

 private:
  bool IsBesideHole(int32_t col, int32_t row) const;

  const GroundRaster& lowest_;
  const int32_t reach_;  // squares
  std::vector<bool> is_rim_, is_near_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_GROUND_SURROUNDINGS_H_
