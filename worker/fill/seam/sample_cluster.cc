#include "worker/fill/seam/sample_cluster.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "common/mesh/winding/wound_region.h"
#include "common/records/asked_places.h"
#include "worker/fill/hole/cell_band.h"
#include "worker/fill/hole/local_hole.h"
#include "worker/fill/region/planar_region.h"
#include "worker/fill/seam/seam_chains.h"
#include "worker/fill/seam/triangle_finder.h"
#include "worker/fill/surface/choose_tension.h"
#include "worker/fill/surface/edge_heights.h"
#include "worker/fill/surface/free_rim.h"
#include "worker/fill/surface/hole_width.h"
#include "worker/fill/surface/plate_over_slope.h"
#include "worker/fill/surface/thin_plate.h"
#include "worker/fill/surface/walled_ground.h"

namespace tilemend {
namespace {

// Twice as coarse each time: more rounds would outgrow any window.
constexpr int kMostCoarsenings = 28;
// Straight lines in place of corners may make new crossings. Enough on 34 real scenes; one took two.
constexpr int kMostRounds = 5;
// Coarse triangles grow at least as fast.
constexpr double kCoarseGradation = 1.3;

// Linear between the corners of a triangle of the patch.
SurfaceSample SampleAt(const PlaceInTriangle& place, const ThinPlateProblem& problem,
                       const std::vector<double>& laplacian, const std::vector<Point2>& slope) {
  SurfaceSample sample;
  for (int k = 0; k < 3; ++k) {
    const int32_t corner = place.triangle[k];
    sample.height += place.share[k] * problem.points[corner].z();
    sample.laplacian += place.share[k] * laplacian[corner];
    sample.slope += place.share[k] * slope[corner];
  }
  return sample;
}

// The cluster with its triangles and seam vertices `coarsening` times as large and far apart as the options say.
class ClusterSampler {
 public:
  ClusterSampler(const CellHoles& cluster, const CellBand& band, const FillOptions& options, double coarsening)
      : cluster_(cluster),
        options_(options),
        coarsening_(coarsening),
        chains_(SeamChains(cluster)),
        hole_(NumberVertices(cluster, band, ThinnedSegments())),
        segments_(hole_.segments) {}

  // Whether the triangulation has no more unknowns than the budget allows. False also where there is none.
  bool Triangulate(int64_t most_unknowns) {
    const auto seam_vertices =
        std::count_if(hole_.vertices.begin(), hole_.vertices.end(), [&](int32_t v) { return !IsKnown(v); });
    const int64_t budget = most_unknowns - seam_vertices;
    if (budget < 0) return false;
    Refine(budget + 1);
    return static_cast<int64_t>(region_.new_points.size()) <= budget;
  }

  bool has_conflicts() const { return !region_.triangulation.conflicts.empty(); }

  std::optional<ClusterSurface> Solve() const {
    ThinPlateProblem problem = Problem();
    ClusterSurface surface;
    if (!FreeRim(hole_.on_object, hole_.ground, problem)) return std::nullopt;
    const GroundTrend ground = TrendOf(problem);
    bool has_walls = false;
    std::optional<std::vector<double>> laplacian = SolveOverSlope(
        cluster_.holes[0].slope, problem, [&] { return SolvePlate(ground, problem, surface.hold_out, has_walls); });
    if (has_walls) {
      surface.hold_out->walls = ground;
      laplacian.emplace(problem.points.size(), 0);
      if (!SolveWalledGround(ReadingsOf(hole_), surface.hold_out->walls, problem)) return std::nullopt;
    }
    if (!laplacian) return std::nullopt;
    surface.samples = Samples(problem, *laplacian, has_walls);
    return surface;
  }

 private:
  // Fills in the heights; returns the Laplacians. Chooses the tension where it is open. Solves nothing if the surface
  // is to have walls.
  std::optional<std::vector<double>> SolvePlate(const GroundTrend& ground, ThinPlateProblem& problem,
                                                std::optional<HoldOut>& hold_out, bool& has_walls) const {
    FreeSteepRim(problem);
    const double width = HoleWidth(problem.points, OutlineSegments());
    if (!options_.tension) {
      hold_out = ChooseTension(problem, width);
      has_walls = HasWalls(hole_, *hold_out, ground);
      if (has_walls) return std::nullopt;
    }
    problem.tension = options_.tension ? *options_.tension : hold_out->tension;
    const std::vector<int32_t> edge = UnknownAtTheEdge(problem);
    if (!edge.empty() && !SolveEdge(width, edge, problem)) return std::nullopt;
    for (const int32_t v : edge) problem.known[v] = true;
    auto laplacian = options_.tension ? SolveThinPlate(problem) : SolveWithinReach(problem);
    if (hold_out) hold_out->tension = problem.tension;
    return laplacian;
  }

