#include "coordinator/plan/overlap/piece_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "common/mesh/bin_grid.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

constexpr int64_t kMostBins = 1 << 20;

double Cross(const Point2& u, const Point2& v) { return u.x() * v.y() - u.y() * v.x(); }

Point2 Flat(const Point3& p) { return p.head<2>(); }

// A place on an edge, from its first end (0) to its last (1) as the walk goes.
struct Place {
  int32_t edge = 0;
  double along = 0;
};

// Where edge `first` meets edge `second`; turn > 0: the first one crosses to the left of the second.
struct Meeting {
  double on_first = 0, on_second = 0, turn = 0;
};

// Where the walk goes next, or ends.
struct Step {
  Place next;
  std::optional<PieceWalk::Arrival> arrival;
};

BinGrid GridOf(const SurveyRecord& record) {
  Eigen::AlignedBox2d box;
  double length = 0;
  const auto box_of = [&](int32_t e) {
    Eigen::AlignedBox2d of(Flat(record.vertices[record.edges[e].from].position));
    return of.extend(Flat(record.vertices[record.edges[e].to].position));
  };
  for (int32_t e = 0; e < std::ssize(record.edges); ++e) {
    const Eigen::AlignedBox2d of = box_of(e);
    box.extend(of);
    length += of.diagonal().norm();
  }
  const double step = length / static_cast<double>(record.edges.size());
  const double least = std::sqrt(box.volume() / kMostBins) + box.diagonal().norm() / kMostBins;
  return {box, std::max(step, least), static_cast<int32_t>(record.edges.size()), box_of};
}

}  // namespace

class PieceWalk::Impl {
 public:
  Impl(const PieceBoundary& boundary, double reach)
      : record_(boundary.record),
        kinds_(boundary.kinds),
        on_outline_(boundary.on_outline),
        reach_(reach),
        leaving_(EdgesBy([](const BoundaryEdge& e) { return e.from; })),
        arriving_(EdgesBy([](const BoundaryEdge& e) { return e.to; })),
        grid_(GridOf(boundary.record)) {}

  std::optional<Arrival> From(int32_t end, bool backward) const {
    if (on_outline_[end]) return Arrival{end, true};
    std::set<int32_t> walked;
    std::optional<Step> step = Start(end, backward);
    while (step && !step->arrival) {
      if (!walked.insert(step->next.edge).second) return std::nullopt;
      step = After(step->next, backward);
    }
    return step ? step->arrival : std::nullopt;
  }

 private:
  template <typename EndOf>
  VertexLists EdgesBy(const EndOf& end_of) const {
    return {record_.vertices.size(), [&](const auto& use) {
              for (int32_t e = 0; e < std::ssize(record_.edges); ++e) use(end_of(record_.edges[e]), e);
            }};
  }

  int32_t First(int32_t e, bool backward) const { return backward ? record_.edges[e].to : record_.edges[e].from; }
  int32_t Last(int32_t e, bool backward) const { return First(e, !backward); }
  const Point3& At(int32_t v) const { return record_.vertices[v].position; }

  double LengthOf(int32_t e) const { return (At(record_.edges[e].to) - At(record_.edges[e].from)).head<2>().norm(); }

  // The only edge of a kind, and of a piece if given, by which the walk may leave a vertex.
  std::optional<int32_t> Next(int32_t v, BoundaryKind kind, bool backward, std::optional<int32_t> piece = {}) const {
    std::optional<int32_t> found;
    for (const int32_t e : (backward ? arriving_ : leaving_).Of(v)) {
      if (kinds_[e] != kind || (piece && record_.edges[e].piece != *piece)) continue;
      if (found) return std::nullopt;
      found = e;
    }
    return found;
  }

  // The edge of the same chain that the walk comes from.
  std::optional<int32_t> Before(int32_t e, bool backward) const {
    return Next(First(e, backward), BoundaryKind::kChain, !backward, record_.edges[e].piece);
  }

  // Where two edges cross or touch, seen from above.
  std::optional<Meeting> Meet(int32_t first, int32_t second, bool backward) const {
    const Point3 &a = At(First(first, backward)), &b = At(Last(first, backward));
    const Point3 &c = At(First(second, backward)), &d = At(Last(second, backward));
    const Point2 u = Flat(b - a), v = Flat(d - c), w = Flat(c - a);
    const double turn = Cross(v, u);
    if (std::abs(turn) <= kMeetTolerance * std::min(u.norm(), v.norm())) return std::nullopt;
    const Meeting meeting{Cross(v, w) / turn, Cross(u, w) / turn, backward ? -turn : turn};
    const auto is_on = [](double along, double length) {
      return along * length >= -kMeetTolerance && (along - 1) * length <= kMeetTolerance;
    };
    if (!is_on(meeting.on_first, u.norm()) || !is_on(meeting.on_second, v.norm())) return std::nullopt;
    return meeting;
  }

