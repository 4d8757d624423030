#include "worker/fill/sample_cluster.h"

#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "worker/fill/cell_band.h"
#include "worker/fill/thin_plate.h"

namespace tilemend {
namespace {

class ClusterSampler {
 public:
  ClusterSampler(const CellHoles& cluster, const FillOptions& options) : cluster_(cluster), options_(options) {}

  std::vector<SurfaceSample> Run() {
    NumberVertices();
    const auto region = Triangulate();
    if (!region.triangulation.conflicts.empty()) return {};
    ThinPlateProblem problem;
    problem.tension = options_.tension;
    for (const int32_t v : rim_) {
      problem.points.push_back(cluster_.vertices[v].position);
      problem.known.push_back(cluster_.vertices[v].index >= 0);
      problem.full_ring.push_back(!external_.contains(v));
    }
    for (const LatticePoint& p : region.new_points) {
      const Point2 q = window_->ToMetres(p);
      problem.points.emplace_back(q.x(), q.y(), 0);
    }
    problem.known.resize(problem.points.size(), false);
    problem.full_ring.resize(problem.points.size(), true);
    problem.patch = region.triangulation.triangles;
    AddBand(problem);
    if (!external_.empty()) {
      if (!SolveMembrane(problem)) return {};
      for (size_t i = 0; i < rim_.size(); ++i) {
        if (external_.contains(rim_[i])) problem.known[i] = true;
      }
    }
    const auto laplacian = SolveThinPlate(problem);
    if (!laplacian) return {};
    std::vector<SurfaceSample> samples;
    for (size_t i = 0; i < rim_.size(); ++i) {
      const int32_t seam_vertex = cluster_.vertices[rim_[i]].seam_vertex;
      if (seam_vertex >= 0) samples.push_back({seam_vertex, problem.points[i].z(), (*laplacian)[i]});
    }
    return samples;
  }

 private:
  void NumberVertices() {
    std::set<std::pair<int32_t, int32_t>> seams;
    for (const CellHole& hole : cluster_.holes) {
      for (const RimSegment& s : hole.segments) {
        if (s.seam) seams.insert({s.from, s.to});
        const int32_t from = Local(s.from);
        segments_.push_back({from, Local(s.to)});
      }
    }
    for (const auto& [from, to] : seams) {
      if (!seams.contains({to, from})) external_.insert({from, to});
    }
  }

  int32_t Local(int32_t v) {
    const auto [it, fresh] = number_.try_emplace(v, static_cast<int32_t>(rim_.size()));
    if (fresh) rim_.push_back(v);
    return it->second;
  }

  RefinedRegion Triangulate() {
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
      size.push_back(cluster_.vertices[v].size / window_->step());
    }
    return RefineRegion(points, segments_, size, options_.refine);
  }

  // The original triangles at the rim vertices with a full ring.
  void AddBand(ThinPlateProblem& problem) {
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
          problem.full_ring.push_back(false);
        }
        out[k] = it->second;
      }
      problem.band.push_back(out);
    }
  }

  const CellHoles& cluster_;
  const FillOptions& options_;
  std::optional<LatticeWindow> window_;
  std::vector<int32_t> rim_;  // local -> cluster
  std::unordered_map<int32_t, int32_t> number_;
  std::vector<RegionSegment> segments_;
  std::set<int32_t> external_;  // vertices on seams with the cluster on one side only
};

}  // namespace

std::vector<SurfaceSample> SampleCluster(const CellHoles& cluster, const FillOptions& options) {
  return ClusterSampler(cluster, options).Run();
}

}  // namespace tilemend