  std::vector<int32_t> UnknownAtTheEdge(const ThinPlateProblem& problem) const {
    std::vector<int32_t> edge;
    for (int32_t v = 0; v < hole_.size(); ++v) {
      if (external_.contains(hole_.vertices[v]) && !problem.known[v]) edge.push_back(v);
    }
    return edge;
  }

  // With walls at all vertices: the surface need not meet the rim.
  std::vector<SurfaceSample> Samples(const ThinPlateProblem& problem, const std::vector<double>& laplacian,
                                     bool has_walls) const {
    const std::vector<Point2> slope = Slopes(problem);
    std::map<int32_t, SurfaceSample> samples = AtSeams(problem, laplacian, slope, has_walls);
    AddBesideSeams(problem, laplacian, slope, samples);
    for (int32_t v = 0; v < hole_.size(); ++v) {
      if (!has_walls && !cluster_.vertices[hole_.vertices[v]].on_object) continue;
      samples.try_emplace(hole_.vertices[v], SurfaceSample{0, problem.points[v].z(), 0, slope[v]});
    }
    AddPlaces(problem, laplacian, slope, samples);
    std::vector<SurfaceSample> result;
    for (auto& [v, sample] : samples) {
      sample.seam_vertex = cluster_.vertices[v].seam_vertex;
      result.push_back(sample);
    }
    return result;
  }

  bool IsOriginal(int32_t v) const { return cluster_.vertices[v].index >= 0; }
  // Beside water new vertices are known as well.
  bool IsKnown(int32_t v) const { return IsOriginal(v) || cluster_.vertices[v].height_known; }

  // The segments of the cluster, those at seams between the vertices that are kept.
  std::vector<RimSegment> ThinnedSegments() {
    std::vector<RimSegment> segments;
    for (const CellHole& hole : cluster_.holes) {
      std::copy_if(hole.segments.begin(), hole.segments.end(), std::back_inserter(segments),
                   [](const RimSegment& s) { return !s.seam; });
    }
    for (const SeamChain& chain : chains_) {
      kept_.push_back(ThinnedChain(cluster_, chain, coarsening_ > 1 ? coarsening_ : 0));
      for (size_t i = 0; i + 1 < kept_.back().size(); ++i) {
        const int32_t a = chain.vertices[kept_.back()[i]], b = chain.vertices[kept_.back()[i + 1]];
        if (chain.forward) segments.push_back({a, b, true});
        if (chain.backward) segments.push_back({b, a, true});
        if (chain.forward != chain.backward) external_.insert({a, b});
      }
    }
    return segments;
  }

  // The outline of the triangulated region: segments without those that it has on both sides.
  std::vector<RegionSegment> OutlineSegments() const {
    std::set<std::pair<int32_t, int32_t>> directed;
    for (const RegionSegment& s : segments_) directed.insert({s.from, s.to});
    std::vector<RegionSegment> outline;
    std::copy_if(segments_.begin(), segments_.end(), std::back_inserter(outline), [&](const RegionSegment& s) {
      return !directed.contains({s.to, s.from});
    });
    return outline;
  }

  void Refine(int64_t most_new_points) {
    std::vector<Point2> flat;
    std::vector<double> sizes;
    for (int32_t v = 0; v < hole_.size(); ++v) {
      flat.emplace_back(hole_.positions[v].head<2>());
      sizes.push_back(coarsening_ * hole_.sizes[v]);
    }
    planar_.emplace(RoundToWindow(flat, sizes));
    RefineOptions refine = options_.refine;
    refine.max_new_points = std::min(refine.max_new_points, most_new_points);
    if (coarsening_ > 1) {
      refine.uniform = false;
      refine.gradation = std::max(refine.gradation, kCoarseGradation);
      refine.size_limit *= coarsening_;
    }
    region_ = RefineRegion(planar_->points, hole_.segments, planar_->sizes, refine);
    for (int round = 0; has_conflicts() && round < kMostRounds; ++round) {
      std::vector<RegionSegment> simple = WithoutFolds();
      if (simple.empty()) return;
      segments_ = std::move(simple);
      region_ = RefineRegion(planar_->points, segments_, planar_->sizes, refine);
    }
  }

