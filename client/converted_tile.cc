#include "client/converted_tile.h"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/ply_header.h"
#include "common/grid/delivery_paths.h"
#include "common/util/file_pack.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

std::array<uint64_t, 3> BitsOf(const Point3& p) {
  std::array<uint64_t, 3> bits{};
  for (size_t axis = 0; axis < 3; ++axis) bits[axis] = std::bit_cast<uint64_t>(p[static_cast<int>(axis)]);
  return bits;
}

// Those of the output's file, whose fills may need more than the tile does. None of a file that is not there or
// damaged.
absl::StatusOr<PlyColumns> ColumnsOf(const std::string& path) {
  PlyColumns columns;
  const auto bytes = ReadFile(path);
  if (!bytes.ok()) return absl::IsNotFound(bytes.status()) ? absl::StatusOr<PlyColumns>(columns) : bytes.status();
  const auto header = ParsePlyHeader(*bytes, path);
  if (!header.ok()) return columns;
  columns.float64 = header->elements[header->vertex].properties[header->xyz[0]].type == PlyType::kFloat64;
  for (const PlyProperty& property : header->elements[header->face].properties) {
    columns.images = columns.images || property.name == "texnumber";
  }
  return columns;
}

absl::StatusOr<DeliveryTarget> TargetOf(const Scene& scene, const SceneTile& tile, const std::string& out) {
  const Point2 middle =
      scene.grid.corner + scene.grid.cell_size.cwiseProduct(Point2(tile.cell.col + 0.5, tile.cell.row + 0.5));
  DeliveryTarget target{.format = std::string(DeliveryFormatOf(tile.delivered)),
                        .stem = std::filesystem::path(tile.delivered).stem().string(),
                        .origin = DeliveryOrigin(tile.path, middle)};
  if (target.format == "ply") {
    TILEMEND_ASSIGN_OR_RETURN(target.ply, ColumnsOf(absl::StrCat(out, "/", tile.delivered)));
  }
  return target;
}

ExactPositions PositionsOf(const DeliveryTile& tile, const Point3& origin) {
  ExactPositions exact;
  for (const DeliveryPiece& piece : tile.pieces) {
    for (const DeliverySurface& surface : piece.surfaces) {
      for (const Point3& p : surface.mesh.points) {
        const Point3 rounded = Point3(p - origin).cast<float>().cast<double>() + origin;
        const std::array<double, 3> position = {p.x(), p.y(), p.z()};
        const auto [at, is_new] = exact.try_emplace(BitsOf(rounded), position);
        if (!is_new) at->second = std::min(at->second, position);
      }
    }
  }
  return exact;
}

// The bytes of the tile whose files these are, as ReadTileBytes has them.
std::string BytesOf(const std::vector<DeliveryFile>& files, const TileFrame& frame) {
  std::vector<PackedFile> pack;
  for (const DeliveryFile& file : files) pack.push_back({file.name, file.bytes});
  const std::string_view numbers(reinterpret_cast<const char*>(frame.data()), frame.size() * sizeof(double));
  if (!frame.empty()) pack.push_back({kFrameFile, numbers});
  return PackFiles(pack);
}

void RestoreMesh(const ExactPositions& exact, TriMesh& mesh) {
  for (Point3& p : mesh.points) {
    if (const auto found = exact.find(BitsOf(p)); found != exact.end()) p = Point3(found->second.data());
  }
}

}  // namespace

absl::StatusOr<ConvertedTile> ConvertTile(const Scene& scene, const SceneTile& tile, const std::string& out) {
  TILEMEND_ASSIGN_OR_RETURN(const DeliveryTarget target, TargetOf(scene, tile, out));
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes,
                            ReadTileBytes(absl::StrCat(scene.root, "/", tile.path), tile.frame));
  TILEMEND_ASSIGN_OR_RETURN(DeliveryTile delivery, DeliveryOf(bytes, {scene.root, tile.path, {}, ""}, target.format));
  TILEMEND_ASSIGN_OR_RETURN(std::vector<DeliveryFile> files, Deliver(delivery, target));
  ConvertedTile converted;
  const std::string name = absl::StrCat(scene.root, "/", tile.path, " as ", tile.delivered);
  const bool is_tree = IsTileTree(tile.delivered);
  const std::string written = is_tree ? BytesOf(files, OutputFrame(tile)) : std::move(files[0].bytes);
  TILEMEND_ASSIGN_OR_RETURN(converted.tile, ParseCheckedTile(written, name));
  if (target.format == "3dtiles" && !target.origin.isZero(0)) converted.exact = PositionsOf(delivery, target.origin);
  for (size_t f = 1; f < files.size() && !is_tree; ++f) {
    converted.beside.push_back({FileBesideTile(tile.delivered, files[f].name), std::move(files[f].bytes)});
  }
  return converted;
}

void Restore(const ExactPositions& exact, CheckedTile& tile) {
  if (exact.empty()) return;
  RestoreMesh(exact, tile.faces.mesh);
  for (LookedMesh& level : tile.coarser) RestoreMesh(exact, level.mesh);
}

}  // namespace tilemend
