#include "worker/fill/region/refine_region.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "common/mesh/triangulation/delaunay.h"
#include "worker/fill/region/mesh_order.h"
#include "worker/fill/region/smooth_region.h"

namespace tilemend {
namespace {

using internal::DelaunayMesh;
using internal::Location;
using internal::MeshTriangle;
using internal::Next;
using internal::Point32;
using internal::Previous;
using internal::RegionMesh;

// A triangle is done when its circumradius is at most this multiple of that of the equilateral triangle of its size.
// Above sqrt(3/2), the ratio of a square's half, so that a square of the right size stays as it is.
constexpr double kLargestRadius = 1.3;
// A new point must not see a segment under an angle of which the cosine is below this (110 degrees): the triangle on
// the segment would be flat. (Smaller angles keep slivers off very long segments, but leave them large empty
// triangles.)
constexpr double kLeastSegmentCosine = -0.34;
// A new point keeps this multiple of its size away from other points.
constexpr double kLeastDistance = 0.6;
// Sizes below this number of lattice steps are not honoured: rounding would distort the triangles.
constexpr double kSmallestSize = 8;
// Larger than any window, small enough for its fourth power.
constexpr double kLargestSize = 4294967296.0;
// New points lie close to their triangle; a walk that does not end soon goes round in circles.
constexpr int64_t kLongestWalk = 1000;
constexpr size_t kLookEvery = 4096;  // triangles; some milliseconds
// Growing faster than this makes no triangle better.
constexpr double kLargestGradation = 10;
// The worst shapes are gone after two rounds of evening out; further ones make the mean quality worse where sizes grow.
constexpr int kEvenRounds = 2;
// Gains 0.01 of mean quality; a second one 0.002.
constexpr int kShapeRounds = 1;

// In uniform mode sizes are interpolated, but no faster than this: a lone outlier on the rim is not followed.
constexpr double kUniformSlope = 0.3;

enum : uint32_t { kWaiting = 0, kQueued = 1, kDone = 2 };

double Distance(Point32 a, Point32 b) {
  const double x = double{1} * b.x - a.x, y = double{1} * b.y - a.y;
  return std::sqrt(x * x + y * y);
}

// A frontal Delaunay refinement (Rebay 1993): a queue of triangles that are too large and border on a finished triangle
// or on the rim; each gets a point that makes a triangle of the wanted size on that border edge.
class Refiner {
 public:
  Refiner(RegionMesh& region, std::span<const RegionSegment> segments, std::span<const double> size,
          const RefineOptions& options);
  void Run();

 private:
  void SetSizes(std::span<const RegionSegment> segments, std::span<const double> size);
  void SetLimits(std::span<const RegionSegment> segments);
  void LimitGradient();
  bool IsFront(int32_t half_edge) const;
  bool HasFront(int32_t t) const { return IsFront(4 * t) || IsFront(4 * t + 1) || IsFront(4 * t + 2); }
  bool IsSmall(int32_t t) const;
  void Enqueue(int32_t t);
  void FinishTriangle(int32_t t);
  bool Split(int32_t t);
  std::optional<Point32> Propose(int32_t front) const;
  bool TryPoint(int32_t t, int32_t front);
  bool IsAdmissible(Point32 p, double size) const;
  double SizeAt(Point32 p, double limit) const;

