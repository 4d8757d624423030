#include "coordinator/plan/water/shore.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "common/mesh/edge_loops.h"
#include "coordinator/plan/water/rim_level.h"

namespace tilemend {
namespace {

constexpr double kWall = 1;                      // metres: what rises further over two triangles is no noise
constexpr double kLowShare = 0.25;               // of a shore's vertices: they are on the water, if there is any
constexpr double kDeviationsPerMedian = 1.4826;  // of the absolute value of normal noise
constexpr double kLowest = 1.25;  // what the lowest of a shore are off a plane, to what all are: noise made them so

using Edge = std::pair<int32_t, int32_t>;

// How far four points are from a plane, in standard deviations' units: their heights' combination that is zero for a
// plane, with coefficients of length one. NaN if they lie on a line seen from above.
double OffPlane(const std::array<Point3, 4>& p) {
  const auto area = [&](int a, int b, int c) {
    const Point2 u = (p[b] - p[a]).head<2>(), v = (p[c] - p[a]).head<2>();
    return u.x() * v.y() - u.y() * v.x();
  };
  const Eigen::Vector4d weights(area(1, 2, 3), -area(0, 2, 3), area(0, 1, 3), -area(0, 1, 2));
  const Eigen::Vector4d heights(0, p[1].z() - p[0].z(), p[2].z() - p[0].z(), p[3].z() - p[0].z());
  return std::abs(weights.dot(heights)) / weights.norm();
}

double HeightOf(const std::array<Point3, 4>& p) {
  const auto [least, most] = std::minmax({p[0].z(), p[1].z(), p[2].z(), p[3].z()});
  return most - least;
}

double MedianOf(const std::vector<double>& values) { return values.empty() ? 0 : Quantile(values, 0.5); }

class GroundFinder {
 public:
  GroundFinder(const Plan& plan, std::span<const std::vector<int32_t>> shores)
      : shores_(shores),
        shore_of_(plan.vertices.size(), -1),
        sum_(shore_of_.size(), 0),
        count_(shore_of_.size(), 0),
        low_(shore_of_.size(), false),
        off_plane_(shores.size()),
        low_off_plane_(shores.size()) {
    for (size_t s = shores.size(); s-- > 0;) {
      for (const int32_t v : shores[s]) shore_of_[v] = static_cast<int32_t>(s);
      MarkLow(plan, shores[s]);
    }
  }

  // Whether any boundary vertex of a tile is a shore vertex.
  bool Wants(const std::vector<int32_t>& plan_vertex) const {
    return std::any_of(plan_vertex.begin(), plan_vertex.end(), [&](int32_t v) { return v >= 0 && shore_of_[v] >= 0; });
  }

  void AddTile(const SurveyRecord& record, const std::vector<int32_t>& plan_vertex) {
    std::map<Edge, std::pair<int32_t, int32_t>> open;  // edge -> the corner across it, the shore
    for (const Triangle& t : record.band.triangles) {
      const std::array<int32_t, 3> at = {OnShore(t[0], plan_vertex), OnShore(t[1], plan_vertex),
                                         OnShore(t[2], plan_vertex)};
      const int32_t shore = ShoreAt(at);
      if (shore < 0) continue;
      AddBank(record.band, t, at);
      for (int k = 0; k < 3; ++k) {
        const Edge edge = std::minmax(t[k], t[(k + 1) % 3]);
        const int32_t across = t[(k + 2) % 3];
        const auto [it, fresh] = open.try_emplace(edge, across, shore);
        if (fresh || it->second.second != shore) continue;
        const std::array<int32_t, 4> corners = {edge.first, edge.second, across, it->second.first};
        open.erase(it);
        const auto& p = record.band.points;
        const std::array<Point3, 4> pair = {p[corners[0]], p[corners[1]], p[corners[2]], p[corners[3]]};
        const double off = OffPlane(pair);
        if (!std::isfinite(off) || HeightOf(pair) > kWall) continue;
        off_plane_[shore].push_back(off);
        const bool low = std::any_of(corners.begin(), corners.end(), [&](int32_t c) { return IsLow(c, plan_vertex); });
        if (low) low_off_plane_[shore].push_back(off);
      }
    }
  }

