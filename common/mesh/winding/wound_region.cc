#include "common/mesh/winding/wound_region.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <polyclipping/clipper.hpp>
#include <set>
#include <utility>

#include "common/mesh/bin_grid.h"
#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

using ClipperLib::Clipper;
using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

// Rounding crossings may make new ones; the second round has hardly ever any.
constexpr int kMostRounds = 6;

LatticePoint ToLattice(const IntPoint& p) { return {p.X, p.Y}; }
IntPoint ToClipper(LatticePoint p) { return {p.x, p.y}; }

// Splits directed segments into walks that close, the last step of some a straight one.
std::vector<std::vector<int32_t>> WalksOf(std::span<const DirectedEdge> segments) {
  std::map<int32_t, std::vector<int32_t>> next;
  std::map<int32_t, int> surplus;
  for (const DirectedEdge& s : segments) {
    next[s.from].push_back(s.to);
    ++surplus[s.from];
    --surplus[s.to];
  }
  std::vector<int32_t> starts;  // where chains begin that do not close: those walks come first
  for (const auto& [v, more] : surplus) {
    if (more > 0) starts.push_back(v);
  }
  for (const auto& [v, unused] : next) starts.push_back(v);
  std::vector<std::vector<int32_t>> walks;
  for (const int32_t start : starts) {
    while (!next[start].empty()) {
      std::vector<int32_t> walk = {start};
      while (!next[walk.back()].empty()) {
        std::vector<int32_t>& ways = next[walk.back()];
        const int32_t to = ways.back();
        ways.pop_back();
        if (to == start) break;
        walk.push_back(to);
      }
      walks.push_back(std::move(walk));
    }
  }
  return walks;
}

Paths PathsOf(std::span<const LatticePoint> points, std::span<const DirectedEdge> segments) {
  Paths paths;
  for (const std::vector<int32_t>& walk : WalksOf(segments)) {
    Path& path = paths.emplace_back();
    for (const int32_t v : walk) path.push_back(ToClipper(points[v]));
  }
  return paths;
}

// How far from an edge a corner is that the edge gets too.
enum class Near {
  kOnIt,     // not at all
  kRounded,  // the edge passes through the unit square about the corner, and might be rounded to it (Hobby 1999)
};

// Of a corner between the ends of an edge, lower corners first.
bool IsNear(LatticePoint a, LatticePoint b, LatticePoint corner, Near near) {
  if (near == Near::kOnIt) return Orientation(a, b, corner) == 0;
  const int64_t dx = b.x - a.x, dy = b.y - a.y;
  const int64_t area = dx * (corner.y - a.y) - dy * (corner.x - a.x);
  return 2 * std::abs(area) < std::abs(dx) + std::abs(dy);
}