  // The segments with what the outline winds around in place of the outline (wound_region.h), and straight where that
  // has a corner of its own; none where a new vertex of a seam is not on it.
  std::vector<RegionSegment> WithoutFolds() {
    const std::vector<RegionSegment> outline = OutlineSegments();
    std::vector<DirectedEdge> edges;
    std::set<std::pair<int32_t, int32_t>> on_outline;
    std::set<int32_t> cut_off;
    for (const RegionSegment& s : outline) {
      edges.push_back({s.from, s.to});
      on_outline.insert({s.from, s.to});
      cut_off.insert(s.from);
    }
    std::vector<RegionSegment> segments = AroundRegion(FindWoundRegion(planar_->points, edges));
    for (const RegionSegment& s : segments) cut_off.erase(s.from);
    if (!std::all_of(cut_off.begin(), cut_off.end(), [&](int32_t v) { return IsOriginal(hole_.vertices[v]); }))
      return {};
    for (const RegionSegment& s : segments) {
      if (!on_outline.contains({s.from, s.to})) at_fold_.insert({s.from, s.to});
    }
    at_fold_.insert(cut_off.begin(), cut_off.end());
    for (const RegionSegment& s : segments_) {
      const bool inner = !on_outline.contains({s.from, s.to});
      if (inner && !cut_off.contains(s.from) && !cut_off.contains(s.to)) segments.push_back(s);
    }
    return segments;
  }

  std::vector<RegionSegment> AroundRegion(const WoundRegion& region) const {
    std::vector<RegionSegment> segments;
    std::vector<int32_t> loop;
    int32_t first = -1;
    for (const DirectedEdge& s : region.segments) {
      if (first < 0) first = s.from;
      if (s.from < std::ssize(planar_->points)) loop.push_back(s.from);
      if (s.to != first) continue;
      for (size_t i = 0; loop.size() >= 3 && i < loop.size(); ++i)
        segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
      loop.clear();
      first = -1;
    }
    return segments;
  }

  ThinPlateProblem Problem() const {
    ThinPlateProblem problem;
    problem.is_cancelled = options_.refine.is_cancelled;
    problem.points = hole_.positions;
    for (int32_t v = 0; v < hole_.size(); ++v) {
      const int32_t rim = hole_.vertices[v];
      // Where overlapping tiles were cut for the plan, the rim has vertices that no triangle of theirs has.
      const bool without_ring = external_.contains(rim) || (IsKnown(rim) && hole_.band->At(rim).empty());
      problem.known.push_back(IsKnown(rim));
      problem.has_equation.push_back(!without_ring && !at_fold_.contains(v));
    }
    for (const LatticePoint& p : region_.new_points) {
      const Point2 q = planar_->window.ToMetres(p);
      problem.points.emplace_back(q.x(), q.y(), 0);
    }
    problem.known.resize(problem.points.size(), false);
    problem.has_equation.resize(problem.points.size(), true);
    problem.patch = region_.triangulation.triangles;
    const BandTriangles band =
        BandAt(hole_, std::vector<bool>(hole_.vertices.size(), true), static_cast<int32_t>(problem.points.size()));
    problem.band = band.triangles;
    for (const int32_t v : band.others) problem.points.push_back(cluster_.band.points[v]);
    problem.known.resize(problem.points.size(), true);
    problem.has_equation.resize(problem.points.size(), false);
    return problem;
  }

  // The surface's gradient at each point of the patch: the mean of its triangles, by their areas.
  static std::vector<Point2> Slopes(const ThinPlateProblem& problem) {
    std::vector<Eigen::Vector3d> normal(problem.points.size(), Eigen::Vector3d::Zero());
    for (const Triangle& t : problem.patch) {
      const Point3 &a = problem.points[t[0]], &b = problem.points[t[1]], &c = problem.points[t[2]];
      const Eigen::Vector3d n = (b - a).cross(c - a);
      for (const int32_t v : t) normal[v] += n;
    }
    std::vector<Point2> slopes;
    for (const Eigen::Vector3d& n : normal) {
      slopes.emplace_back(n.z() > 0 ? Point2(-n.head<2>() / n.z()) : Point2(0, 0));
    }
    return slopes;
  }

