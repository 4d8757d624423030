#include "coordinator/plan/overlap/outline_walk.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "common/mesh/vertex_lists.h"
#include "coordinator/plan/overlap/closed_runs.h"
#include "coordinator/plan/overlap/piece_ends.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

constexpr double kApart = 2e-2;  // metres: so far beyond another one a way comes to the outline
constexpr double kOverlaps = 8;  // the surface of a piece ends at most so many reaches before that of the next begins

// Edges that a way follows at either end. Each vertex of the one end is compared with those of the other, so it bounds
// their pairs to a million where the outline of a piece has edges of a centimetre.
constexpr int64_t kMostFollowed = 1000;

// A vertex where a chain off the outline ends or begins, seen along the walk.
struct Event {
  double place = 0;
  int32_t vertex = 0;
  bool ends = false;  // surface ends here: counter-clockwise of it there is one layer less
  bool on_outline = false;
  std::optional<int> across = {};  // as OutlineGap::from_across
};

// Of the outline, with as much surface all along.
struct Stretch {
  double begin = 0, end = 0;
  int layers = 0;
};

// Where there is surface, metres. Edges of neighbouring faces may end a hair apart: a short stretch without surface
// says nothing.
double LengthCovered(const std::vector<Stretch>& stretches) {
  double covered = 0;
  for (const Stretch& s : stretches) covered += s.layers > 0 ? s.end - s.begin : 0;
  return covered;
}

// A vertex on the outline of a piece, and how it is reached.
struct OutlineStep {
  int32_t vertex = 0, edge = -1;  // the edge comes there; -1: it is the first vertex
  double way = 0;                 // metres from the first vertex
};

// The axis across an edge that is level with one.
std::optional<int> AxisAcross(const SurveyRecord& record, const BoundaryEdge& e) {
  const Point3 way = record.vertices[e.to].position - record.vertices[e.from].position;
  const bool of_x = std::abs(way.x()) <= kMeetTolerance, of_y = std::abs(way.y()) <= kMeetTolerance;
  return of_x == of_y ? std::nullopt : std::optional(of_x ? 0 : 1);
}

// Edges on outlines of pieces. Each is in one way at most.
class OutlineWays {
 public:
  OutlineWays(const SurveyRecord& record, const std::vector<bool>& taken)
      : record_(record),
        leaving_(EdgesBy(taken, [](const BoundaryEdge& e) { return e.from; })),
        arriving_(EdgesBy(taken, [](const BoundaryEdge& e) { return e.to; })),
        is_used_(record.edges.size(), false) {}

  // Where outlines run along the way between two chains, it goes along them: as short as can be, if their edges count
  // less than what lies between them. Edges that an earlier way has taken are in the way of this one.
  void Follow(OutlineGap& gap) {
    double least = (At(gap.to) - At(gap.from)).norm();
    const std::vector<OutlineStep> after = From(gap.to, false, least), before = From(gap.from, true, least);
    std::pair<size_t, size_t> best{0, 0};
    for (size_t i = 0; i < after.size(); ++i) {
      for (size_t k = 0; k < before.size(); ++k) {
        const double along = kOutlineWeight * (after[i].way + before[k].way);
        if (along >= least) break;
        const double length = along + (At(after[i].vertex) - At(before[k].vertex)).norm();
        if (length >= least) continue;
        least = length;
        best = {i, k};
      }
    }
    for (size_t i = 1; i <= best.first; ++i) Take(after[i].edge, gap);
    for (size_t k = 1; k <= best.second; ++k) Take(before[k].edge, gap);
    gap.link = {before[best.second].vertex, after[best.first].vertex};
    if (best.first > 0) gap.to_across = AxisAcross(record_, record_.edges[after[best.first].edge]);
    if (best.second > 0) gap.from_across = AxisAcross(record_, record_.edges[before[best.second].edge]);
  }

 private:
  const Point3& At(int32_t v) const { return record_.vertices[v].position; }

  void Take(int32_t edge, OutlineGap& gap) {
    gap.along.push_back(edge);
    is_used_[edge] = true;
  }

  // From a vertex along the edges or against them, until they divide, one is used, or the way counts as much as
  // `longest`.
  std::vector<OutlineStep> From(int32_t v, bool backward, double longest) const {
    std::vector<OutlineStep> steps = {{v}};
    while (kOutlineWeight * steps.back().way < longest && std::ssize(steps) <= kMostFollowed) {
      const auto on = (backward ? arriving_ : leaving_).Of(steps.back().vertex);
      if (on.size() != 1 || is_used_[on[0]]) break;
      const auto& [from, to, piece] = record_.edges[on[0]];
      steps.push_back({backward ? from : to, on[0], steps.back().way + (At(to) - At(from)).norm()});
    }
    return steps;
  }

