#include "worker/fill/crease/crease_fill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "worker/fill/crease/crease_curves.h"
#include "worker/fill/crease/part_fill.h"
#include "worker/fill/hole/rim_loops.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

// Steps along a curve by which its length in triangle sizes is summed up.
constexpr int kSteps = 512;
// The normal of the surface along the rim follows that beside each edge by this share; edges that face further off
// than the cosine belong to another part of the surface.
constexpr double kFollow = 0.3;
constexpr double kLeastCosine = 0.5;

// The wanted size of triangles anywhere in a hole: grows from the rim's sizes with the distance (Persson 2006, as in
// RefineRegion).
class SizeField {
 public:
  SizeField(const CellHoles& cell, const std::vector<RimLoop>& loops, const RefineOptions& options)
      : options_(options) {
    double length = 0;
    for (const RimLoop& loop : loops) {
      for (int32_t i = 0; i < loop.size(); ++i) {
        const Point3& p = loop.positions[i];
        const double edge = (loop.positions[(i + 1) % loop.size()] - p).norm();
        const double size = cell.vertices[loop.vertices[i]].size;
        rim_.emplace_back(p, size > 0 ? size : edge);
        length += edge;
      }
    }
    limit_ = length / static_cast<double>(rim_.size()) * std::max(options.size_limit, 1.0);
    slope_ = 2 * (options.gradation - 1) / (options.gradation + 1);
  }

  double At(const Point3& p) const {
    double least = limit_, sum = 0, weights = 0;
    for (const auto& [q, size] : rim_) {
      const double distance = (p - q).norm();
      least = std::min(least, size + slope_ * distance);
      const double weight = 1 / std::max(distance * distance, size * size);
      sum += weight * size;
      weights += weight;
    }
    return options_.uniform ? sum / weights : least;
  }

 private:
  const RefineOptions& options_;
  std::vector<std::pair<Point3, double>> rim_;  // positions and sizes
  double limit_ = 0, slope_ = 0;
};

// Points along a curve, its ends left out, as far apart as `size` wants. At least `least` of them.
std::vector<Point3> Sample(const FeatureCurve& curve, const SizeField& size, int least) {
  std::vector<double> sum = {0};  // of length / size up to each step
  Point3 before = curve.At(0);
  for (int k = 1; k <= kSteps; ++k) {
    const Point3 p = curve.At(static_cast<double>(k) / kSteps);
    sum.push_back(sum.back() + (p - before).norm() / size.At((p + before) / 2));
    before = p;
  }
  const int pieces = std::max(static_cast<int>(std::lround(sum.back())), least + 1);
  std::vector<Point3> points;
  int k = 0;
  for (int piece = 1; piece < pieces; ++piece) {
    const double wanted = sum.back() * piece / pieces;
    while (sum[k + 1] < wanted) ++k;
    points.push_back(curve.At((k + (wanted - sum[k]) / (sum[k + 1] - sum[k])) / kSteps));
  }
  return points;
}

std::vector<ChartCorner> WholeLoop(const RimLoop& loop) {
  const std::vector<Vector3d> normals = EvenNormals(loop);
  std::vector<ChartCorner> corners;
  for (int32_t i = 0; i < loop.size(); ++i) corners.push_back({loop.vertices[i], normals[i], false});
  return corners;
}

Chart WholeHole(const CellHoles& cell, const CellHole& hole, const CellBand& band) {
  Chart chart;
  for (const RimLoop& loop : LoopsOf(cell, hole, band)) chart.loops.push_back(WholeLoop(loop));
  return chart;
}

std::vector<int32_t> CornersOf(const std::vector<ChartCorner>& loop) {
  std::vector<int32_t> corners;
  for (const ChartCorner& c : loop) corners.push_back(c.corner);
  return corners;
}

// Cuts the loops of a hole along the curves of a network into charts.
class ChartCutter {
 public:
  ChartCutter(const std::vector<RimLoop>& loops, const FeatureNetwork& network,
              const std::vector<std::vector<int32_t>>& curve_points)
      : loops_(loops), network_(network), curve_points_(curve_points) {
    curve_of_.assign(network.ends.size(), -1);
    for (size_t c = 0; c < network.curves.size(); ++c) {
      const FeatureCurve& curve = network.curves[c];
      for (const int32_t end : {curve.from, curve.to}) {
        if (end >= 0) curve_of_[end] = static_cast<int32_t>(c);
      }
    }
  }

