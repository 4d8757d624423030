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

// The surface along the outline, from one end of a gap to the next.
class OutlineRuns {
 public:
  OutlineRuns(const SurveyRecord& record, const std::vector<bool>& on_outline, const Outline& outline,
              std::span<const GapEnd> ends)
      : record_(record), outline_(outline), leaving_(record.vertices.size(), -1), is_end_(record.vertices.size()) {
    for (size_t e = 0; e < record.edges.size(); ++e) {
      if (on_outline[e]) leaving_[record.edges[e].from] = static_cast<int32_t>(e);
    }
    for (const GapEnd& end : ends) is_end_[end.vertex] = true;
  }

  // The edges of the run at a gap's end, if it leads to the gap's beginning; else none.
  std::vector<int32_t> RunOf(const OutlineGap& gap) const {
    std::vector<int32_t> run;
    int32_t v = gap.to;
    do {
      if (leaving_[v] < 0 || run.size() > record_.edges.size()) return {};
      run.push_back(leaving_[v]);
      v = record_.edges[leaving_[v]].to;
    } while (!is_end_[v]);
    return v == gap.from ? run : std::vector<int32_t>{};
  }

  // A hole that a gap closes below or above the run is bounded by the run itself, if that is no detour. The run goes
  // backward; one that goes on around the tile is beside the gap.
  void Follow(OutlineGap& gap) const {
    const auto place = [&](int32_t v) -> const Point3& { return record_.vertices[v].position; };
    std::vector<int32_t> run = RunOf(gap);
    double length = 0, ahead = 0;
    for (const int32_t e : run) {
      const Point3 &from = place(record_.edges[e].from), &to = place(record_.edges[e].to);
      length += (to - from).norm();
      ahead += std::remainder(PlaceOf(record_.edges[e].to) - PlaceOf(record_.edges[e].from), outline_.Length());
    }
    if (run.empty() || ahead > 0 || kOutlineWeight * length >= (place(gap.to) - place(gap.from)).norm()) return;
    gap.along = std::move(run);
    gap.link = {gap.from, gap.from};
  }

 private:
  double PlaceOf(int32_t v) const {
    const Point3& p = record_.vertices[v].position;
    return outline_.PlaceOf(p, outline_.SideAt(p).value_or(outline_.NearestSide(p)));
  }

  const SurveyRecord& record_;
  const Outline& outline_;
  std::vector<int32_t> leaving_;  // of each vertex: the edge on the outline that leaves it; -1: none
  std::vector<bool> is_end_;      // of each vertex: whether gaps end there
};

// A gap by its ends, into those along the outline.
struct Way {
  size_t from = 0, to = 0;
};

class RunJoiner {
 public:
  RunJoiner(const SurveyRecord& record, const Outline& outline, std::span<OutlineGap> gaps)
      : record_(record), outline_(outline), gaps_(gaps), ways_(gaps.size()) {
    for (size_t g = 0; g < gaps.size(); ++g) {
      const std::optional<double> from = PlaceOf(gaps[g].from), to = PlaceOf(gaps[g].to);
      if (!from || !to) continue;
      ends_.push_back({*from, gaps[g].from, g, true});
      ends_.push_back({*to, gaps[g].to, g, false});
    }
    std::ranges::sort(ends_, {}, [](const GapEnd& e) { return std::tuple(e.place, e.vertex, e.begins, e.gap); });
    for (size_t i = 0; i < ends_.size(); ++i) {
      (ends_[i].begins ? ways_[ends_[i].gap].from : ways_[ends_[i].gap].to) = i;
    }
  }

  void Run(const std::vector<bool>& on_outline) {
    const OutlineRuns runs(record_, on_outline, outline_, ends_);
    for (const GapEnd& end : ends_) {
      if (!end.begins || runs.RunOf(gaps_[end.gap]).empty()) continue;
      Join(end.gap, [&](const Way& closed, const Way& street) { return GainOf(closed, street); });
    }
    for (const GapEnd& end : ends_) {
      if (!end.begins) continue;
      Join(end.gap, [&](const Way& a, const Way& b) { return AreNested(a, b) ? LeastGainOf(a, b) : 0; });
    }
    for (const GapEnd& end : ends_) {
      if (end.begins && !gaps_[end.gap].open) runs.Follow(gaps_[end.gap]);
    }
  }

 private:
  std::optional<double> PlaceOf(int32_t v) const {
    const Point3& p = record_.vertices[v].position;
    const std::optional<Side> side = outline_.SideAt(p);
    return side ? std::optional(outline_.PlaceOf(p, *side)) : std::nullopt;
  }

  // With the gap that has an end beside one of its own and gains most.
  template <typename Gain>
  void Join(size_t gap, const Gain& gain_of) {
    const Way own = ways_[gap];
    double most = 0;
    size_t best = gap;
    for (const size_t end : {own.from, own.to}) {
      for (const size_t beside : {end + 1, end + ends_.size() - 1}) {
        const size_t other = ends_[beside % ends_.size()].gap;
        const double gain = other == gap ? 0 : gain_of(own, ways_[other]);
        if (gain > most) std::tie(most, best) = std::pair(gain, other);
      }
    }
    if (best != gap) Exchange(gap, best);
  }

  // Whether one of two gaps lies in the other.
  bool AreNested(const Way& a, const Way& b) const {
    const auto lies_in = [&](const Way& in, const Way& out) {
      const double begin = Ahead(out.from, in.from), end = Ahead(out.from, in.to), all = Ahead(out.from, out.to);
      return begin < end && end < all && all < outline_.Length() / 2;
    };
    return lies_in(a, b) || lies_in(b, a);
  }

  // How much shorter both are when they exchange ends, by the measure by which they gain less.
  double LeastGainOf(const Way& a, const Way& b) const {
    const auto [link, way] = Exchanged(a, b);
    const auto [shorter, street] = Along(a) < Along(b) ? std::pair(a, b) : std::pair(b, a);
    const auto [straight, falls] = GainsOf(shorter, street, link, way);
    return std::min(straight, falls);
  }

  // How much shorter both are when they exchange ends, the street by the lowest end or straight.
  double GainOf(const Way& closed, const Way& street) const {
    const auto [link, way] = Exchanged(closed, street);
    const auto [straight, falls] = GainsOf(closed, street, link, way);
    return std::max(straight, falls);
  }

  // Straight, and with the street by the lowest end.
  std::pair<double, double> GainsOf(const Way& link, const Way& street, const Way& new_link,
                                    const Way& new_street) const {
    const double lowest = std::min({Height(link.from), Height(link.to), Height(street.from), Height(street.to)});
    const auto falls = [&](const Way& w) { return Along(w) + Height(w.from) + Height(w.to) - 2 * lowest; };
    const double in_links = Straight(link) - Straight(new_link);
    return {in_links + Straight(street) - Straight(new_street), in_links + falls(street) - falls(new_street)};
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

  // How far around the outline from one end to another.
  double Ahead(size_t from, size_t to) const {
    const double ahead = ends_[to].place - ends_[from].place;
    return ahead < 0 ? ahead + outline_.Length() : ahead;
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
  std::vector<GapEnd> ends_;  // of gaps with both ends on the outline, along it
  std::vector<Way> ways_;     // of each gap
};

}  // namespace

void JoinClosedRuns(const SurveyRecord& record, const std::vector<bool>& on_outline, const Outline& outline,
                    std::span<OutlineGap> gaps) {
  RunJoiner(record, outline, gaps).Run(on_outline);
}

}  // namespace tilemend
