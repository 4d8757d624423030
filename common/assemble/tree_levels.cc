#include "common/assemble/tree_levels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "absl/strings/str_format.h"
#include "common/assemble/fill_level.h"
#include "common/codec/tree/tile_tree.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr Rgb kUnknownColour{128, 128, 128};

// Hands the triangles of a patch to the pieces of one level.
class PieceChoice {
 public:
  // Of the pieces of `level` that are `wanted`.
  template <typename Wanted>
  PieceChoice(const TileTree& tile, const TreeLevel& level, const Wanted& wanted) {
    for (size_t p = 0; p < level.parts.size(); ++p) {
      const TreePiece& piece = tile.pieces[level.parts[p].piece];
      const auto begin = static_cast<size_t>(level.parts[p].first_vertex);
      const size_t end =
          p + 1 < level.parts.size() ? static_cast<size_t>(level.parts[p + 1].first_vertex) : level.mesh.points.size();
      if (!wanted(piece) || begin == end) continue;
      Eigen::AlignedBox3d box;
      for (size_t v = begin; v < end; ++v) box.extend(level.mesh.points[v]);
      pieces_.emplace_back(level.parts[p].piece, box);
    }
  }

  bool empty() const { return pieces_.empty(); }

  // Seen from above; of pieces above each other the one at this height.
  int32_t Of(const Point3& middle) const {
    const double far = std::numeric_limits<double>::infinity();
    std::pair<double, double> least{far, far};
    int32_t best = -1;
    for (const auto& [piece, box] : pieces_) {
      const Point3 gap = (box.min() - middle).cwiseMax(middle - box.max()).cwiseMax(0);
      const std::pair<double, double> distance{gap.head<2>().squaredNorm(), gap.z()};
      if (distance < least) std::tie(least, best) = std::pair(distance, piece);
    }
    return best;
  }

 private:
  std::vector<std::pair<int32_t, Eigen::AlignedBox3d>> pieces_;
};

// The new faces of one piece, of one material if they are not painted.
struct Share {
  TreeFaces faces;
  std::unordered_map<int32_t, int32_t> number;  // of the level's vertices and the new ones
};

class LevelPatcher {
 public:
  LevelPatcher(const TileTree& tile, std::span<const FillMaterial> materials, const PaintFaces& paint,
               const std::string& image_name)
      : tile_(tile),
        paint_(paint),
        image_name_(image_name),
        edits_(tile.files.size()),
        levels_(static_cast<size_t>(tile.levels)),
        new_geometries_(tile.pieces.size()) {
    for (const FillMaterial& material : materials) colours_[material.name] = material.colour;
  }

  // Of the level that is `above_finest` levels coarser than the finest.
  absl::Status Add(const TreeLevel& level, int32_t above_finest, const FilePatch& patch, const PieceChoice& choice) {
    if (choice.empty()) return absl::OkStatus();
    for (auto& [key, share] : SharesOf(level, patch, choice)) {
      const TreePiece& piece = tile_.pieces[key.first];
      share.faces.file = piece.file;
      share.faces.part = piece.part;
      share.faces.above_finest = above_finest;
      Count(key.first, std::ssize(share.faces.triangles));
      TILEMEND_ASSIGN_OR_RETURN(TreePatch made, PatchOf(std::move(share.faces)));
      edits_[piece.file].patches.push_back(std::move(made));
      ++new_geometries_[static_cast<size_t>(key.first)];
    }
    return absl::OkStatus();
  }

  const std::vector<TreeEdit>& edits() const { return edits_; }
  const std::vector<LevelCounts>& levels() const { return levels_; }
  const std::vector<int32_t>& new_geometries() const { return new_geometries_; }

 private:
  void Count(int32_t piece, int64_t triangles) {
    LevelCounts& level = levels_[static_cast<size_t>(tile_.pieces[piece].level)];
    level.filled += filled_.insert(piece).second ? 1 : 0;
    level.added += triangles;
  }

  using Shares = std::map<std::pair<int32_t, size_t>, Share>;  // by piece and run; painted ones have the run 0

  Shares SharesOf(const TreeLevel& level, const FilePatch& patch, const PieceChoice& choice) const {
    Shares shares;
    size_t run = 0;
    const auto old = static_cast<int32_t>(level.mesh.points.size());
    const auto at = [&](int32_t v) { return v < old ? level.mesh.points[v] : patch.new_points[v - old]; };
    for (size_t t = 0; t < patch.triangles.size(); ++t) {
      while (run + 1 < patch.materials.size() && static_cast<size_t>(patch.materials[run + 1].first) <= t) ++run;
      const Triangle& triangle = patch.triangles[t];
      const Point3 middle = (at(triangle[0]) + at(triangle[1]) + at(triangle[2])) / 3;
      Share& share = shares[{choice.Of(middle), paint_ ? 0 : run}];
      share.faces.colours.push_back(ColourOf(patch, run));
      Triangle& own = share.faces.triangles.emplace_back();
      for (int k = 0; k < 3; ++k) {
        const auto [number, fresh] = share.number.emplace(triangle[k], static_cast<int32_t>(share.faces.points.size()));
        if (fresh) share.faces.points.push_back(at(triangle[k]));
        own[k] = number->second;
      }
    }
    return shares;
  }

  absl::StatusOr<TreePatch> PatchOf(TreeFaces faces) const {
    if (paint_) {
      TILEMEND_ASSIGN_OR_RETURN(FacePaint paint, paint_(faces));
      return PaintedPatch(faces, std::move(paint), image_name_);
    }
    TreePatch patch;
    patch.part = faces.part;
    patch.colour = faces.colours.front();
    patch.points = std::move(faces.points);
    patch.triangles = std::move(faces.triangles);
    return patch;
  }

