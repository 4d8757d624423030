#include "common/assemble/fill_level.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "common/mesh/bin_grid.h"
#include "common/mesh/edge_key.h"
#include "common/mesh/lattice.h"
#include "common/mesh/position_index.h"
#include "common/mesh/triangulation/region_triangulation.h"
#include "common/mesh/winding/wound_region.h"

namespace tilemend {
namespace {

// The strip along a rim in which water may rise to it, as a share of the level's edges.
constexpr double kStripOfRim = 0.125;

// The boundary edges of a mesh on welded positions: surface on the left, seen from above.
struct Outline {
  std::vector<Point3> positions;
  std::vector<int32_t> vertex;  // of the mesh, the first at each position
  std::vector<DirectedEdge> edges;
};

template <typename PointOf>
Outline OutlineOf(std::span<const Triangle> triangles, const PointOf& point_of) {
  PositionIndex index;
  Outline outline;
  std::unordered_map<uint64_t, int32_t> ways;  // how much more often an edge is passed this way than the other
  std::vector<DirectedEdge> order;
  const auto number = [&](int32_t v) {
    const int32_t n = index.Insert(point_of(v));
    if (n == static_cast<int32_t>(outline.vertex.size())) outline.vertex.push_back(v);
    return n;
  };
  for (const Triangle& t : triangles) {
    const Triangle n{number(t[0]), number(t[1]), number(t[2])};
    if (n[0] == n[1] || n[1] == n[2] || n[0] == n[2]) continue;
    for (int k = 0; k < 3; ++k) {
      const DirectedEdge edge{n[k], n[(k + 1) % 3]};
      ++ways[EdgeKey(edge.from, edge.to)];
      order.push_back(edge);
    }
  }
  for (const DirectedEdge& edge : order) {
    int32_t& there = ways[EdgeKey(edge.from, edge.to)];
    const auto back = ways.find(EdgeKey(edge.to, edge.from));
    if (there <= 0 || (back != ways.end() && back->second >= there)) continue;
    outline.edges.push_back(edge);
    --there;
  }
  outline.positions = index.positions();
  return outline;
}

double Length(const Point3& a, const Point3& b) { return (a - b).head<2>().norm(); }

template <typename Values>
double MedianOf(Values values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The region that is to be filled, as directed segments between points of one lattice. Points come in groups: those of
// the level first, then those of the finest patch, then corners.
class LevelRegion {
 public:
  explicit LevelRegion(const LatticeWindow& window) : window_(window) {}

  int32_t Add(const Point2& p) {
    points_.push_back(window_.Round(p));
    return static_cast<int32_t>(points_.size()) - 1;
  }
  // The edges of an outline, whose positions were added from number `first` on.
  static std::vector<DirectedEdge> Shifted(const Outline& outline, int32_t first) {
    std::vector<DirectedEdge> edges;
    for (const DirectedEdge& e : outline.edges) edges.push_back({first + e.from, first + e.to});
    return edges;
  }
  int32_t AddAll(const Outline& outline) {
    const auto first = static_cast<int32_t>(points_.size());
    for (const Point3& p : outline.positions) Add(p.head<2>());
    return first;
  }

  // What the edges wind around, as a simple boundary.
  std::vector<DirectedEdge> Simple(const std::vector<DirectedEdge>& edges) {
    const WoundRegion region = FindWoundRegion(points_, edges);
    for (const RegionCorner& corner : region.corners) points_.push_back(corner.place);
    return region.segments;
  }
  // The same edges between the first points at their places.
  std::vector<DirectedEdge> AtFirstPoints(std::vector<DirectedEdge> edges) const {
    std::map<LatticePoint, int32_t> first;
    for (int32_t v = 0; v < std::ssize(points_); ++v) first.emplace(points_[v], v);
    for (DirectedEdge& e : edges) e = {first.at(points_[e.from]), first.at(points_[e.to])};
    return edges;
  }
  // What both simple boundaries wind around.
  std::vector<DirectedEdge> Both(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b) {
    a.insert(a.end(), b.begin(), b.end());
    const std::vector<DirectedEdge> window = Window();
    for (const DirectedEdge& e : window) a.push_back({e.to, e.from});
    return Simple(a);
  }
  std::vector<DirectedEdge> Either(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return Simple(a);
  }
  // What a winds around and b does not.
  std::vector<DirectedEdge> Without(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b) {
    for (const DirectedEdge& e : b) a.push_back({e.to, e.from});
    return Simple(a);
  }
  // A region grown by a square of twice `reach`.
  std::vector<DirectedEdge> Grown(const std::vector<DirectedEdge>& edges, double reach) {
    std::vector<DirectedEdge> all = edges;
    for (const DirectedEdge& e : edges) {
      AddHull(points_[e.from], points_[e.to], static_cast<int64_t>(reach / window_.step()), all);
    }
    return Simple(all);
  }

  const std::vector<LatticePoint>& points() const { return points_; }
  Point2 At(int32_t v) const { return window_.ToMetres(points_[v]); }

 private:
  // The hull of the squares about two points, counter-clockwise.
  void AddHull(LatticePoint a, LatticePoint b, int64_t r, std::vector<DirectedEdge>& edges) {
    std::vector<LatticePoint> corners;
    for (const LatticePoint& p : {a, b}) {
      for (const int64_t sx : {-r, r}) {
        for (const int64_t sy : {-r, r}) corners.push_back({p.x + sx, p.y + sy});
      }
    }
    std::sort(corners.begin(), corners.end());
    std::vector<LatticePoint> hull;  // Andrew 1979
    for (int side = 0; side < 2; ++side) {
      const size_t least = hull.size() + 2;
      for (const LatticePoint& p : corners) {
        while (hull.size() >= least && Orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
        hull.push_back(p);
      }
      hull.pop_back();
      std::reverse(corners.begin(), corners.end());
    }
    const auto first = static_cast<int32_t>(points_.size());
    points_.insert(points_.end(), hull.begin(), hull.end());
    const auto n = static_cast<int32_t>(hull.size());
    for (int32_t i = 0; i < n; ++i) edges.push_back({first + i, first + (i + 1) % n});
  }

  std::vector<DirectedEdge> Window() {
    constexpr int64_t kFar = (int64_t{1} << 29) - 1;
    const auto first = static_cast<int32_t>(points_.size());
    points_.insert(points_.end(), {{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}});
    return {{first, first + 1}, {first + 1, first + 2}, {first + 2, first + 3}, {first + 3, first}};
  }

  const LatticeWindow window_;
  std::vector<LatticePoint> points_;
};

// The finest patch as a mesh of its own vertices.
class FinestPatch {
 public:
  FinestPatch(const TriMesh& finest, const FilePatch& patch) : finest_(finest), patch_(patch) {
    const auto first_new = static_cast<int32_t>(finest.points.size());
    std::vector<double> shortest(patch.new_points.size(), std::numeric_limits<double>::infinity());
    std::vector<double> lengths;
    for (size_t t = 0; t < patch.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const int32_t a = patch.triangles[t][k], b = patch.triangles[t][(k + 1) % 3];
        const double length = Length(At(a), At(b));
        if (a < first_new && b < first_new) lengths.push_back(length);
        for (const int32_t v : {a, b}) {
          if (v < first_new) continue;
          double& least = shortest[v - first_new];
          if (length > 0) least = std::min(least, length);
        }
      }
    }
    FindLevel();
    for (const double length : shortest) lengths_.push_back(std::isfinite(length) ? length : 0);
    rim_edge_ = MedianOf(lengths.empty() ? lengths_ : lengths);
  }

  const Point3& At(int32_t v) const {
    const auto first_new = static_cast<int32_t>(finest_.points.size());
    return v < first_new ? finest_.points[v] : patch_.new_points[v - first_new];
  }
  double rim_edge() const { return rim_edge_; }                          // the median of those along the rim, metres
  double EdgeAt(size_t new_point) const { return lengths_[new_point]; }  // the shortest at a new vertex, metres
  // Whether the new vertices around a new vertex have its height to the bit, as in water.
  bool IsLevelAt(size_t new_point) const { return is_level_[new_point]; }

 private:
  void FindLevel() {
    const auto first_new = static_cast<int32_t>(finest_.points.size());
    is_level_.assign(patch_.new_points.size(), true);
    for (const Triangle& t : patch_.triangles) {
      for (int k = 0; k < 3; ++k) {
        const int32_t a = t[k], b = t[(k + 1) % 3];
        if (a < first_new || b < first_new || At(a).z() == At(b).z()) continue;
        is_level_[a - first_new] = is_level_[b - first_new] = false;
      }
    }
  }

  const TriMesh& finest_;
  const FilePatch& patch_;
  std::vector<bool> is_level_;
  std::vector<double> lengths_;
  double rim_edge_ = 0;
};

// Finds the nearest of some positions, seen from above.
class NearestPosition {
 public:
  explicit NearestPosition(const std::vector<Point3>& positions) : positions_(positions) {
    for (const Point3& p : positions) extent_.extend(Point2(p.head<2>()));
    if (positions.empty()) return;
    const double side = std::max(extent_.sizes().maxCoeff(), 1e-3);
    const double step = side / std::max(1.0, std::sqrt(static_cast<double>(positions.size())));
    grid_.emplace(extent_, step, static_cast<int32_t>(positions.size()),
                  [&](int32_t i) { return Eigen::AlignedBox2d(Point2(positions_[i].head<2>())); });
  }
  // The lowest number of the nearest; -1 if there is none.
  int32_t Of(const Point2& p) const {
    if (!grid_) return -1;
    int32_t best = -1;
    double least = std::numeric_limits<double>::infinity();
    const double farthest = 2 * (extent_.sizes().norm() + extent_.exteriorDistance(p)) + grid_->step();
    for (double reach = grid_->step(); best < 0 || std::sqrt(least) > reach / 2; reach *= 2) {
      const Point2 d(reach / 2, reach / 2);
      for (const int32_t i : grid_->In({p - d, p + d})) {
        const double distance = (positions_[i].head<2>() - p).squaredNorm();
        if (distance < least || (distance == least && i < best)) std::tie(least, best) = std::pair(distance, i);
      }
      if (reach > farthest) break;
    }
    return best;
  }

 private:
  const std::vector<Point3>& positions_;
  Eigen::AlignedBox2d extent_;
  std::optional<BinGrid> grid_;
};

// Vertices thinned to the level's edges: in each square of a lattice whose step fits the edges there, the first one.
class Thinning {
 public:
  // Edges are to be `factor` times as long as they are, and no shorter than `least`, metres.
  Thinning(double factor, double least) : factor_(factor), least_(least) {}

  // Whether a vertex with edges of `edge` metres is the first in its square.
  bool Take(const Point2& p, double edge) {
    const double wanted = std::max(factor_ * edge, least_);
    if (!(wanted > 0)) return true;
    const int level = std::ilogb(wanted);
    const double step = std::ldexp(1.0, level);
    const auto square = std::tuple(level, static_cast<int64_t>(std::floor(p.x() / step)),
                                   static_cast<int64_t>(std::floor(p.y() / step)));
    return taken_.insert(square).second;
  }

 private:
  const double factor_, least_;
  std::set<std::tuple<int, int64_t, int64_t>> taken_;
};

class LevelFiller {
 public:
  LevelFiller(const TriMesh& level, const TriMesh& finest, const FilePatch& patch)
      : level_(level),
        patch_(patch),
        first_new_(static_cast<int32_t>(finest.points.size())),
        finest_patch_(finest, patch),
        level_outline_(OutlineOf(level.triangles, [&](int32_t v) { return level.points[v]; })),
        finest_outline_(OutlineOf(finest.triangles, [&](int32_t v) { return finest.points[v]; })),
        patch_outline_(OutlineOf(patch.triangles, [&](int32_t v) { return finest_patch_.At(v); })),
        region_(Window()),
        nearest_(patch.new_points) {}

  FilePatch Run() {
    const std::vector<DirectedEdge> segments = Region();
    if (segments.empty()) return {};
    const RegionTriangulation mesh = Triangulated(segments, FreePoints(segments));
    std::vector<bool> is_wanted = WantedComponents(mesh);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (is_wanted[mesh.component[t]]) AddTriangle(mesh.triangles[t]);
    }
    return Finish();
  }

 private:
  LatticeWindow Window() const {
    Eigen::AlignedBox2d box;
    for (const Outline* outline : {&level_outline_, &finest_outline_, &patch_outline_}) {
      for (const Point3& p : outline->positions) box.extend(Point2(p.head<2>()));
    }
    for (const Point3& p : patch_.new_points) box.extend(Point2(p.head<2>()));
    return {box.min(), box.max()};
  }

  // The edges of the level's rim near the patch are this long.
  double LevelEdge() const {
    Eigen::AlignedBox2d box;
    for (const Point3& p : patch_outline_.positions) box.extend(Point2(p.head<2>()));
    std::vector<double> near, all;
    for (const DirectedEdge& e : level_outline_.edges) {
      const Point3 &a = level_outline_.positions[e.from], &b = level_outline_.positions[e.to];
      all.push_back(Length(a, b));
      if (box.contains(Point2(a.head<2>()))) near.push_back(all.back());
    }
    return MedianOf(near.empty() ? all : near);
  }

  std::vector<DirectedEdge> Region() {
    const int32_t level_first = region_.AddAll(level_outline_);
    patch_first_ = region_.AddAll(patch_outline_);
    const int32_t finest_first = region_.AddAll(finest_outline_);
    footprint_ = region_.Simple(LevelRegion::Shifted(patch_outline_, patch_first_));
    if (footprint_.empty()) return {};
    const auto covered = region_.Simple(LevelRegion::Shifted(level_outline_, level_first));
    const auto fine = region_.Simple(LevelRegion::Shifted(finest_outline_, finest_first));
    const auto either = region_.Either(footprint_, fine);
    const auto near = region_.Both(region_.Grown(footprint_, LevelEdge()), either);
    return Thinned(region_.AtFirstPoints(region_.Without(near, covered)));
  }

  bool IsLevelVertex(int32_t v) const { return v < patch_first_; }

  // The region's boundary without those of its own corners that lie closer than the level's edges are long.
  std::vector<DirectedEdge> Thinned(const std::vector<DirectedEdge>& segments) {
    // Loops come one after the other, each from its first segment on.
    std::vector<DirectedEdge> thinned;
    Thinning thinning(1, LevelEdge());
    for (size_t i = 0; i < segments.size();) {
      size_t end = i + 1;
      while (end < segments.size() && segments[end].from == segments[end - 1].to) ++end;
      std::vector<int32_t> loop;
      for (size_t s = i; s < end; ++s) {
        const int32_t v = segments[s].from;
        const int32_t before = segments[s == i ? end - 1 : s - 1].from;
        const bool is_end = IsLevelVertex(before) != IsLevelVertex(v) || IsLevelVertex(segments[s].to);
        if (IsLevelVertex(v) || is_end || thinning.Take(region_.At(v), LevelEdge())) loop.push_back(v);
      }
      for (size_t k = 0; loop.size() >= 3 && k < loop.size(); ++k) {
        thinned.push_back({loop[k], loop[(k + 1) % loop.size()]});
      }
      i = end;
    }
    return Triangulated(thinned, {}).conflicts.empty() ? thinned : segments;
  }

  // The region between segments. Of the points that no segment uses only those of `free` are inserted.
  RegionTriangulation Triangulated(const std::vector<DirectedEdge>& segments, const std::vector<int32_t>& free) const {
    std::vector<int32_t> used = free;
    for (const DirectedEdge& s : segments) used.push_back(s.from);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    const auto place = [&](int32_t v) {
      return static_cast<int32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    };
    std::vector<LatticePoint> points;
    for (const int32_t v : used) points.push_back(region_.points()[v]);
    std::vector<RegionSegment> between;
    for (const DirectedEdge& s : segments) between.push_back({place(s.from), place(s.to)});
    RegionTriangulation mesh = TriangulateRegion(points, between);
    for (Triangle& t : mesh.triangles) t = {used[t[0]], used[t[1]], used[t[2]]};
    return mesh;
  }

  // Inserted in the region: vertices of the finest patch at the level's spacing, and along the rim what keeps the
  // surface as it is there.
  std::vector<int32_t> FreePoints(const std::vector<DirectedEdge>& segments) {
    const double rim = finest_patch_.rim_edge();
    Thinning thinning(rim > 0 ? std::max(1.0, LevelEdge() / rim) : 1, LevelEdge());
    free_first_ = static_cast<int32_t>(region_.points().size());
    for (const DirectedEdge& s : segments) {
      thinning.Take(region_.At(s.from), rim);
      AddBesideRim(s);
    }
    for (size_t i = 0; i < patch_.new_points.size(); ++i) {
      const Point2 p = patch_.new_points[i].head<2>();
      if (thinning.Take(p, finest_patch_.EdgeAt(i))) AddFree(p, static_cast<int32_t>(i));
    }
    std::vector<int32_t> points(free_.size());
    std::iota(points.begin(), points.end(), free_first_);
    return points;
  }

  void AddFree(const Point2& p, int32_t source) {
    region_.Add(p);
    free_.push_back(source);
  }

  // Water is level up to its rim: two vertices beside each edge of the rim.
  void AddBesideRim(const DirectedEdge& s) {
    const Point2 a = region_.At(s.from), b = region_.At(s.to), along = b - a;
    const int32_t nearest = nearest_.Of((a + b) / 2);
    if (nearest < 0 || !finest_patch_.IsLevelAt(static_cast<size_t>(nearest)) || along.norm() == 0) return;
    const Point2 inward = kStripOfRim * LevelEdge() * Point2(-along.y(), along.x()).normalized();
    for (const Point2& end : {a, b}) AddFree(end + inward, nearest);
  }

  // Components that lie on the finest patch for the most part.
  std::vector<bool> WantedComponents(const RegionTriangulation& mesh) {
    const RegionTriangulation inside = Triangulated(footprint_, {});
    std::vector<Triangle> footprint = inside.triangles;
    std::vector<double> on(mesh.component_count, 0), all(mesh.component_count, 0);
    Eigen::AlignedBox2d extent;
    const auto box_of = [&](int32_t i) {
      Eigen::AlignedBox2d box;
      for (const int32_t v : footprint[i]) box.extend(region_.At(v));
      return box;
    };
    for (int32_t i = 0; i < std::ssize(footprint); ++i) extent.extend(box_of(i));
    if (footprint.empty()) return std::vector<bool>(mesh.component_count, false);
    const double step = std::max(extent.sizes().maxCoeff() / std::sqrt(static_cast<double>(footprint.size())), 1e-3);
    const BinGrid grid(extent, step, static_cast<int32_t>(footprint.size()), box_of);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& triangle = mesh.triangles[t];
      const Point2 a = region_.At(triangle[0]), b = region_.At(triangle[1]), c = region_.At(triangle[2]);
      const Point2 u = b - a, v = c - a;
      const double area = u.x() * v.y() - u.y() * v.x();
      all[mesh.component[t]] += area;
      if (Covers(grid, footprint, (a + b + c) / 3)) on[mesh.component[t]] += area;
    }
    std::vector<bool> wanted;
    for (int32_t i = 0; i < mesh.component_count; ++i) wanted.push_back(on[i] > 0.5 * all[i]);
    return wanted;
  }