  // The surface at every vertex of the seams, by vertex; between those that were kept, along the seam.
  std::map<int32_t, SurfaceSample> AtSeams(const ThinPlateProblem& problem, const std::vector<double>& laplacian,
                                           const std::vector<Point2>& slope, bool has_walls) const {
    // A curve would go beyond both sides of a wall.
    const auto between = has_walls ? LinearAlong : InterpolatedAlong;
    std::map<int32_t, SurfaceSample> values;
    std::map<int32_t, int32_t> number;
    for (int32_t v = 0; v < hole_.size(); ++v) number.emplace(hole_.vertices[v], v);
    for (size_t c = 0; c < chains_.size(); ++c) {
      const std::vector<int32_t>& vertices = chains_[c].vertices;
      std::vector<double> along = {0}, knots, heights, laplacians, slopes_x, slopes_y;
      for (size_t i = 1; i < vertices.size(); ++i) {
        const Point3 &a = cluster_.vertices[vertices[i - 1]].position, &b = cluster_.vertices[vertices[i]].position;
        along.push_back(along.back() + (b - a).head<2>().norm());
      }
      for (const size_t i : kept_[c]) {
        const int32_t local = number.at(vertices[i]);
        knots.push_back(along[i]);
        heights.push_back(problem.points[local].z());
        laplacians.push_back(laplacian[local]);
        slopes_x.push_back(slope[local].x());
        slopes_y.push_back(slope[local].y());
      }
      const std::vector<double> h = between(knots, heights, along);
      const std::vector<double> l = between(knots, laplacians, along);
      const std::vector<double> x = between(knots, slopes_x, along);
      const std::vector<double> y = between(knots, slopes_y, along);
      for (size_t i = 0; i < vertices.size(); ++i) {
        const int32_t v = vertices[i];
        const bool stays = IsKnown(v) && !IsOriginal(v);
        values[v] = {0, stays ? cluster_.vertices[v].position.z() : h[i], l[i], {x[i], y[i]}};
      }
    }
    return values;
  }

  // New vertices of the rim that no seam ends at: where the edge of the area runs along a grid line.
  void AddBesideSeams(const ThinPlateProblem& problem, const std::vector<double>& laplacian,
                      const std::vector<Point2>& slope, std::map<int32_t, SurfaceSample>& samples) const {
    for (int32_t v = 0; v < hole_.size(); ++v) {
      if (IsOriginal(hole_.vertices[v])) continue;
      samples.try_emplace(hole_.vertices[v], SurfaceSample{0, problem.points[v].z(), laplacian[v], slope[v]});
    }
  }

  void AddPlaces(const ThinPlateProblem& problem, const std::vector<double>& laplacian,
                 const std::vector<Point2>& slope, std::map<int32_t, SurfaceSample>& samples) const {
    const std::vector<int32_t> places = VerticesWithoutSegment(cluster_);
    if (places.empty()) return;
    const TriangleFinder triangles(problem.points, problem.patch);
    for (const int32_t v : places) {
      const auto place = triangles.Find(cluster_.vertices[v].position.head<2>());
      if (place) samples[v] = SampleAt(*place, problem, laplacian, slope);
    }
  }

  const CellHoles& cluster_;
  const FillOptions& options_;
  const double coarsening_;
  const std::vector<SeamChain> chains_;
  std::vector<std::vector<size_t>> kept_;  // of each chain
  std::set<int32_t> external_;             // vertices on seams with the cluster on one side only
  const LocalHole hole_;                   // all holes of the cluster as one
  std::vector<RegionSegment> segments_;    // of the triangulated region: those of hole_, without its folds
  std::optional<PlanarPoints> planar_;
  RefinedRegion region_;
  std::set<int32_t> at_fold_;  // local vertices at and in the folds that were cut off
};

}  // namespace

std::optional<ClusterSurface> SampleCluster(const CellHoles& cluster, const FillOptions& options,
                                            int64_t most_unknowns) {
  const CellBand band(cluster);
  double coarsening = 1;
  for (int round = 0; round < kMostCoarsenings; ++round, coarsening *= 2) {
    ClusterSampler sampler(cluster, band, options, coarsening);
    const bool fits = sampler.Triangulate(most_unknowns);
    if (sampler.has_conflicts()) return std::nullopt;
    if (fits) return sampler.Solve();
  }
  return std::nullopt;
}

}  // namespace tilemend
