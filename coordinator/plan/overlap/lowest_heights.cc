#include "coordinator/plan/overlap/lowest_heights.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

// An edge seen across the line: x is the coordinate along it, y the height.
struct ProfileEdge {
  Point2 from, to;

  double HeightAt(double t) const { return from.y() + (t - from.x()) / (to.x() - from.x()) * (to.y() - from.y()); }
};

// The lowest of many edges at each of some places: a Li Chao tree over the places.
class LowestEdges {
 public:
  explicit LowestEdges(std::vector<double> places) : places_(std::move(places)), lowest_(4 * places_.size()) {}

  // Strictly between the ends of the edge.
  void Add(const ProfileEdge& edge) {
    const auto [low, high] = std::minmax(edge.from.x(), edge.to.x());
    const auto first = std::ranges::upper_bound(places_, low), last = std::ranges::lower_bound(places_, high);
    if (first < last) AddTo(0, 0, places_.size(), first - places_.begin(), last - places_.begin(), edge);
  }

  // `place` is one of the places.
  std::optional<double> HeightAt(double place) const {
    const auto at = static_cast<size_t>(std::ranges::lower_bound(places_, place) - places_.begin());
    std::optional<double> lowest;
    for (size_t node = 0, begin = 0, end = places_.size();;) {
      if (lowest_[node]) {
        const double height = lowest_[node]->HeightAt(place);
        if (!lowest || height < *lowest) lowest = height;
      }
      if (end - begin == 1) return lowest;
      const size_t middle = (begin + end) / 2;
      node = 2 * node + (at < middle ? 1 : 2);
      (at < middle ? end : begin) = middle;
    }
  }

 private:
  // To the places [first, last) among those of the node, [begin, end).
  void AddTo(size_t node, size_t begin, size_t end, ptrdiff_t first, ptrdiff_t last, ProfileEdge edge) {
    const auto from = std::max(static_cast<size_t>(first), begin), to = std::min(static_cast<size_t>(last), end);
    if (from >= to) return;
    const size_t middle = (begin + end) / 2;
    if (from > begin || to < end) {
      AddTo(2 * node + 1, begin, middle, first, last, edge);
      AddTo(2 * node + 2, middle, end, first, last, edge);
      return;
    }
    std::optional<ProfileEdge>& there = lowest_[node];
    if (!there) {
      there = edge;
      return;
    }
    const auto is_lower = [&](size_t at) { return edge.HeightAt(places_[at]) < there->HeightAt(places_[at]); };
    if (is_lower(middle)) std::swap(*there, edge);
    if (end - begin == 1) return;
    // The other is lower on one side of the middle at most.
    if (is_lower(begin)) AddTo(2 * node + 1, begin, middle, first, last, edge);
    if (is_lower(end - 1)) AddTo(2 * node + 2, middle, end, first, last, edge);
  }

  const std::vector<double> places_;  // rising
  std::vector<std::optional<ProfileEdge>> lowest_;
};

}  // namespace

std::map<double, double> LowestHeights(const SurveyRecord& record, int axis,
                                       const std::function<bool(const Point3&)>& beyond) {
  std::map<double, double> heights;
  for (const BoundaryVertex& v : record.vertices) {
    if (!beyond(v.position)) continue;
    const auto [it, fresh] = heights.emplace(v.position[axis], v.position.z());
    if (!fresh) it->second = std::min(it->second, v.position.z());
  }
  if (heights.empty()) return heights;
  std::vector<double> places;
  for (const auto& [place, height] : heights) places.push_back(place);
  LowestEdges lowest(std::move(places));
  for (const BoundaryEdge& e : record.edges) {
    const Point3 &from = record.vertices[e.from].position, &to = record.vertices[e.to].position;
    if (beyond(from) && beyond(to)) lowest.Add({{from[axis], from.z()}, {to[axis], to.z()}});
  }
  std::erase_if(heights, [&](const auto& vertex) {
    const std::optional<double> edge = lowest.HeightAt(vertex.first);
    return edge && *edge < vertex.second - kMeetTolerance;
  });
  return heights;
}

}  // namespace tilemend
