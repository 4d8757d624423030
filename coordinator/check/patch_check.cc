#include "coordinator/check/patch_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/mesh/faces_down.h"
#include "common/mesh/triangle_shape.h"
#include "common/mesh/vertex_lists.h"
#include "common/records/moved_outline.h"

namespace tilemend {
namespace {

// A reason is a line for people.
constexpr size_t kMostReasonBytes = 2048;

absl::Status Wrong(int32_t hole, const std::string& what) {
  return absl::InvalidArgumentError(absl::StrCat("hole ", hole, ": ", what));
}

// Directed, sorted: the two directions of an edge are neighbours.
using Edges = std::vector<uint64_t>;

// Precondition: both below 2^31.
uint64_t EdgeKey(uint32_t from, uint32_t to) {
  const auto [lower, upper] = std::minmax(from, to);
  return static_cast<uint64_t>(lower) << 32 | static_cast<uint64_t>(upper) << 1 | (from > to ? 1 : 0);
}

uint64_t Reversed(uint64_t edge) { return edge ^ 1; }

Edges EdgesOf(const HolePatch& patch, size_t rim_vertices) {
  const auto number = [&](int32_t corner) {
    return static_cast<uint32_t>(corner >= 0 ? corner : static_cast<int64_t>(rim_vertices) - 1 - corner);
  };
  // At the lower end of each edge the other half of its key: few, which takes a third of the time to sort all.
  const VertexLists halves(rim_vertices + patch.new_points.size(), [&](const auto& use) {
    for (const Triangle& t : patch.triangles) {
      for (int k = 0; k < 3; ++k) {
        const uint64_t key = EdgeKey(number(t[k]), number(t[(k + 1) % 3]));
        use(static_cast<int32_t>(key >> 32), static_cast<int32_t>(key & UINT32_MAX));
      }
    }
  });
  Edges edges;
  edges.reserve(3 * patch.triangles.size());
  for (uint64_t v = 0; v < rim_vertices + patch.new_points.size(); ++v) {
    const std::span<const int32_t> of_vertex = halves.Of(static_cast<int32_t>(v));
    for (const int32_t half : of_vertex) edges.push_back(v << 32 | static_cast<uint32_t>(half));
    std::sort(edges.end() - std::ssize(of_vertex), edges.end());
  }
  return edges;
}

// Without the segments that a patch may leave (moved_outline.h), if those are not asked for.
Edges RimOf(const CellHole& hole, bool with_outline) {
  Edges rim;
  rim.reserve(hole.segments.size());
  for (const RimSegment& s : hole.segments) {
    if (!with_outline && hole.own_outline && s.seam) continue;
    rim.push_back(EdgeKey(static_cast<uint32_t>(s.from), static_cast<uint32_t>(s.to)));
  }
  std::sort(rim.begin(), rim.end());
  return rim;
}

// Those of which the other direction is not there. `edges` are sorted.
Edges OpenOnes(const Edges& edges) {
  Edges open;
  for (size_t i = 0; i < edges.size(); ++i) {
    const bool is_closed = i + 1 < edges.size() && edges[i + 1] == Reversed(edges[i]);
    if (is_closed) {
      ++i;
    } else {
      open.push_back(edges[i]);
    }
  }
  return open;
}

std::vector<PlacedEdge> InSpace(const Edges& edges, const CellHoles& asked, const HolePatch& patch) {
  const auto rim_vertices = static_cast<int64_t>(asked.vertices.size());
  const auto at = [&](int64_t v) {
    return v < rim_vertices ? asked.vertices[v].position : patch.new_points[v - rim_vertices];
  };
  std::vector<PlacedEdge> placed;
  for (const uint64_t edge : edges) {
    auto from = static_cast<int64_t>(edge >> 32), to = static_cast<int64_t>((edge & UINT32_MAX) >> 1);
    if ((edge & 1) != 0) std::swap(from, to);
    placed.push_back({from, to, at(from), at(to)});
  }
  return placed;
}

absl::Status CheckEdges(const CellHoles& asked, const CellHole& hole, const HolePatch& patch) {
  const auto is_flat = [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[0] == t[2]; };
  if (std::any_of(patch.triangles.begin(), patch.triangles.end(), is_flat)) {
    return Wrong(hole.id, "a triangle with a corner twice");
  }
  const Edges edges = EdgesOf(patch, asked.vertices.size()), rim = RimOf(hole, true);
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) {
    return Wrong(hole.id, "an edge with two triangles on one side");
  }
  if (!std::ranges::includes(edges, RimOf(hole, false))) return Wrong(hole.id, "a rim segment without a triangle");
  Edges inner, lost;
  inner.reserve(edges.size() - std::min(edges.size(), rim.size()));
  std::ranges::set_difference(edges, rim, std::back_inserter(inner));
  std::ranges::set_difference(rim, edges, std::back_inserter(lost));
  const Edges fresh = OpenOnes(inner);
  if (lost.empty() && fresh.empty()) return absl::OkStatus();
  const bool may_move = MayMoveOutline(InSpace(lost, asked, patch), InSpace(fresh, asked, patch));
  return may_move ? absl::OkStatus() : Wrong(hole.id, "an edge inside that is left open");
}

// As ReachOf, twice as far: a surface may go beyond its rim, but not away. Water lies where its level is, ground under
// objects at the rim where that is known.
Eigen::AlignedBox3d PlaceOf(const CellHoles& asked, const CellHole& hole) {
  Eigen::AlignedBox3d box;
  for (const RimSegment& s : hole.segments) {
    const RimVertex& v = asked.vertices[s.from];
    box.extend(v.position);
    if (v.ground) box.extend(Point3(v.position.x(), v.position.y(), *v.ground));
  }
  const double size = box.diagonal().norm();
  const Point3 middle = box.center();
  if (hole.level) box.extend(Point3(middle.x(), middle.y(), *hole.level));
  for (const Point3& station : hole.river.stations) box.extend(Point3(middle.x(), middle.y(), station.z()));
  return {box.min() - Point3::Constant(size), box.max() + Point3::Constant(size)};
}

absl::Status CheckPoints(const CellHoles& asked, const CellHole& hole, const HolePatch& patch) {
  const Eigen::AlignedBox3d place = PlaceOf(asked, hole);
  for (const Point3& p : patch.new_points) {
    // False for what is not a number, too.
    const bool inside = (p.array() >= place.min().array()).all() && (p.array() <= place.max().array()).all();
    if (!inside) return Wrong(hole.id, "a new vertex far from the hole");
  }
  return absl::OkStatus();
}

// Walls at the outlines of overlapping tiles may face down.
bool IsOverGround(const CellHole& hole, const HolePatch& patch) {
  return !hole.own_outline && (patch.way == FillWay::kGround || patch.way == FillWay::kWater);
}

absl::Status CheckTriangles(const CellHoles& asked, const CellHole& hole, const HolePatch& patch) {
  for (const Triangle& t : patch.triangles) {
    std::array<Point3, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = t[k] >= 0 ? asked.vertices[t[k]].position : patch.new_points[-1 - t[k]];
    if (TwiceVectorArea(p[0], p[1], p[2]).isZero(0)) return Wrong(hole.id, "a triangle without area");
    if (IsOverGround(hole, patch) && FacesDown(p[0], p[1], p[2])) {
      return Wrong(hole.id, "a triangle that faces down");
    }
  }
  return absl::OkStatus();
}

absl::Status CheckPatch(const CellHoles& asked, const CellHole& hole, const HolePatch& patch) {
  if (!patch.failure.empty()) {
    if (patch.failure.size() > kMostReasonBytes) return Wrong(hole.id, "a reason of many kilobytes");
    const bool bare = patch.triangles.empty() && patch.new_points.empty() && !patch.hold_out;
    return bare ? absl::OkStatus() : Wrong(hole.id, "both a reason to leave it and a patch");
  }
  if (patch.way == FillWay::kNone) return Wrong(hole.id, "filled in no way");
  absl::Status status = CheckEdges(asked, hole, patch);
  if (status.ok()) status = CheckPoints(asked, hole, patch);
  return status.ok() ? CheckTriangles(asked, hole, patch) : status;
}

absl::Status CheckQuality(const std::vector<HolePatch>& patches, const QualityTally& quality) {
  int64_t triangles = 0;
  for (const HolePatch& patch : patches) triangles += static_cast<int64_t>(patch.triangles.size());
  int64_t sum = 0;
  bool fits = quality.triangles == triangles;
  for (const int64_t n : quality.histogram) {
    fits = fits && n >= 0 && n <= triangles;
    sum += fits ? n : 0;
  }
  fits = fits && sum == triangles && quality.poor >= 0 && quality.poor <= triangles && quality.poor_forced >= 0 &&
         quality.poor_forced <= quality.poor && quality.sum_millionths >= 0 &&
         quality.sum_millionths <= 1'000'000 * triangles && quality.least >= 0 && quality.least <= 1;
  return fits ? absl::OkStatus() : absl::InvalidArgumentError("a quality that is not that of the triangles");
}

}  // namespace

absl::Status CheckPatches(const CellHoles& asked, const std::vector<HolePatch>& patches, const QualityTally& quality) {
  std::map<int32_t, const HolePatch*> given;
  for (const HolePatch& patch : patches) {
    if (!given.emplace(patch.hole, &patch).second) return Wrong(patch.hole, "two patches");
  }
  for (const CellHole& hole : asked.holes) {
    const auto patch = given.find(hole.id);
    if (patch == given.end()) return Wrong(hole.id, "no patch");
    absl::Status status = CheckPatch(asked, hole, *patch->second);
    if (!status.ok()) return status;
  }
  if (given.size() != asked.holes.size())
    return absl::InvalidArgumentError("a patch for a hole that was not asked for");
  return CheckQuality(patches, quality);
}

}  // namespace tilemend
