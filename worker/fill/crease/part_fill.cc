#include "worker/fill/crease/part_fill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "worker/fill/hole/projection_frame.h"
#include "worker/fill/hole/rim_loops.h"
#include "worker/fill/region/refine_region.h"
#include "worker/fill/space/minimum_weight.h"
#include "worker/fill/surface/fair_surface.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

// A triangle that faces further off than this belongs to another part of the surface: the slope does not go on there.
constexpr double kLeastCosine = 0.5;
// Enough for a direction to within about a degree.
constexpr int kViewSteps = 200;
// Over a plane triangles are stretched by one over the cosine of the slope; twice is too much if at more than a tenth
// of the rim.
constexpr double kSteepCosine = 0.5;
constexpr double kSteepShare = 0.1;

// A chart with its corners numbered from 0 in order of first appearance along its loops.
class ChartShape {
 public:
  ChartShape(const CellHoles& cell, const CellBand& band, const Chart& chart, const HolePatch& patch)
      : cell_(cell), band_(band) {
    std::map<int32_t, int32_t> number;
    for (const std::vector<ChartCorner>& loop : chart.loops) {
      std::vector<int32_t> local;
      for (const ChartCorner& c : loop) {
        const auto [it, fresh] = number.try_emplace(c.corner, size());
        if (fresh) Add(c, patch);
        free_[it->second] = free_[it->second] || c.ends_crease;
        local.push_back(it->second);
      }
      for (size_t i = 0; i < local.size(); ++i) segments_.push_back({local[i], local[(i + 1) % local.size()]});
      loops_.push_back(std::move(local));
    }
    FindSizes();
    for (int32_t c = 0; c < size(); ++c) free_[c] = free_[c] || HasFold(c);
  }

  int32_t size() const { return static_cast<int32_t>(corners_.size()); }
  int32_t Corner(int32_t c) const { return corners_[c]; }
  const Point3& Position(int32_t c) const { return positions_[c]; }
  double Size(int32_t c) const { return sizes_[c]; }
  const Vector3d& Normal(int32_t c) const { return normals_[c]; }
  const Vector3d& facing() const { return facing_; }  // their sum
  // Whether the patch may bend against the surface there, or against the next chart.
  bool IsFree(int32_t c) const { return free_[c]; }
  const std::vector<std::vector<int32_t>>& loops() const { return loops_; }
  const std::vector<RegionSegment>& segments() const { return segments_; }

  Vector3d VectorArea() const {
    Vector3d sum = Vector3d::Zero();
    for (const RegionSegment& s : segments_) {
      sum += (positions_[s.from] - positions_[0]).cross(positions_[s.to] - positions_[0]) / 2;
    }
    return sum;
  }

  // The direction that makes the least angle with all normals beside the rim: if any plane has no overhangs at the rim,
  // the one across it. (Badoiu and Clarkson 2003: steps of 1 / k to the normal furthest away.)
  Vector3d WidestView() const {
    std::vector<Vector3d> normals;
    for (const RegionSegment& s : segments_) normals.push_back(RawBeside(s.from, s.to));
    Vector3d view = facing_.normalized();
    for (int k = 2; k < kViewSteps; ++k) {
      const Vector3d* furthest = nullptr;
      for (const Vector3d& n : normals) {
        if (!n.isZero() && (furthest == nullptr || n.dot(view) < furthest->dot(view))) furthest = &n;
      }
      if (furthest != nullptr) view = (view + (*furthest - view) / k).normalized();
    }
    return view;
  }

  // Normal of the original triangle at a segment that belongs to the same part of the surface; zero if there is none.
  Vector3d Beside(int32_t from, int32_t to) const {
    const Vector3d n = RawBeside(from, to);
    return n.dot(normals_[from]) >= kLeastCosine && n.dot(normals_[to]) >= kLeastCosine ? n : Vector3d::Zero();
  }

