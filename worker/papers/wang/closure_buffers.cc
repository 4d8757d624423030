#include "worker/papers/wang/closure_buffers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "common/mesh/bin_grid.h"
#include "common/mesh/exact_signs.h"
#include "common/mesh/rounding.h"
#include "common/mesh/segment_distance.h"
#include "worker/papers/wang/grid_stretches.h"

namespace tilemend {
namespace {

constexpr double kOnLine = 1e-3;         // metres
constexpr double kLeastWidth = 0.5;      // of the boundary's edges
constexpr double kPointClearance = 0.4;  // of the width
constexpr double kEdgeClearance = 0.2;   // likewise
constexpr double kLongestEdge = 4;       // likewise

using Segment2 = std::pair<Point2, Point2>;

double Distance(const Segment2& a, const Segment2& b) {
  const bool cross = TurnOf(a.first, a.second, b.first) * TurnOf(a.first, a.second, b.second) < 0 &&
                     TurnOf(b.first, b.second, a.first) * TurnOf(b.first, b.second, a.second) < 0;
  if (cross) return 0;
  return std::min({DistanceToSegment(a.first, b.first, b.second), DistanceToSegment(a.second, b.first, b.second),
                   DistanceToSegment(b.first, a.first, a.second), DistanceToSegment(b.second, a.first, a.second)});
}

// What a joint says: how wide the buffer is there, and from which boundary point on.
struct Joint {
  ClosureCase closure;
  double width;
  int32_t anchor;
};

// A point of a buffer's boundary.
struct BufferPoint {
  int at;  // of the stretch's vertices, opposite it
  Point3 position;
  double width;         // of the buffer there
  int32_t number = -1;  // once an edge needs it

  Point2 place() const { return position.head<2>(); }
};

// How wide the buffer is along a stretch.
class Widths {
 public:
  void Add(double t, double width) { knots_[t] = width; }
  bool empty() const { return knots_.empty(); }

  double At(double t) const {
    const auto next = knots_.lower_bound(t);
    if (next == knots_.begin()) return next->second;
    const auto before = std::prev(next);
    if (next == knots_.end()) return before->second;
    const double share = (t - before->first) / (next->first - before->first);
    return before->second + share * (next->second - before->second);
  }

 private:
  std::map<double, double> knots_;  // by place along the line
};

class BufferLayer {
 public:
  explicit BufferLayer(const LocalHole& hole) : hole_(hole), walls_(WallsOf(hole)), near_(IndexWalls()) {}

  ClosureBuffers Run() {
    std::vector<GridStretch> stretches = StretchesAround(hole_);
    MoveToNeighbours(hole_, stretches);
    for (const GridStretch& stretch : stretches) Lay(stretch);
    return std::move(result_);
  }

 private:
  static std::vector<RegionSegment> WallsOf(const LocalHole& hole) {
    std::vector<RegionSegment> walls = hole.segments;
    walls.insert(walls.end(), hole.inner_edges.begin(), hole.inner_edges.end());
    return walls;
  }

  BinGrid IndexWalls() const {
    Eigen::AlignedBox2d extent;
    double length = 0;
    for (const RegionSegment& s : walls_) {
      extent.extend(PlaceOf(s.from));
      length += (PlaceOf(s.to) - PlaceOf(s.from)).norm();
    }
    const auto count = static_cast<int32_t>(walls_.size());
    // No more bins than a few for each segment, however long and thin the hole is.
    const double least = extent.sizes().maxCoeff() / (4 * std::sqrt(static_cast<double>(count)) + 1);
    return BinGrid(extent, std::max({length / count, least, kOnLine}), count, [&](int32_t i) {
      return BoxOf({PlaceOf(walls_[i].from), PlaceOf(walls_[i].to)}, 0);
    });
  }

  static Eigen::AlignedBox2d BoxOf(const Segment2& s, double reach) {
    Eigen::AlignedBox2d box(s.first.cwiseMin(s.second), s.first.cwiseMax(s.second));
    box.min() -= Point2::Constant(reach);
    box.max() += Point2::Constant(reach);
    return box;
  }

