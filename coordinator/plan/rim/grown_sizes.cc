#include "coordinator/plan/rim/grown_sizes.h"

#include <algorithm>
#include <utility>

namespace tilemend {
namespace {

constexpr size_t kPointsOfLeaf = 8;

// To a box: never more than to a point in it, also as rounded.
double Distance(const Eigen::AlignedBox2d& box, const Point2& p) {
  return (box.min() - p).cwiseMax(p - box.max()).cwiseMax(0.0).norm();
}

}  // namespace

GrownSizes::GrownSizes(std::vector<Point> points) : points_(std::move(points)) {
  nodes_.reserve(2 * (points_.size() / (kPointsOfLeaf / 2) + 1));
  if (!points_.empty()) Build(0, points_.size());
}

size_t GrownSizes::Build(size_t begin, size_t end) {
  const size_t number = nodes_.size();
  Node node{{}, points_[begin].size, begin, end, 0};
  for (size_t i = begin; i < end; ++i) {
    node.box.extend(points_[i].position);
    node.least = std::min(node.least, points_[i].size);
  }
  nodes_.push_back(node);
  if (end - begin <= kPointsOfLeaf) return number;
  const Point2 sides = node.box.sizes();
  const int axis = sides.x() >= sides.y() ? 0 : 1;
  const size_t middle = begin + (end - begin) / 2;
  const auto at = [this](size_t i) { return points_.begin() + static_cast<ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [axis](const Point& a, const Point& b) { return a.position[axis] < b.position[axis]; });
  Build(begin, middle);
  const size_t other = Build(middle, end);
  nodes_[number].other = other;
  return number;
}

double GrownSizes::At(const Point2& p, double growth, double limit) const {
  double best = limit;
  const auto bound = [&](size_t n) { return nodes_[n].least + growth * Distance(nodes_[n].box, p); };
  std::vector<std::pair<size_t, double>> next;
  if (!nodes_.empty()) next.emplace_back(0, bound(0));
  while (!next.empty()) {
    const auto [number, least] = next.back();
    next.pop_back();
    if (least >= best) continue;
    const Node& node = nodes_[number];
    if (node.other == 0) {
      for (size_t i = node.begin; i < node.end; ++i) {
        best = std::min(best, points_[i].size + growth * (points_[i].position - p).norm());
      }
      continue;
    }
    std::pair<size_t, double> a(number + 1, bound(number + 1)), b(node.other, bound(node.other));
    if (a.second < b.second) std::swap(a, b);
    next.push_back(a);  // the better one is looked at first
    next.push_back(b);
  }
  return best;
}

}  // namespace tilemend