  // The band triangles at corners that are not free, over corners (c < size()) and `others` (size() + k), points of the
  // band.
  std::vector<Triangle> BandTriangles(std::vector<int32_t>& others) const {
    std::map<int32_t, int32_t> number;
    std::set<int32_t> used;
    for (int32_t c = 0; c < size(); ++c) {
      if (corners_[c] >= 0) number.emplace(corners_[c], c);
      if (!free_[c]) used.insert(band_.At(corners_[c]).begin(), band_.At(corners_[c]).end());
    }
    std::vector<Triangle> triangles;
    for (const int32_t t : used) {
      Triangle out;
      for (int k = 0; k < 3; ++k) {
        const int32_t v = cell_.band.triangles[t][k];
        const auto [it, fresh] = number.try_emplace(v, size() + static_cast<int32_t>(others.size()));
        if (fresh) others.push_back(v);
        out[k] = it->second;
      }
      triangles.push_back(out);
    }
    return triangles;
  }

 private:
  void Add(const ChartCorner& c, const HolePatch& patch) {
    corners_.push_back(c.corner);
    positions_.push_back(c.corner >= 0 ? cell_.vertices[c.corner].position : patch.new_points[-1 - c.corner]);
    normals_.push_back(c.normal);
    free_.push_back(c.corner < 0);
    facing_ += c.normal;
  }

  Vector3d RawBeside(int32_t from, int32_t to) const {
    if (corners_[from] < 0 || corners_[to] < 0) return Vector3d::Zero();
    return UnitNormalBeside(cell_, band_, corners_[from], corners_[to]);
  }

  void FindSizes() {
    std::vector<double> sum(corners_.size(), 0), count(corners_.size(), 0);
    for (const RegionSegment& s : segments_) {
      for (const int32_t c : {s.from, s.to}) {
        sum[c] += (positions_[s.to] - positions_[s.from]).norm();
        count[c] += 1;
      }
    }
    for (size_t c = 0; c < corners_.size(); ++c) {
      const double given = corners_[c] >= 0 ? cell_.vertices[corners_[c]].size : 0;
      sizes_.push_back(given > 0 ? given : sum[c] / count[c]);
    }
  }

  bool HasFold(int32_t c) const {
    if (corners_[c] < 0) return true;
    const auto& around = band_.At(corners_[c]);
    return std::any_of(around.begin(), around.end(), [&](int32_t t) {
      const Vector3d n = band_.Normal(t);
      return n.dot(normals_[c]) < kLeastCosine * n.norm();
    });
  }

  const CellHoles& cell_;
  const CellBand& band_;
  std::vector<int32_t> corners_;
  std::vector<Point3> positions_;
  std::vector<double> sizes_;
  std::vector<Vector3d> normals_;
  std::vector<bool> free_;
  Vector3d facing_ = Vector3d::Zero();
  std::vector<std::vector<int32_t>> loops_;
  std::vector<RegionSegment> segments_;
};

// Stores new points, rounded to the scene's lattice, and triangles over chart corners and new points.
void Store(const CellHoles& cell, const ChartShape& shape, std::span<const Point3> new_points,
           std::span<const Triangle> triangles, HolePatch& patch) {
  const auto first = static_cast<int32_t>(patch.new_points.size());
  for (const Point3& p : new_points) {
    patch.new_points.emplace_back((p / cell.lattice_step).array().round().matrix() * cell.lattice_step);
  }
  for (const Triangle& t : triangles) {
    Triangle out;
    for (int k = 0; k < 3; ++k) {
      out[k] = t[k] < shape.size() ? shape.Corner(t[k]) : -1 - (first + t[k] - shape.size());
    }
    patch.triangles.push_back(out);
  }
}

// A region of the plane on its lattice.
struct PlanarRegion {
  LatticeWindow window;
  RefinedRegion refined;

  Point2 NewPoint(size_t k) const { return window.ToMetres(refined.new_points[k]); }
};

