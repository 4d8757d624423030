#include "common/assemble/tree_paint.h"

#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Numbers of the geometries of a part.
std::vector<size_t> GeometriesOf(const TreeFile& file, int32_t part) {
  std::vector<size_t> found;
  for (size_t g = 0; g < file.geometries.size(); ++g) {
    if (file.geometries[g].part == part) found.push_back(g);
  }
  return found;
}

// The paint of the geometry that a part of a written file has after those of the original.
absl::StatusOr<FacePaint> PaintIn(const TreeFile& original, const TreeFile& written, const PackedFile& packed,
                                  const TreeFaces& faces) {
  const auto missing = [&] { return absl::InvalidArgumentError(absl::StrCat(packed.name, ": no painted faces")); };
  const std::vector<size_t> after = GeometriesOf(written, faces.part);
  const size_t before = GeometriesOf(original, faces.part).size();
  if (after.size() != before + 1) return missing();
  const TreeGeometry& geometry = written.geometries[after.back()];
  if (geometry.texture < 0 || static_cast<size_t>(geometry.triangle_count) != faces.triangles.size()) return missing();
  const TreeImage& image = written.images[static_cast<size_t>(geometry.texture)];
  if (!image.is_encoded) return missing();
  FacePaint paint{std::string(packed.bytes.substr(image.offset, image.size)), {}};
  for (int32_t t = 0; t < geometry.triangle_count; ++t) {
    const Triangle& corners = written.triangles[static_cast<size_t>(geometry.first_triangle + t)];
    auto& places = paint.corners.emplace_back();
    for (size_t k = 0; k < 3; ++k) places[k] = written.uv[static_cast<size_t>(corners[k])];
  }
  return paint;
}

bool HasPaint(const TileTree& original, const TileTree& written) {
  for (const TreePiece& piece : original.pieces) {
    const auto f = static_cast<size_t>(piece.file);
    const std::vector<size_t> after = GeometriesOf(written.files[f], piece.part);
    const bool is_longer = after.size() > GeometriesOf(original.files[f], piece.part).size();
    if (is_longer && written.files[f].geometries[after.back()].texture >= 0) return true;
  }
  return false;
}

// A tile with the bytes that it points into.
struct HeldTree {
  std::string bytes;
  TileTree tile;
};

absl::StatusOr<std::shared_ptr<const HeldTree>> Hold(std::string_view pack, const std::string& name) {
  auto held = std::make_shared<HeldTree>(HeldTree{std::string(pack), {}});
  TILEMEND_ASSIGN_OR_RETURN(held->tile, ReadTileTree(held->bytes, name));
  return held;
}

}  // namespace

absl::StatusOr<TreePatch> PaintedPatch(const TreeFaces& faces, FacePaint paint, const std::string& image_name) {
  if (paint.corners.size() != faces.triangles.size()) {
    return absl::InvalidArgumentError(
        absl::StrCat(paint.corners.size(), " painted faces, expected ", faces.triangles.size()));
  }
  TreePatch patch;
  patch.part = faces.part;
  std::map<std::tuple<int32_t, float, float>, int32_t> numbers;
  for (size_t t = 0; t < faces.triangles.size(); ++t) {
    Triangle& corners = patch.triangles.emplace_back();
    for (size_t k = 0; k < 3; ++k) {
      const int32_t point = faces.triangles[t][k];
      const std::array<float, 2>& place = paint.corners[t][k];
      const auto [number, fresh] =
          numbers.try_emplace({point, place[0], place[1]}, static_cast<int32_t>(patch.points.size()));
      if (fresh) {
        patch.points.push_back(faces.points[static_cast<size_t>(point)]);
        patch.uv.push_back(place);
      }
      corners[k] = number->second;
    }
  }
  patch.image = std::move(paint.image);
  patch.image_name = image_name;
  return patch;
}

absl::StatusOr<PaintFaces> PaintOfWritten(std::string_view original, std::string_view written,
                                          const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const auto before, Hold(original, name));
  TILEMEND_ASSIGN_OR_RETURN(const auto after, Hold(written, name));
  if (before->tile.files.size() != after->tile.files.size()) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": other files than the original's"));
  }
  if (!HasPaint(before->tile, after->tile)) return PaintFaces();
  return [before, after](const TreeFaces& faces) -> absl::StatusOr<FacePaint> {
    const auto file = static_cast<size_t>(faces.file);
    return PaintIn(before->tile.files[file], after->tile.files[file], after->tile.packed[file], faces);
  };
}

}  // namespace tilemend
