#include "coordinator/plan/seam/area_edge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "absl/strings/str_format.h"
#include "common/mesh/segment_distance.h"
#include "coordinator/plan/seam/area_ring.h"
#include "coordinator/plan/seam/seam_path.h"

namespace tilemend {
namespace {

using Ring = std::vector<Point2>;

constexpr double kHair = 1e-6;  // metres: a point this far beside an edge tells its sides apart
// A place on the polygon: the ring and how far along it, in its segments.
struct RingPlace {
  size_t ring = 0;
  double at = 0;
};

// A rim edge that passes the polygon's edge.
struct Passing {
  double at;     // along the ring
  int32_t edge;  // of the rim
  bool leaving;  // the rim goes out of the polygon
};

Point2 RightOf(const Point2& a, const Point2& b) {
  const Point2 d = (b - a).normalized();
  return {d.y(), -d.x()};
}

const Point2& After(const Ring& ring, size_t i) { return ring[(i + 1) % ring.size()]; }

// Whether an oriented ring has the outside within.
bool TakesAway(const Ring& ring) {
  double doubled = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i] - ring[0], b = After(ring, i) - ring[0];
    doubled += a.x() * b.y() - a.y() * b.x();
  }
  return doubled > 0;
}

// The square on the right of an edge, where the hole lies.
CellId CellBeside(const Grid& grid, const Point2& a, const Point2& b) {
  const Point2 p = (a + b) / 2 + kOnLine * RightOf(a, b);
  const Point2 at = (p - grid.corner).cwiseQuotient(grid.cell_size);
  return {static_cast<int32_t>(std::floor(at.x())), static_cast<int32_t>(std::floor(at.y()))};
}

// The polygon of the area.
class AreaPolygon {
 public:
  AreaPolygon(const PlanePolygon& area, const SeamSite& site) : area_{OrientedRings(area, site)} {}

  const std::vector<Ring>& rings() const { return area_.rings; }

  bool IsInside(const Point2& p) const { return Contains(area_, p) && NearestPlace(p).second > kOnLine; }

  // Halving finds the place also where a vertex of the surface lies on the polygon.
  RingPlace PassingPlace(Point2 inner, Point2 outer) const {
    while ((outer - inner).norm() > kHair) {
      const Point2 middle = (inner + outer) / 2;
      (IsInside(middle) ? inner : outer) = middle;
    }
    return NearestPlace(inner).first;
  }

 private:
  // The nearest place on the polygon, and how far p is from it.
  std::pair<RingPlace, double> NearestPlace(const Point2& p) const {
    RingPlace best;
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t r = 0; r < rings().size(); ++r) {
      for (size_t i = 0; i < rings()[r].size(); ++i) {
        const Point2 &a = rings()[r][i], &b = After(rings()[r], i);
        const Point2 d = b - a;
        const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
        const double distance = (p - a - t * d).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        best = {r, static_cast<double>(i) + t};
      }
    }
    return {best, nearest};
  }

  const PlanePolygon area_;
};

// The numbers of new points of the rim.
std::vector<int32_t> AddPoints(const std::vector<RingVertex>& vertices, Rim& rim) {
  std::vector<int32_t> numbers;
  for (const RingVertex& v : vertices) {
    RimPoint point;
    point.index = -1;
    point.position = Point3(v.position.x(), v.position.y(), 0);
    point.size = v.size;
    numbers.push_back(static_cast<int32_t>(rim.points.size()));
    rim.points.push_back(point);
  }
  return numbers;
}

class AreaCutter {
 public:
  AreaCutter(const SeamSite& site, const PlanInput& input)
      : site_(site), input_(input), spacer_(site), polygon_(input.area, site), rings_(polygon_.rings()) {
    result_.rim = site.rim;
  }

  AreaCut Run() {
    SortEdges();
    for (size_t r = 0; r < rings_.size(); ++r) FollowRing(r);
    std::vector<RimEdge> edges;
    for (size_t e = 0; e < keeps_.size(); ++e) {
      if (keeps_[e]) edges.push_back(site_.rim.edges[e]);
    }
    edges.insert(edges.end(), chains_.begin(), chains_.end());
    result_.rim.edges = std::move(edges);
    result_.rim.surface_beyond = true;
    LinkLoops(result_.rim);
    return std::move(result_);
  }

 private:
  Point2 PositionOf(int32_t v) const { return result_.rim.points[v].position.head<2>(); }

  // Which edges stay, and those that pass the polygon by ring.
  void SortEdges() {
    std::vector<bool> inside;
    for (const RimPoint& p : site_.rim.points) inside.push_back(polygon_.IsInside(p.position.head<2>()));
    passings_.resize(rings_.size());
    for (size_t e = 0; e < site_.rim.edges.size(); ++e) {
      const RimEdge& edge = site_.rim.edges[e];
      keeps_.push_back(inside[edge.from] || inside[edge.to]);
      if (inside[edge.from] == inside[edge.to]) continue;
      const RingPlace place = polygon_.PassingPlace(PositionOf(inside[edge.from] ? edge.from : edge.to),
                                                    PositionOf(inside[edge.from] ? edge.to : edge.from));
      passings_[place.ring].push_back({place.at, static_cast<int32_t>(e), inside[edge.from]});
    }
    for (auto& of_ring : passings_) {
      std::sort(of_ring.begin(), of_ring.end(),
                [](const Passing& a, const Passing& b) { return std::tie(a.at, a.edge) < std::tie(b.at, b.edge); });
    }
  }