  template <typename EndOf>
  VertexLists EdgesBy(const std::vector<bool>& taken, const EndOf& end_of) const {
    return {record_.vertices.size(), [&](const auto& use) {
              for (int32_t e = 0; e < std::ssize(record_.edges); ++e) {
                if (!taken[e]) use(end_of(record_.edges[e]), e);
              }
            }};
  }

  const SurveyRecord& record_;
  const VertexLists leaving_, arriving_;
  std::vector<bool> is_used_;  // of each edge
};

class Walker {
 public:
  Walker(const SurveyRecord& record, const std::vector<bool>& taken, const Outline& outline, double piece_reach)
      : record_(record), taken_(taken), outline_(outline), piece_reach_(piece_reach) {}

  OutlineWalk Run(const std::vector<ChainPassage>& passages) {
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      walk_.on_outline.push_back(taken_[e] && SideOf(record_.edges[e]).has_value());
    }
    FindEvents();
    CloseAtPieces(passages);
    SortEvents();
    CountLayers();
    OrderWherePiecesOverlap();
    if (events_.empty()) {
      walk_.all_open = LengthCovered(stretches_) < outline_.Length() / 2;
    } else {
      const size_t at_pieces = walk_.gaps.size();
      CloseUpperSheets();
      Match();
      JoinClosedRuns(record_, walk_.on_outline, outline_, std::span(walk_.gaps).subspan(at_pieces));
    }
    return std::move(walk_);
  }

 private:
  std::optional<Side> SideOf(const BoundaryEdge& e) const {
    const Point3 &a = record_.vertices[e.from].position, &b = record_.vertices[e.to].position;
    for (const Side s : kSides) {
      if (Reaches(a, s) && Reaches(b, s)) return s;
    }
    return std::nullopt;
  }

  bool Reaches(const Point3& p, Side s) const {
    return (p[AxisOf(s)] - outline_.side[s]) * OutwardOf(s) >= -kMeetTolerance;
  }

  void FindEvents() {
    std::map<int32_t, int> leaving;                  // chains that begin there, less those that end
    std::map<int32_t, std::optional<int>> at_piece;  // vertices where a piece ends: the axis across its outline
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      const auto [from, to, piece] = record_.edges[e];
      if (!taken_[e]) {
        for (const int32_t v : {from, to})
          at_piece[v] = at_piece[v] ? at_piece[v] : AxisAcross(record_, record_.edges[e]);
      }
      if (!taken_[e] || walk_.on_outline[e]) continue;
      ++leaving[from];
      --leaving[to];
    }
    for (const auto& [v, more] : leaving) {
      const std::optional<Side> side = outline_.SideAt(record_.vertices[v].position);
      const auto piece = at_piece.find(v);
      Event event{PlaceOf(v), v, more > 0, side.has_value()};
      if (side) event.across = AxisOf(*side);
      if (!side && piece != at_piece.end()) event.across = piece->second;
      std::vector<Event>& events = side && piece == at_piece.end() ? events_ : piece_ends_;
      for (int k = 0; k < std::abs(more); ++k) events.push_back(event);
    }
  }

  // What ends where a piece does goes on at another chain, or counts to the outline.
  void CloseAtPieces(const std::vector<ChainPassage>& passages) {
    if (piece_ends_.empty()) return;
    PieceBoundary boundary{record_, {}, {}, passages};
    for (size_t e = 0; e < taken_.size(); ++e) boundary.in_chain.push_back(taken_[e] && !walk_.on_outline[e]);
    for (const BoundaryVertex& v : record_.vertices) {
      boundary.on_outline.push_back(outline_.SideAt(v.position).has_value());
    }
    std::vector<PieceEnd> ends;
    for (const Event& event : piece_ends_) ends.push_back({event.vertex, event.ends});
    const PieceMatches matches = MatchPieceEnds(boundary, ends, piece_reach_);
    OutlineWays ways(record_, taken_);
    for (const auto& [begin, end] : matches.pairs) {
      const Event &from = piece_ends_[begin], &to = piece_ends_[end];
      OutlineGap gap{from.vertex, to.vertex, 0, 0, false, from.across, to.across};
      ways.Follow(gap);
      walk_.gaps.push_back(std::move(gap));
    }
    for (const auto& [end, at] : matches.on_outline) {
      Event& event = events_.emplace_back(piece_ends_[end]);
      if (!at) continue;
      const Point3 there(at->x(), at->y(), 0);
      const double place = outline_.PlaceOf(there, outline_.NearestSide(there));
      if (std::abs(place - event.place) > kOverlaps * piece_reach_) event.place = place;  // else straight on to it
    }
  }

  double PlaceOf(int32_t v) const {
    const Point3& p = record_.vertices[v].position;
    return outline_.PlaceOf(p, outline_.SideAt(p).value_or(outline_.NearestSide(p)));
  }

  void SortEvents() {
    std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
      return std::tuple(a.place, !a.ends, a.vertex) < std::tuple(b.place, !b.ends, b.vertex);
    });
  }

  void CountLayers() {
    std::map<double, int> step;  // how many more layers there are from a place on
    step[0] = 0;
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      if (!walk_.on_outline[e]) continue;
      const BoundaryEdge& edge = record_.edges[e];
      const Side side = *SideOf(edge);
      for (const auto& [v, more] : {std::pair(edge.from, 1), std::pair(edge.to, -1)}) {
        const double place = outline_.PlaceOf(record_.vertices[v].position, side);
        step[side == kWest && place == 0 ? outline_.Length() : place] += more;
      }
    }
    int layers = 0;
    for (auto it = step.begin(); it != step.end(); ++it) {
      const double end = std::next(it) == step.end() ? outline_.Length() : std::next(it)->first;
      layers += it->second;
      if (end > it->first) stretches_.push_back({it->first, end, layers});
    }
  }

  // `place`, or the same one round farther, not before `from`.
  double Beyond(double from, double place) const { return place < from ? place + outline_.Length() : place; }

  // Calls visit(layers, length) for the stretches of the outline from one event to another.
  template <typename Visit>
  void VisitBetween(const Event& from, const Event& to, Visit visit) const {
    const double to_place = Beyond(from.place, to.place), length = outline_.Length();
    for (const double round : {0.0, length}) {
      auto it = std::upper_bound(stretches_.begin(), stretches_.end(), from.place - round,
                                 [](double place, const Stretch& s) { return place < s.end; });
      for (; it != stretches_.end() && it->begin + round < to_place; ++it) {
        visit(it->layers, std::min(it->end + round, to_place) - std::max(it->begin + round, from.place));
      }
    }
  }

  // A sheet that begins and ends over other surface is closed for itself: it is the top of something.
  void CloseUpperSheets() {
    for (size_t i = 0; i + 1 < events_.size();) {
      const Event begin = events_[i], end = events_[i + 1];
      int fewest = begin.ends || !end.ends ? 0 : std::numeric_limits<int>::max();
      VisitBetween(begin, end, [&](int layers, double) { fewest = std::min(fewest, layers); });
      if (fewest < 2 || fewest == std::numeric_limits<int>::max()) {
        ++i;
        continue;
      }
      walk_.gaps.push_back({end.vertex, begin.vertex, 0, 0, false});
      events_.erase(events_.begin() + static_cast<ptrdiff_t>(i), events_.begin() + static_cast<ptrdiff_t>(i) + 2);
      i -= i > 0;
    }
  }

  // Where two pieces overlap, the surface of one may end a hair before that of the other begins, though there was none
  // between the end of the last one and there: the other one comes first.
  void OrderWherePiecesOverlap() {
    for (size_t i = 1; i + 1 < events_.size(); ++i) {
      const Event& last = events_[i - 1];
      Event &end = events_[i], &begin = events_[i + 1];
      const bool is_of_pieces = !end.on_outline || !begin.on_outline;
      const bool is_near = begin.place - end.place <= kOverlaps * piece_reach_;
      if (!last.ends || !end.ends || begin.ends || !is_of_pieces || !is_near || !IsUncovered(last, end)) continue;
      // The two ways then part where the surface ends: none runs beside the other.
      if (end.on_outline) {
        begin.place = std::max(end.place - kApart, last.place);
      } else {
        end.place = std::min(begin.place + kApart, i + 2 < events_.size() ? events_[i + 2].place : outline_.Length());
      }
      std::swap(end, begin);
    }
  }

  // How much of the way from one event to another has no surface, where that is most of it; else 0.
  double LengthUncovered(const Event& from, const Event& to) const {
    double empty = 0, all = 0;
    VisitBetween(from, to, [&](int layers, double length) {
      all += length;
      if (layers == 0) empty += length;
    });
    return empty > all / 2 ? empty : 0;
  }
  bool IsUncovered(const Event& from, const Event& to) const { return LengthUncovered(from, to) > 0; }

  // Goes around from where most layers are, so that every end has its beginning behind it.
  void Match() {
    const size_t n = events_.size();
    int layers = 0, most = std::numeric_limits<int>::min();
    size_t start = 0;
    for (size_t i = 0; i < n; ++i) {
      layers += events_[i].ends ? -1 : 1;
      if (layers <= most) continue;
      most = layers;
      start = i;
    }
    struct End {
      size_t event;
      std::vector<size_t> inner;  // open gaps between it and its beginning
    };
    std::vector<End> ends;
    for (size_t k = 1; k <= n; ++k) {
      const size_t i = (start + k) % n;
      if (events_[i].ends) {
        ends.push_back({i, {}});
        continue;
      }
      if (ends.empty()) continue;
      const Event &from = events_[ends.back().event], &to = events_[i];
      std::vector<size_t> inner = std::move(ends.back().inner);
      ends.pop_back();
      const bool open = IsOpen(from, to, inner);
      if (open) inner = {walk_.gaps.size()};
      walk_.gaps.push_back(
          {from.vertex, to.vertex, from.place, Beyond(from.place, to.place), open, from.across, to.across});
      if (!ends.empty()) ends.back().inner.insert(ends.back().inner.end(), inner.begin(), inner.end());
    }
  }

  // Of two gaps, one in the other, one is open. It is the inner one, as where something lies in the water at the
  // outline, unless that is but a small part of the way: two pieces that end there one beyond the other.
  bool IsOpen(const Event& from, const Event& to, const std::vector<size_t>& inner) {
    const double uncovered = LengthUncovered(from, to);
    double in_inner = 0;
    for (const size_t gap : inner) in_inner += walk_.gaps[gap].end - walk_.gaps[gap].begin;
    if (uncovered <= 2 * in_inner) return uncovered > 0 && inner.empty();
    for (const size_t gap : inner) walk_.gaps[gap].open = false;
    return true;
  }

  const SurveyRecord& record_;
  const std::vector<bool>& taken_;
  const Outline& outline_;
  const double piece_reach_;
  std::vector<Event> events_;      // along the outline
  std::vector<Event> piece_ends_;  // where pieces end
  std::vector<Stretch> stretches_;
  OutlineWalk walk_;
};

}  // namespace

