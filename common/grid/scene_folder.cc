#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_split.h"
#include "common/grid/grid_fit.h"
#include "common/grid/scene_sources.h"
#include "common/grid/tile_hulls.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

// Takes the last "_+CCC" off `stem`; nullopt if there is none.
std::optional<int32_t> TakeIndex(std::string_view* stem) {
  const size_t underscore = stem->rfind('_');
  if (underscore == std::string_view::npos || underscore + 2 >= stem->size()) return std::nullopt;
  const char sign = (*stem)[underscore + 1];
  if (sign != '+' && sign != '-') return std::nullopt;
  const char* const begin = stem->data() + underscore + 2;
  const char* const end = stem->data() + stem->size();
  uint32_t value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || value >= static_cast<uint32_t>(kMaxCellsPerSide)) return std::nullopt;
  stem->remove_suffix(stem->size() - underscore);
  return sign == '-' ? -static_cast<int32_t>(value) : static_cast<int32_t>(value);
}

// What a name like Tile_+003_-001 says.
struct NameOfTile {
  CellId cell;
  bool has_third = false;  // three indices: the tiles are cut in height, too
};

std::optional<NameOfTile> ReadName(std::string_view stem) {
  const std::optional<int32_t> row = TakeIndex(&stem);
  const std::optional<int32_t> col = row.has_value() ? TakeIndex(&stem) : std::nullopt;
  if (!col.has_value()) return std::nullopt;
  return NameOfTile{{*col, *row}, TakeIndex(&stem).has_value()};
}

// The entries of a folder that are of one kind, sorted by name; none if there is no such folder. A link to nothing that
// has a tile's name is an error: a cell that is left out in silence is a hole that nobody sees.
absl::StatusOr<std::vector<fs::path>> List(const fs::path& folder, PathKind kind) {
  std::vector<fs::path> found;
  const auto entries = ListKinds(folder.string());
  if (absl::IsNotFound(entries.status())) return found;
  TILEMEND_RETURN_IF_ERROR(entries.status());
  for (const FolderEntry& entry : *entries) {
    const fs::path path = folder / entry.name;
    if (entry.kind == kind) found.push_back(path);
    if (entry.kind == PathKind::kNothing && ReadName(path.stem().string()).has_value()) {
      TILEMEND_RETURN_IF_ERROR(IsThere(path.string()).status());
    }
  }
  return found;
}

// What was found in the folder, by names only.
struct Findings {
  std::map<CellId, fs::path> tiles;
  bool in_folders = false;  // a tile is a folder, as photogrammetry writes them
  std::string unread;       // a tile by its name, in a format that is not read
  std::string unnumbered;   // a tile by its place, whose name has no column and row
  int64_t similar = 0;      // meshes, or packed files, whose names have column and row and more behind
  std::string first_similar;
  std::string problem;  // why the scene cannot be read
  std::vector<std::string> warnings;
};

// Whether "_+000_-014" or the like is anywhere in a name.
bool HasColumnAndRow(std::string_view name) {
  for (size_t end = name.size(); end > 0; --end) {
    std::string_view stem = name.substr(0, end);
    if (absl::ascii_isdigit(static_cast<unsigned char>(stem.back())) && ReadName(stem).has_value()) return true;
  }
  return false;
}

// Takes note of what is likely a tile under another name: Tile_+000_+014_L17.obj, Tile_+000_+014.ply.gz.
void NoteSimilar(const fs::path& file, Findings* findings) {
  constexpr std::string_view kPacked[] = {".gz", ".bz2", ".xz", ".zst", ".zip", ".7z"};
  const std::string extension = file.extension().string();
  const bool may_be = IsTileFormat(file.string()) || IsTileTree(file.string()) ||
                      std::ranges::find(kPacked, extension) != std::end(kPacked);
  if (!may_be || !HasColumnAndRow(file.filename().string())) return;
  if (findings->similar++ == 0) findings->first_similar = file.filename().string();
}

absl::Status AddTile(CellId cell, const fs::path& file, Findings* findings) {
  const auto [at, fresh] = findings->tiles.emplace(cell, file);
  if (fresh) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat(at->second.string(), " and ", file.string(), " are both cell ", ToString(cell)));
}