// None if the boundary crosses itself.
std::optional<PlanarRegion> Refine(const std::vector<Point2>& flat, const std::vector<RegionSegment>& segments,
                                   const std::vector<double>& size, const RefineOptions& options) {
  Point2 lo = flat[0], hi = lo;
  for (const Point2& p : flat) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  PlanarRegion region{LatticeWindow(lo, hi), {}};
  std::vector<LatticePoint> points;
  std::vector<double> steps;
  for (size_t i = 0; i < flat.size(); ++i) {
    points.push_back(region.window.Round(flat[i]));
    steps.push_back(size[i] / region.window.step());
  }
  region.refined = RefineRegion(points, segments, steps, options);
  if (!region.refined.triangulation.conflicts.empty()) return std::nullopt;
  return region;
}

std::vector<double> SizesOf(const ChartShape& shape) {
  std::vector<double> sizes;
  for (int32_t c = 0; c < shape.size(); ++c) sizes.push_back(shape.Size(c));
  return sizes;
}

// The heights that bend least over the plane of `frame`; none if they cannot be found.
std::optional<std::vector<Point3>> BendOver(const CellHoles& cell, const ProjectionFrame& frame,
                                            const PlanarRegion& region, const ChartShape& shape, double tension) {
  ThinPlateProblem plate;
  const size_t count = region.refined.new_points.size();
  for (int32_t c = 0; c < shape.size(); ++c) plate.points.push_back(frame.ToFrame(shape.Position(c)));
  std::vector<int32_t> others;
  plate.band = shape.BandTriangles(others);
  for (Triangle& t : plate.band) {
    for (int32_t& v : t) {
      if (v >= shape.size()) v += static_cast<int32_t>(count);
    }
  }
  for (size_t k = 0; k < count; ++k) {
    const Point2 p = region.NewPoint(k);
    plate.points.emplace_back(p.x(), p.y(), 0);
  }
  for (const int32_t v : others) plate.points.push_back(frame.ToFrame(cell.band.points[v]));
  plate.patch = region.refined.triangulation.triangles;
  const auto rim = static_cast<size_t>(shape.size());
  for (size_t v = 0; v < plate.points.size(); ++v) {
    plate.known.push_back(v < rim || v >= rim + count);
    plate.has_equation.push_back(v < rim ? !shape.IsFree(static_cast<int32_t>(v)) : v < rim + count);
  }
  plate.tension = tension;
  if (!SolveThinPlate(plate)) return std::nullopt;
  std::vector<Point3> points;
  for (size_t k = 0; k < count; ++k) points.push_back(frame.ToScene(plate.points[rim + k]));
  return points;
}

