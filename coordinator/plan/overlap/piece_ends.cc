#include "coordinator/plan/overlap/piece_ends.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "common/mesh/vertex_lists.h"

namespace tilemend {
namespace {

// Chains of two pieces end at most so many reaches from each other where the pieces and the tile end together.
constexpr double kNear = 8;
constexpr double kFirst = 0.01;  // metres: ends so near are matched first, then by powers of two

// Follows chains to where they begin and end.
class ChainWalk {
 public:
  explicit ChainWalk(const PieceBoundary& boundary)
      : boundary_(boundary),
        leaving_(EdgesBy([](const BoundaryEdge& e) { return e.from; })),
        arriving_(EdgesBy([](const BoundaryEdge& e) { return e.to; })) {}

  struct End {
    int32_t vertex = 0;
    double way = 0;  // metres, seen from above
  };

  // From a place, along the edges or against them; none if no chain ends within `longest`, or one divides.
  std::optional<End> From(const ChainPlace& start, bool backward, double longest) const {
    const auto& [edge, place] = start;
    if (!boundary_.in_chain[edge]) return std::nullopt;
    End end{VertexAfter(edge, backward), 0};
    end.way = (At(end.vertex) - place).norm();
    for (size_t steps = 0; end.way <= longest && steps < boundary_.record.edges.size(); ++steps) {
      const auto on = (backward ? arriving_ : leaving_).Of(end.vertex);
      if (on.empty()) return end;
      if (on.size() > 1) break;
      const int32_t before = end.vertex;
      end.vertex = VertexAfter(on[0], backward);
      end.way += (At(end.vertex) - At(before)).norm();
    }
    return std::nullopt;
  }

 private:
  template <typename EndOf>
  VertexLists EdgesBy(const EndOf& end_of) const {
    const SurveyRecord& record = boundary_.record;
    return {record.vertices.size(), [&](const auto& use) {
              for (int32_t e = 0; e < std::ssize(record.edges); ++e) {
                if (boundary_.in_chain[e]) use(end_of(record.edges[e]), e);
              }
            }};
  }

  Point2 At(int32_t v) const { return boundary_.record.vertices[v].position.head<2>(); }

  int32_t VertexAfter(int32_t e, bool backward) const {
    return backward ? boundary_.record.edges[e].from : boundary_.record.edges[e].to;
  }

  const PieceBoundary& boundary_;
  const VertexLists leaving_, arriving_;
};

class Matcher {
 public:
  Matcher(const PieceBoundary& boundary, const std::vector<PieceEnd>& ends, double reach)
      : boundary_(boundary), ends_(ends), reach_(reach), matched_(ends.size(), false), at_outline_(ends.size()) {}

  PieceMatches Run() {
    MatchAtPassages();
    MatchNearest(kNear * reach_);
    for (size_t i = 0; i < ends_.size(); ++i) {
      if (!matched_[i] && at_outline_[i]) CountToOutline(i);
    }
    MatchNearest(2 * (boundary_.record.hi - boundary_.record.lo).norm());
    for (size_t i = 0; i < ends_.size(); ++i) {
      if (!matched_[i]) CountToOutline(i);
    }
    return std::move(matches_);
  }

 private:
  using EndAt = std::pair<int32_t, bool>;  // as PieceEnd

  // Between ends that are near to it.
  struct Passage {
    std::optional<EndAt> begin, end;
    std::optional<Point2> at_outline;
  };

