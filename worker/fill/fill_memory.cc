#include "worker/fill/fill_memory.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "worker/fill/seam/sample_cluster.h"

namespace tilemend {
namespace {

// Bytes for each expected vertex, as measured.
constexpr double kOfPlate = 550;
// Of the factor of Wang's fairing, which has the more entries in each row the more rows there are.
constexpr double kOfFairingLeast = 600;
constexpr double kOfFairingEachDoubling = 300;
constexpr double kOfFairingAtOne = -2870;
constexpr double kOfResult = 100;

// What each task takes beside that.
constexpr double kOfTask = 1 << 20;

// Water is flat.
bool IsFaired(const CellHole& hole, const FillOptions& options) {
  return !hole.level && (options.surface == Surface::kWang || options.filler == Filler::kMinimumArea);
}

double MemoryOfPatch(double vertices, bool is_faired) {
  if (!is_faired || vertices <= 1) return kOfPlate * vertices;
  return vertices * std::max(kOfFairingLeast, kOfFairingEachDoubling * std::log2(vertices) + kOfFairingAtOne);
}

}  // namespace

double ExpectedVertices(const CellHoles& cell, const CellHole& hole, const RefineOptions& options) {
  if (hole.segments.empty()) return 0;
  const Point3 origin = cell.vertices[hole.segments[0].from].position;
  Eigen::Vector3d twice_area(0, 0, 0);
  double length = 0, size = 0;
  for (const RimSegment& s : hole.segments) {
    const RimVertex &from = cell.vertices[s.from], &to = cell.vertices[s.to];
    twice_area += (from.position - origin).cross(to.position - origin);
    const double edge = (to.position - from.position).norm();
    length += edge;
    size += edge * (from.size + to.size) / 2;
  }
  if (!(size > 0)) return 0;
  size /= length;
  const double area = twice_area.norm() / 2, per_vertex = std::numbers::sqrt3 / 2 * size * size;
  const double uniform = area / per_vertex, growth = options.uniform ? 0 : options.gradation - 1;
  if (!(growth > 0)) return uniform;
  // Rows of vertices beside the boundary, each that much further apart than the last, then the largest triangles.
  const double graded = length / size / growth + uniform / (options.size_limit * options.size_limit);
  return std::min(uniform, graded);
}

int64_t FillMemory(const CellHoles& cell, const FillOptions& options) {
  const auto limit = static_cast<double>(options.refine.max_new_points);
  double most = 0, all = 0;
  for (const CellHole& hole : cell.holes) {
    const double vertices = std::min(ExpectedVertices(cell, hole, options.refine), limit);
    most = std::max(most, MemoryOfPatch(vertices, IsFaired(hole, options)));
    all += vertices;
  }
  return static_cast<int64_t>(kOfTask + most + kOfResult * std::min(all, limit));
}

int64_t SampleMemory(const CellHoles& cluster, const FillOptions& options) {
  double all = 0;
  for (const CellHole& hole : cluster.holes) all += ExpectedVertices(cluster, hole, options.refine);
  const double solved = std::min(all, static_cast<double>(kMostClusterUnknowns));
  return static_cast<int64_t>(kOfTask + kOfPlate * solved);
}

}  // namespace tilemend