  bool IsOriginal(int32_t v) const {
    const int32_t k = hole_.vertices[v];
    return k >= 0 && hole_.cell->vertices[k].index >= 0;
  }

  // Cases 1 and 2: at the end of a stretch, where `boundary` goes on from it.
  std::optional<Joint> JointAt(const GridStretch& s, int32_t end, const std::vector<int32_t>& boundary) const {
    if (!IsOriginal(end) || boundary.empty()) return std::nullopt;
    const int32_t beside = boundary.front();
    const double off = s.OffLine(PlaceOf(end)), off_beside = s.OffLine(PlaceOf(beside));
    if (off > kOnLine) return Joint{ClosureCase::kAcross, Wide(off, end), end};
    if (!IsOriginal(beside) || off_beside <= kOnLine) return std::nullopt;
    return Joint{off < -kOnLine ? ClosureCase::kAcross : ClosureCase::kOnLine, Wide(off_beside, end), beside};
  }

  // Case 3: where the stretch passes a point of the other cell's surface boundary.
  std::optional<Joint> TouchAt(const GridStretch& s, int32_t v) const {
    if (!IsOriginal(v)) return std::nullopt;
    double sum = 0;
    const std::vector<Point2> beside = BoundaryNeighbors(v);
    for (const Point2& p : beside) {
      if (s.OffLine(p) >= -kOnLine) return std::nullopt;
      sum -= s.OffLine(p);
    }
    if (beside.empty()) return std::nullopt;
    return Joint{ClosureCase::kTouching, Wide(sum / static_cast<double>(beside.size()), v), -1};
  }

  // The ends of the edges at a vertex that one original triangle has.
  std::vector<Point2> BoundaryNeighbors(int32_t v) const {
    const TriMesh& band = hole_.cell->band;
    std::map<int32_t, int> uses;
    for (const int32_t t : hole_.band->At(hole_.vertices[v])) {
      for (const int32_t corner : band.triangles[t]) ++uses[corner];
    }
    std::vector<Point2> places;
    for (const auto& [corner, count] : uses) {
      if (count == 1 && corner != hole_.vertices[v]) places.emplace_back(band.points[corner].head<2>());
    }
    return places;
  }

  double Wide(double width, int32_t at) const { return std::max(width, kLeastWidth * EdgeAt(at)); }

  // Mean length of the original edges at a vertex of the boundary.
  double EdgeAt(int32_t v) const {
    const TriMesh& band = hole_.cell->band;
    const std::vector<int32_t>& around = hole_.band->At(hole_.vertices[v]);
    double sum = 0;
    int count = 0;
    for (const int32_t t : around) {
      for (const int32_t corner : band.triangles[t]) {
        if (corner == hole_.vertices[v]) continue;
        sum += (band.points[corner].head<2>() - PlaceOf(v)).norm();
        ++count;
      }
    }
    return count == 0 ? 0 : sum / count;
  }

  void Lay(const GridStretch& s) {
    const auto first = JointAt(s, s.vertices.front(), s.before), last = JointAt(s, s.vertices.back(), s.after);
    Widths widths;
    const auto add = [&](int32_t v, const std::optional<Joint>& joint) {
      if (!joint) return;
      widths.Add(PlaceOf(v)[1 - s.axis], joint->width);
      result_.joints.push_back(joint->closure);
    };
    add(s.vertices.front(), first);
    for (size_t i = 1; i + 1 < s.vertices.size(); ++i) add(s.vertices[i], TouchAt(s, s.vertices[i]));
    add(s.vertices.back(), last);
    if (!widths.empty()) LayPoints(s, widths, first ? first->anchor : -1, last ? last->anchor : -1);
  }

