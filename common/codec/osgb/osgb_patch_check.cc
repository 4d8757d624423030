#include "common/codec/osgb/osgb_patch_check.h"

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

constexpr double kMaxPatchCoordinate = 1e9;

bool IsOnEarth(const Point3& point) { return (point.array().abs() <= kMaxPatchCoordinate).all(); }

}  // namespace

absl::Status OsgbPatchError(const std::string& name, size_t patch, const std::string& message) {
  return absl::InvalidArgumentError(absl::StrCat(name, ": new geometry ", patch, ": ", message));
}

absl::Status CheckOsgbPatch(const OsgbPatch& patch, const Point3& translation, size_t index, const std::string& name) {
  for (const Point3& point : patch.points) {
    if (!IsOnEarth(point - translation)) return OsgbPatchError(name, index, "expected coordinates of at most 1e9 m");
  }
  const auto points = static_cast<int64_t>(patch.points.size());
  for (const Triangle& triangle : patch.triangles) {
    for (const int32_t corner : triangle) {
      if (corner >= 0 && corner < points) continue;
      return OsgbPatchError(name, index, absl::StrCat("vertex index ", corner, " of ", points, " vertices"));
    }
  }
  if (patch.image.empty() || patch.uv.size() == patch.points.size()) return absl::OkStatus();
  return OsgbPatchError(name, index, absl::StrCat(patch.uv.size(), " texture coordinates for ", points, " vertices"));
}

uint64_t BytesOfOsgbPatch(const OsgbPatch& patch) {
  constexpr uint64_t kVertexBytes = 20, kTriangleBytes = 12;
  return patch.image.size() + kVertexBytes * patch.points.size() + kTriangleBytes * patch.triangles.size();
}

}  // namespace tilemend
