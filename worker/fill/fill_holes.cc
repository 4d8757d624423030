#include "worker/fill/fill_holes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/mesh/rounding.h"
#include "worker/fill/crease/crease_fill.h"
#include "worker/fill/hole/cell_band.h"
#include "worker/fill/hole/edge_lists.h"
#include "worker/fill/hole/projection_frame.h"
#include "worker/fill/hole/rim_loops.h"
#include "worker/fill/region/fold_cutting.h"
#include "worker/fill/shape/flip_edges.h"
#include "worker/fill/shape/smooth_on_surface.h"
#include "worker/fill/space/minimum_weight.h"
#include "worker/fill/space/patch_crossings.h"
#include "worker/fill/space/sound_triangulation.h"
#include "worker/fill/surface/choose_tension.h"
#include "worker/fill/surface/fair_heights.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

using Edge = std::pair<int32_t, int32_t>;
using Box3 = Eigen::AlignedBox3d;

// Each gains less; a fourth one 0.001 of mean quality.
constexpr int kSurfaceRounds = 3;
constexpr char kRimCrosses[] =
    "the surface around it passes through its boundary, and through every patch that was tried";
constexpr char kCrosses[] = "every patch that was tried passes through itself or the surface around it";

// How far a patch over triangles of the rim alone bends, tried in this order.
constexpr double kBends[] = {1, 0.5, 0};
// Of the ways to tie the first island to the rest of a rim.
constexpr size_t kBridgesTried = 12;
constexpr int kSplitRounds = 8;  // each may bring up further edges; more than a few never came up

Edge Undirected(int32_t a, int32_t b) { return {std::min(a, b), std::max(a, b)}; }

class HoleFiller {
 public:
  HoleFiller(const CellHoles& cell, const CellHole& hole, const CellBand& band, const FillOptions& options,
             const SurfaceNear& near, std::span<const HolePatch> earlier)
      : cell_(cell), hole_(hole), band_(band), options_(options), near_(near), earlier_(earlier) {
    NumberVertices();
  }

  // A closed hole first in parts along its creases. Over the plane; then, if the hole is closed, in space (first if it
  // is steep); then over the plane with folds cut off.
  HolePatch Run() {
    const std::vector<ProjectionFrame> frames = Frames();
    HolePatch patch = Failed("its boundary has no area");
    patch.hole = hole_.id;
    if (std::any_of(rim_.begin(), rim_.end(), [&](int32_t v) { return !cell_.vertices[v].height_known; })) {
      patch.failure = "no hole gave heights to a seam of it";
      return patch;
    }
    const auto done = [&](HolePatch attempt, bool in_space) {
      if (attempt.failure.empty()) attempt.failure = Unsound(attempt);
      if (attempt.failure.empty() && in_space && CrossesSurface(attempt)) attempt.failure = kCrosses;
      if (attempt.failure.empty() || patch.failure != kCrosses) patch = std::move(attempt);
      return patch.failure.empty();
    };
    const bool in_parts = !hole_.open && !hole_.level && options_.surface == Surface::kThinPlate;
    const auto in_space = [&](const auto& fill) {
      std::optional<HolePatch> attempt = fill(cell_, hole_, band_, options_);
      if (!attempt || !StaysNear(*attempt) || (FacesDown(*attempt) && LiesInHeightField())) return false;
      return done(std::move(*attempt), true);
    };
    const bool steep = in_parts && IsSteepHole(cell_, hole_, band_);
    bool finished = in_parts && (in_space(FillAlongFeatures) || (steep && in_space(FillHoleInSpace)));
    for (const bool cut_folds : {false, true}) {
      for (const ProjectionFrame& frame : frames) {
        finished = finished || done(FillOver(frame, cut_folds), !hole_.open && (cut_folds || !frame.upright()));
      }
      if (hole_.open || cut_folds) continue;
      finished = finished || (in_parts && (in_space(FillHoleOverPlane) || in_space(FillHoleInSpace))) ||
                 done(FillInSpace(), true);
    }
    if (!patch.failure.empty()) patch.new_points.clear(), patch.triangles.clear();
    if (patch.failure == kCrosses && rim_is_crossed_) patch.failure = kRimCrosses;
    patch.hole = hole_.id;
    return patch;
  }