void CheckIndices(const NameOfTile& name, const fs::path& entry, Findings* findings) {
  if (!name.has_third) return;
  findings->problem = absl::StrCat(entry.string(), ": a name with three numbers, as of tiles that are cut in height, ",
                                   "too. Such scenes are not read; export the mesh in tiles of a plane grid");
}

// Tiles that are files of `folder`.
absl::Status FindFiles(const fs::path& folder, Findings* findings) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<fs::path> entries, List(folder, PathKind::kFile));
  for (const fs::path& entry : entries) {
    const std::optional<NameOfTile> name = ReadName(entry.stem().string());
    if (!name.has_value()) {
      NoteSimilar(entry, findings);
      continue;
    }
    if (IsTileTree(entry.string())) {
      findings->problem = absl::StrCat(entry.string(), ": an .osgb tile has to lie in a folder of its own, as ",
                                       entry.stem().string(), "/", entry.filename().string());
    } else if (IsTileFormat(entry.string())) {
      CheckIndices(*name, entry, findings);
      TILEMEND_RETURN_IF_ERROR(AddTile(name->cell, entry, findings));
    } else if (entry.extension() != ".mtl") {
      findings->unread = entry.string();
    }
  }
  return absl::OkStatus();
}

// The mesh of one tile folder: named as the folder, or the only one. Empty if there is none.
absl::StatusOr<fs::path> MeshOfFolder(const fs::path& folder, Findings* findings) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<fs::path> entries, List(folder, PathKind::kFile));
  std::vector<fs::path> named;
  std::vector<fs::path> meshes;
  for (const fs::path& entry : entries) {
    const bool same_name = entry.stem() == folder.filename();
    if (!IsTileFormat(entry.string())) {
      if (same_name && entry.extension() != ".mtl") findings->unread = entry.string();
      if (!same_name) NoteSimilar(entry, findings);
      continue;
    }
    meshes.push_back(entry);
    if (same_name) named.push_back(entry);
  }
  if (named.empty() && meshes.size() > 1 && IsTileTree(meshes[0].string())) {
    return absl::NotFoundError(absl::StrCat((folder / folder.filename()).string(),
                                            ".osgb: is not there, the top of the tile's tree; without it the ",
                                            meshes.size(), " other files there cannot be read"));
  }
  const std::vector<fs::path>& choice = named.empty() ? meshes : named;
  if (choice.size() > 1) {
    return absl::InvalidArgumentError(absl::StrCat(choice[0].string(), " and ", choice[1].string(),
                                                   " could both be the tile ", folder.filename().string()));
  }
  return choice.empty() ? fs::path() : choice[0];
}

// A folder that has a mesh of its own name: BlockA/BlockA.obj, Tile_1/Tile_1.osgb.
void NoteUnnumbered(const fs::path& folder, Findings* findings) {
  for (const char* const extension : {".osgb", ".obj", ".ply"}) {
    const fs::path mesh = folder / (folder.filename().string() + extension);
    if (findings->unnumbered.empty() && KindOf(mesh.string()) == PathKind::kFile) findings->unnumbered = mesh.string();
  }
}

// Tiles that are folders of `folder`.
absl::Status FindFolders(const fs::path& folder, Findings* findings) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<fs::path> entries, List(folder, PathKind::kFolder));
  for (const fs::path& entry : entries) {
    const std::optional<NameOfTile> name = ReadName(entry.filename().string());
    if (!name.has_value()) {
      NoteUnnumbered(entry, findings);
      continue;
    }
    CheckIndices(*name, entry, findings);
    TILEMEND_ASSIGN_OR_RETURN(const fs::path mesh, MeshOfFolder(entry, findings));
    if (mesh.empty()) {
      findings->warnings.push_back(
          absl::StrCat(entry.string(), ": no .ply, .obj or .osgb in it; the cell is left out"));
      continue;
    }
    TILEMEND_RETURN_IF_ERROR(AddTile(name->cell, mesh, findings));
    findings->in_folders = true;
  }
  return absl::OkStatus();
}

