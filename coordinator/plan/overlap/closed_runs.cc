#include "coordinator/plan/overlap/closed_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace tilemend {
namespace {

// Where a gap begins or ends on the outline.
struct GapEnd {
  double place = 0;
  int32_t vertex = 0;
  size_t gap = 0;
  bool begins = false;  // the gap; else it ends there
};

// A gap by its ends, into those along the outline.
struct Way {
  size_t from = 0, to = 0;
};

class RunJoiner {
 public:
  RunJoiner(const SurveyRecord& record, const Outline& outline, std::span<OutlineGap> gaps)
      : record_(record), outline_(outline), gaps_(gaps), is_seen_(record.vertices.size(), false), ways_(gaps.size()) {
    for (size_t g = 0; g < gaps.size(); ++g) {
      const std::optional<double> from = PlaceOf(gaps[g].from), to = PlaceOf(gaps[g].to);
      if (!from || !to) continue;
      ends_.push_back({*from, gaps[g].from, g, true});
      ends_.push_back({*to, gaps[g].to, g, false});
    }
    std::ranges::sort(ends_, {}, [](const GapEnd& e) { return std::tuple(e.place, e.vertex, e.begins, e.gap); });
    for (size_t i = 0; i < ends_.size(); ++i) {
      (ends_[i].begins ? ways_[ends_[i].gap].from : ways_[ends_[i].gap].to) = i;
      is_seen_[ends_[i].vertex] = true;
    }
  }

  void Run(const std::vector<bool>& on_outline) {
    std::vector<int32_t> next(record_.vertices.size(), -1);
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      if (on_outline[e]) next[record_.edges[e].from] = record_.edges[e].to;
    }
    for (const GapEnd& end : ends_) {
      if (end.begins && IsClosed(gaps_[end.gap], next)) Join(end.gap);
    }
  }

 private:
  std::optional<double> PlaceOf(int32_t v) const {
    const Point3& p = record_.vertices[v].position;
    const std::optional<Side> side = outline_.SideAt(p);
    return side ? std::optional(outline_.PlaceOf(p, *side)) : std::nullopt;
  }

  // Whether the run at the gap's end leads to its beginning. Each vertex is passed once.
  bool IsClosed(const OutlineGap& gap, const std::vector<int32_t>& next) {
    int32_t v = next[gap.to];
    for (; v >= 0 && !is_seen_[v]; v = next[v]) is_seen_[v] = true;
    return v == gap.from;
  }

  void Join(size_t gap) {
    const Way closed = ways_[gap];
    double most = 0;
    size_t best = gap;
    for (const size_t end : {closed.from, closed.to}) {
      for (const size_t beside : {end + 1, end + ends_.size() - 1}) {
        const size_t other = ends_[beside % ends_.size()].gap;
        const double gain = other == gap ? 0 : GainOf(closed, ways_[other]);
        if (gain > most) std::tie(most, best) = std::pair(gain, other);
      }
    }
    if (best != gap) Exchange(gap, best);
  }

  // How much shorter both are when they exchange ends, the street by the lowest end or straight.
  double GainOf(const Way& closed, const Way& street) const {
    const auto [link, way] = Exchanged(closed, street);
    const double lowest = std::min({Height(closed.from), Height(closed.to), Height(street.from), Height(street.to)});
    const auto falls = [&](const Way& w) { return Along(w) + Height(w.from) + Height(w.to) - 2 * lowest; };
    const double in_links = Straight(closed) - Straight(link);
    return in_links + std::max(falls(street) - falls(way), Straight(street) - Straight(way));
  }

  // The shorter one along the outline first: the other is along the street.
  std::array<Way, 2> Exchanged(const Way& a, const Way& b) const {
    const Way c{a.from, b.to}, d{b.from, a.to};
    return Along(c) < Along(d) ? std::array{c, d} : std::array{d, c};
  }

  void Exchange(size_t closed, size_t street) {
    const bool is_open = gaps_[street].open || gaps_[closed].open;
    const auto [link, way] = Exchanged(ways_[closed], ways_[street]);
    std::swap(gaps_[closed].to_across, gaps_[street].to_across);
    for (const Way& w : {link, way}) {
      const size_t gap = ends_[w.from].gap;
      ways_[gap] = w;
      ends_[w.to].gap = gap;
      gaps_[gap].to = ends_[w.to].vertex;
      gaps_[gap].open = false;
      gaps_[gap].begin = gaps_[gap].end = 0;
    }
    if (!is_open) return;
    OutlineGap& open = gaps_[ends_[way.from].gap];
    open.open = true;
    open.begin = ends_[way.from].place;
    open.end = ends_[way.to].place + (ends_[way.to].place < open.begin ? outline_.Length() : 0);
  }

  double Height(size_t end) const { return record_.vertices[ends_[end].vertex].position.z(); }
  double Straight(const Way& way) const { return Along(way) + std::abs(Height(way.from) - Height(way.to)); }
  double Along(const Way& way) const {
    const double along = std::abs(ends_[way.from].place - ends_[way.to].place);
    return std::min(along, outline_.Length() - along);
  }

  const SurveyRecord& record_;
  const Outline& outline_;
  const std::span<OutlineGap> gaps_;
  std::vector<bool> is_seen_;  // of each vertex: gaps end there, or a run was followed past it
  std::vector<GapEnd> ends_;   // of gaps with both ends on the outline, along it
  std::vector<Way> ways_;      // of each gap
};

}  // namespace

void JoinClosedRuns(const SurveyRecord& record, const std::vector<bool>& on_outline, const Outline& outline,
                    std::span<OutlineGap> gaps) {
  RunJoiner(record, outline, gaps).Run(on_outline);
}

}  // namespace tilemend