  void MatchAtPassages() {
    std::map<EndAt, std::pair<double, size_t>> nearest;  // the way to a passage, and its number
    std::vector<Passage> passages;
    const ChainWalk chains(boundary_);
    for (const ChainPassage& p : boundary_.passages) {
      Passage passage{{}, {}, p.at_outline};
      const auto reach = [&](const std::optional<ChainPlace>& from, bool begins, std::optional<EndAt>& end) {
        const auto there = from ? chains.From(*from, begins, reach_) : std::nullopt;
        if (!there) return;
        end = EndAt{there->vertex, begins};
        const std::pair way(there->way, passages.size());
        const auto [it, fresh] = nearest.try_emplace(*end, way);
        if (!fresh) it->second = std::min(it->second, way);
      };
      reach(p.leaving, true, passage.begin);
      reach(p.arriving, false, passage.end);
      passages.push_back(passage);
    }
    std::map<EndAt, std::vector<size_t>> at;
    for (size_t i = 0; i < ends_.size(); ++i) at[{ends_[i].vertex, ends_[i].begins}].push_back(i);
    for (size_t k = 0; k < passages.size(); ++k) {
      const auto own = [&](const std::optional<EndAt>& end) -> std::optional<size_t> {
        if (!end || nearest.at(*end).second != k || at[*end].size() != 1) return std::nullopt;
        return at[*end][0];
      };
      const std::optional<size_t> begin = own(passages[k].begin), end = own(passages[k].end);
      if (begin && end && AreBeside(*begin, *end)) Match(*begin, *end);
      if (!passages[k].at_outline) continue;
      for (const std::optional<size_t>& i : {begin, end}) {
        if (i) at_outline_[*i] = passages[k].at_outline;
      }
    }
  }

  // Seen from above, passages do not tell chains apart that end above each other on a facade.
  bool AreBeside(size_t a, size_t b) const {
    const Point3 way = At(a) - At(b);
    return std::abs(way.z()) <= way.head<2>().norm() + reach_;
  }

  // Those left over, the nearest pairs first, unless the ways of both lead to the outline.
  void MatchNearest(double farthest) {
    for (double reach = kFirst; reach / 2 < farthest; reach *= 2) MatchWithin(std::min(reach, farthest));
  }

  const Point3& At(size_t i) const { return boundary_.record.vertices[ends_[i].vertex].position; }
  bool IsOnOutline(size_t i) const { return boundary_.on_outline[ends_[i].vertex]; }

  void Match(size_t begin, size_t end) {
    matched_[begin] = matched_[end] = true;
    matches_.pairs.emplace_back(begin, end);
  }

  void CountToOutline(size_t i) {
    matched_[i] = true;
    matches_.on_outline.emplace_back(i, at_outline_[i]);
  }

  // The pairs no farther apart than `reach`, if all nearer ones are matched: by squares of that size.
  void MatchWithin(double reach) {
    const auto square = [&](size_t i) {
      const Point3& p = At(i);
      return std::pair(std::llround(p.x() / reach), std::llround(p.y() / reach));
    };
    std::map<std::pair<int64_t, int64_t>, std::vector<size_t>> ends;
    for (size_t k = 0; k < ends_.size(); ++k) {
      if (!matched_[k] && !ends_[k].begins) ends[square(k)].push_back(k);
    }
    std::vector<std::tuple<double, size_t, size_t>> pairs;
    for (size_t i = 0; i < ends_.size(); ++i) {
      if (matched_[i] || !ends_[i].begins) continue;
      const auto [column, row] = square(i);
      for (int64_t c = column - 1; c <= column + 1; ++c) {
        for (int64_t r = row - 1; r <= row + 1; ++r) AddPairs(i, ends[{c, r}], reach, pairs);
      }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [distance, begin, end] : pairs) {
      if (!matched_[begin] && !matched_[end]) Match(begin, end);
    }
  }

  void AddPairs(size_t begin, const std::vector<size_t>& ends, double reach,
                std::vector<std::tuple<double, size_t, size_t>>& pairs) const {
    const double farthest = std::pow(kNear * reach_, 2);
    for (const size_t end : ends) {
      const double distance = (At(begin) - At(end)).squaredNorm();
      if (distance > reach * reach || (at_outline_[begin] && at_outline_[end])) continue;
      if (distance <= farthest || (!IsOnOutline(begin) && !IsOnOutline(end))) pairs.emplace_back(distance, begin, end);
    }
  }

  const PieceBoundary& boundary_;
  const std::vector<PieceEnd>& ends_;
  const double reach_;
  std::vector<bool> matched_;
  std::vector<std::optional<Point2>> at_outline_;  // where the way from an end comes to the tile's outline
  PieceMatches matches_;
};

}  // namespace

PieceMatches MatchPieceEnds(const PieceBoundary& boundary, const std::vector<PieceEnd>& ends, double reach) {
  return Matcher(boundary, ends, reach).Run();
}

}  // namespace tilemend
