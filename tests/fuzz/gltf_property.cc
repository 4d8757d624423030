#include "tests/fuzz/gltf_property.h"

#include <algorithm>
#include <cmath>

#include "common/codec/gltf/gltf_container.h"
#include "tests/support/gltf_samples.h"

namespace tilemend {
namespace {

constexpr const char* kAllowedRefusals[] = {"two nodes share mesh", "cannot be inverted", "no finite float32",
                                            "first buffer is not",  "expected an array",  "expected true or false"};

bool HasPlace(const absl::Status& status) {
  return status.message().find("input: byte ") == 0 || status.message().find("input: JSON /") == 0;
}

// Accessors of compressed primitives are not read before they are written plainly.
bool IsAllowed(const GltfFile& file, const absl::Status& status) {
  if (std::ranges::any_of(file.primitives, &GltfPrimitive::is_draco) && HasPlace(status)) return true;
  return std::ranges::any_of(kAllowedRefusals,
                             [&](const char* text) { return status.message().find(text) != absl::string_view::npos; });
}

// The triangles that stay, as positions.
std::vector<SpaceTriangle> KeptSpace(const GltfFile& file, const std::vector<bool>& drop) {
  std::vector<SpaceTriangle> kept;
  for (size_t i = 0; i < file.triangles.size(); ++i) {
    if (!drop.empty() && drop[i]) continue;
    SpaceTriangle& triangle = kept.emplace_back();
    for (size_t k = 0; k < 3; ++k) triangle[k] = file.points[static_cast<size_t>(file.triangles[i][k])];
  }
  return kept;
}

std::vector<std::string_view> ImagesOf(const GltfFile& file, std::string_view bytes) {
  std::vector<std::string_view> images;
  for (const GltfImage& image : file.images) images.push_back(bytes.substr(image.offset, image.size));
  return images;
}

// Whether the triangles of `before` are there in order, with `added` more somewhere between.
bool HoldsInOrder(const std::vector<SpaceTriangle>& before, const std::vector<SpaceTriangle>& after, size_t added) {
  size_t next = 0;
  for (const SpaceTriangle& triangle : after) {
    if (next < before.size() && before[next] == triangle) ++next;
  }
  return next == before.size() && after.size() == before.size() + added;
}

}  // namespace

GltfPatch GltfTriangle(const GltfFile& file, int32_t node) {
  GltfPatch patch;
  Point3 at = file.nodes[static_cast<size_t>(node)].matrix.topRightCorner<3, 1>();
  if (!file.points.empty()) at = file.points.front();
  patch.points = {at, at + Point3(1, 0, 0), at + Point3(0, 1, 0.5)};
  patch.uv = {{0, 0}, {0.5, 0}, {0, 0.25}};
  patch.triangles = {{0, 1, 2}};
  patch.image = OnePixelPng();
  patch.image_name = "fill.png";
  patch.node = node;
  return patch;
}

GltfEdit SampleGltfEdit(const GltfFile& file) {
  GltfEdit edit;
  edit.drop.resize(file.triangles.size());
  for (size_t i = 0; i < edit.drop.size(); i += 3) edit.drop[i] = true;
  if (!file.nodes.empty()) {
    edit.patches.push_back(GltfTriangle(file, 0));
    edit.patches.push_back(GltfTriangle(file, static_cast<int32_t>(file.nodes.size()) - 1));
    edit.patches.back().image.clear();
    edit.patches.back().uv.clear();
  }
  return edit;
}

std::string GltfPropertyViolation(std::string_view bytes) {
  const absl::StatusOr<GltfFile> before = ReadGltf(bytes, GltfUpAxis::kY, "input");
  if (!before.ok()) return HasPlace(before.status()) ? "" : before.status().ToString();
  const GltfEdit edit = SampleGltfEdit(*before);
  const absl::StatusOr<std::string> changed = ChangeGltf(bytes, GltfUpAxis::kY, edit, "input");
  if (!changed.ok())
    return IsAllowed(*before, changed.status()) ? "" : "changing failed: " + changed.status().ToString();
  const absl::StatusOr<GltfFile> after = ReadGltf(*changed, GltfUpAxis::kY, "changed");
  if (!after.ok()) return "reading back failed: " + after.status().ToString();
  const std::vector<std::string_view> images = ImagesOf(*before, bytes), now = ImagesOf(*after, *changed);
  if (now.size() < images.size() || !std::equal(images.begin(), images.end(), now.begin())) return "images changed";
  if (!HoldsInOrder(KeptSpace(*before, edit.drop), KeptSpace(*after, {}), edit.patches.size())) {
    return "triangles changed";
  }
  const auto old_container = ParseGltfContainer(bytes, "input"), container = ParseGltfContainer(*changed, "changed");
  if (!container->bin.starts_with(old_container->bin)) return "the binary chunk changed";
  if (container->trailing != old_container->trailing) return "a chunk changed";
  return "";
}

}  // namespace tilemend