absl::StatusOr<Findings> FindTiles(const std::string& root) {
  Findings findings;
  TILEMEND_RETURN_IF_ERROR(FindFiles(root, &findings));
  TILEMEND_RETURN_IF_ERROR(FindFiles(fs::path(root) / "tiles", &findings));
  TILEMEND_RETURN_IF_ERROR(FindFolders(fs::path(root) / "Data", &findings));
  TILEMEND_RETURN_IF_ERROR(FindFolders(root, &findings));
  if (!findings.problem.empty()) return absl::InvalidArgumentError(findings.problem);
  if (!findings.tiles.empty()) return findings;
  if (!findings.unread.empty()) {
    const std::string format = fs::path(findings.unread).extension().string();
    return absl::InvalidArgumentError(
        absl::StrCat(findings.unread, ": format \"", format, "\" is not read; tiles are .ply, .obj or .osgb"));
  }
  if (!findings.unnumbered.empty()) {
    return absl::InvalidArgumentError(
        absl::StrCat(findings.unnumbered, ": a name without column and row, as Tile_+000_+014 has. Write a scene.json ",
                     "that says which cell each tile is, or export the mesh in tiles of a regular plane grid"));
  }
  std::string similar;
  if (findings.similar > 0) {
    similar =
        absl::StrCat("; found ", findings.similar, findings.similar == 1 ? " file named " : " files such as ",
                     Printable(findings.first_similar), ": unpack or rename ", findings.similar == 1 ? "it" : "them");
  }
  return absl::NotFoundError(absl::StrCat(root, ": no scene.json, and no tile named like Tile_+000_+014.ply in it, in ",
                                          "tiles/ or in Data/Tile_+000_+014/", similar));
}

// "500000.0,4100000.0,0"
bool ParseOrigin(const std::string& text, Point3* origin) {
  const std::vector<std::string> parts = absl::StrSplit(text, ',');
  if (parts.size() != 3) return false;
  for (int i = 0; i < 3; ++i) {
    if (!absl::SimpleAtod(parts[i], &(*origin)[i]) || !std::isfinite((*origin)[i])) return false;
  }
  return true;
}

// For people: the scene has none. It may be that of the folder above, if the scene is given as its Data.
std::string MissingMetadata(const fs::path& root) {
  std::error_code failure;
  const fs::path folder = fs::weakly_canonical(root, failure);
  const std::string above = folder.parent_path().string();
  const bool is_above = !failure && folder.filename() == "Data" && fs::exists(above + "/metadata.xml", failure);
  return absl::StrCat(root.string(), ": no metadata.xml; the output has no CRS, and the origin is taken as 0, 0, 0",
                      is_above ? absl::StrCat("; there is one in ", above, ": give that folder") : "");
}

// CRS and origin from metadata.xml, which need not be there.
absl::Status ReadMetadata(const std::string& root, bool expected, Scene* scene) {
  const std::string path = (fs::path(root) / "metadata.xml").string();
  TILEMEND_ASSIGN_OR_RETURN(const bool is_there, IsThere(path));
  if (!is_there) {
    if (expected) scene->warnings.push_back(MissingMetadata(root));
    return absl::OkStatus();
  }
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadFile(path));
  return ParseMetadata(text, path, scene);
}

// Numbers the cells from 0, as everywhere else: shifts negative indices and the grid's corner with them.
void ShiftToZero(Scene* scene) {
  CellId least{0, 0};
  for (const SceneTile& tile : scene->tiles) {
    least.col = std::min(least.col, tile.cell.col);
    least.row = std::min(least.row, tile.cell.row);
  }
  if (least == CellId{0, 0}) return;
  for (SceneTile& tile : scene->tiles) tile.cell = {tile.cell.col - least.col, tile.cell.row - least.row};
  scene->grid.corner += scene->grid.cell_size.cwiseProduct(Point2(least.col, least.row));
  scene->warnings.push_back(
      absl::StrCat("the tiles' names have negative indices; cell ", ToString(least), " is numbered +000_+000 here"));
}

void SetExtent(Scene* scene) {
  for (const SceneTile& tile : scene->tiles) {
    scene->cols = std::max(scene->cols, tile.cell.col + 1);
    scene->rows = std::max(scene->rows, tile.cell.row + 1);
  }
}

absl::StatusOr<std::vector<PlacedTile>> ReadBounds(const Findings& findings, const HullReader& read_hull) {
  std::vector<CellId> cells;
  std::vector<std::string> files;
  for (const auto& [cell, file] : findings.tiles) {
    cells.push_back(cell);
    files.push_back(file.string());
  }
  std::vector<PlacedTile> placed;
  for (const size_t t : TilesToLookAt(cells)) {
    TILEMEND_ASSIGN_OR_RETURN(const ConvexHull hull, read_hull(files[t], {}));
    placed.push_back({cells[t], files[t], BoundsOf(hull, 0)});
  }
  return placed;
}