// A disc of triangles over a loop, without vertices inside, unrolled into the plane: each triangle keeps its shape.
class Unrolled {
 public:
  Unrolled(const std::vector<Point3>& positions, std::vector<Triangle> triangles)
      : positions_(positions), triangles_(std::move(triangles)), flat_(positions.size(), Point2::Zero()) {
    std::map<std::pair<int32_t, int32_t>, int32_t> beside;  // of directed edges
    for (size_t t = 0; t < triangles_.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        beside[{triangles_[t][k], triangles_[t][(k + 1) % 3]}] = static_cast<int32_t>(t);
      }
    }
    const Triangle& first = triangles_[0];
    flat_[first[1]] = {(positions[first[1]] - positions[first[0]]).norm(), 0};
    Place(first, 0);
    std::vector<int32_t> open = {0};
    std::vector<bool> placed(triangles_.size(), false);
    placed[0] = true;
    for (size_t next = 0; next < open.size(); ++next) {
      const Triangle t = triangles_[open[next]];
      for (int k = 0; k < 3; ++k) {
        const auto it = beside.find({t[(k + 1) % 3], t[k]});
        if (it == beside.end() || placed[it->second]) continue;
        const Triangle& other = triangles_[it->second];
        Place(other, static_cast<int>(std::find(other.begin(), other.end(), t[(k + 1) % 3]) - other.begin()));
        placed[it->second] = true;
        open.push_back(it->second);
      }
    }
  }

  const std::vector<Point2>& flat() const { return flat_; }

  // The point of the disc in space that lies at p: in the triangle that p is in or least outside of.
  Point3 Lift(const Point2& p) const {
    Vector3d best = Vector3d::Constant(-INFINITY);
    const Triangle* at = nullptr;
    for (const Triangle& t : triangles_) {
      const Vector3d weights = Weights(t, p);
      if (weights.minCoeff() <= best.minCoeff()) continue;
      best = weights;
      at = &t;
      if (best.minCoeff() >= 0) break;
    }
    return best[0] * positions_[(*at)[0]] + best[1] * positions_[(*at)[1]] + best[2] * positions_[(*at)[2]];
  }

 private:
  // Places the third corner of t, where edge k has both its ends placed, on its left.
  void Place(const Triangle& t, int k) {
    const int32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    const Vector3d edge = positions_[b] - positions_[a], side = positions_[c] - positions_[a];
    const Point2 along = (flat_[b] - flat_[a]).normalized(), left(-along.y(), along.x());
    flat_[c] = flat_[a] + side.dot(edge) / edge.norm() * along + side.cross(edge).norm() / edge.norm() * left;
  }

  Vector3d Weights(const Triangle& t, const Point2& p) const {
    const auto area = [](const Point2& u, const Point2& v) { return u.x() * v.y() - u.y() * v.x(); };
    const Point2 a = flat_[t[0]] - p, b = flat_[t[1]] - p, c = flat_[t[2]] - p;
    const Vector3d parts(area(b, c), area(c, a), area(a, b));
    return parts / parts.sum();
  }

  const std::vector<Point3>& positions_;
  std::vector<Triangle> triangles_;
  std::vector<Point2> flat_;
};

std::vector<Triangle> TriangulateChart(const CellBand& band, const ChartShape& shape) {
  const std::vector<int32_t>& loop = shape.loops()[0];
  const auto n = static_cast<int32_t>(loop.size());
  std::vector<Point3> positions;
  std::vector<Vector3d> outside;
  for (int32_t i = 0; i < n; ++i) {
    positions.push_back(shape.Position(loop[i]));
    outside.push_back(shape.Beside(loop[i], loop[(i + 1) % n]));
  }
  return TriangulateLoop(positions, outside, [&](int32_t i, int32_t k) {
    const int32_t a = shape.Corner(loop[i]), b = shape.Corner(loop[k]);
    return a != b && (a < 0 || b < 0 || !band.HasEdge(a, b));
  });
}

// The surface of least bending over the unrolled region, its new points the share `bend` of the way to it from the
// disc; none if it cannot be found.
std::optional<std::vector<Point3>> BendInSpace(const CellHoles& cell, const Unrolled& disc, const PlanarRegion& region,
                                               const ChartShape& shape, double bend) {
  const size_t rim = disc.flat().size(), count = region.refined.new_points.size();
  FairSurfaceProblem fair;
  std::vector<Point3> flat;
  for (size_t c = 0; c < rim; ++c) {
    fair.points.push_back(shape.Position(static_cast<int32_t>(c)));
    flat.emplace_back(disc.flat()[c].x(), disc.flat()[c].y(), 0);
  }
  std::vector<int32_t> others;
  fair.band = shape.BandTriangles(others);
  for (Triangle& t : fair.band) {
    for (int32_t& v : t) {
      if (v >= shape.size()) v += static_cast<int32_t>(count);
    }
  }
  for (size_t k = 0; k < count; ++k) {
    const Point2 p = region.NewPoint(k);
    fair.points.push_back(disc.Lift(p));
    flat.emplace_back(p.x(), p.y(), 0);
  }
  for (const int32_t v : others) fair.points.push_back(cell.band.points[v]);
  flat.resize(fair.points.size(), Point3::Zero());
  fair.patch = region.refined.triangulation.triangles;
  for (size_t v = 0; v < fair.points.size(); ++v) {
    fair.known.push_back(v < rim || v >= rim + count);
    fair.has_equation.push_back(v < rim ? !shape.IsFree(static_cast<int32_t>(v)) : v < rim + count);
  }
  const auto first = fair.points.begin() + static_cast<ptrdiff_t>(rim);
  const std::vector<Point3> lifted(first, first + static_cast<ptrdiff_t>(count));
  if (bend > 0 && !FairSurface(flat, fair)) return std::nullopt;
  std::vector<Point3> points;
  for (size_t k = 0; k < count; ++k) points.emplace_back(lifted[k] + bend * (fair.points[rim + k] - lifted[k]));
  return points;
}

}  // namespace

