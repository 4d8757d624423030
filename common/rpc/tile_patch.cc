#include "common/rpc/tile_patch.h"

#include <filesystem>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/assemble/assemble.h"
#include "common/assemble/tree_levels.h"
#include "common/codec/obj.h"
#include "common/records/patch_heights.h"
#include "common/rpc/clear_payloads.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/smoothed_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

absl::Status MalformedPatch(const char* what) {
  return absl::InvalidArgumentError(absl::StrCat("malformed payload: ", what));
}

absl::StatusOr<std::vector<HolePatch>> PatchesOf(const v1::AssembleInput& input, const FillColours& colours) {
  TILEMEND_ASSIGN_OR_RETURN(std::vector<HolePatch> patches,
                            FromProto(input.patches(), static_cast<size_t>(input.vertices().col_size())));
  int64_t points = 0;
  for (const HolePatch& patch : patches) {
    if (patch.failure.empty() && !colours.of_holes.contains(patch.hole))
      return MalformedPatch("a patch without a colour");
    points += static_cast<int64_t>(patch.new_points.size());
  }
  std::vector<std::vector<SmoothedPoint>> moves;
  for (const v1::SmoothedPoints& of_seam : input.smoothed()) {
    TILEMEND_ASSIGN_OR_RETURN(moves.emplace_back(), FromProto(of_seam, points));
  }
  if (!moves.empty()) MoveSmoothedPoints(moves, input.lattice_step(), patches);
  return patches;
}

std::vector<FilledRun> RunsOf(const std::vector<HolePatch>& patches, const FillColours& colours) {
  std::vector<FilledRun> runs;
  size_t first = 0;
  for (const HolePatch& patch : patches) {
    if (!patch.failure.empty()) continue;
    const FillColour& colour = colours.of_holes.at(patch.hole);
    runs.push_back({static_cast<int32_t>(first), colour.is_water, colour.colour});
    first += patch.triangles.size();
  }
  return runs;
}

}  // namespace

absl::StatusOr<TilePatch> TilePatchOf(const v1::AssembleInput& input) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<RimVertex> vertices, FromProto(input.vertices()));
  TILEMEND_ASSIGN_OR_RETURN(const FillColours colours, ColoursOf(input));
  std::vector<HolePatch> patches;
  if (input.has_patches()) {
    TILEMEND_ASSIGN_OR_RETURN(patches, PatchesOf(input, colours));
  }
  const CellId cell{input.tile().col(), input.tile().row()};
  const bool has_tile = !input.tile().path().empty();
  for (const RimVertex& v : vertices) {
    if (has_tile && v.tile == cell && v.index >= input.tile_vertices()) {
      return MalformedPatch("a rim vertex that the tile does not have");
    }
  }
  const int32_t tile_vertices = has_tile ? static_cast<int32_t>(input.tile_vertices()) : 0;
  TilePatch result;
  result.patch = MergePatches(vertices, patches, cell, tile_vertices, colours);
  result.runs = RunsOf(patches, colours);
  if (!has_tile || result.patch.triangles.empty()) return result;
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(input.tile().path()));
  if (input.without_colours()) {
    result.patch.materials = {{0, "tilemend_fill"}};  // defined nowhere
    return result;
  }
  if (format == MeshFormat::kObj || format == MeshFormat::kTileTree) result.materials = MaterialsOf(patches, colours);
  if (input.new_library()) result.patch.library = std::filesystem::path(input.library()).filename().string();
  return result;
}

void SetTexture(const v1::AssembleInput& input, std::vector<std::array<float, 2>> places, std::vector<Triangle> corners,
                TilePatch& added) {
  const std::filesystem::path image(input.texture());
  // The name of the image is new in the scene, and so is that of the material.
  const std::string material = "tilemend_fill_" + image.stem().string();
  constexpr Rgb kWhite = {255, 255, 255};  // the image's colours as they are
  added.materials = {{material, kWhite, image.filename().string()}};
  added.patch.materials = {{0, material}};
  added.patch.texture_places = std::move(places);
  added.patch.texture_corners = std::move(corners);
}

absl::Status TakeTexture(const v1::AssembleInput& input, std::string_view original, std::string_view written,
                         TilePatch& added) {
  const std::string name = absl::StrCat(input.tile().root(), "/", input.tile().path());
  if (IsTileTree(input.tile().path())) {
    TILEMEND_ASSIGN_OR_RETURN(added.paint, PaintOfWritten(original, written, name));
    return absl::OkStatus();
  }
  TILEMEND_ASSIGN_OR_RETURN(const ObjFile before, ParseTexturedObj(original, name, NoFaces::kAccept));
  TILEMEND_ASSIGN_OR_RETURN(ObjFile after, ParseTexturedObj(written, name));
  const size_t known = before.textures.coordinates.size(), count = added.patch.triangles.size();
  auto& places = after.textures.coordinates;
  auto& corners = after.textures.corners;
  if (places.size() < known || corners.size() < count) return MalformedPatch("a tile without its patch's texture");
  places.erase(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(known));
  corners.erase(corners.begin(), corners.end() - static_cast<std::ptrdiff_t>(count));
  for (Triangle& triangle : corners) {
    for (int32_t& corner : triangle) corner -= static_cast<int32_t>(known);
  }
  SetTexture(input, std::move(places), std::move(corners), added);
  return absl::OkStatus();
}

absl::StatusOr<PatchedBytes> PatchedTile(const v1::AssembleInput& input, const TilePatch& added,
                                         std::string_view original) {
  const FilePatch& patch = added.patch;
  const v1::TileRef& tile = input.tile();
  if (tile.path().empty()) {
    return PatchedBytes{NewPlyFile(patch, input.float32() ? NumberType::kFloat32 : NumberType::kFloat64)};
  }
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(tile.path()));
  const std::string name = absl::StrCat(tile.root(), "/", tile.path());
  PatchedBytes result;
  std::vector<TriMesh> cleared_surfaces;
  if (!tile.clear().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(ClearedTile cleared, ClearTile(tile, original));
    result = {std::move(cleared.bytes), std::move(cleared.levels)};
    cleared_surfaces = std::move(cleared.surfaces);
    if (patch.triangles.empty()) return result;
    original = result.bytes;
  }
  if (format != MeshFormat::kTileTree) {
    TILEMEND_ASSIGN_OR_RETURN(result.bytes, AppendPatch(format, original, patch, name));
    return result;
  }
  const std::string image = std::filesystem::path(input.texture()).filename().string();
  TILEMEND_ASSIGN_OR_RETURN(
      PatchedTree tree, PatchTreeLevels(original, patch, added.materials, name, added.paint, image, cleared_surfaces));
  result.bytes = std::move(tree.pack);
  AddLevels(tree.levels, result.levels);
  result.warnings = std::move(tree.warnings);
  result.new_geometries = std::move(tree.new_geometries);
  return result;
}

}  // namespace tilemend
