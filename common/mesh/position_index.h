// Numbers positions: equal coordinates get equal numbers.
#ifndef TILEMEND_COMMON_MESH_POSITION_INDEX_H_
#define TILEMEND_COMMON_MESH_POSITION_INDEX_H_

#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A hash index of positions, compared by value (so that -0.0 and 0.0 are one; NaN must not be inserted). Numbers count
// from 0 in order of insertion. A small filter in front makes looking up positions that are not there cheap.
class PositionIndex {
 public:
  PositionIndex();

  // The number of `p`, inserting it if it is new.
  int32_t Insert(const Point3& p);
  // The number of `p`, or -1.
  int32_t Find(const Point3& p) const;
  int32_t size() const { return static_cast<int32_t>(positions_.size()); }
  const std::vector<Point3>& positions() const { return positions_; }

 private:
  static uint64_t Hash(const Point3& p);
  void Grow();

  std::vector<Point3> positions_;
  std::vector<int32_t> slots_;    // open addressing, a power of two; -1 is free
  std::vector<uint64_t> filter_;  // one bit per hash bucket
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_POSITION_INDEX_H_