  Rgb ColourOf(const FilePatch& patch, size_t run) const {
    if (run >= patch.materials.size()) return kUnknownColour;
    const auto at = colours_.find(patch.materials[run].material);
    return at == colours_.end() ? kUnknownColour : at->second;
  }

  const TileTree& tile_;
  const PaintFaces& paint_;
  const std::string& image_name_;
  std::map<std::string, Rgb> colours_;
  std::vector<TreeEdit> edits_;
  std::vector<LevelCounts> levels_;
  std::vector<int32_t> new_geometries_;  // by piece
  std::set<int32_t> filled_;             // pieces
};

// Adds a triangle of a piece to the levels at which a viewer shows the piece.
void AddToLevels(const TreePiece& piece, const TreeFile& file, const Triangle& triangle,
                 std::vector<TriMesh>& surfaces) {
  const size_t last = piece.is_finest ? surfaces.size() : static_cast<size_t>(piece.level) + 1;
  for (auto l = static_cast<size_t>(piece.level); l < std::min(last, surfaces.size()); ++l) {
    const auto first = static_cast<int32_t>(surfaces[l].points.size());
    for (const int32_t v : triangle) surfaces[l].points.push_back(file.points[v]);
    surfaces[l].triangles.push_back({first, first + 1, first + 2});
  }
}

std::string WarningOf(int32_t level, const std::vector<Point2>& open, const std::string& name) {
  return absl::StrFormat(
      "%s: level of detail %d (0 the coarsest): %d %s open there, which cannot be triangulated; the "
      "first at [%.3f,%.3f]",
      name, level, open.size(), open.size() == 1 ? "hole stays" : "holes stay", open[0].x(), open[0].y());
}

}  // namespace

absl::StatusOr<ClearedTile> ClearTreeLevels(std::string_view pack, std::span<const ClearArea> areas,
                                            const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const TileTree tile, ReadTileTree(pack, name));
  std::vector<TreeEdit> edits(tile.files.size());
  std::vector<int64_t> taken(areas.size(), 0);
  std::vector<LevelCounts> levels(static_cast<size_t>(tile.levels));
  std::vector<TriMesh> surfaces(static_cast<size_t>(std::max(tile.levels - 1, 0)));
  for (size_t f = 0; f < tile.files.size(); ++f) {
    const TreeFile& file = tile.files[f];
    const std::vector<int32_t> cleared_by =
        AreasThatClear({PointRows(file.points), TriangleRows(file.triangles)}, areas);
    bool any = false;
    for (const int32_t area : cleared_by) any = any || area >= 0;
    if (any) {
      for (const int32_t area : cleared_by) edits[f].drop.push_back(area >= 0);
    }
    for (const TreePiece& piece : tile.pieces) {
      if (piece.file != static_cast<int32_t>(f)) continue;
      for (const TreeGeometry& geometry : file.geometries) {
        if (geometry.part != piece.part) continue;
        for (int32_t t = 0; t < geometry.triangle_count; ++t) {
          const int32_t area = cleared_by[geometry.first_triangle + t];
          if (area < 0) continue;
          ++levels[static_cast<size_t>(piece.level)].removed;
          if (piece.is_finest) ++taken[static_cast<size_t>(area)];
          AddToLevels(piece, file, file.triangles[geometry.first_triangle + t], surfaces);
        }
      }
    }
  }
  ClearedTile cleared;
  cleared.triangles = std::move(taken);
  cleared.levels = std::move(levels);
  cleared.surfaces = std::move(surfaces);
  TILEMEND_ASSIGN_OR_RETURN(cleared.bytes, ChangeTileTree(tile, edits, name));
  TILEMEND_ASSIGN_OR_RETURN(cleared.file, ParseMesh(MeshFormat::kTileTree, cleared.bytes, name, NoFaces::kAccept));
  return cleared;
}

absl::StatusOr<PatchedTree> PatchTreeLevels(std::string_view pack, const FilePatch& patch,
                                            std::span<const FillMaterial> materials, const std::string& name,
                                            const PaintFaces& paint, const std::string& image_name,
                                            std::span<const TriMesh> cleared) {
  TILEMEND_ASSIGN_OR_RETURN(const TileTree tile, ReadTileTree(pack, name));
  const TreeLevel finest = LevelOf(tile, tile.levels - 1);
  LevelPatcher patcher(tile, materials, paint, image_name);
  TILEMEND_RETURN_IF_ERROR(
      patcher.Add(finest, 0, patch, PieceChoice(tile, finest, [](const TreePiece& piece) { return piece.is_finest; })));
  std::vector<std::string> warnings;
  for (int32_t l = 0; l + 1 < tile.levels; ++l) {
    const TreeLevel level = LevelOf(tile, l);
    const PieceChoice choice(tile, level, [](const TreePiece& piece) { return !piece.is_finest; });
    if (choice.empty()) continue;
    const auto number = static_cast<size_t>(l);
    const LevelFill coarse =
        FillLevel(level.mesh, finest.mesh, patch, number < cleared.size() ? cleared[number] : TriMesh());
    if (!coarse.open.empty()) warnings.push_back(WarningOf(l, coarse.open, name));
    TILEMEND_RETURN_IF_ERROR(patcher.Add(level, tile.levels - 1 - l, coarse.patch, choice));
  }
  TILEMEND_ASSIGN_OR_RETURN(std::string changed, ChangeTileTree(tile, patcher.edits(), name));
  return PatchedTree{std::move(changed), patcher.levels(), std::move(warnings), patcher.new_geometries()};
}

}  // namespace tilemend