// Where a corner of one loop lies near an edge of another or its own, the edge gets it too, and so it gets `corners`.
void ShareCorners(std::vector<LatticePoint> corners, Near near, Paths& loops) {
  for (const Path& loop : loops) {
    for (const IntPoint& p : loop) corners.push_back(ToLattice(p));
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (Path& loop : loops) {
    Path shared;
    for (size_t i = 0; i < loop.size(); ++i) {
      const LatticePoint a = ToLattice(loop[i]), b = ToLattice(loop[(i + 1) % loop.size()]);
      shared.push_back(loop[i]);
      const auto [lo, hi] = std::minmax(a, b);
      std::vector<LatticePoint> between;
      for (auto c = std::upper_bound(corners.begin(), corners.end(), lo); c != corners.end() && *c < hi; ++c) {
        if (IsNear(lo, hi, *c, near)) between.push_back(*c);
      }
      const auto ahead = [&](LatticePoint c) { return (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y); };
      std::ranges::sort(between, {}, ahead);
      for (const LatticePoint& c : between) shared.push_back(ToClipper(c));
    }
    loop = std::move(shared);
  }
}

// It looks at its options when paths are added. In place of ioStrictlySimple, which takes quadratic time (68 s for a
// loop of 100,000 corners), loops are cut here.
constexpr int kOptions = ClipperLib::ioPreserveCollinear;

Paths Executed(Clipper& clipper, ClipperLib::ClipType type) {
  Paths solution, simple;
  clipper.Execute(type, solution, ClipperLib::pftPositive, ClipperLib::pftPositive);
  for (const Path& path : solution) {
    std::vector<LatticePoint> corners;
    std::transform(path.begin(), path.end(), std::back_inserter(corners), ToLattice);
    for (const std::vector<LatticePoint>& loop : CutWhereItTouches<LatticePoint>(corners)) {
      if (loop.size() < 3) continue;
      std::transform(loop.begin(), loop.end(), std::back_inserter(simple.emplace_back()), ToClipper);
    }
  }
  return simple;
}

Paths Clipped(const Paths& paths, const std::optional<LatticeBox>& box, Winding winding) {
  Clipper clipper(kOptions);
  if (!box) {
    clipper.AddPaths(paths, ClipperLib::ptSubject, true);
    return Executed(clipper, ClipperLib::ctUnion);
  }
  const Path square = {ToClipper(box->lo), IntPoint(box->hi.x, box->lo.y), ToClipper(box->hi),
                       IntPoint(box->lo.x, box->hi.y)};
  const bool inside = winding == Winding::kInside;
  clipper.AddPaths(paths, inside ? ClipperLib::ptSubject : ClipperLib::ptClip, true);
  clipper.AddPath(square, inside ? ClipperLib::ptClip : ClipperLib::ptSubject, true);
  return Executed(clipper, inside ? ClipperLib::ctIntersection : ClipperLib::ctDifference);
}

std::vector<std::pair<LatticePoint, LatticePoint>> SidesOf(const Paths& loops) {
  std::vector<std::pair<LatticePoint, LatticePoint>> sides;
  for (const Path& loop : loops) {
    for (size_t i = 0; i < loop.size(); ++i) {
      sides.emplace_back(ToLattice(loop[i]), ToLattice(loop[(i + 1) % loop.size()]));
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

std::vector<LatticePoint> PointsOf(const Paths& paths) {
  std::vector<LatticePoint> points;
  for (const Path& path : paths) std::ranges::transform(path, std::back_inserter(points), ToLattice);
  return points;
}

// Rounds until nothing changes: crossings that rounding made are resolved as well.
//   points  those of the boundary: Clipper leaves some out of straight edges whatever its options
Paths Simple(const std::vector<LatticePoint>& points, Paths loops) {
  for (int round = 0; round < kMostRounds; ++round) {
    const auto before = SidesOf(loops);
    ShareCorners({}, Near::kRounded, loops);
    Clipper clipper(kOptions);
    clipper.AddPaths(loops, ClipperLib::ptSubject, true);
    loops = Executed(clipper, ClipperLib::ctUnion);
    if (SidesOf(loops) == before) break;
  }
  ShareCorners(points, Near::kOnIt, loops);
  return loops;
}

class Numberer {
 public:
  Numberer(std::span<const LatticePoint> points, std::span<const DirectedEdge> segments,
           const std::optional<LatticeBox>& box)
      : points_(points), segments_(segments), box_(box) {
    for (const DirectedEdge& s : segments) {
      joined_.insert({s.from, s.to});
      for (const int32_t v : {s.from, s.to}) at_[points[v]].insert(v);
    }
  }

  WoundRegion Run(const Paths& loops) {
    for (const Path& loop : loops) AddLoop(loop);
    return std::move(region_);
  }

 private:
  void AddLoop(const Path& loop) {
    if (loop.size() < 3) return;
    std::vector<int32_t> vertices;
    for (size_t i = 0; i < loop.size(); ++i) {
      const int32_t before = vertices.empty() ? -1 : vertices.back();
      vertices.push_back(VertexAt(ToLattice(loop[i]), before, ToLattice(loop[(i + 1) % loop.size()])));
    }
    for (size_t i = 0; i < vertices.size(); ++i) {
      region_.segments.push_back({vertices[i], vertices[(i + 1) % vertices.size()]});
    }
  }

  int32_t VertexAt(LatticePoint place, int32_t before, LatticePoint next) {
    const auto it = at_.find(place);
    if (it == at_.end()) return CornerAt(place);
    std::set<int32_t>& here = it->second;
    if (here.size() > 1) here = {ChooseFrom(here, before, next)};
    return *here.begin();
  }

  // Of several points at one place, one that a segment joins with the vertex before, or with a point at the next place.
  int32_t ChooseFrom(const std::set<int32_t>& here, int32_t before, LatticePoint next) const {
    const auto joined = std::find_if(here.begin(), here.end(), [&](int32_t v) { return Joined(before, v); });
    if (joined != here.end()) return *joined;
    const auto after = at_.find(next);
    if (after == at_.end()) return *here.begin();
    const auto goes_on = std::find_if(here.begin(), here.end(), [&](int32_t v) {
      return std::any_of(after->second.begin(), after->second.end(), [&](int32_t w) { return Joined(v, w); });
    });
    return goes_on != here.end() ? *goes_on : *here.begin();
  }

  bool Joined(int32_t a, int32_t b) const { return joined_.contains({a, b}) || joined_.contains({b, a}); }

  int32_t CornerAt(LatticePoint place) {
    const auto next = static_cast<int32_t>(points_.size() + region_.corners.size());
    const auto [it, fresh] = corner_at_.try_emplace(place, next);
    if (!fresh) return it->second;
    region_.corners.push_back({place, IsOfBox(place) ? std::vector<int32_t>{} : SegmentsThrough(place)});
    return it->second;
  }

  bool IsOfBox(LatticePoint p) const {
    return box_ && (p.x == box_->lo.x || p.x == box_->hi.x) && (p.y == box_->lo.y || p.y == box_->hi.y);
  }

  // Those within a step of the lattice, else the nearest.
  std::vector<int32_t> SegmentsThrough(LatticePoint place) {
    if (!bins_) MakeBins();
    std::vector<int32_t> through;
    const Point2 p = ToPoint(place), step(1, 1);
    for (const int32_t s : bins_->In({Point2(p - step), Point2(p + step)})) {
      if (DistanceTo(s, p) <= 1) through.push_back(s);
    }
    return through.empty() ? std::vector<int32_t>{NearestSegment(p)} : through;
  }

  int32_t NearestSegment(const Point2& p) const {
    int32_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int32_t s = 0; s < std::ssize(segments_); ++s) {
      const double distance = DistanceTo(s, p);
      if (distance >= least) continue;
      least = distance;
      nearest = s;
    }
    return nearest;
  }

  double DistanceTo(int32_t s, const Point2& p) const {
    return DistanceToSegment(p, ToPoint(points_[segments_[s].from]), ToPoint(points_[segments_[s].to]));
  }

  // Some bins for each segment.
  void MakeBins() {
    Eigen::AlignedBox2d extent;
    const auto box_of = [&](int32_t s) {
      Eigen::AlignedBox2d box(ToPoint(points_[segments_[s].from]));
      return box.extend(ToPoint(points_[segments_[s].to]));
    };
    for (int32_t s = 0; s < std::ssize(segments_); ++s) extent.extend(box_of(s));
    const double bins = std::sqrt(static_cast<double>(segments_.size()));
    bins_.emplace(extent, std::max(extent.sizes().maxCoeff() / bins, 1.0), static_cast<int32_t>(segments_.size()),
                  box_of);
  }

  static Point2 ToPoint(LatticePoint p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

  std::span<const LatticePoint> points_;
  std::span<const DirectedEdge> segments_;
  const std::optional<LatticeBox>& box_;
  std::map<LatticePoint, std::set<int32_t>> at_;
  std::set<std::pair<int32_t, int32_t>> joined_;
  std::map<LatticePoint, int32_t> corner_at_;
  std::optional<BinGrid> bins_;  // of the segments
  WoundRegion region_;
};

}  // namespace

WoundRegion FindWoundRegion(std::span<const LatticePoint> points, std::span<const DirectedEdge> segments,
                            const std::optional<LatticeBox>& box, Winding winding) {
  const Paths boundary = PathsOf(points, segments);
  const Paths loops = Simple(PointsOf(boundary), Clipped(boundary, box, winding));
  return Numberer(points, segments, box).Run(loops);
}

WoundRegion UniteWoundRegions(std::span<const LatticePoint> points, std::span<const DirectedEdge> segments,
                              size_t first_of_second, const LatticeBox& box) {
  const Paths first = PathsOf(points, segments.first(first_of_second)),
              second = PathsOf(points, segments.subspan(first_of_second));
  Clipper clipper(kOptions);
  clipper.AddPaths(first, ClipperLib::ptSubject, true);
  clipper.AddPaths(second, ClipperLib::ptClip, true);
  std::vector<LatticePoint> used = PointsOf(first), more = PointsOf(second);
  used.insert(used.end(), more.begin(), more.end());
  const Paths loops = Simple(used, Clipped(Executed(clipper, ClipperLib::ctUnion), box, Winding::kInside));
  return Numberer(points, segments, box).Run(loops);
}

std::vector<std::vector<int32_t>> LoopsBetween(std::span<const DirectedEdge> outer,
                                               std::span<const DirectedEdge> inner) {
  std::map<std::pair<int32_t, int32_t>, int> count;
  for (const DirectedEdge& e : outer) ++count[{e.from, e.to}];
  for (const DirectedEdge& e : inner) ++count[{e.to, e.from}];
  std::map<int32_t, std::vector<int32_t>> next;
  for (const auto& [edge, n] : count) {
    const auto back = count.find({edge.second, edge.first});
    const int left = n - (back == count.end() ? 0 : back->second);
    next[edge.first].insert(next[edge.first].end(), std::max(left, 0), edge.second);
  }
  std::vector<std::vector<int32_t>> loops;
  for (auto& [start, unused] : next) {
    std::vector<int32_t> walk;
    for (int32_t at = start; !next[at].empty();) {
      walk.push_back(at);
      at = next[at].back();
      next[walk.back()].pop_back();
    }
    for (std::vector<int32_t>& loop : CutWhereItTouches<int32_t>(walk)) {
      if (loop.size() > 2) loops.push_back(std::move(loop));
    }
  }
  return loops;
}

}  // namespace tilemend
