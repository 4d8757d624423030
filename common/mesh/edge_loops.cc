#include "common/mesh/edge_loops.h"

#include <algorithm>

namespace tilemend {
namespace {

class EdgeLinker {
 public:
  EdgeLinker(std::span<const DirectedEdge> edges, const ChooseEdge* choose)
      : edges_(edges), choose_(choose), walked_(edges.size(), false) {
    for (size_t e = 0; e < edges.size(); ++e) leaving_.emplace_back(edges[e].from, static_cast<int32_t>(e));
    std::sort(leaving_.begin(), leaving_.end());
  }

  std::vector<EdgeWalk> Run() {
    std::vector<int32_t> ends;
    for (const DirectedEdge& e : edges_) ends.push_back(e.to);
    std::sort(ends.begin(), ends.end());
    const auto count = static_cast<int32_t>(edges_.size());
    for (int32_t e = 0; e < count; ++e) {
      if (!std::binary_search(ends.begin(), ends.end(), edges_[e].from)) Walk(e);
    }
    for (int32_t e = 0; e < count; ++e) {
      if (!walked_[e]) Walk(e);
    }
    return std::move(walks_);
  }

 private:
  void Walk(int32_t first) {
    EdgeWalk walk;
    for (int32_t e = first; e >= 0;) {
      walked_[e] = true;
      walk.edges.push_back(e);
      const int32_t next = NextOf(e, first);
      walk.closed = next == first;
      e = walk.closed ? -1 : next;
    }
    walks_.push_back(std::move(walk));
  }

  // The edge that e runs on into, in a walk from `first`; -1 if there is none.
  int32_t NextOf(int32_t e, int32_t first) {
    candidates_.clear();
    auto it = std::lower_bound(leaving_.begin(), leaving_.end(), std::pair(edges_[e].to, int32_t{0}));
    for (; it != leaving_.end() && it->first == edges_[e].to; ++it) {
      if (!walked_[it->second] || it->second == first) candidates_.push_back(it->second);
    }
    if (candidates_.empty()) return -1;
    return choose_ != nullptr ? (*choose_)(e, candidates_) : FirstInList(e, first);
  }

  // Closes a walk only where it cannot go on.
  int32_t FirstInList(int32_t e, int32_t first) const {
    const auto follower = std::find(candidates_.begin(), candidates_.end(), e + 1);
    if (follower != candidates_.end() && *follower != first) return *follower;
    return candidates_[0] == first && candidates_.size() > 1 ? candidates_[1] : candidates_[0];
  }

  std::span<const DirectedEdge> edges_;
  const ChooseEdge* choose_;
  std::vector<std::pair<int32_t, int32_t>> leaving_;  // vertex, edge
  std::vector<bool> walked_;
  std::vector<int32_t> candidates_;
  std::vector<EdgeWalk> walks_;
};

}  // namespace

std::vector<EdgeWalk> LinkEdges(std::span<const DirectedEdge> edges) { return EdgeLinker(edges, nullptr).Run(); }

std::vector<EdgeWalk> LinkEdges(std::span<const DirectedEdge> edges, const ChooseEdge& choose) {
  return EdgeLinker(edges, &choose).Run();
}

std::vector<EdgeWalk> FollowEdges(std::span<const int32_t> next) {
  std::vector<bool> led_to(next.size(), false), walked(next.size(), false);
  for (const int32_t e : next) {
    if (e >= 0) led_to[e] = true;
  }
  std::vector<EdgeWalk> walks;
  for (const bool chains : {true, false}) {
    for (size_t first = 0; first < next.size(); ++first) {
      if (walked[first] || (chains && led_to[first])) continue;
      EdgeWalk walk;
      walk.closed = !chains;
      for (auto e = static_cast<int32_t>(first); e >= 0 && !walked[e]; e = next[e]) {
        walked[e] = true;
        walk.edges.push_back(e);
      }
      walks.push_back(std::move(walk));
    }
  }
  return walks;
}

}  // namespace tilemend
