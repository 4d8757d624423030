#include "coordinator/plan/overlap/piece_ends.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace tilemend {
namespace {

// Chains of two pieces end at most so many reaches from each other where the pieces and the tile end together, and run
// as far under another piece before they end.
constexpr double kNear = 8;
constexpr double kFirst = 0.01;  // metres: ends so near are matched first, then by powers of two

class Matcher {
 public:
  Matcher(const PieceBoundary& boundary, const std::vector<PieceEnd>& ends, double reach)
      : boundary_(boundary), ends_(ends), reach_(reach), matched_(ends.size(), false), outline_vertex_(ends.size()) {}

  PieceMatches Run() {
    WalkAlongPieces();
    MatchNearest(kNear * reach_);
    for (size_t i = 0; i < ends_.size(); ++i) {
      if (!matched_[i] && outline_vertex_[i]) CountToOutline(i, *outline_vertex_[i]);
    }
    MatchNearest(2 * (boundary_.record.hi - boundary_.record.lo).norm());
    for (size_t i = 0; i < ends_.size(); ++i) {
      if (!matched_[i]) CountToOutline(i, ends_[i].vertex);
    }
    return std::move(matches_);
  }

 private:
  // From where chains end, then back from where they begin.
  void WalkAlongPieces() {
    const PieceWalk pieces(boundary_, kNear * reach_);
    std::map<std::pair<int32_t, bool>, std::vector<size_t>> at;
    for (size_t i = 0; i < ends_.size(); ++i) at[{ends_[i].vertex, ends_[i].begins}].push_back(i);
    for (const bool backward : {false, true}) {
      for (size_t i = 0; i < ends_.size(); ++i) {
        if (matched_[i] || ends_[i].begins != backward || IsOnOutline(i)) continue;
        const auto arrival = pieces.From(ends_[i].vertex, backward);
        if (!arrival) continue;
        if (arrival->on_outline) {
          outline_vertex_[i] = arrival->vertex;
          continue;
        }
        std::vector<size_t>& others = at[{arrival->vertex, !backward}];
        std::erase_if(others, [&](size_t k) { return matched_[k]; });
        if (!others.empty()) Match(backward ? i : others.front(), backward ? others.front() : i);
      }
    }
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

  void CountToOutline(size_t i, int32_t vertex) {
    matched_[i] = true;
    matches_.on_outline.emplace_back(i, vertex);
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
      if (distance > reach * reach || (outline_vertex_[begin] && outline_vertex_[end])) continue;
      if (distance <= farthest || (!IsOnOutline(begin) && !IsOnOutline(end))) pairs.emplace_back(distance, begin, end);
    }
  }

  const PieceBoundary& boundary_;
  const std::vector<PieceEnd>& ends_;
  const double reach_;
  std::vector<bool> matched_;
  std::vector<std::optional<int32_t>> outline_vertex_;  // where the way from an end comes to the tile's outline
  PieceMatches matches_;
};

}  // namespace

PieceMatches MatchPieceEnds(const PieceBoundary& boundary, const std::vector<PieceEnd>& ends, double reach) {
  return Matcher(boundary, ends, reach).Run();
}

}  // namespace tilemend
