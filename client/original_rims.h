// The vertices of the scene at the rims of its surface.
#ifndef TILEMEND_CLIENT_ORIGINAL_RIMS_H_
#define TILEMEND_CLIENT_ORIGINAL_RIMS_H_

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "client/area_rim.h"
#include "worker/check/added_faults.h"

namespace tilemend {

// A fill begins at them, also at those of other tiles. Kept row by row, as the edges of JoinedEdges are.
class OriginalRims {
 public:
  // Takes the ends of edges that were there in the input, of a tile in `row`. O(log n) for each edge.
  void Add(int32_t row, const std::vector<OpenEdge>& edges);

  // Which ends of the edge are such vertices, of the tiles that were added and not forgotten; of an edge of an original
  // triangle both. O(log n).
  AreaRim::OriginalEnds EndsOf(const OpenEdge& edge) const;

  // Whether p is such a vertex. O(log n).
  bool Has(const Point3& p) const;

  // Forgets the vertices that are in tiles in rows below `row` alone. Linear.
  void ForgetBelow(int32_t row);

 private:
  std::map<std::array<double, 3>, int32_t> rows_;  // the highest row, by position
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_ORIGINAL_RIMS_H_