  std::vector<Chart> Run() const {
    std::vector<Chart> charts;
    std::vector<bool> used(network_.ends.size(), false);
    for (int32_t e = 0; e < static_cast<int32_t>(used.size()); ++e) {
      if (used[e] || curve_of_[e] < 0) continue;
      Chart chart;
      chart.loops.emplace_back();
      for (int32_t at = e; !used[at];) {
        used[at] = true;
        at = AlongRim(at, chart);
        at = AlongCurve(at, chart.loops[0]);
      }
      charts.push_back(std::move(chart));
    }
    return charts;
  }

  // Whether a curve ends at a loop.
  bool Touches(int32_t loop) const {
    for (size_t e = 0; e < curve_of_.size(); ++e) {
      if (curve_of_[e] >= 0 && network_.ends[e].loop == loop) return true;
    }
    return false;
  }

 private:
  // From an end along the rim to the next one that a curve leaves from; appends the vertices on the way, the last one
  // left out.
  int32_t AlongRim(int32_t end, Chart& chart) const {
    const FeatureEnd& from = network_.ends[end];
    const RimLoop& loop = loops_[from.loop];
    int32_t next = -1, least = 0;
    for (int32_t e = 0; e < static_cast<int32_t>(curve_of_.size()); ++e) {
      if (curve_of_[e] < 0 || network_.ends[e].loop != from.loop) continue;
      const int32_t way = (RankOf(e) - RankOf(end) + 2 * loop.size() - 1) % (2 * loop.size()) + 1;
      if (next >= 0 && way >= least) continue;
      next = e;
      least = way;
    }
    const int32_t edges = (least + from.order - network_.ends[next].order) / 2;
    Vector3d normal = from.after;
    for (int32_t k = 0; k < edges; ++k) {
      const int32_t place = (from.place + k) % loop.size();
      chart.loops[0].push_back({loop.vertices[place], normal, k == 0});
      // Where the rim runs along the crease the surface beside it is that of the other side.
      if (loop.outside[place].dot(normal) < kLeastCosine) continue;
      normal = (normal + kFollow * (loop.outside[place] - normal)).normalized();
    }
    return next;
  }

  // From an end along its curve, and on from corners, to the end from which the chart's boundary goes on along the rim;
  // appends end and points.
  int32_t AlongCurve(int32_t end, std::vector<ChartCorner>& corners) const {
    const FeatureEnd& from = network_.ends[end];
    corners.push_back({loops_[from.loop].vertices[from.place], from.before, true});
    int32_t at = end, by = curve_of_[end];
    while (true) {
      const FeatureCurve& curve = network_.curves[by];
      AppendPoints(by, at == curve.from, corners);
      at = at == curve.from ? curve.to : curve.from;
      if (at >= 0) return at;
      corners.push_back({at});  // corners are the first new points
      const auto& around = network_.corners[-1 - at].curves;
      by = around[(std::find(around.begin(), around.end(), by) - around.begin() + 2) % 3];
    }
  }

  void AppendPoints(int32_t c, bool forward, std::vector<ChartCorner>& corners) const {
    std::vector<int32_t> points = curve_points_[c];
    if (!forward) std::reverse(points.begin(), points.end());
    for (const int32_t p : points) corners.push_back({p});
  }

  // The ends of a loop in order have rising ranks.
  int32_t RankOf(int32_t end) const { return 2 * network_.ends[end].place + network_.ends[end].order; }

  const std::vector<RimLoop>& loops_;
  const FeatureNetwork& network_;
  const std::vector<std::vector<int32_t>>& curve_points_;
  std::vector<int32_t> curve_of_;  // per end; -1: none
};

class FeatureFiller {
 public:
  FeatureFiller(const CellHoles& cell, const CellHole& hole, const CellBand& band, const FillOptions& options)
      : cell_(cell), band_(band), options_(options), loops_(LoopsOf(cell, hole, band)) {}

  std::optional<HolePatch> Run() {
    network_ = FindFeatures(loops_);
    if (network_.curves.empty()) return std::nullopt;
    SampleCurves();
    const ChartCutter cutter(loops_, network_, curve_points_);
    std::vector<Chart> charts = cutter.Run();
    for (size_t l = 0; l < loops_.size(); ++l) {
      if (!cutter.Touches(static_cast<int32_t>(l)) && !AddIsland(loops_[l], charts)) return std::nullopt;
    }
    for (const Chart& chart : charts) {
      if (!Fill(chart)) return std::nullopt;
    }
    return std::move(patch_);
  }

 private:
  Point3 OnLattice(const Point3& p) const {
    return (p / cell_.lattice_step).array().round().matrix() * cell_.lattice_step;
  }