  bool Covers(const BinGrid& grid, std::span<const Triangle> triangles, const Point2& p) const {
    for (const int32_t i : grid.In(Eigen::AlignedBox2d(p))) {
      const Triangle& t = triangles[i];
      bool inside = true;
      for (int k = 0; k < 3 && inside; ++k) {
        const Point2 a = region_.At(t[k]), d = region_.At(t[(k + 1) % 3]) - a, e = p - a;
        inside = d.x() * e.y() - d.y() * e.x() >= 0;
      }
      if (inside) return true;
    }
    return false;
  }

  // The number of a point of the region among the level's vertices and the new ones.
  int32_t NumberOf(int32_t v) {
    if (IsLevelVertex(v)) return level_outline_.vertex[v];
    const auto [at, fresh] = number_.emplace(v, static_cast<int32_t>(level_.points.size() + result_.new_points.size()));
    if (!fresh) return at->second;
    const int32_t nearest = v >= free_first_ ? free_[v - free_first_] : nearest_.Of(region_.At(v));
    Point3 p = nearest >= 0 ? patch_.new_points[nearest] : HeightOfRim(v);
    p.head<2>() = region_.At(v);
    if (IsPatchVertex(v)) p = patch_outline_.positions[v - patch_first_];
    result_.new_points.push_back(p);
    result_.like.push_back(-1);
    source_.push_back(nearest);
    return at->second;
  }