  // Where the chain that ends at a vertex first runs under another piece, never to come out again; else where its own
  // piece's outline goes on there.
  std::optional<Step> Start(int32_t end, bool backward) const {
    std::optional<Step> start;
    double walked = 0;
    bool is_covered = true;
    const auto own = Next(end, BoundaryKind::kPiece, backward);
    auto e = Next(end, BoundaryKind::kChain, !backward, own ? std::optional(record_.edges[*own].piece) : std::nullopt);
    for (; e && is_covered && walked <= reach_; e = Before(*e, backward)) {
      std::vector<std::pair<Meeting, Step>> met = StepsOff(*e, backward);
      std::sort(met.begin(), met.end(),
                [](const auto& m, const auto& n) { return m.first.on_first > n.first.on_first; });
      for (const auto& [meeting, step] : met) {
        if (walked + (1 - meeting.on_first) * LengthOf(*e) <= kMeetTolerance) continue;  // the end itself
        is_covered = is_covered && meeting.turn > 0;
        if (is_covered) start = step;
      }
      walked += LengthOf(*e);
    }
    return start || !own ? start : std::optional(Step{{*own, 0}, {}});
  }

  // From a place on a piece's outline.
  std::optional<Step> After(const Place& place, bool backward) const {
    double first = std::numeric_limits<double>::infinity();
    std::optional<Step> step;
    const double least = place.along - kMeetTolerance / std::max(kMeetTolerance, LengthOf(place.edge));
    for (const auto& [meeting, there] : StepsOff(place.edge, backward)) {
      if (meeting.turn < 0 || meeting.on_first < least || meeting.on_first >= first) continue;
      first = meeting.on_first;
      step = there;
    }
    if (step) return step;
    const int32_t v = Last(place.edge, backward);
    if (on_outline_[v]) return Step{{}, Arrival{v, true}};
    const int32_t piece = record_.edges[place.edge].piece;
    if (const auto next = Next(v, BoundaryKind::kPiece, backward, piece)) return Step{{*next, 0}, {}};
    if (Next(v, BoundaryKind::kChain, backward)) return Step{{}, Arrival{v, false}};
    return std::nullopt;
  }

  // Where an edge meets outlines of other pieces, and chains near where they begin, and where the walk goes on there.
  std::vector<std::pair<Meeting, Step>> StepsOff(int32_t edge, bool backward) const {
    Eigen::AlignedBox2d box(Flat(At(record_.edges[edge].from)));
    box.extend(Flat(At(record_.edges[edge].to)));
    box.min().array() -= kMeetTolerance;
    box.max().array() += kMeetTolerance;
    std::vector<std::pair<Meeting, Step>> steps;
    for (const int32_t f : grid_.In(box)) {
      if (record_.edges[f].piece == record_.edges[edge].piece || kinds_[f] == BoundaryKind::kOutline) continue;
      const auto meeting = Meet(edge, f, backward);
      if (!meeting) continue;
      if (kinds_[f] == BoundaryKind::kPiece) {
        steps.emplace_back(*meeting, Step{{f, meeting->on_second}, {}});
      } else if (const auto begin = BeginOf(f, backward)) {
        steps.emplace_back(*meeting, Step{{}, Arrival{*begin, on_outline_[*begin]}});
      }
    }
    return steps;
  }

  // Where the chain of an edge begins, if that is near.
  std::optional<int32_t> BeginOf(int32_t edge, bool backward) const {
    double walked = 0;
    for (int32_t e = edge; walked <= reach_; walked += LengthOf(e)) {
      const int32_t v = First(e, backward);
      const auto before = Before(e, backward);
      if (!before) return v;
      e = *before;
    }
    return std::nullopt;
  }

  const SurveyRecord& record_;
  const std::vector<BoundaryKind>& kinds_;
  const std::vector<bool>& on_outline_;
  const double reach_;
  const VertexLists leaving_, arriving_;  // the edges from, and to, each vertex
  const BinGrid grid_;
};

PieceWalk::PieceWalk(const PieceBoundary& boundary, double reach)
    : impl_(std::make_unique<const Impl>(boundary, reach)) {}

PieceWalk::~PieceWalk() = default;

std::optional<PieceWalk::Arrival> PieceWalk::From(int32_t end, bool backward) const {
  return impl_->From(end, backward);
}

}  // namespace tilemend