 private:
  void NumberVertices() {
    const auto local = [&](int32_t v) {
      const auto [it, fresh] = local_.try_emplace(v, static_cast<int32_t>(rim_.size()));
      if (fresh) rim_.push_back(v);
      return it->second;
    };
    for (const RimSegment& s : hole_.segments) {
      const int32_t from = local(s.from);
      segments_.push_back({from, local(s.to)});
    }
    has_equation_.assign(rim_.size(), true);
    for (size_t i = 0; i < segments_.size(); ++i) {
      if (hole_.segments[i].seam) has_equation_[segments_[i].from] = has_equation_[segments_[i].to] = false;
      boundary_.push_back(Undirected(segments_[i].from, segments_[i].to));
    }
    std::sort(boundary_.begin(), boundary_.end());
  }

  const RimVertex& Rim(int32_t local) const { return cell_.vertices[rim_[local]]; }

  Eigen::Vector3d VectorArea() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const Point3 origin = Rim(0).position;
    for (const RegionSegment& s : segments_) sum += (Rim(s.from).position - origin).cross(Rim(s.to).position - origin);
    return sum / 2;
  }

  bool SurroundingsFaceUp() const {
    return std::all_of(rim_.begin(), rim_.end(), [&](int32_t v) {
      const auto& triangles = band_.At(v);
      return std::all_of(triangles.begin(), triangles.end(), [&](int32_t t) { return band_.Normal(t).z() > 0; });
    });
  }

  // Whether the hole is one in a height field: then heights fill it without a fold.
  bool LiesInHeightField() const {
    if (!SurroundingsFaceUp()) return false;
    Point2 lo = Rim(0).position.head<2>(), hi = lo;
    for (const int32_t v : rim_) {
      lo = lo.cwiseMin(cell_.vertices[v].position.head<2>());
      hi = hi.cwiseMax(cell_.vertices[v].position.head<2>());
    }
    const LatticeWindow window(lo, hi);
    std::vector<LatticePoint> points;
    for (const int32_t v : rim_) points.push_back(window.Round(cell_.vertices[v].position.head<2>()));
    return TriangulateRegion(points, segments_).conflicts.empty();
  }

  std::vector<ProjectionFrame> Frames() const {
    std::vector<ProjectionFrame> frames;
    if (hole_.open || hole_.level) return {ProjectionFrame::Upright()};
    const Eigen::Vector3d area = VectorArea();
    const bool up = SurroundingsFaceUp();
    if (up && area.z() > 0) frames.push_back(ProjectionFrame::Upright());
    if (area.norm() > 0) frames.emplace_back(Rim(0).position, area);
    return frames;
  }

  HolePatch Failed(std::string reason) const {
    HolePatch patch;
    patch.failure = std::move(reason);
    return patch;
  }

  // Whether a new edge may join two local vertices: the surface or the boundary may have it already.
  bool MayJoin(int32_t a, int32_t b) const {
    return a != b && !std::binary_search(boundary_.begin(), boundary_.end(), Undirected(a, b)) &&
           !band_.HasEdge(rim_[a], rim_[b]);
  }

  // Triangulation, refinement, adjustment and fairing over the plane of `frame`.
  HolePatch FillOver(const ProjectionFrame& frame, bool cut_folds) const {
    std::vector<Point3> flat;
    for (size_t i = 0; i < rim_.size(); ++i) flat.push_back(frame.ToFrame(Rim(static_cast<int32_t>(i)).position));
    Point2 lo = flat[0].head<2>(), hi = lo;
    for (const Point3& p : flat) {
      lo = lo.cwiseMin(p.head<2>());
      hi = hi.cwiseMax(p.head<2>());
    }
    const LatticeWindow window(lo, hi);
    std::vector<LatticePoint> points;
    std::vector<double> size;
    for (size_t i = 0; i < rim_.size(); ++i) {
      points.push_back(window.Round(flat[i].head<2>()));
      size.push_back(Rim(static_cast<int32_t>(i)).size / window.step());
    }
    CutBoundary cut{segments_, {}, {}, true};
    if (cut_folds) cut = CutFolds(points, segments_, [this](int32_t a, int32_t b) { return MayJoin(a, b); });
    RefinedRegion region;
    if (cut.simple && !cut.segments.empty()) region = RefineRegion(points, cut.segments, size, options_.refine);
    if (!cut.simple || !region.triangulation.conflicts.empty()) {
      return Failed(hole_.open ? "its boundary crosses itself seen from above"
                               : "its boundary crosses itself on its own plane");
    }
    if (cut_folds) SplitRepeatedEdges(points, cut, region);
    const bool repeats = !RepeatedEdges(region.triangulation.triangles, cut).empty();
    if (repeats && (cut_folds || !hole_.open)) {  // over a height field an edge is in the hole or on the surface

      return Failed("its boundary is joined by edges of the surface already");
    }
    if (frame.upright()) SnapToLattice(window, points, cut.segments, region);
    points.insert(points.end(), region.new_points.begin(), region.new_points.end());
    return Shape(frame, window, flat, std::move(points), std::move(region), cut);
  }

  static std::set<Edge> Chords(const CutBoundary& cut) {
    std::set<Edge> chords;
    for (const std::vector<int32_t>& run : cut.runs) chords.insert(Undirected(run.front(), run.back()));
    return chords;
  }

  // The triangle edges between two rim vertices, none of the segments around the triangles, that the surface, the
  // hole's boundary or a chord has already.
  std::set<Edge> RepeatedEdges(const std::vector<Triangle>& triangles, const CutBoundary& cut) const {
    std::vector<Edge> segments;
    for (const RegionSegment& s : cut.segments) segments.push_back(Undirected(s.from, s.to));
    std::sort(segments.begin(), segments.end());
    std::set<Edge> repeated;
    const std::set<Edge> taken = Chords(cut);
    const auto count = static_cast<int32_t>(rim_.size());
    for (const Triangle& t : triangles) {
      for (int k = 0; k < 3; ++k) {
        const int32_t a = t[k], b = t[(k + 1) % 3];
        if (a > b || b >= count || std::binary_search(segments.begin(), segments.end(), Edge(a, b))) continue;
        if (taken.contains({a, b}) || !MayJoin(a, b)) repeated.insert({a, b});
      }
    }
    return repeated;
  }

  // Puts new points on such edges.
  void SplitRepeatedEdges(const std::vector<LatticePoint>& points, const CutBoundary& cut,
                          RefinedRegion& region) const {
    for (int round = 0; round < kSplitRounds; ++round) {
      const std::set<Edge> repeated = RepeatedEdges(region.triangulation.triangles, cut);
      if (repeated.empty()) return;
      for (const auto& [a, b] : repeated) {
        region.new_points.push_back({(points[a].x + points[b].x) / 2, (points[a].y + points[b].y) / 2});
      }
      LeaveOut(std::vector<bool>(region.new_points.size(), true), points, cut.segments, region);
    }
  }

  // Moves the new points to the scene's lattice, or at least to positions that the output can hold; leaves out those
  // that can go to neither without turning a triangle over.
  void SnapToLattice(const LatticeWindow& window, const std::vector<LatticePoint>& points,
                     const std::vector<RegionSegment>& segments, RefinedRegion& region) const {
    const auto rim = static_cast<int32_t>(points.size());
    std::vector<std::vector<int32_t>> around(region.new_points.size());
    const auto& triangles = region.triangulation.triangles;
    for (size_t t = 0; t < triangles.size(); ++t) {
      for (const int32_t v : triangles[t]) {
        if (v >= rim) around[v - rim].push_back(static_cast<int32_t>(t));
      }
    }
    const auto at = [&](int32_t v) { return v < rim ? points[v] : region.new_points[v - rim]; };
    std::vector<bool> kept(around.size(), true);
    for (size_t k = 0; k < around.size(); ++k) {
      const LatticePoint before = region.new_points[k];
      const Point2 p = window.ToMetres(before);
      const auto fits = [&](const Point2& q) {
        region.new_points[k] = window.Round(q);
        return window.ToMetres(region.new_points[k]) == q &&
               std::all_of(around[k].begin(), around[k].end(), [&](int32_t t) {
                 return Orientation(at(triangles[t][0]), at(triangles[t][1]), at(triangles[t][2])) > 0;
               });
      };
      kept[k] = fits(ToNumberType(OnLattice(p))) || fits(ToNumberType(p));
      if (!kept[k]) region.new_points[k] = before;
    }
    if (std::find(kept.begin(), kept.end(), false) != kept.end()) LeaveOut(kept, points, segments, region);
  }

  // Triangulates again with the new points that are kept.
  static void LeaveOut(const std::vector<bool>& kept, const std::vector<LatticePoint>& points,
                       const std::vector<RegionSegment>& segments, RefinedRegion& region) {
    std::vector<LatticePoint> all = points, left;
    for (size_t k = 0; k < kept.size(); ++k) {
      if (kept[k]) left.push_back(region.new_points[k]);
    }
    all.insert(all.end(), left.begin(), left.end());
    region.triangulation = TriangulateRegion(all, segments);
    const auto rim = static_cast<int32_t>(points.size());
    std::vector<int32_t> number(left.size(), -1);  // one on a segment or on another point is not inserted
    region.new_points.clear();
    for (Triangle& t : region.triangulation.triangles) {
      for (int32_t& v : t) {
        if (v < rim) continue;
        int32_t& n = number[v - rim];
        if (n < 0) {
          n = static_cast<int32_t>(region.new_points.size());
          region.new_points.push_back(left[v - rim]);
        }
        v = rim + n;
      }
    }
  }

  template <typename Vector>
  Vector OnLattice(const Vector& p) const {
    return (p / cell_.lattice_step).array().round().matrix() * cell_.lattice_step;
  }

  //   flat    of the rim, in the frame
  //   points  of the rim, then the region's new ones, in the window
  HolePatch Shape(const ProjectionFrame& frame, const LatticeWindow& window, const std::vector<Point3>& flat,
                  std::vector<LatticePoint> points, RefinedRegion region, const CutBoundary& cut) const {
    const std::vector<std::vector<int32_t>>& runs = cut.runs;
    FairingProblem problem;
    problem.rim_count = static_cast<int32_t>(rim_.size());
    problem.new_count = static_cast<int32_t>(region.new_points.size());
    problem.points.reserve(flat.size() + region.new_points.size() + cell_.band.points.size());
    problem.points = flat;
    for (const LatticePoint& p : region.new_points) {
      const Point2 q = window.ToMetres(p);
      problem.points.emplace_back(q.x(), q.y(), 0);
    }
    problem.patch = std::move(region.triangulation.triangles);
    region = {};  // the largest piece of memory before the solve
    problem.has_equation = has_equation_;
    for (const std::vector<int32_t>& run : runs) {
      for (const int32_t v : run) problem.has_equation[v] = false;
    }
    HolePatch patch;
    if (!FindHeights(frame, problem, patch.hold_out)) return Failed("the equations of its surface have no solution");
    ImproveShapes(frame, window, cut, std::move(points), problem);
    patch.new_points.reserve(problem.new_count);
    patch.triangles.reserve(problem.patch.size());
    for (int32_t k = 0; k < problem.new_count; ++k) {
      const Point3 p = frame.ToScene(problem.points[problem.rim_count + k]);
      Point3 q = OnLattice(p);
      if (frame.upright()) q.head<2>() = p.head<2>();  // there already
      patch.new_points.push_back(q);
    }
    StoreTriangles(problem.patch, patch);
    std::set<Edge> used;  // between rim vertices
    const auto use = [&](const std::vector<Triangle>& triangles) {
      for (const Triangle& t : triangles) {
        for (int k = 0; k < 3; ++k) {
          const auto [a, b] = Undirected(t[k], t[(k + 1) % 3]);
          if (b < problem.rim_count) used.insert({a, b});
        }
      }
    };
    if (!runs.empty()) use(problem.patch);
    for (const std::vector<int32_t>& run : runs) used.insert(Undirected(run.front(), run.back()));
    for (const std::vector<int32_t>& run : runs) {
      const std::vector<Triangle> triangles = OverLoop(TriangulateInSpace(run, used, {}), run);
      use(triangles);
      if (triangles.empty()) {
        StoreFan(run, patch);
      } else {
        StoreTriangles(triangles, patch);
      }
    }
    return patch;
  }

  // Better triangles in space, where good ones in the plane are poor on a steep surface: other diagonals and, with a
  // thin plate, new vertices moved along the surface.
  //   points  of the rim, then the new ones, in the window
  void ImproveShapes(const ProjectionFrame& frame, const LatticeWindow& window, const CutBoundary& cut,
                     std::vector<LatticePoint> points, FairingProblem& problem) const {
    const std::set<Edge> chords = Chords(cut);
    const auto flip = [&] {
      problem.patch = FlipForShape(problem.patch, points, problem.points, cut.segments, [&](int32_t a, int32_t b) {
        const bool both_on_rim = a < problem.rim_count && b < problem.rim_count;
        return !both_on_rim || (MayJoin(a, b) && !chords.contains(Undirected(a, b)));
      });
    };
    flip();
    if (hole_.level || options_.surface != Surface::kThinPlate) return;
    const PlacePoint place = [&](const Point2& p) { return PlaceInWindow(frame, window, p); };
    for (int round = 0; round < kSurfaceRounds && IsSteepPatch(problem.patch, problem.points); ++round) {
      SmoothOnSurface(problem.patch, problem.rim_count, place, points, problem.points);
      flip();
    }
  }

  // The place nearest to p where a new vertex can be.
  std::optional<std::pair<LatticePoint, Point2>> PlaceInWindow(const ProjectionFrame& frame,
                                                               const LatticeWindow& window, const Point2& p) const {
    const Point2 wanted = frame.upright() ? ToNumberType(OnLattice(p)) : p;
    const LatticePoint near = window.Round(wanted);
    const Point2 there = window.ToMetres(near);
    if (frame.upright() && there != wanted) return std::nullopt;
    return std::pair(near, there);
  }

  bool FindHeights(const ProjectionFrame& frame, FairingProblem& problem, std::optional<HoldOut>& hold_out) const {
    if (hole_.level) {
      for (int32_t k = 0; k < problem.new_count; ++k) problem.points[problem.rim_count + k].z() = *hole_.level;
      return true;
    }
    AddBand(frame, problem);
    return options_.surface == Surface::kWang ? ShapeAsWang(problem) : ShapeAsThinPlate(frame, problem, hold_out);
  }

  static bool ShapeAsWang(FairingProblem& problem) {
    AdjustHeights(problem);
    return FairHeights(problem);
  }

  bool ShapeAsThinPlate(const ProjectionFrame& frame, FairingProblem& problem, std::optional<HoldOut>& chosen) const {
    ThinPlateProblem plate;
    plate.points = std::move(problem.points);
    plate.patch = std::move(problem.patch);
    plate.band = std::move(problem.band);
    const auto rim = static_cast<size_t>(problem.rim_count), all = rim + static_cast<size_t>(problem.new_count);
    for (size_t v = 0; v < plate.points.size(); ++v) {
      plate.known.push_back(v < rim || v >= all);
      plate.has_equation.push_back(v < rim ? static_cast<bool>(problem.has_equation[v]) : v < all);
    }
    for (size_t v = 0; v < rim; ++v) {
      const RimVertex& vertex = Rim(static_cast<int32_t>(v));
      if (problem.has_equation[v] || !vertex.laplacian_known || !frame.upright()) continue;
      plate.laplacian.resize(plate.points.size());
      plate.laplacian[v] = vertex.laplacian;
    }
    FreeSteepRim(plate);
    if (options_.tension || hole_.tension) {
      plate.tension = options_.tension ? *options_.tension : *hole_.tension;
    } else {
      chosen = ChooseTension(plate, rim < kLeastRimForHoldOut ? 0 : HoleWidth(plate.points, segments_));
      plate.tension = chosen->tension;
    }
    const bool solved = (chosen ? SolveWithinReach(plate) : SolveThinPlate(plate)).has_value();
    if (chosen) chosen->tension = plate.tension;
    problem.points = std::move(plate.points);
    problem.patch = std::move(plate.patch);
    return solved;
  }

  Point2 ToNumberType(const Point2& p) const {
    const NumberType type = cell_.float32 ? NumberType::kFloat32 : NumberType::kFloat64;
    return {RoundedTo(type, p.x()), RoundedTo(type, p.y())};
  }

  // The band triangles at the hole's rim, in the frame.
  void AddBand(const ProjectionFrame& frame, FairingProblem& problem) const {
    std::unordered_map<int32_t, int32_t> number = local_;
    std::vector<int32_t> used;
    for (size_t i = 0; i < rim_.size(); ++i) {
      if (has_equation_[i]) used.insert(used.end(), band_.At(rim_[i]).begin(), band_.At(rim_[i]).end());
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const int32_t t : used) {
      Triangle out;
      for (int k = 0; k < 3; ++k) {
        const int32_t v = cell_.band.triangles[t][k];
        const auto [it, fresh] = number.try_emplace(v, static_cast<int32_t>(problem.points.size()));
        if (fresh) problem.points.push_back(frame.ToFrame(cell_.band.points[v]));
        out[k] = it->second;
      }
      problem.band.push_back(out);
    }
  }

  // Closes a run about a new vertex in its middle: possible where every chord is an edge already.
  void StoreFan(const std::vector<int32_t>& run, HolePatch& patch) const {
    Point3 middle = Point3::Zero();
    for (const int32_t v : run) middle += Rim(v).position;
    patch.new_points.push_back(OnLattice(Point3(middle / static_cast<double>(run.size()))));
    const auto centre = -static_cast<int32_t>(patch.new_points.size());
    for (size_t k = 0; k < run.size(); ++k) {
      patch.triangles.push_back({rim_[run[k]], rim_[run[(k + 1) % run.size()]], centre});
    }
  }

  // Local triangles to corners of a HolePatch.
  void StoreTriangles(const std::vector<Triangle>& triangles, HolePatch& patch) const {
    const auto rim = static_cast<int32_t>(rim_.size());
    for (const Triangle& t : triangles) {
      Triangle out;
      for (int k = 0; k < 3; ++k) out[k] = t[k] < rim ? rim_[t[k]] : -1 - (t[k] - rim);
      patch.triangles.push_back(out);
    }
  }

  // The corners of a patch's triangle.
  SpaceTriangle InSpace(const HolePatch& patch, const Triangle& t) const {
    const auto at = [&](int32_t v) { return v >= 0 ? cell_.vertices[v].position : patch.new_points[-1 - v]; };
    return {at(t[0]), at(t[1]), at(t[2])};
  }

  // Twice the vector area of a patch's triangle.
  Eigen::Vector3d NormalIn(const HolePatch& patch, const Triangle& t) const {
    const SpaceTriangle corners = InSpace(patch, t);
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  }

  bool HasFlatTriangle(const HolePatch& patch) const {
    return std::any_of(patch.triangles.begin(), patch.triangles.end(),
                       [&](const Triangle& t) { return NormalIn(patch, t).squaredNorm() <= 0; });
  }

  bool FacesDown(const HolePatch& patch) const {
    return std::any_of(patch.triangles.begin(), patch.triangles.end(),
                       [&](const Triangle& t) { return NormalIn(patch, t).z() <= 0; });
  }

  // The surface in the box and maybe beyond: that around the hole, and patches made before.
  const std::vector<SpaceTriangle>& Surroundings(const Box3& box) {
    if (looked_at_.contains(box)) return surroundings_;
    looked_at_.extend(box);
    surroundings_.clear();
    if (near_) {
      surroundings_ = near_(looked_at_.min(), looked_at_.max());
    } else {
      const auto& points = cell_.band.points;
      for (const Triangle& t : cell_.band.triangles)
        surroundings_.push_back({points[t[0]], points[t[1]], points[t[2]]});
    }
    for (const HolePatch& patch : earlier_) {
      for (const Triangle& t : patch.triangles) surroundings_.push_back(InSpace(patch, t));
    }
    if (knows_crossed_) LeaveOutCrossed();
    return surroundings_;
  }

  // Whether the patch keeps within half its rim's extent around it.
  bool StaysNear(const HolePatch& patch) const {
    const Box3 reach = ReachOf(cell_, hole_);
    return std::all_of(patch.new_points.begin(), patch.new_points.end(),
                       [&](const Point3& p) { return reach.contains(p); });
  }

  bool CrossesSurface(const HolePatch& patch) {
    std::vector<SpaceTriangle> triangles;
    Box3 box = ReachOf(cell_, hole_);
    for (const Triangle& t : patch.triangles) {
      triangles.push_back(InSpace(patch, t));
      for (const Point3& p : triangles.back()) box.extend(p);
    }
    if (!PatchCrosses(triangles, Surroundings(box))) return false;
    if (knows_crossed_) return true;
    LeaveOutCrossed();
    return PatchCrosses(triangles, surroundings_);
  }

  bool IsSound(const HolePatch& patch) { return Unsound(patch).empty() && !CrossesSurface(patch); }

  // Whether a triangle of the surface passes through an edge of the boundary: then it does through any patch.
  bool PassesThroughRim(const SpaceTriangle& t) const {
    const auto has = [&](const Point3& p) { return t[0] == p || t[1] == p || t[2] == p; };
    return std::any_of(segments_.begin(), segments_.end(), [&](const RegionSegment& s) {
      const Point3 &from = Rim(s.from).position, &to = Rim(s.to).position;
      return !has(from) && !has(to) && SegmentCrosses(from, to, t);
    });
  }

  // Such triangles do not count; looked for when a patch is first found to cross any.
  void LeaveOutCrossed() {
    knows_crossed_ = true;
    if (std::erase_if(surroundings_, [&](const SpaceTriangle& t) { return PassesThroughRim(t); }) > 0) {
      rim_is_crossed_ = true;
    }
  }

  // Why the patch would not be a sound part of the surface; empty if it is.
  std::string Unsound(const HolePatch& patch) const {
    if (HasFlatTriangle(patch)) return "a triangle of its patch would have no area";
    const auto rim = static_cast<int32_t>(rim_.size());
    std::vector<Triangle> triangles;  // of local vertices, the new ones after the rim's
    for (const Triangle& t : patch.triangles) {
      if (t[0] >= 0 && t[1] >= 0 && t[2] >= 0 && band_.HasTriangle(t)) {
        return "its patch would repeat a triangle of the surface";
      }
      Triangle& out = triangles.emplace_back();
      for (int k = 0; k < 3; ++k) out[k] = t[k] >= 0 ? local_.at(t[k]) : rim - 1 - t[k];
    }
    const EdgeLists edges(triangles, rim_.size() + patch.new_points.size());
    for (const Triangle& t : triangles) {
      for (int k = 0; k < 3; ++k) {
        const int32_t a = t[k], b = t[(k + 1) % 3];
        const int others = a < rim && b < rim ? band_.CountEdge(rim_[a], rim_[b]) : 0;
        const int times = edges.Count(a, b);
        if (times > 1 || times + edges.Count(b, a) + others > 2) {
          return "its patch would make an edge with three triangles";
        }
      }
    }
    for (const RegionSegment& s : segments_) {
      if (edges.Count(s.from, s.to) == 0) return "its patch would not close on its whole boundary";
    }
    return {};
  }

  // The hole's loops, of local vertices; a loop may pass a vertex several times.
  std::vector<std::vector<int32_t>> Loops() const {
    std::vector<std::vector<int32_t>> loops;
    for (const RimLoop& loop : LoopsOf(cell_, hole_, band_)) {
      std::vector<int32_t>& local = loops.emplace_back();
      for (const int32_t v : loop.vertices) local.push_back(local_.at(v));
    }
    return loops;
  }

  // A way from a loop to another and back.
  struct Bridge {
    size_t from, loop, to;  // place on the first loop, the other loop, place on it
    double length;
  };

  // All bridges that may be built, the shortest first.
  std::vector<Bridge> Bridges(const std::vector<std::vector<int32_t>>& loops) const {
    std::vector<Bridge> bridges;
    for (size_t l = 1; l < loops.size(); ++l) {
      for (size_t i = 0; i < loops[0].size(); ++i) {
        for (size_t k = 0; k < loops[l].size(); ++k) {
          const int32_t a = loops[0][i], b = loops[l][k];
          if (a == b || MayJoin(a, b)) bridges.push_back({i, l, k, (Rim(a).position - Rim(b).position).norm()});
        }
      }
    }
    std::stable_sort(bridges.begin(), bridges.end(),
                     [](const Bridge& a, const Bridge& b) { return a.length < b.length; });
    return bridges;
  }

  // Makes one loop of two: along the first to the bridge, over it, around the other and back.
  static void Cross(const Bridge& bridge, std::vector<std::vector<int32_t>>& loops, std::set<Edge>& bridges) {
    const std::vector<int32_t> other = std::move(loops[bridge.loop]);
    loops.erase(loops.begin() + static_cast<ptrdiff_t>(bridge.loop));
    std::vector<int32_t>& loop = loops[0];
    std::vector<int32_t> around(other.begin() + static_cast<ptrdiff_t>(bridge.to), other.end());
    around.insert(around.end(), other.begin(), other.begin() + static_cast<ptrdiff_t>(bridge.to));
    if (loop[bridge.from] != around[0]) {
      bridges.insert(Undirected(loop[bridge.from], around[0]));
      around.push_back(around[0]);
      around.push_back(loop[bridge.from]);
    } else {
      around.push_back(around[0]);
      around.erase(around.begin());
    }
    loop.insert(loop.begin() + static_cast<ptrdiff_t>(bridge.from) + 1, around.begin(), around.end());
  }

  // A triangulation of the rim alone. Islands are tied to the rest of it by bridges, the shortest that lead to a sound
  // one.
  HolePatch FillInSpace() {
    const std::vector<std::vector<int32_t>> loops = Loops();
    if (loops.empty() || static_cast<int32_t>(segments_.size()) > kLongestSpatialLoop) {
      return Failed(absl::StrCat("it projects on no plane without overlap and has ", segments_.size(),
                                 " boundary vertices; at most ", kLongestSpatialLoop, " can be filled in space"));
    }
    Surroundings(ReachOf(cell_, hole_));
    if (!knows_crossed_) LeaveOutCrossed();
    if (loops.size() == 1) return FillLoopInSpace(loops[0], {});
    HolePatch patch = Failed("no way from its islands to the rest of its boundary is free");
    const std::vector<Bridge> first = Bridges(loops);
    for (size_t b = 0; b < std::min(first.size(), kBridgesTried); ++b) {
      std::vector<std::vector<int32_t>> joined = loops;
      std::set<Edge> used;
      Cross(first[b], joined, used);
      while (joined.size() > 1) {
        const std::vector<Bridge> next = Bridges(joined);
        if (next.empty()) return patch;
        Cross(next[0], joined, used);
      }
      patch = FillLoopInSpace(joined[0], used);
      if (patch.failure.empty() && IsSound(patch)) return patch;
    }
    return patch;
  }

  HolePatch FillLoopInSpace(const std::vector<int32_t>& loop, const std::set<Edge>& used) {
    const std::vector<Triangle> triangles = TriangulateInSpace(loop, used, Surroundings(ReachOf(cell_, hole_)));
    if (triangles.empty()) return Failed(kCrosses);
    HolePatch patch;
    if (used.empty() && options_.surface == Surface::kThinPlate) {
      for (const double bend : kBends) {
        auto refined = FillHoleOver(cell_, hole_, band_, options_, triangles, bend);
        if (refined && StaysNear(*refined) && IsSound(*refined)) return *std::move(refined);
      }
    }
    StoreTriangles(OverLoop(triangles, loop), patch);
    return patch;
  }

  static std::vector<Triangle> OverLoop(std::vector<Triangle> triangles, const std::vector<int32_t>& loop) {
    for (Triangle& t : triangles) t = {loop[t[0]], loop[t[1]], loop[t[2]]};
    return triangles;
  }

  // A minimum-weight triangulation, over places of a loop of local vertices, without the `used` edges inside; empty if
  // there is none. It crosses nothing of `surface`, or is empty.
  std::vector<Triangle> TriangulateInSpace(const std::vector<int32_t>& loop, const std::set<Edge>& used,
                                           std::span<const SpaceTriangle> surface) const {
    std::vector<Point3> positions;
    std::vector<Eigen::Vector3d> outside;
    for (size_t i = 0; i < loop.size(); ++i) {
      positions.push_back(Rim(loop[i]).position);
      outside.push_back(UnitNormalBeside(cell_, band_, rim_[loop[i]], rim_[loop[(i + 1) % loop.size()]]));
    }
    const auto allowed = [&](int32_t a, int32_t b) {
      return MayJoin(loop[a], loop[b]) && !used.contains(Undirected(loop[a], loop[b]));
    };
    return TriangulateSoundly(positions, outside, allowed, surface);
  }

  const CellHoles& cell_;
  const CellHole& hole_;
  const CellBand& band_;
  const FillOptions& options_;
  std::vector<int32_t> rim_;  // local -> cell
  std::unordered_map<int32_t, int32_t> local_;
  std::vector<RegionSegment> segments_;
  std::vector<bool> has_equation_;
  std::vector<Edge> boundary_;  // sorted
  const SurfaceNear& near_;
  std::span<const HolePatch> earlier_;
  Box3 looked_at_;
  std::vector<SpaceTriangle> surroundings_;  // within looked_at_, without those that pass through the rim once known
  bool knows_crossed_ = false, rim_is_crossed_ = false;
};

}  // namespace

std::vector<HolePatch> FillHoles(const CellHoles& cell, const FillOptions& options, const SurfaceNear& near) {
  CellBand band(cell);
  std::vector<HolePatch> patches;
  for (const CellHole& hole : cell.holes) {
    HolePatch patch = HoleFiller(cell, hole, band, options, near, patches).Run();
    if (&hole != &cell.holes.back()) band.Add(hole, patch);
    patches.push_back(std::move(patch));
  }
  return patches;
}

}  // namespace tilemend
