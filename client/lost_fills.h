// Fills that an output should have, and has not.
#ifndef TILEMEND_CLIENT_LOST_FILLS_H_
#define TILEMEND_CLIENT_LOST_FILLS_H_

#include <cstdint>
#include <vector>

#include "common/mesh/box_tree.h"
#include "worker/check/tile_joins.h"

namespace tilemend {

// Looks at the original edges around the holes that were filled. A fill that is gone as a whole leaves no edge that is
// open only in the output: its boundary was open in the input, and is again.
class LostFills {
 public:
  // `rims`: boundaries of filled holes from above, rounded to millimetres; the last point of a ring is the first.
  // O(n log n).
  explicit LostFills(const std::vector<std::vector<Point2>>& rims);

  // Whether the edge from a to b is one of a boundary, seen from above. O(log n).
  bool IsAtRim(const Point3& a, const Point3& b) const;

  // Takes one more edge with one triangle in the input, and one or more in the output.
  void Add(const NewOpenEdge& edge);

  // The open edges of the boundaries of which more than half is open. Where surfaces lie above each other, a part of a
  // boundary is closed if the edge of one of them is. Of holes that a polygon cleared most edges were not open in the
  // input, so they are not told of. O(n).
  std::vector<NewOpenEdge> Lost() const;

 private:
  struct Segment {
    Point2 a, b;
    int32_t rim;
    bool is_closed = false;
    std::vector<NewOpenEdge> open = {};
  };

  template <typename Visit>
  bool AnyAt(const Point3& a, const Point3& b, const Visit& visit) const;

  std::vector<Segment> segments_;
  int32_t rims_ = 0;
  BoxTree tree_;  // from above
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_LOST_FILLS_H_