  void SampleCurves() {
    for (const FeatureCorner& corner : network_.corners) patch_.new_points.push_back(OnLattice(corner.position));
    const SizeField size(cell_, loops_, options_.refine);
    for (const FeatureCurve& curve : network_.curves) {
      const bool taken = curve.from >= 0 && curve.to >= 0 && band_.HasEdge(VertexOf(curve.from), VertexOf(curve.to));
      curve_points_.emplace_back();
      for (const Point3& p : Sample(curve, size, taken ? 1 : 0)) {
        curve_points_.back().push_back(-1 - static_cast<int32_t>(patch_.new_points.size()));
        patch_.new_points.push_back(OnLattice(p));
      }
    }
  }

  int32_t VertexOf(int32_t end) const {
    const FeatureEnd& e = network_.ends[end];
    return loops_[e.loop].vertices[e.place];
  }

  Point3 PositionOf(int32_t corner) const {
    return corner >= 0 ? cell_.vertices[corner].position : patch_.new_points[-1 - corner];
  }

  // Adds an island to the chart that it lies in, seen along the chart's normal; of several the one nearest to it.
  bool AddIsland(const RimLoop& island, std::vector<Chart>& charts) const {
    Chart* best = nullptr;
    double least = INFINITY;
    for (Chart& chart : charts) {
      const std::vector<int32_t> outer = CornersOf(chart.loops[0]);
      const Point3 p = island.positions[0];
      Point3 middle = Point3::Zero();
      for (const int32_t c : outer) middle += PositionOf(c) / static_cast<double>(outer.size());
      Vector3d normal = Vector3d::Zero();
      for (size_t i = 0; i < outer.size(); ++i) {
        normal += (PositionOf(outer[i]) - middle).cross(PositionOf(outer[(i + 1) % outer.size()]) - middle);
      }
      normal.normalize();
      const double off = std::abs(normal.dot(p - middle));
      if (off >= least || !GoesAround(outer, p, normal)) continue;
      least = off;
      best = &chart;
    }
    if (best != nullptr) best->loops.push_back(WholeLoop(island));
    return best != nullptr;
  }

  // Whether a loop goes around the line through p along the normal.
  bool GoesAround(const std::vector<int32_t>& loop, const Point3& p, const Vector3d& normal) const {
    double angle = 0;
    for (size_t i = 0; i < loop.size(); ++i) {
      Vector3d a = PositionOf(loop[i]) - p, b = PositionOf(loop[(i + 1) % loop.size()]) - p;
      a -= a.dot(normal) * normal;
      b -= b.dot(normal) * normal;
      angle += std::atan2(a.cross(b).dot(normal), a.dot(b));
    }
    return angle > std::numbers::pi;
  }

  bool Fill(const Chart& chart) {
    const bool steep = IsSteep(cell_, band_, chart, patch_);
    return (!steep && FillChartOverPlane(cell_, band_, options_, chart, patch_)) ||
           FillChartInSpace(cell_, band_, options_, chart, patch_);
  }

  const CellHoles& cell_;
  const CellBand& band_;
  const FillOptions& options_;
  const std::vector<RimLoop> loops_;
  FeatureNetwork network_;
  std::vector<std::vector<int32_t>> curve_points_;  // corners along each curve, its ends left out
  HolePatch patch_;
};

}  // namespace

std::optional<HolePatch> FillAlongFeatures(const CellHoles& cell, const CellHole& hole, const CellBand& band,
                                           const FillOptions& options) {
  return FeatureFiller(cell, hole, band, options).Run();
}

std::optional<HolePatch> FillHoleInSpace(const CellHoles& cell, const CellHole& hole, const CellBand& band,
                                         const FillOptions& options) {
  const Chart chart = WholeHole(cell, hole, band);
  HolePatch patch;
  if (chart.loops.empty() || !FillChartInSpace(cell, band, options, chart, patch)) return std::nullopt;
  return patch;
}

std::optional<HolePatch> FillHoleOver(const CellHoles& cell, const CellHole& hole, const CellBand& band,
                                      const FillOptions& options, std::vector<Triangle> triangles, double bend) {
  const Chart chart = WholeHole(cell, hole, band);
  HolePatch patch;
  if (!FillChartOver(cell, band, options, chart, std::move(triangles), bend, patch)) return std::nullopt;
  return patch;
}

std::optional<HolePatch> FillHoleOverPlane(const CellHoles& cell, const CellHole& hole, const CellBand& band,
                                           const FillOptions& options) {
  const Chart chart = WholeHole(cell, hole, band);
  HolePatch patch;
  if (chart.loops.empty() || !FillChartOverPlane(cell, band, options, chart, patch)) return std::nullopt;
  return patch;
}

bool IsSteepHole(const CellHoles& cell, const CellHole& hole, const CellBand& band) {
  return IsSteep(cell, band, WholeHole(cell, hole, band), {});
}

}  // namespace tilemend