std::string GridWarning(const Scene& scene, size_t looked_at) {
  const Grid& grid = scene.grid;
  const std::string tiles = looked_at == scene.tiles.size()
                                ? absl::StrCat(looked_at, " tiles")
                                : absl::StrCat(looked_at, " of ", scene.tiles.size(), " tiles");
  return absl::StrFormat(
      "%s: no scene.json; from the names and bounds of %s: cell size %.10g x %.10g, grid corner %.10g, %.10g",
      scene.root, tiles, grid.cell_size.x(), grid.cell_size.y(), grid.corner.x(), grid.corner.y());
}

// The tiles as their names number them, with the place on the Earth.
absl::StatusOr<Scene> NamedTiles(const std::string& root, const Findings& findings) {
  Scene scene;
  scene.root = root;
  scene.found_by_name = true;
  scene.warnings = findings.warnings;
  TILEMEND_RETURN_IF_ERROR(ReadMetadata(root, findings.in_folders, &scene));
  for (const auto& [cell, file] : findings.tiles) {
    scene.tiles.push_back({cell, file.lexically_relative(root).string()});
    if (!IsUtf8(scene.tiles.back().path)) {
      return absl::InvalidArgumentError(
          absl::StrCat(Printable(file.string()), ": a file name that is not UTF-8; rename it"));
    }
  }
  return scene;
}

}  // namespace

absl::Status ParseMetadata(const std::string& text, const std::string& path, Scene* scene) {
  pugi::xml_document document;
  if (const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size()); !result) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": not XML: byte ", result.offset, ": ", result.description()));
  }
  const pugi::xml_node metadata = document.child("ModelMetadata");
  scene->crs = std::string(absl::StripAsciiWhitespace(metadata.child_value("SRS")));
  if (scene->crs.empty()) scene->warnings.push_back(absl::StrCat(path, ": no SRS; the output has no CRS"));
  const std::string origin = metadata.child_value("SRSOrigin");
  if (!metadata.child("SRSOrigin")) {
    scene->warnings.push_back(absl::StrCat(path, ": no SRSOrigin; the origin is taken as 0, 0, 0"));
  } else if (!ParseOrigin(origin, &scene->origin)) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": SRSOrigin: expected three numbers with commas, found \"", origin, "\""));
  }
  return absl::OkStatus();
}

absl::Status NumberCells(Scene* scene) {
  ShiftToZero(scene);
  SortTiles(&scene->tiles);
  SetExtent(scene);
  if (std::max(scene->cols, scene->rows) <= kMaxCellsPerSide) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(scene->root, ": more than ", kMaxCellsPerSide, " columns or rows"));
}

absl::StatusOr<Scene> FindScene(const std::string& root, const HullReader& read_hull) {
  if (!read_hull) return absl::FailedPreconditionError(absl::StrCat(root, ": no scene.json, and no reader of tiles"));
  TILEMEND_ASSIGN_OR_RETURN(const Findings findings, FindTiles(root));
  TILEMEND_ASSIGN_OR_RETURN(Scene scene, NamedTiles(root, findings));
  TILEMEND_ASSIGN_OR_RETURN(std::vector<PlacedTile> placed, ReadBounds(findings, read_hull));
  const size_t looked_at = placed.size();
  TILEMEND_ASSIGN_OR_RETURN(scene.grid, FitGrid(std::move(placed)));
  scene.warnings.push_back(GridWarning(scene, looked_at));
  TILEMEND_RETURN_IF_ERROR(NumberCells(&scene));
  return scene;
}

absl::StatusOr<Scene> FindSceneWithoutGrid(const std::string& root) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string tileset, FindTileset(root));
  if (!tileset.empty()) return absl::NotFoundError(absl::StrCat(root, ": the scene of the tileset ", tileset));
  TILEMEND_ASSIGN_OR_RETURN(const Findings findings, FindTiles(root));
  TILEMEND_ASSIGN_OR_RETURN(Scene scene, NamedTiles(root, findings));
  scene.grid.cell_size = {0, 0};
  TILEMEND_RETURN_IF_ERROR(NumberCells(&scene));
  return scene;
}

}  // namespace tilemend
