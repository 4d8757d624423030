#include "worker/propose/height_tree.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

namespace tilemend {
namespace {

// Calls `use` with the squares that touch one at a side or a corner.
template <typename Use>
void ForEachNeighbour(int32_t cols, int32_t rows, int32_t square, const Use& use) {
  const int32_t col = square % cols, row = square / cols;
  for (int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, rows - 1); ++r) {
    for (int32_t c = std::max(col - 1, 0); c <= std::min(col + 1, cols - 1); ++c) {
      if (r != row || c != col) use(r * cols + c);
    }
  }
}

// A region while levels rise.
struct Growing {
  int64_t area = 0;
  int32_t level = 0;                         // that `recent` ends with
  int32_t node = -1;                         // its last one
  std::array<int32_t, kDeepSteps> recent{};  // squares at the level, one step below it, ...

  void RiseTo(int32_t to) {
    const int32_t steps = std::min(to - level, kDeepSteps);
    std::shift_right(recent.begin(), recent.end(), steps);
    std::fill_n(recent.begin(), steps, 0);
    level = to;
  }
};

class Builder {
 public:
  explicit Builder(const SteppedHeights& heights)
      : heights_(heights), root_(heights.steps.size(), -1), regions_(heights.steps.size()) {}

  std::vector<HeightNode> Build() {
    std::vector<int32_t> order;
    for (size_t i = 0; i < heights_.steps.size(); ++i) {
      if (heights_.steps[i] != SteppedHeights::kWall) order.push_back(static_cast<int32_t>(i));
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](int32_t a, int32_t b) { return heights_.steps[a] < heights_.steps[b]; });
    for (size_t first = 0; first < order.size();) {
      size_t end = first;
      const int32_t level = heights_.steps[order[first]];
      while (end < order.size() && heights_.steps[order[end]] == level) Add(order[end++]);
      Close(level, order.begin() + first, order.begin() + end);
      first = end;
    }
    return std::move(nodes_);
  }

 private:
  int32_t Find(int32_t square) {
    while (root_[square] != square) square = root_[square] = root_[root_[square]];
    return square;
  }

  void Add(int32_t square) {
    root_[square] = square;
    regions_[square] = {1, heights_.steps[square], -1, {1}};
    children_[square];
    ForEachNeighbour(heights_.cols, heights_.rows, square, [&](int32_t other) {
      if (root_[other] >= 0) Join(Find(square), Find(other));
    });
  }

  void Join(int32_t a, int32_t b) {
    if (a == b) return;
    if (regions_[a].area < regions_[b].area) std::swap(a, b);
    Growing& to = regions_[a];
    Growing& from = regions_[b];
    std::vector<int32_t>& children = children_[a];
    if (from.node >= 0) children.push_back(from.node);
    const auto others = children_.find(b);
    if (others != children_.end()) {
      children.insert(children.end(), others->second.begin(), others->second.end());
      children_.erase(b);
    }
    to.area += from.area;
    const int32_t level = std::max(to.level, from.level);
    to.RiseTo(level);
    from.RiseTo(level);
    for (size_t i = 0; i < to.recent.size(); ++i) to.recent[i] += from.recent[i];
    from = {};
    root_[b] = a;
  }

  // Makes the nodes of the regions that have grown at this level.
  template <typename It>
  void Close(int32_t level, It first, It end) {
    for (; first != end; ++first) {
      const int32_t root = Find(*first);
      const auto grown = children_.find(root);
      if (grown == children_.end()) continue;
      Growing& region = regions_[root];
      region.RiseTo(level);
      const int64_t shallow = std::accumulate(region.recent.begin(), region.recent.end(), int64_t{0});
      const auto node = static_cast<int32_t>(nodes_.size());
      for (const int32_t child : grown->second) nodes_[child].parent = node;
      if (region.node >= 0) nodes_[region.node].parent = node;
      region.node = node;
      nodes_.push_back({level, region.area, region.area - shallow, -1, *first});
      children_.erase(grown);
    }
  }

  const SteppedHeights& heights_;
  std::vector<int32_t> root_;                         // of each square; -1: not there yet
  std::vector<Growing> regions_;                      // at their roots
  std::map<int32_t, std::vector<int32_t>> children_;  // of the regions that grow at this level: nodes that joined
  std::vector<HeightNode> nodes_;
};

}  // namespace

std::vector<HeightNode> HeightTreeOf(const SteppedHeights& heights) { return Builder(heights).Build(); }

std::vector<int32_t> SquaresBelow(const SteppedHeights& heights, int32_t square, int32_t level) {
  std::vector<int32_t> found, open = {square};
  std::set<int32_t> seen = {square};
  while (!open.empty()) {
    const int32_t next = open.back();
    open.pop_back();
    found.push_back(next);
    ForEachNeighbour(heights.cols, heights.rows, next, [&](int32_t other) {
      if (heights.steps[other] <= level && seen.insert(other).second) open.push_back(other);
    });
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace tilemend
