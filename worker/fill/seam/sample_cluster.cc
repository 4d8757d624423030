#include "worker/fill/seam/sample_cluster.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "worker/fill/hole/cell_band.h"
#include "worker/fill/region/fold_cutting.h"
#include "worker/fill/seam/seam_chains.h"
#include "worker/fill/surface/choose_tension.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

// Twice as coarse each time: more rounds would outgrow any window.
constexpr int kMostCoarsenings = 28;
// Coarse triangles grow at least as fast.
constexpr double kCoarseGradation = 1.3;

// The cluster with its triangles and seam vertices `coarsening` times as large and far apart as the options say.
class ClusterSampler {
 public:
  ClusterSampler(const CellHoles& cluster, const FillOptions& options, double coarsening)
      : cluster_(cluster), options_(options), coarsening_(coarsening), chains_(SeamChains(cluster)) {
    NumberVertices();
  }

  // Whether the triangulation has no more unknowns than the budget allows. False also where there is none.
  bool Triangulate(int64_t most_unknowns) {
    const auto seam_vertices = std::count_if(rim_.begin(), rim_.end(), [&](int32_t v) { return !IsKnown(v); });
    const int64_t budget = most_unknowns - seam_vertices;
    if (budget < 0) return false;
    Refine(budget + 1);
    return static_cast<int64_t>(region_.new_points.size()) <= budget;
  }

  bool has_conflicts() const { return !region_.triangulation.conflicts.empty(); }

  std::optional<ClusterSurface> Solve() const {
    ThinPlateProblem problem = Problem();
    ClusterSurface surface;
    FreeSteepRim(problem);
    if (!options_.tension) surface.hold_out = ChooseTension(problem, HoleWidth(problem.points, OutlineSegments()));
    problem.tension = options_.tension ? *options_.tension : surface.hold_out->tension;
    if (!external_.empty()) {
      if (!SolveMembrane(problem)) return std::nullopt;
      for (size_t i = 0; i < rim_.size(); ++i) {
        if (external_.contains(rim_[i])) problem.known[i] = true;
      }
    }
    const auto laplacian = options_.tension ? SolveThinPlate(problem) : SolveWithinReach(problem);
    if (!laplacian) return std::nullopt;
    if (surface.hold_out) surface.hold_out->tension = problem.tension;
    for (const auto& [v, value] : AtSeams(problem, *laplacian)) {
      surface.samples.push_back({cluster_.vertices[v].seam_vertex, value.first, value.second});
    }
    return surface;
  }

 private:
  bool IsKnown(int32_t v) const { return cluster_.vertices[v].index >= 0; }

  void NumberVertices() {
    for (const CellHole& hole : cluster_.holes) {
      for (const RimSegment& s : hole.segments) {
        if (!s.seam) AddSegment(s.from, s.to);
      }
    }
    for (const SeamChain& chain : chains_) {
      kept_.push_back(ThinnedChain(cluster_, chain, coarsening_ > 1 ? coarsening_ : 0));
      for (size_t i = 0; i + 1 < kept_.back().size(); ++i) {
        const int32_t a = chain.vertices[kept_.back()[i]], b = chain.vertices[kept_.back()[i + 1]];
        if (chain.forward) AddSegment(a, b);
        if (chain.backward) AddSegment(b, a);
        if (chain.forward != chain.backward) external_.insert({a, b});
      }
    }
  }

  // The cluster's outline: segments without those that it has on both sides.
  std::vector<RegionSegment> OutlineSegments() const {
    std::set<std::pair<int32_t, int32_t>> directed;
    for (const RegionSegment& s : segments_) directed.insert({s.from, s.to});
    std::vector<RegionSegment> outline;
    std::copy_if(segments_.begin(), segments_.end(), std::back_inserter(outline), [&](const RegionSegment& s) {
      return !directed.contains({s.to, s.from});
    });
    return outline;
  }

  void AddSegment(int32_t from, int32_t to) {
    const int32_t local = Local(from);
    segments_.push_back({local, Local(to)});
  }

  int32_t Local(int32_t v) {
    const auto [it, fresh] = number_.try_emplace(v, static_cast<int32_t>(rim_.size()));
    if (fresh) rim_.push_back(v);
    return it->second;
  }

  void Refine(int64_t most_new_points) {
    Point2 lo = cluster_.vertices[rim_[0]].position.head<2>(), hi = lo;
    for (const int32_t v : rim_) {
      lo = lo.cwiseMin(cluster_.vertices[v].position.head<2>());
      hi = hi.cwiseMax(cluster_.vertices[v].position.head<2>());
    }
    window_.emplace(lo, hi);
    std::vector<LatticePoint> points;
    std::vector<double> size;
    for (const int32_t v : rim_) {
      points.push_back(window_->Round(cluster_.vertices[v].position.head<2>()));
      size.push_back(coarsening_ * cluster_.vertices[v].size / window_->step());
    }
    RefineOptions refine = options_.refine;
    refine.max_new_points = std::min(refine.max_new_points, most_new_points);
    if (coarsening_ > 1) {
      refine.uniform = false;
      refine.gradation = std::max(refine.gradation, kCoarseGradation);
      refine.size_limit *= coarsening_;
    }
    region_ = RefineRegion(points, segments_, size, refine);
    if (!has_conflicts()) return;
    const std::vector<RegionSegment> simple = WithoutFolds(points);
    if (!simple.empty()) region_ = RefineRegion(points, simple, size, refine);
  }