double Outline::PlaceOf(const Point3& p, Side s) const {
  const double x = std::clamp(p.x(), side[kWest], side[kEast]) - side[kWest];
  const double y = std::clamp(p.y(), side[kSouth], side[kNorth]) - side[kSouth];
  switch (s) {
    case kSouth:
      return x;
    case kEast:
      return Width() + y;
    case kNorth:
      return Width() + Height() + (Width() - x);
    case kWest:
      break;
  }
  const double place = 2 * Width() + Height() + (Height() - y);
  return place < Length() ? place : 0;
}

std::pair<Point2, Side> Outline::At(double place) const {
  double along = std::fmod(place, Length());
  if (along <= Width()) return {{side[kWest] + along, side[kSouth]}, kSouth};
  along -= Width();
  if (along <= Height()) return {{side[kEast], side[kSouth] + along}, kEast};
  along -= Height();
  if (along <= Width()) return {{side[kEast] - along, side[kNorth]}, kNorth};
  return {{side[kWest], side[kNorth] - (along - Width())}, kWest};
}

double Outline::CornerPlace(int corner) const {
  return (corner > 0 ? Width() : 0) + (corner > 1 ? Height() : 0) + (corner > 2 ? Width() : 0);
}

Point2 Outline::CornerAt(int corner) const {
  return {side[corner == 1 || corner == 2 ? kEast : kWest], side[corner > 1 ? kNorth : kSouth]};
}

std::optional<Side> Outline::SideAt(const Point3& p) const {
  for (const Side s : kSides) {
    if ((p[AxisOf(s)] - side[s]) * OutwardOf(s) >= -kMeetTolerance) return s;
  }
  return std::nullopt;
}

Side Outline::NearestSide(const Point3& p) const {
  const auto inside = [&](Side s) { return (side[s] - p[AxisOf(s)]) * OutwardOf(s); };
  return *std::min_element(kSides.begin(), kSides.end(), [&](Side a, Side b) { return inside(a) < inside(b); });
}

OutlineWalk WalkOutline(const SurveyRecord& record, const std::vector<bool>& taken, const Outline& outline,
                        double piece_reach, const std::vector<ChainPassage>& passages) {
  return Walker(record, taken, outline, piece_reach).Run(passages);
}

}  // namespace tilemend