bool FillChartOverPlane(const CellHoles& cell, const CellBand& band, const FillOptions& options, const Chart& chart,
                        HolePatch& patch) {
  const ChartShape shape(cell, band, chart, patch);
  for (const Vector3d& normal : {shape.facing(), shape.VectorArea(), shape.WidestView()}) {
    if (normal.isZero()) continue;
    const ProjectionFrame frame(shape.Position(0), normal);
    std::vector<Point2> flat;
    for (int32_t c = 0; c < shape.size(); ++c) flat.emplace_back(frame.ToFrame(shape.Position(c)).head<2>());
    const std::optional<PlanarRegion> region = Refine(flat, shape.segments(), SizesOf(shape), options.refine);
    if (!region) continue;
    const auto points = BendOver(cell, frame, *region, shape, options.tension.value_or(0));
    if (!points) return false;
    Store(cell, shape, *points, region->refined.triangulation.triangles, patch);
    return true;
  }
  return false;
}

bool FillChartInSpace(const CellHoles& cell, const CellBand& band, const FillOptions& options, const Chart& chart,
                      HolePatch& patch) {
  const ChartShape shape(cell, band, chart, patch);
  if (chart.loops.size() != 1 || shape.size() > kLongestSpatialLoop) return false;
  return FillChartOver(cell, band, options, chart, TriangulateChart(band, shape), 1, patch);
}

bool FillChartOver(const CellHoles& cell, const CellBand& band, const FillOptions& options, const Chart& chart,
                   std::vector<Triangle> triangles, double bend, HolePatch& patch) {
  const ChartShape shape(cell, band, chart, patch);
  if (chart.loops.size() != 1 || triangles.empty()) return false;
  const std::vector<int32_t>& loop = shape.loops()[0];
  if (static_cast<int32_t>(loop.size()) != shape.size()) return false;  // it touches itself
  std::vector<Point3> positions;
  for (const int32_t c : loop) positions.push_back(shape.Position(c));
  const Unrolled disc(positions, std::move(triangles));
  const std::optional<PlanarRegion> region = Refine(disc.flat(), shape.segments(), SizesOf(shape), options.refine);
  if (!region) return false;
  const auto points = BendInSpace(cell, disc, *region, shape, bend);
  if (!points) return false;
  Store(cell, shape, *points, region->refined.triangulation.triangles, patch);
  return true;
}

bool IsSteep(const CellHoles& cell, const CellBand& band, const Chart& chart, const HolePatch& patch) {
  const ChartShape shape(cell, band, chart, patch);
  const Vector3d normal = shape.facing().normalized();
  int32_t steep = 0, rim = 0;
  for (int32_t c = 0; c < shape.size(); ++c) {
    if (shape.Normal(c).isZero()) continue;
    ++rim;
    steep += shape.Normal(c).dot(normal) < kSteepCosine;
  }
  return steep > kSteepShare * rim;
}

}  // namespace tilemend