  void FollowRing(size_t r) {
    const std::vector<Passing>& passings = passings_[r];
    const auto n = static_cast<double>(rings_[r].size());
    if (passings.empty()) {
      if (!site_.index.InSurface(rings_[r][0], kOnLine)) FollowWhole(r);
      return;
    }
    for (size_t i = 0; i < passings.size(); ++i) {
      const Passing& begin = passings[i];
      const Passing& end = passings[(i + 1) % passings.size()];
      if (!begin.leaving) continue;
      const double last = i + 1 < passings.size() ? end.at : end.at + n;
      if (end.leaving || !Follow(r, begin, last, end)) Leave(begin);
    }
  }

  void Leave(const Passing& at) {
    const RimEdge& e = site_.rim.edges[at.edge];
    const Point2 p = PositionOf(e.from);
    result_.left.push_back(
        {e.owner,
         absl::StrFormat("at (%.3f, %.3f) the edge of the area cannot be followed through the hole", p.x(), p.y())});
  }

  // Lays a chain from one passing to the next. Ends outside the polygon first, then those inside.
  bool Follow(size_t r, const Passing& begin, double last, const Passing& end) {
    const RimEdge &out = site_.rim.edges[begin.edge], &in = site_.rim.edges[end.edge];
    const std::vector<int32_t> between = NewVertices(r, begin.at, last);
    for (const auto& [from, to] : {std::pair(out.to, in.from), std::pair(out.from, in.from), std::pair(out.to, in.to),
                                   std::pair(out.from, in.to)}) {
      if (from == out.from && to == in.to && begin.edge == end.edge) continue;
      if (from == to) return Keep(begin, from == out.to, end, to == in.from);
      std::vector<int32_t> way = {from};
      way.insert(way.end(), between.begin(), between.end());
      way.push_back(to);
      if (!AddChain(way)) continue;
      return Keep(begin, from == out.to, end, to == in.from);
    }
    return false;
  }

  bool Keep(const Passing& begin, bool keep_begin, const Passing& end, bool keep_end) {
    if (!keep_begin) keeps_[begin.edge] = false;
    if (!keep_end) keeps_[end.edge] = false;
    return true;
  }

  // A ring wholly inside a hole: beyond the end of the surface, or a part of a hole that the area leaves out.
  void FollowWhole(size_t r) {
    if (TakesAway(rings_[r])) {
      const Point2& p = rings_[r][0];
      result_.left.push_back(
          {CellBeside(input_.grid, p, After(rings_[r], 0)),
           absl::StrFormat("at (%.3f, %.3f) the area leaves out a part inside a hole: it is filled", p.x(), p.y())});
      return;
    }
    std::vector<int32_t> way = AddPoints(spacer_.Around(rings_[r]), result_.rim);
    way.push_back(way.front());
    AddChain(way);
  }

  bool AddChain(const std::vector<int32_t>& way) {
    const auto position = [this](int32_t v) { return PositionOf(v); };
    const auto path = FindSeamPath(way, site_.rim, site_.index, position);
    if (!path) return false;
    const auto rim_points = static_cast<int32_t>(site_.rim.points.size());
    for (size_t i = 0; i + 1 < path->size(); ++i) {
      const int32_t p = (*path)[i], q = (*path)[i + 1];
      const int32_t e = p < rim_points && q < rim_points ? site_.index.EdgeBetween(p, q) : -1;
      if (e >= 0) {  // with the rim the rim itself bounds the hole; against it nothing lies between
        keeps_[e] = site_.rim.edges[e].from == p;
        continue;
      }
      chains_.push_back({p, q, CellBeside(input_.grid, PositionOf(p), PositionOf(q)), true});
    }
    return true;
  }

  // New vertices along a ring between two places on it.
  std::vector<int32_t> NewVertices(size_t r, double begin, double end) {
    const Ring& ring = rings_[r];
    const auto at = [&](double t) -> Point2 {
      const auto i = static_cast<size_t>(std::floor(t + static_cast<double>(ring.size()))) % ring.size();
      return ring[i] + (t - std::floor(t)) * (After(ring, i) - ring[i]);
    };
    std::vector<Point2> corners = {at(begin)};
    for (double t = std::floor(begin) + 1; t < end; ++t) corners.push_back(at(t));
    corners.push_back(at(end));
    return AddPoints(spacer_.Along(corners), result_.rim);
  }

  const SeamSite& site_;
  const PlanInput& input_;
  const RingSpacer spacer_;
  const AreaPolygon polygon_;
  const std::vector<Ring>& rings_;              // of the polygon
  std::vector<bool> keeps_;                     // by rim edge
  std::vector<std::vector<Passing>> passings_;  // by ring
  std::vector<RimEdge> chains_;
  AreaCut result_;
};

}  // namespace

AreaCut CutByArea(const SeamSite& site, const PlanInput& input) { return AreaCutter(site, input).Run(); }

}  // namespace tilemend
