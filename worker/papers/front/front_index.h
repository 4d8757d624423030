// Finds the edges of an advancing front by where they lie.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_FRONT_INDEX_H_
#define TILEMEND_WORKER_PAPERS_FRONT_FRONT_INDEX_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/papers/front/front_loops.h"

namespace tilemend {

// Edges by their middles, in bins of space some edges large: one hash table for each power of two. An edge is known
// by the node that it leaves. Edges that are no longer of the front are dropped where they are come upon.
class FrontIndex {
 public:
  // Must outlive it.
  explicit FrontIndex(const FrontLoops& loops) : loops_(loops) {}

  // The edge that leaves a node is new, or has a new end. The length of edges here is `unit`, > 0; much shorter ones
  // count as a millionth of it.
  void Add(int32_t node, const Point3& from, const Point3& to, double unit);

  // The nodes whose edges may meet a box, rising. O(edges near it) where edges are about as long as the box.
  std::vector<int32_t> Near(const Eigen::AlignedBox3d& box) const;

  // How many edges Near has looked at in all: the same on every machine.
  int64_t looked_at() const { return looked_at_; }

 private:
  using Bin = std::vector<std::pair<int32_t, int32_t>>;  // nodes of an edge
  struct Place {
    int64_t x, y, z;
    bool operator==(const Place&) const = default;
  };
  struct PlaceHash {
    size_t operator()(const Place& p) const;
  };
  using Bins = std::unordered_map<Place, Bin, PlaceHash>;

  static Place PlaceOf(const Point3& p, double side);
  void CollectIn(const Eigen::AlignedBox3d& middles, double side, Bins& bins, std::vector<int32_t>& found) const;
  // False if nothing is left in the bin.
  bool Collect(Bin& bin, std::vector<int32_t>& found) const;

  const FrontLoops& loops_;
  // By the exponent of the bins' side. A search drops what is gone.
  mutable std::map<int, Bins> levels_;
  mutable int64_t looked_at_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_FRONT_INDEX_H_