  DelaunayMesh& mesh_;
  const RefineOptions options_;
  double slope_;
  size_t original_points_;
  std::vector<bool> is_free_;  // per original point: no segment ends there
  std::vector<double> size_;   // per point
  std::vector<double> limit_;  // per component
  std::vector<int32_t> queue_;
};

Refiner::Refiner(RegionMesh& region, std::span<const RegionSegment> segments, std::span<const double> size,
                 const RefineOptions& options)
    : mesh_(region.mesh),
      options_(options),
      original_points_(region.mesh.points.size()),
      is_free_(region.mesh.points.size(), false) {
  // Edges whose lengths grow by the factor g from one to the next have, at their middles, lengths of this slope.
  const double g = options.gradation > 1 ? std::min(options.gradation, kLargestGradation) : 1;
  slope_ = options.uniform ? 0 : 2 * (g - 1) / (g + 1);
  SetSizes(segments, size);
  limit_.resize(region.component_count);
  SetLimits(segments);
  LimitGradient();
}

void Refiner::SetSizes(std::span<const RegionSegment> segments, std::span<const double> size) {
  std::vector<double> sum(original_points_, 0);
  std::vector<int32_t> count(original_points_, 0);
  for (const RegionSegment& s : segments) {
    const double length = Distance(mesh_.points[s.from], mesh_.points[s.to]);
    for (int32_t v : {s.from, s.to}) {
      sum[v] += length;
      ++count[v];
    }
  }
  size_.resize(original_points_);
  for (size_t v = 0; v < original_points_; ++v) {
    const bool given = v < size.size() && size[v] > 0;
    // A free point wants nothing: it takes the largest size that its surroundings allow.
    const double wanted = count[v] == 0 ? kLargestSize : given ? size[v] : sum[v] / count[v];
    size_[v] = std::clamp(wanted, kSmallestSize, kLargestSize);
    if (count[v] == 0) is_free_[v] = true;
  }
}

void Refiner::SetLimits(std::span<const RegionSegment> segments) {
  std::vector<double> sum(limit_.size(), 0), count(limit_.size(), 0);
  for (const MeshTriangle& t : mesh_.triangles) {
    for (int k = 0; k < 3; ++k) {
      if (t.twin[k] >= 0) continue;
      const RegionSegment& s = segments[~t.twin[k]];
      sum[t.tag] += Distance(mesh_.points[s.from], mesh_.points[s.to]);
      count[t.tag] += 1;
    }
  }
  for (size_t c = 0; c < limit_.size(); ++c) {
    limit_[c] = std::max(sum[c] / count[c] * (options_.size_limit > 1 ? options_.size_limit : 1), kSmallestSize);
  }
}

// Lowers sizes until none exceeds that of a joined point by more than the slope times their distance: a vertex between
// a short and a very long rim edge must not blow up the triangles at the short one.
void Refiner::LimitGradient() {
  using Entry = std::pair<double, int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> lowered;
  const auto relax = [&](int32_t from, int32_t to) {
    const double slope = options_.uniform && !is_free_[to] ? kUniformSlope : slope_;
    const double bound = size_[from] + slope * Distance(mesh_.points[from], mesh_.points[to]);
    if (size_[to] <= bound) return;
    size_[to] = bound;
    lowered.emplace(bound, to);
  };
  std::vector<std::pair<int32_t, int32_t>> edges;
  for (const MeshTriangle& t : mesh_.triangles) {
    for (int k = 0; k < 3; ++k) {
      if (is_free_[t.corner[k]]) size_[t.corner[k]] = std::min(size_[t.corner[k]], limit_[t.tag]);
      edges.emplace_back(t.corner[k], t.corner[Next(k)]);
      if (t.twin[Previous(k)] < 0) edges.emplace_back(t.corner[Next(k)], t.corner[k]);
    }
  }
  std::sort(edges.begin(), edges.end());
  for (const auto& [from, to] : edges) relax(from, to);
  while (!lowered.empty()) {
    const auto [value, from] = lowered.top();
    lowered.pop();
    if (value > size_[from]) continue;
    auto it = std::lower_bound(edges.begin(), edges.end(), std::pair(from, int32_t{0}));
    for (; it != edges.end() && it->first == from; ++it) relax(from, it->second);
  }
}

bool Refiner::IsFront(int32_t half_edge) const {
  const int32_t across = mesh_.Twin(half_edge);
  return across < 0 || mesh_.triangles[across >> 2].flags == kDone;
}

bool Refiner::IsSmall(int32_t t) const {
  const auto& [a, b, c] = mesh_.triangles[t].corner;
  const Point32 pa = mesh_.points[a], pb = mesh_.points[b], pc = mesh_.points[c];
  const double area2 = static_cast<double>(internal::Turn(pa, pb, pc));
  const double radius = Distance(pa, pb) * Distance(pb, pc) * Distance(pc, pa) / (2 * area2);
  const double mean_size = (size_[a] + size_[b] + size_[c]) / 3;
  return radius <= kLargestRadius / std::sqrt(3.0) * mean_size;
}

void Refiner::Enqueue(int32_t t) {
  if (mesh_.triangles[t].flags != kWaiting || !HasFront(t)) return;
  mesh_.triangles[t].flags = kQueued;
  queue_.push_back(t);
}

// Marks t as finished, which makes its edges a front for its neighbours.
void Refiner::FinishTriangle(int32_t t) {
  mesh_.triangles[t].flags = kDone;
  for (int32_t across : mesh_.triangles[t].twin) {
    if (across >= 0) Enqueue(across >> 2);
  }
}

void Refiner::Run() {
  const auto count = static_cast<int32_t>(mesh_.triangles.size());
  for (int32_t t = 0; t < count; ++t) mesh_.triangles[t].flags = IsSmall(t) ? kDone : kWaiting;
  for (int32_t t = 0; t < count; ++t) Enqueue(t);
  size_t head = 0;
  while (head < queue_.size()) {  // it grows
    const int32_t t = queue_[head++];
    if (mesh_.triangles[t].flags != kQueued) continue;
    if (static_cast<int64_t>(mesh_.points.size() - original_points_) >= options_.max_new_points) break;
    if (head % kLookEvery == 0 && options_.cancelled()) return;
    mesh_.triangles[t].flags = kWaiting;
    if (!Split(t)) {
      FinishTriangle(t);
    } else {
      Enqueue(t);  // rounding may leave the new point outside its circle; if so, it is still waiting
    }
  }
  internal::SortMesh(mesh_, original_points_, size_);
  internal::SmoothRegion(mesh_, original_points_, size_, kEvenRounds, kShapeRounds);
}

// Inserts a point for the triangle; tries its front edges from the shortest up. The triangle need not go away.
bool Refiner::Split(int32_t t) {
  std::array<std::pair<double, int32_t>, 3> fronts;
  int count = 0;
  for (int32_t e = 4 * t; e < 4 * t + 3; ++e) {
    if (!IsFront(e)) continue;
    fronts[count++] = {Distance(mesh_.points[mesh_.Origin(e)], mesh_.points[mesh_.Target(e)]), e};
  }
  std::sort(fronts.begin(), fronts.begin() + count);
  for (int i = 0; i < count; ++i) {
    if (TryPoint(t, fronts[i].second)) return true;
  }
  return false;
}

// The point that makes a triangle of the wanted size on the front edge, but no farther from it than the circumcentre:
// up to there the ends of the edge are the nearest points.
std::optional<Point32> Refiner::Propose(int32_t front) const {
  const int32_t a = mesh_.Origin(front), b = mesh_.Target(front), c = mesh_.Apex(front);
  const Point32 pa = mesh_.points[a], pb = mesh_.points[b];
  const double base = Distance(pa, pb), half = base / 2;
  // How far the circumcentre lies above the front edge: half the base times the cotangent of the angle at c.
  const double centre = half * static_cast<double>(internal::Dot(mesh_.points[c], pa, pb)) /
                        static_cast<double>(internal::Turn(pa, pb, mesh_.points[c]));
  const double limit = limit_[mesh_.triangles[front >> 2].tag];
  const double here = (size_[a] + size_[b]) / 2;
  const double above = std::max(std::min(here * (1 + slope_ * std::sqrt(0.75)), limit), here);
  const double leg = (here + above) / 2;
  const double height = std::min(std::sqrt(std::max(leg * leg - half * half, leg * leg / 4)), centre);
  if (!(height > kSmallestSize / 4)) return std::nullopt;
  const double nx = -(double{1} * pb.y - pa.y) / base, ny = (double{1} * pb.x - pa.x) / base;
  const double x = (double{1} * pa.x + pb.x) / 2 + nx * height, y = (double{1} * pa.y + pb.y) / 2 + ny * height;
  const double bound = internal::kCoordinateBound - 1;
  if (std::abs(x) > bound || std::abs(y) > bound) return std::nullopt;
  return Point32{static_cast<int32_t>(std::lround(x)), static_cast<int32_t>(std::lround(y))};
}

bool Refiner::TryPoint(int32_t t, int32_t front) {
  const std::optional<Point32> p = Propose(front);
  if (!p) return false;
  const Location where = mesh_.Locate(*p, t, kLongestWalk);
  if (where.kind == Location::Kind::kBlocked || where.kind == Location::Kind::kOnVertex) return false;
  if (where.kind == Location::Kind::kOnEdge && mesh_.Twin(4 * where.triangle + where.k) < 0) return false;
  mesh_.FindCavity(*p, where);
  const double size = SizeAt(*p, limit_[mesh_.triangles[t].tag]);
  if (!IsAdmissible(*p, size)) return false;
  mesh_.points.push_back(*p);
  size_.push_back(size);
  const auto star = mesh_.FillCavity(static_cast<int32_t>(mesh_.points.size() - 1));
  for (int32_t s : star) mesh_.triangles[s].flags = IsSmall(s) ? kDone : kWaiting;
  for (int32_t s : star) {
    if (mesh_.triangles[s].flags == kDone) {
      FinishTriangle(s);
    } else {
      Enqueue(s);
    }
  }
  return true;
}

// The wanted size at p from those of the points that p would be joined to.
double Refiner::SizeAt(Point32 p, double limit) const {
  double least = INFINITY, sum = 0, weights = 0;
  for (int32_t e : mesh_.cavity_rim()) {
    const int32_t v = mesh_.Origin(e);
    const double d = Distance(mesh_.points[v], p);
    least = std::min(least, size_[v] + slope_ * d);
    sum += size_[v] / (d * d);
    weights += 1 / (d * d);
  }
  return options_.uniform ? sum / weights : std::min(least, limit);
}

// Keeps the triangles at the rim well shaped: not too flat on a segment, no point too close to another.
bool Refiner::IsAdmissible(Point32 p, double size) const {
  for (int32_t e : mesh_.cavity_rim()) {
    const Point32 a = mesh_.points[mesh_.Origin(e)], b = mesh_.points[mesh_.Target(e)];
    const double to_a = Distance(a, p);
    if (!(to_a >= kLeastDistance * std::min(size, size_[mesh_.Origin(e)]))) return false;
    if (mesh_.Twin(e) >= 0) continue;
    const double cosine = static_cast<double>(internal::Dot(p, a, b)) / (to_a * Distance(b, p));
    if (!(cosine >= kLeastSegmentCosine)) return false;
  }
  return true;
}

}  // namespace

RefinedRegion RefineRegion(std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                           std::span<const double> size, const RefineOptions& options) {
  RegionMesh region = internal::BuildRegionMesh(points, segments);
  if (region.conflicts.empty()) Refiner(region, segments, size, options).Run();
  RefinedRegion result;
  for (size_t i = points.size(); i < region.mesh.points.size(); ++i) {
    result.new_points.push_back(internal::Widen(region.mesh.points[i]));
  }
  result.triangulation = internal::ExportRegion(region, segments.size());
  return result;
}

}  // namespace tilemend