  bool IsPatchVertex(int32_t v) const {
    return v >= patch_first_ && v < patch_first_ + static_cast<int32_t>(patch_outline_.positions.size());
  }

  // The place of a point with the height of the nearest vertex on the patch's rim: for a patch without new vertices.
  Point3 HeightOfRim(int32_t v) const {
    const Point2 p = region_.At(v);
    const int32_t nearest = NearestPosition(patch_outline_.positions).Of(p);
    return {p.x(), p.y(), patch_outline_.positions[nearest].z()};
  }

  void AddTriangle(const Triangle& t) { result_.triangles.push_back({NumberOf(t[0]), NumberOf(t[1]), NumberOf(t[2])}); }

  // The triangles by their materials.
  FilePatch Finish() {
    if (patch_.materials.empty() || result_.triangles.empty()) return std::move(result_);
    const std::vector<int32_t> run_of = RunsOfNewPoints();
    std::map<int32_t, std::vector<Triangle>> by_run;
    for (const Triangle& t : result_.triangles) by_run[RunOf(t, run_of)].push_back(t);
    result_.triangles.clear();
    for (const auto& [run, triangles] : by_run) {
      result_.materials.push_back(
          {static_cast<int32_t>(result_.triangles.size()), patch_.materials[static_cast<size_t>(run)].material});
      result_.triangles.insert(result_.triangles.end(), triangles.begin(), triangles.end());
    }
    return std::move(result_);
  }