  // The points opposite those of the stretch, the edges between those that follow one another, and those to its joints.
  void LayPoints(const GridStretch& s, const Widths& widths, int32_t first_anchor, int32_t last_anchor) {
    std::vector<BufferPoint> points;
    for (int i = 1; i + 1 < std::ssize(s.vertices); ++i) {
      const double width = widths.At(PlaceOf(s.vertices[i])[1 - s.axis]);
      if (const auto p = PointOpposite(s, s.vertices[i], width)) points.push_back({i, *p, width});
    }
    if (points.empty()) return;
    const size_t laid_before = result_.edges.size();
    for (size_t k = 0; k + 1 < points.size(); ++k) {
      BufferPoint &a = points[k], &b = points[k + 1];
      const bool follow = b.at == a.at + 1;
      if (!follow || !IsClear({a.place(), b.place()}, -1, std::min(a.width, b.width))) continue;
      const int32_t from = Number(s, a);
      AddEdge(from, Number(s, b));
    }
    Tie(s, first_anchor, points.front(), -s.way);
    Tie(s, last_anchor, points.back(), s.way);
    for (size_t e = laid_before; e < result_.edges.size(); ++e) {
      laid_.emplace_back(EndOf(result_.edges[e].from), EndOf(result_.edges[e].to));
    }
  }

  // Closes the buffer to the point of the surface boundary that it begins or ends at, which lies this way along the
  // line.
  void Tie(const GridStretch& s, int32_t anchor, BufferPoint& p, double way) {
    if (anchor < 0 || (PlaceOf(anchor)[1 - s.axis] - p.place()[1 - s.axis]) * way <= 0) return;
    if (IsClear({PlaceOf(anchor), p.place()}, anchor, p.width)) AddEdge(anchor, Number(s, p));
  }

  // Its number in the patch; it gets one now if it has none.
  int32_t Number(const GridStretch& s, BufferPoint& p) {
    if (p.number >= 0) return p.number;
    result_.points.push_back(p.position);
    result_.sizes.push_back(hole_.sizes[s.vertices[p.at]]);
    return p.number = hole_.size() + static_cast<int32_t>(result_.points.size()) - 1;
  }

  Point2 EndOf(int32_t v) const {
    return v < hole_.size() ? PlaceOf(v) : Point2(result_.points[v - hole_.size()].head<2>());
  }

  std::optional<Point3> PointOpposite(const GridStretch& s, int32_t v, double width) const {
    Point3 p = hole_.positions[v];
    p[s.axis] = s.line + s.own * width;
    p.head<2>() = RoundedToLattice(Point2(p.head<2>()), hole_.cell->lattice_step);
    const Point2 place = p.head<2>();
    if (NearestOther({place, place}, -1, kPointClearance * width) < kPointClearance * width) return std::nullopt;
    // In the hole, and seen from the grid boundary.
    if (NearestOther({PlaceOf(v), place}, v, kEdgeClearance * width) < kEdgeClearance * width) return std::nullopt;
    return p;
  }

  bool IsClear(const Segment2& edge, int32_t anchor, double width) const {
    return (edge.second - edge.first).norm() <= kLongestEdge * width &&
           NearestOther(edge, anchor, kEdgeClearance * width) >= kEdgeClearance * width;
  }

  // The distance to what was laid before and to the walls; at a vertex of one, of its own walls the other ends.
  double NearestOther(const Segment2& edge, int32_t at, double reach) const {
    double nearest = reach;
    for (const int32_t i : near_.In(BoxOf(edge, reach))) {
      const RegionSegment& s = walls_[i];
      if (s.from == at || s.to == at) {
        const Point2 other = PlaceOf(s.from == at ? s.to : s.from);
        nearest = std::min(nearest, DistanceToSegment(other, edge.first, edge.second));
      } else {
        nearest = std::min(nearest, Distance(edge, {PlaceOf(s.from), PlaceOf(s.to)}));
      }
    }
    for (const Segment2& laid : laid_) nearest = std::min(nearest, Distance(edge, laid));
    return nearest;
  }

  void AddEdge(int32_t a, int32_t b) { result_.edges.push_back({a, b}); }

  Point2 PlaceOf(int32_t v) const { return hole_.positions[v].head<2>(); }

  const LocalHole& hole_;
  ClosureBuffers result_;
  std::vector<Segment2> laid_;              // of the stretches before
  const std::vector<RegionSegment> walls_;  // the boundary, and edges inside
  const BinGrid near_;                      // of the walls
};

}  // namespace

ClosureBuffers LayClosureBuffers(const LocalHole& hole) { return BufferLayer(hole).Run(); }

}  // namespace tilemend
