#include "tests/fuzz/osgb_property.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "common/codec/osgb/osgb_file.h"

namespace tilemend {
namespace {

OsgbPatch SmallPatch(int32_t geode, bool has_image) {
  OsgbPatch patch;
  patch.points = {{0.25, -0.5, 0.75}, {1000, 1.5, -0.0}, {250.0009765625, 7, 3}, {1, 2, 3}};
  patch.triangles = {{0, 1, 2}, {2, 1, 3}};
  patch.colour = {10, 20, 30};
  patch.geode = geode;
  if (!has_image) return patch;
  patch.uv = {{0, 0}, {1, 0}, {1, 1}, {0.5, 0.25}};
  patch.image = "\xff\xd8 new \xff\xd9";
  patch.image_name = "fill.jpg";
  return patch;
}

bool SameBits(const Point3& a, const Point3& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::bit_cast<uint64_t>(a[axis]) != std::bit_cast<uint64_t>(b[axis])) return false;
  }
  return true;
}

bool SameBits(const std::array<float, 2>& a, const std::array<float, 2>& b) {
  return std::bit_cast<std::array<uint32_t, 2>>(a) == std::bit_cast<std::array<uint32_t, 2>>(b);
}

// The bytes of all images with their names, sorted.
std::vector<std::string> ImagesOf(const OsgbFile& file, std::string_view bytes) {
  std::vector<std::string> images;
  for (const OsgbImage& image : file.images) {
    images.push_back(image.name + '\0' + std::string(bytes.substr(image.offset, image.size)));
  }
  std::ranges::sort(images);
  return images;
}

// Whether the vertices of geometry i and its texture are the same in both files.
bool SameGeometry(const OsgbFile& a, const OsgbGeometry& x, const OsgbFile& b, const OsgbGeometry& y) {
  if (x.vertex_count != y.vertex_count || x.geode != y.geode || (x.texture < 0) != (y.texture < 0)) return false;
  for (size_t i = 0; i < static_cast<size_t>(x.vertex_count); ++i) {
    const size_t v = static_cast<size_t>(x.first_vertex) + i;
    const size_t w = static_cast<size_t>(y.first_vertex) + i;
    if (!SameBits(a.points[v], b.points[w]) || !SameBits(a.uv[v], b.uv[w])) return false;
  }
  return x.texture < 0 ||
         a.images[static_cast<size_t>(x.texture)].name == b.images[static_cast<size_t>(y.texture)].name;
}

// Triangle i by indices into its geometry's vertices.
Triangle LocalTriangle(const OsgbFile& file, const OsgbGeometry& geometry, size_t i) {
  Triangle triangle = file.triangles[i];
  for (int32_t& corner : triangle) corner -= geometry.first_vertex;
  return triangle;
}

// The triangles of geometry x of `before` that stay, against those of geometry y of `after`.
bool SameTriangles(const OsgbFile& before, const OsgbGeometry& x, const std::vector<bool>& drop, const OsgbFile& after,
                   const OsgbGeometry& y) {
  auto next = static_cast<size_t>(y.first_triangle);
  const size_t end = next + static_cast<size_t>(y.triangle_count);
  for (size_t k = 0; k < static_cast<size_t>(x.triangle_count); ++k) {
    const size_t i = static_cast<size_t>(x.first_triangle) + k;
    if (drop[i]) continue;
    if (next == end || LocalTriangle(before, x, i) != LocalTriangle(after, y, next++)) return false;
  }
  return next == end;
}

// Finds the geometries of `before` in those of `after`, in order; what is left over has the vertices of SmallPatch.
std::string GeometryViolation(const OsgbFile& before, const std::vector<bool>& drop, const OsgbFile& after,
                              size_t added) {
  if (after.geometries.size() != before.geometries.size() + added) return "other number of geometries";
  if (after.paged_lods.size() != before.paged_lods.size()) return "other number of PagedLODs";
  // New geometries are the last of their geode, and geodes follow each other.
  std::vector<int32_t> left(after.geodes.size());
  for (const OsgbGeometry& geometry : before.geometries) {
    if (geometry.geode >= 0) ++left[static_cast<size_t>(geometry.geode)];
  }
  size_t next = 0;
  for (const OsgbGeometry& geometry : after.geometries) {
    if (geometry.geode >= 0 && left[static_cast<size_t>(geometry.geode)]-- <= 0) continue;
    if (next == before.geometries.size()) return "geometries in another order";
    if (!SameGeometry(before, before.geometries[next], after, geometry)) return "a geometry changed";
    if (!SameTriangles(before, before.geometries[next], drop, after, geometry)) return "triangles changed";
    ++next;
  }
  return next == before.geometries.size() ? "" : "geometries are missing";
}

std::string AppendViolation(const OsgbFile& before, std::string_view bytes) {
  std::vector<OsgbPatch> patches;
  for (size_t i = 0; i < std::min<size_t>(before.geodes.size(), 3); ++i) {
    patches.push_back(SmallPatch(static_cast<int32_t>(i), i % 2 == 0));
  }
  const absl::StatusOr<std::string> appended = AppendOsgb(bytes, patches, "input");
  if (!appended.ok()) {
    const absl::string_view message = appended.status().message();
    const bool is_allowed = message.find("is empty") != absl::string_view::npos ||
                            message.find("no ids are left") != absl::string_view::npos ||
                            message.find("at most 1e9 m") != absl::string_view::npos;
    return is_allowed ? "" : "appending failed: " + appended.status().ToString();
  }
  const absl::StatusOr<OsgbFile> after = ReadOsgb(*appended, "appended");
  if (!after.ok()) return "reading back failed: " + after.status().ToString();
  const auto with_image =
      static_cast<size_t>(std::ranges::count_if(patches, [](const OsgbPatch& p) { return !p.image.empty(); }));
  if (after->images.size() != before.images.size() + with_image) return "other number of images";
  if (!std::ranges::includes(ImagesOf(*after, *appended), ImagesOf(before, bytes))) return "images changed";
  return GeometryViolation(before, std::vector<bool>(before.triangles.size()), *after, patches.size());
}

std::string DropViolation(const OsgbFile& before, std::string_view bytes) {
  std::vector<bool> drop(before.triangles.size());
  for (size_t i = 0; i < drop.size(); i += 3) drop[i] = true;
  absl::StatusOr<std::string> dropped = DropOsgbTriangles(bytes, drop, "input");
  if (!dropped.ok() && dropped.status().message().find("no list of triangles") != absl::string_view::npos) {
    drop.assign(drop.size(), true);
    dropped = DropOsgbTriangles(bytes, drop, "input");
  }
  if (!dropped.ok()) return "dropping failed: " + dropped.status().ToString();
  const absl::StatusOr<OsgbFile> after = ReadOsgb(*dropped, "dropped");
  if (!after.ok()) return "reading back failed: " + after.status().ToString();
  if (ImagesOf(*after, *dropped) != ImagesOf(before, bytes)) return "images changed";
  return GeometryViolation(before, drop, *after, 0);
}

}  // namespace

std::string OsgbPropertyViolation(std::string_view bytes) {
  const absl::StatusOr<OsgbFile> before = ReadOsgb(bytes, "input");
  if (!before.ok()) {
    const bool has_place = before.status().message().find("input: byte ") != absl::string_view::npos;
    const bool is_invalid = before.status().code() == absl::StatusCode::kInvalidArgument;
    return has_place && is_invalid ? "" : before.status().ToString();
  }
  std::string violation = AppendViolation(*before, bytes);
  return violation.empty() ? DropViolation(*before, bytes) : violation;
}

}  // namespace tilemend
