#include "coordinator/plan/overlap/chain_groups.h"

#include <algorithm>
#include <map>
#include <set>

#include "common/mesh/disjoint_sets.h"

namespace tilemend {
namespace {

// Vertices, edges and holes of one tile as things of one numbering.
class Grouper {
 public:
  Grouper(const SurveyRecord& record, const std::vector<bool>& is_chain, const std::vector<OutlineGap>& gaps,
          const std::vector<std::vector<int32_t>>& edges_of_hole)
      : record_(record),
        is_chain_(is_chain),
        gaps_(gaps),
        edges_of_hole_(edges_of_hole),
        vertices_(static_cast<int32_t>(record.vertices.size())),
        around_(record.vertices.size()),
        sets_(vertices_ + static_cast<int32_t>(record.edges.size() + edges_of_hole.size())) {}

  std::vector<ChainGroup> Run() {
    JoinChains();
    for (size_t i = 0; i < edges_of_hole_.size(); ++i) {
      for (const int32_t e : edges_of_hole_[i]) sets_.Join(OfHole(i), OfEdge(e));
    }
    JoinWhereOpen();
    return Collect();
  }

 private:
  int32_t OfEdge(int32_t e) const { return vertices_ + e; }
  int32_t OfHole(size_t i) const { return vertices_ + static_cast<int32_t>(record_.edges.size() + i); }

  void JoinChains() {
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      if (!is_chain_[e]) continue;
      for (const int32_t v : {record_.edges[e].from, record_.edges[e].to}) {
        around_[v].push_back(static_cast<int32_t>(e));
      }
    }
    for (int32_t v = 0; v < vertices_; ++v) {
      if (around_[v].size() <= 2) JoinAround(v);
    }
    for (const OutlineGap& gap : gaps_) {
      JoinAround(gap.from), JoinAround(gap.to);
      sets_.Join(gap.from, gap.to);
    }
  }

  void JoinAround(int32_t v) {
    for (const int32_t e : around_[v]) sets_.Join(OfEdge(e), v);
  }

  void JoinWhereOpen() {
    for (bool changed = true; changed;) {
      changed = false;
      std::set<int32_t> with_hole;
      for (size_t i = 0; i < edges_of_hole_.size(); ++i) with_hole.insert(sets_.LowestOf(OfHole(i)));
      for (int32_t v = 0; v < vertices_; ++v) {
        if (around_[v].size() <= 2 || IsApart(v, with_hole)) continue;
        JoinAround(v);
        changed = true;
      }
    }
  }

  // Whether the chains at a vertex are one, or close each for itself.
  bool IsApart(int32_t v, const std::set<int32_t>& with_hole) {
    std::map<int32_t, int> balance;
    for (const int32_t e : around_[v]) balance[sets_.LowestOf(OfEdge(e))] += record_.edges[e].from == v ? 1 : -1;
    return balance.size() <= 1 || std::all_of(balance.begin(), balance.end(), [&](const auto& b) {
             return b.second == 0 && with_hole.contains(b.first);
           });
  }

  std::vector<ChainGroup> Collect() {
    std::vector<ChainGroup> groups;
    std::map<int32_t, size_t> number;
    for (size_t i = 0; i < edges_of_hole_.size(); ++i) {
      const auto [it, fresh] = number.try_emplace(sets_.LowestOf(OfHole(i)), groups.size());
      if (fresh) groups.emplace_back();
      groups[it->second].holes.push_back(i);
    }
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      if (!is_chain_[e]) continue;
      const auto it = number.find(sets_.LowestOf(OfEdge(static_cast<int32_t>(e))));
      if (it != number.end()) groups[it->second].edges.push_back(static_cast<int32_t>(e));
    }
    for (const OutlineGap& gap : gaps_) {
      if (const auto it = number.find(sets_.LowestOf(gap.from)); it != number.end()) {
        groups[it->second].gaps.push_back(gap);
      }
    }
    return groups;
  }

  const SurveyRecord& record_;
  const std::vector<bool>& is_chain_;
  const std::vector<OutlineGap>& gaps_;
  const std::vector<std::vector<int32_t>>& edges_of_hole_;
  const int32_t vertices_;
  std::vector<std::vector<int32_t>> around_;  // edges of chains at each vertex
  DisjointSets sets_;
};

}  // namespace

std::vector<ChainGroup> GroupChains(const SurveyRecord& record, const std::vector<bool>& is_chain,
                                    const std::vector<OutlineGap>& gaps,
                                    const std::vector<std::vector<int32_t>>& edges_of_hole) {
  return Grouper(record, is_chain, gaps, edges_of_hole).Run();
}

}  // namespace tilemend
