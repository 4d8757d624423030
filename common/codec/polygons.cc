#include "common/codec/polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "absl/strings/str_cat.h"
#include "common/codec/text.h"
#include "common/mesh/triangulation/cut_polygon.h"

namespace tilemend {
namespace {

bool HasRepeatedCorner(const std::vector<int32_t>& corners) {
  constexpr size_t kFewCorners = 8;  // up to here comparing all pairs beats sorting
  if (corners.size() <= kFewCorners) {
    for (size_t i = 1; i < corners.size(); ++i) {
      for (size_t k = 0; k < i; ++k) {
        if (corners[k] == corners[i]) return true;
      }
    }
    return false;
  }
  std::vector<int32_t> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

// The places of the corners but for those that repeat the one before, or the last the first.
std::vector<int32_t> PlacesWithoutRepeats(const std::vector<int32_t>& corners) {
  std::vector<int32_t> places;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (places.empty() || corners[i] != corners[places.back()]) places.push_back(static_cast<int32_t>(i));
  }
  while (places.size() > 1 && corners[places.back()] == corners[places.front()]) places.pop_back();
  return places;
}

}  // namespace

void AddPolygon(const std::vector<int32_t>& corners, MeshFile& file, std::vector<Triangle>& cut,
                std::span<const Point3> all) {
  cut.clear();
  if (corners.size() > 3) ++file.polygon_count;
  if (corners.size() < 3) return;
  const std::span<const Point3> points = all.empty() ? std::span<const Point3>(file.mesh.points) : all;
  if (HasRepeatedCorner(corners)) {
    const std::vector<int32_t> places = PlacesWithoutRepeats(corners);
    std::vector<int32_t> others;
    for (const int32_t place : places) others.push_back(corners[place]);
    if (others.size() < 3 || HasRepeatedCorner(others)) return;
    CutPolygon(others, points, cut);
    for (Triangle& t : cut) t = {places[t[0]], places[t[1]], places[t[2]]};
  } else {
    CutPolygon(corners, points, cut);
  }
  for (const Triangle& t : cut) file.mesh.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
}

void AddPolygon(const std::vector<int32_t>& corners, std::span<const TextRange> places, const FaceVisitor& visit,
                MeshFile& file, std::vector<Triangle>& cut, std::span<const Point3> all) {
  const size_t first = file.mesh.triangles.size();
  AddPolygon(corners, file, cut, all);
  if (visit && !cut.empty()) visit(first, places, cut);
}

namespace {

absl::Status CheckTexture(const FilePatch& patch, const std::string& name) {
  const auto invalid = [&name](const auto&... text) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": bad patch: ", text...));
  };
  if (patch.texture_places.empty() && patch.texture_corners.empty()) return absl::OkStatus();
  if (patch.texture_corners.size() != patch.triangles.size()) {
    return invalid(patch.triangles.size(), " triangles but ", patch.texture_corners.size(), " with places in an image");
  }
  for (const std::array<float, 2>& place : patch.texture_places) {
    if (!std::isfinite(place[0]) || !std::isfinite(place[1])) return invalid("a place in an image that is no number");
  }
  for (const Triangle& t : patch.texture_corners) {
    for (const int32_t corner : t) {
      if (corner < 0 || corner >= static_cast<int64_t>(patch.texture_places.size())) {
        return invalid("no place ", corner, " in an image");
      }
    }
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status CheckPatch(const FilePatch& patch, size_t vertex_count, const std::string& name) {
  const auto invalid = [&name](const auto&... text) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": bad patch: ", text...));
  };
  if (patch.like.size() != patch.new_points.size()) {
    return invalid(patch.new_points.size(), " new points but ", patch.like.size(), " models for them");
  }
  if (!patch.colours.empty() && patch.colours.size() != patch.new_points.size()) {
    return invalid(patch.new_points.size(), " new points but ", patch.colours.size(), " colours for them");
  }
  const size_t total = vertex_count + patch.new_points.size();
  if (total > static_cast<size_t>(std::numeric_limits<int32_t>::max())) return invalid(total, " vertices are too many");
  if (!patch.cut_from.empty() && patch.cut_from.size() != patch.triangles.size()) {
    return invalid(patch.triangles.size(), " triangles but ", patch.cut_from.size(), " that they were cut from");
  }
  for (const int32_t model : patch.like) {
    if (model < -1 || model >= static_cast<int64_t>(vertex_count)) return invalid("no vertex ", model, " to be like");
  }
  for (const Point3& p : patch.new_points) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!IsValidCoordinate(p[axis])) return invalid("coordinate ", p[axis]);
    }
  }
  for (const Triangle& t : patch.triangles) {
    for (const int32_t corner : t) {
      if (corner < 0 || corner >= static_cast<int64_t>(total)) return invalid("no vertex ", corner);
    }
  }
  return CheckTexture(patch, name);
}

}  // namespace tilemend
