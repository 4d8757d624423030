#include "common/records/patch_heights.h"

#include <map>
#include <utility>

#include "common/mesh/rounding.h"

namespace tilemend {
namespace {

class Means {
 public:
  void Add(int32_t key, double value) {
    auto& [sum, count] = sums_[key];
    sum += value;
    ++count;
  }

  // With keys rising.
  std::map<int32_t, double> OnLattice(double step) const {
    std::map<int32_t, double> means;
    for (const auto& [key, sum] : sums_) means[key] = RoundedToLattice(sum.first / sum.second, step);
    return means;
  }

 private:
  std::map<int32_t, std::pair<double, int>> sums_;
};

}  // namespace

void TakeSampledHeights(std::span<const int32_t> seam_vertex, std::span<const double> height, CellHoles& holes) {
  Means means;
  for (size_t i = 0; i < seam_vertex.size(); ++i) means.Add(seam_vertex[i], height[i]);
  const std::map<int32_t, double> found = means.OnLattice(holes.lattice_step);
  for (size_t v = 0; v < holes.vertices.size(); ++v) {
    RimVertex& vertex = holes.vertices[v];
    if (vertex.height_known) continue;
    const auto it = found.find(vertex.follows >= 0 ? vertex.follows : vertex.seam_vertex);
    if (it == found.end()) continue;
    vertex.height_known = true;
    vertex.position.z() = it->second;
    if (v < holes.band.points.size()) holes.band.points[v] = vertex.position;
  }
}

void MoveSmoothedPoints(std::span<const std::vector<SmoothedPoint>> moves, double step,
                        std::vector<HolePatch>& patches) {
  Means means;
  for (const std::vector<SmoothedPoint>& points : moves) {
    for (const SmoothedPoint& p : points) means.Add(p.point, p.height);
  }
  auto patch = patches.begin();
  int32_t first = 0;
  for (const auto& [point, height] : means.OnLattice(step)) {
    while (point - first >= static_cast<int32_t>(patch->new_points.size())) {
      first += static_cast<int32_t>(patch->new_points.size());
      ++patch;
    }
    patch->new_points[point - first].z() = height;
  }
}

}  // namespace tilemend