  // The segments with the folds of the outline cut off, as FillHoles does; none where that does not help, or where a
  // new vertex of a seam is in a fold.
  std::vector<RegionSegment> WithoutFolds(const std::vector<LatticePoint>& points) {
    const std::vector<RegionSegment> outline = OutlineSegments();
    CutBoundary cut = CutFolds(points, outline, [](int32_t, int32_t) { return true; });
    if (!cut.simple) return {};
    std::set<int32_t> left, cut_off;
    for (const RegionSegment& s : cut.segments) left.insert({s.from, s.to});
    for (const std::vector<int32_t>& run : cut.runs) {
      at_fold_.insert(run.begin(), run.end());
      std::copy_if(run.begin(), run.end(), std::inserter(cut_off, cut_off.end()),
                   [&](int32_t v) { return !left.contains(v); });
    }
    std::set<std::pair<int32_t, int32_t>> on_outline;
    for (const RegionSegment& s : outline) on_outline.insert({s.from, s.to});
    for (const RegionSegment& s : segments_) {
      const bool inner = !on_outline.contains({s.from, s.to});
      if (inner && !cut_off.contains(s.from) && !cut_off.contains(s.to)) cut.segments.push_back(s);
    }
    if (!std::all_of(cut_off.begin(), cut_off.end(), [&](int32_t v) { return IsKnown(rim_[v]); })) return {};
    return cut.segments;
  }

  ThinPlateProblem Problem() const {
    ThinPlateProblem problem;
    for (const int32_t v : rim_) {
      problem.points.push_back(cluster_.vertices[v].position);
      problem.known.push_back(IsKnown(v));
      problem.has_equation.push_back(!external_.contains(v) && !at_fold_.contains(number_.at(v)));
    }
    for (const LatticePoint& p : region_.new_points) {
      const Point2 q = window_->ToMetres(p);
      problem.points.emplace_back(q.x(), q.y(), 0);
    }
    problem.known.resize(problem.points.size(), false);
    problem.has_equation.resize(problem.points.size(), true);
    problem.patch = region_.triangulation.triangles;
    AddBand(problem);
    return problem;
  }

  // Height and Laplacian at every vertex of the seams, by vertex; between those that were kept, along the seam.
  std::map<int32_t, std::pair<double, double>> AtSeams(const ThinPlateProblem& problem,
                                                       const std::vector<double>& laplacian) const {
    std::map<int32_t, std::pair<double, double>> values;
    for (size_t c = 0; c < chains_.size(); ++c) {
      const std::vector<int32_t>& vertices = chains_[c].vertices;
      std::vector<double> along = {0}, knots, heights, laplacians;
      for (size_t i = 1; i < vertices.size(); ++i) {
        const Point3 &a = cluster_.vertices[vertices[i - 1]].position, &b = cluster_.vertices[vertices[i]].position;
        along.push_back(along.back() + (b - a).head<2>().norm());
      }
      for (const size_t i : kept_[c]) {
        const int32_t local = number_.at(vertices[i]);
        knots.push_back(along[i]);
        heights.push_back(problem.points[local].z());
        laplacians.push_back(laplacian[local]);
      }
      const std::vector<double> h = InterpolatedAlong(knots, heights, along);
      const std::vector<double> l = InterpolatedAlong(knots, laplacians, along);
      for (size_t i = 0; i < vertices.size(); ++i) values[vertices[i]] = {h[i], l[i]};
    }
    return values;
  }

  // The original triangles at the rim vertices with a full ring.
  void AddBand(ThinPlateProblem& problem) const {
    const CellBand band(cluster_);
    std::unordered_map<int32_t, int32_t> number = number_;
    std::set<int32_t> used;
    for (const int32_t v : rim_) used.insert(band.At(v).begin(), band.At(v).end());
    for (const int32_t t : used) {
      Triangle out;
      for (int k = 0; k < 3; ++k) {
        const int32_t v = cluster_.band.triangles[t][k];
        const auto [it, fresh] = number.try_emplace(v, static_cast<int32_t>(problem.points.size()));
        if (fresh) {
          problem.points.push_back(cluster_.band.points[v]);
          problem.known.push_back(true);
          problem.has_equation.push_back(false);
        }
        out[k] = it->second;
      }
      problem.band.push_back(out);
    }
  }

  const CellHoles& cluster_;
  const FillOptions& options_;
  const double coarsening_;
  const std::vector<SeamChain> chains_;
  std::vector<std::vector<size_t>> kept_;  // of each chain
  std::optional<LatticeWindow> window_;
  RefinedRegion region_;
  std::vector<int32_t> rim_;  // local -> cluster
  std::unordered_map<int32_t, int32_t> number_;
  std::vector<RegionSegment> segments_;
  std::set<int32_t> at_fold_;   // local vertices at and in the folds that were cut off
  std::set<int32_t> external_;  // vertices on seams with the cluster on one side only
};

}  // namespace

std::optional<ClusterSurface> SampleCluster(const CellHoles& cluster, const FillOptions& options,
                                            int64_t most_unknowns) {
  double coarsening = 1;
  for (int round = 0; round < kMostCoarsenings; ++round, coarsening *= 2) {
    ClusterSampler sampler(cluster, options, coarsening);
    const bool fits = sampler.Triangulate(most_unknowns);
    if (sampler.has_conflicts()) return std::nullopt;
    if (fits) return sampler.Solve();
  }
  return std::nullopt;
}

}  // namespace tilemend