  std::vector<int32_t> RunsOfNewPoints() const {
    std::vector<int32_t> run_of(patch_.new_points.size(), 0);
    for (size_t r = 0; r < patch_.materials.size(); ++r) {
      const auto begin = static_cast<size_t>(patch_.materials[r].first);
      const size_t end = r + 1 < patch_.materials.size() ? static_cast<size_t>(patch_.materials[r + 1].first)
                                                         : patch_.triangles.size();
      for (size_t t = begin; t < end; ++t) {
        for (const int32_t v : patch_.triangles[t]) {
          if (v >= first_new_) run_of[v - first_new_] = static_cast<int32_t>(r);
        }
      }
    }
    return run_of;
  }

  int32_t RunOf(const Triangle& t, const std::vector<int32_t>& run_of) const {
    for (const int32_t v : t) {
      const int64_t fresh = v - static_cast<int64_t>(level_.points.size());
      if (fresh >= 0 && source_[fresh] >= 0) return run_of[source_[fresh]];
    }
    Point2 middle(0, 0);
    for (const int32_t v : t) {
      const int64_t fresh = v - static_cast<int64_t>(level_.points.size());
      middle += (fresh >= 0 ? result_.new_points[fresh] : level_.points[v]).head<2>() / 3;
    }
    const int32_t nearest = nearest_.Of(middle);
    return nearest >= 0 ? run_of[nearest] : 0;
  }

  const TriMesh& level_;
  const FilePatch& patch_;
  const int32_t first_new_;
  const FinestPatch finest_patch_;
  const Outline level_outline_, finest_outline_, patch_outline_;
  LevelRegion region_;
  const NearestPosition nearest_;
  std::vector<DirectedEdge> footprint_;
  int32_t patch_first_ = 0, free_first_ = 0;  // numbers of points of the region
  std::vector<int32_t> free_;                 // new points of the patch
  std::unordered_map<int32_t, int32_t> number_;
  std::vector<int32_t> source_;  // the new point of the patch that a new point of the level is from; -1: none
  FilePatch result_;
};

}  // namespace

FilePatch FillLevel(const TriMesh& level, const TriMesh& finest, const FilePatch& patch) {
  if (patch.triangles.empty() || level.triangles.empty()) return {};
  return LevelFiller(level, finest, patch).Run();
}

}  // namespace tilemend
