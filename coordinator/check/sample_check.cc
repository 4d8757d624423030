#include "coordinator/check/sample_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "absl/strings/str_cat.h"
#include "common/records/asked_places.h"

namespace tilemend {
namespace {

absl::Status Wrong(int32_t vertex, const char* what) {
  return absl::InvalidArgumentError(absl::StrCat("vertex ", vertex, ": ", what));
}

bool AllFinite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

// What a surface may overshoot beyond its rim, in sizes of the holes: at a tile cut in half it was more than one.
constexpr double kOvershoot = 10;

// Heights that a surface over these holes can have.
absl::Status CheckHeights(const CellHoles& asked, std::span<const int32_t> seam_vertex,
                          std::span<const double> height) {
  Eigen::AlignedBox2d extent;
  Eigen::AlignedBox1d heights;
  for (const RimVertex& v : asked.vertices) {
    extent.extend(Point2(v.position.head<2>()));
    if (v.height_known) heights.extend(Eigen::Matrix<double, 1, 1>(v.position.z()));
    if (v.ground) heights.extend(Eigen::Matrix<double, 1, 1>(*v.ground));
  }
  if (heights.isEmpty()) return absl::OkStatus();
  const double size = kOvershoot * (extent.diagonal().norm() + heights.diagonal().norm());
  for (size_t i = 0; i < height.size(); ++i) {
    const bool near = height[i] >= heights.min().x() - size && height[i] <= heights.max().x() + size;
    if (!near) return Wrong(seam_vertex[i], "a height far from those of the rim");
  }
  return absl::OkStatus();
}

// Of all vertices whose number was told.
std::set<int32_t> Numbers(const CellHoles& asked) {
  std::set<int32_t> numbers;
  for (const RimVertex& v : asked.vertices) {
    if (v.seam_vertex >= 0) numbers.insert(v.seam_vertex);
  }
  return numbers;
}

// Of the new vertices, those on objects and those on seams.
std::set<int32_t> NumbersOnSeams(const CellHoles& asked) {
  std::set<int32_t> numbers;
  const auto add = [&](const RimVertex& v) {
    if (v.seam_vertex >= 0) numbers.insert(v.seam_vertex);
  };
  for (const RimVertex& v : asked.vertices) {
    if (v.on_object || v.index < 0) add(v);
  }
  for (const CellHole& hole : asked.holes) {
    for (const RimSegment& s : hole.segments) {
      if (!s.seam) continue;
      add(asked.vertices[s.from]);
      add(asked.vertices[s.to]);
    }
  }
  return numbers;
}

}  // namespace

absl::Status CheckClusterSamples(const CellHoles& asked, bool has_walls, const ClusterColumns& given) {
  const size_t n = given.seam_vertex.size();
  if (given.height.size() != n || given.laplacian.size() != n || given.slope_x.size() != n ||
      given.slope_y.size() != n) {
    return absl::InvalidArgumentError("columns of unequal length");
  }
  if (has_walls && (n == 0 || std::ranges::none_of(asked.vertices, &RimVertex::on_object))) {
    return absl::InvalidArgumentError("walls without samples, or without an object on the rim");
  }
  if (n == 0) return absl::OkStatus();
  std::set<int32_t> wanted = has_walls ? Numbers(asked) : NumbersOnSeams(asked);
  for (const int32_t vertex : given.seam_vertex) {
    if (wanted.erase(vertex) == 0) return Wrong(vertex, "not asked for, or given twice");
  }
  for (const int32_t v : VerticesWithoutSegment(asked)) {
    if (asked.vertices[v].index < 0)
      wanted.erase(asked.vertices[v].seam_vertex);  // the surface may have no height there
  }
  if (!wanted.empty()) return Wrong(*wanted.begin(), "no sample");
  if (!AllFinite(given.laplacian) || !AllFinite(given.slope_x) || !AllFinite(given.slope_y)) {
    return absl::InvalidArgumentError("a Laplacian or slope that is no number");
  }
  return CheckHeights(asked, given.seam_vertex, given.height);
}

absl::Status CheckLayerSamples(const CellHoles& asked, std::span<const int32_t> seam_vertex,
                               std::span<const double> height) {
  if (height.size() != seam_vertex.size()) return absl::InvalidArgumentError("columns of unequal length");
  std::multiset<int32_t> wanted;
  for (const CellHole& hole : asked.holes) {
    std::set<int32_t> of_hole;
    for (const RimSegment& s : hole.segments) of_hole.insert({s.from, s.to});
    for (const int32_t v : of_hole) {
      if (!asked.vertices[v].height_known) wanted.insert(asked.vertices[v].seam_vertex);
    }
  }
  for (const int32_t vertex : seam_vertex) {
    const auto it = wanted.find(vertex);
    if (it == wanted.end()) return Wrong(vertex, "not asked for, or given too often");
    wanted.erase(it);
  }
  if (!wanted.empty()) return Wrong(*wanted.begin(), "no sample");
  return CheckHeights(asked, seam_vertex, height);
}

}  // namespace tilemend