  std::vector<ShoreGround> Run() {
    std::vector<ShoreGround> grounds(shores_.size());
    for (size_t s = 0; s < shores_.size(); ++s) {
      for (const int32_t v : shores_[s]) {
        grounds[s].bank.push_back(count_[v] > 0 ? sum_[v] / count_[v] : std::numeric_limits<double>::quiet_NaN());
      }
      grounds[s].noise =
          kDeviationsPerMedian * std::max(MedianOf(off_plane_[s]), MedianOf(low_off_plane_[s]) / kLowest);
    }
    return grounds;
  }

 private:
  // The plan's number of a band point that is a shore vertex; else -1.
  int32_t OnShore(int32_t point, const std::vector<int32_t>& plan_vertex) const {
    if (point >= std::ssize(plan_vertex)) return -1;
    const int32_t v = plan_vertex[point];
    return v < 0 || shore_of_[v] < 0 ? -1 : v;
  }

  bool IsLow(int32_t point, const std::vector<int32_t>& plan_vertex) const {
    const int32_t v = OnShore(point, plan_vertex);
    return v >= 0 && low_[v];
  }

  void MarkLow(const Plan& plan, const std::vector<int32_t>& shore) {
    if (shore.empty()) return;
    std::vector<double> heights;
    for (const int32_t v : shore) heights.push_back(plan.vertices[v].position.z());
    const double most = Quantile(heights, kLowShare);
    for (size_t i = 0; i < shore.size(); ++i) low_[shore[i]] = heights[i] <= most;
  }

  int32_t ShoreAt(const std::array<int32_t, 3>& corners) const {
    for (const int32_t v : corners) {
      if (v >= 0) return shore_of_[v];
    }
    return -1;
  }

  void AddBank(const TriMesh& band, const Triangle& t, const std::array<int32_t, 3>& at) {
    for (int k = 0; k < 3; ++k) {
      if (at[k] < 0) continue;
      for (int j = 0; j < 3; ++j) {
        if (at[j] >= 0) continue;
        sum_[at[k]] += band.points[t[j]].z();
        ++count_[at[k]];
      }
    }
  }

  std::span<const std::vector<int32_t>> shores_;
  std::vector<int32_t> shore_of_;  // of the plan's vertices
  std::vector<double> sum_;        // of the heights one edge landward
  std::vector<int32_t> count_;
  std::vector<bool> low_;                           // whether it is one of the lowest of its shore
  std::vector<std::vector<double>> off_plane_;      // by shore
  std::vector<std::vector<double>> low_off_plane_;  // by shore: at its lowest vertices
};

}  // namespace

std::vector<int32_t> ShoreOf(const Plan& plan, const std::vector<int32_t>& holes) {
  std::vector<DirectedEdge> edges;
  for (const int32_t h : holes) {
    for (const RimSegment& s : plan.holes[h].segments) {
      if (!s.seam) edges.push_back({s.from, s.to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  });
  std::vector<int32_t> shore;
  for (const EdgeWalk& walk : LinkEdges(edges)) {
    for (const int32_t e : walk.edges) shore.push_back(edges[e].from);
    const int32_t end = edges[walk.edges.back()].to;
    const auto leaving =
        std::partition_point(edges.begin(), edges.end(), [&](const DirectedEdge& e) { return e.from < end; });
    if (leaving == edges.end() || leaving->from != end) shore.push_back(end);  // the end of a chain
  }
  return shore;
}

std::vector<ShoreGround> FindGround(const Plan& plan, const PlanInput& input,
                                    std::span<const std::vector<int32_t>> shores) {
  GroundFinder finder(plan, shores);
  for (const auto& [cell, record] : input.cells) {
    const auto plan_vertex = plan.vertex_of_boundary.find(cell);
    if (record == nullptr || plan_vertex == plan.vertex_of_boundary.end()) continue;
    if (finder.Wants(plan_vertex->second)) finder.AddTile(*record.WithBand(), plan_vertex->second);
  }
  return finder.Run();
}

}  // namespace tilemend
