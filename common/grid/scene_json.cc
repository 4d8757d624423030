#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "common/grid/json_text.h"
#include "common/grid/scene_sources.h"
#include "common/mesh/outline_crossing.h"
#include "common/mesh/ring_polygons.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

using Json = nlohmann::json;

// Of scene.json: 600,000 tiles with long names. Parsing takes 22 times that, 1.4 GB.
constexpr int64_t kMostSceneBytes = int64_t{64} << 20;

std::string Text(const std::string& text) { return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace); }

// Typed access to the members of one JSON object, with the place in every message.
class Fields {
 public:
  Fields(const Json& object, std::string place) : object_(object), place_(std::move(place)) {}

  bool Has(const char* field) const { return object_.contains(field) && !object_[field].is_null(); }
  const Json& operator[](const char* field) const { return object_[field]; }

  absl::Status Error(std::string_view field, std::string_view what) const {
    return absl::InvalidArgumentError(absl::StrCat(place_, std::string(field), ": ", std::string(what)));
  }

  absl::StatusOr<int32_t> Integer(const char* field, int32_t least, int32_t most) const {
    if (!object_.contains(field)) return Error(field, "missing");
    const Json& value = object_[field];
    if (!value.is_number_integer()) return Error(field, "expected an integer");
    const bool too_large = value.is_number_unsigned() && value.get<uint64_t>() > uint64_t{INT32_MAX};
    if (too_large || value.get<int64_t>() < least || value.get<int64_t>() > most) {
      return Error(field, absl::StrCat("expected ", least, " to ", most, ", found ", value.dump()));
    }
    return value.get<int32_t>();
  }

  absl::Status Numbers(const char* field, int count, double* out) const {
    const Json& value = object_[field];
    const bool right = value.is_array() && value.size() == static_cast<size_t>(count);
    for (int i = 0; i < count; ++i) {
      if (!right || !value[i].is_number())
        return Error(field, absl::StrCat("expected an array of ", count, " numbers"));
      out[i] = value[i].get<double>();
      if (!std::isfinite(out[i])) return Error(field, "expected finite numbers");
    }
    return absl::OkStatus();
  }

 private:
  const Json& object_;
  std::string place_;
};

absl::Status ReadGrid(const Fields& fields, Scene* scene) {
  if (!fields.Has("cell_size")) return fields.Error("cell_size", "missing");
  Point2& size = scene->grid.cell_size;
  if (fields["cell_size"].is_number()) {
    size.setConstant(fields["cell_size"].get<double>());
  } else if (absl::Status status = fields.Numbers("cell_size", 2, size.data()); !status.ok()) {
    return fields.Error("cell_size", "expected a number or an array of 2 numbers");
  }
  if (!size.allFinite() || size.minCoeff() <= 0) return fields.Error("cell_size", "must be finite and greater than 0");
  if (size.maxCoeff() > kMostMetres) return fields.Error("cell_size", "must be at most 1e9 m");
  if (fields.Has("grid_corner")) TILEMEND_RETURN_IF_ERROR(fields.Numbers("grid_corner", 2, scene->grid.corner.data()));
  if (scene->grid.corner.cwiseAbs().maxCoeff() > kMostMetres) {
    return fields.Error("grid_corner", "must be at most 1e9 m from the origin");
  }
  TILEMEND_ASSIGN_OR_RETURN(scene->cols, fields.Integer("cols", 1, kMaxCellsPerSide));
  TILEMEND_ASSIGN_OR_RETURN(scene->rows, fields.Integer("rows", 1, kMaxCellsPerSide));
  return absl::OkStatus();
}

absl::StatusOr<std::vector<Point2>> ReadRing(const Fields& fields, const Json& positions) {
  const absl::Status wrong =
      fields.Error("area", "expected rings of at least 4 positions [x, y], the last as the first");
  std::vector<Point2> ring;
  if (!positions.is_array() || positions.size() < 4) return wrong;
  for (const Json& position : positions) {
    const bool pair = position.is_array() && position.size() >= 2 && position[0].is_number() && position[1].is_number();
    if (!pair) return wrong;
    ring.emplace_back(position[0].get<double>(), position[1].get<double>());
    if (!(ring.back().cwiseAbs().maxCoeff() <= kMostMetres)) {
      return fields.Error("area", "must be at most 1e9 m from the origin");
    }
  }
  if (ring.front() != ring.back()) return wrong;
  ring.pop_back();
  return ring;
}

absl::Status ReadArea(const Fields& fields, Scene* scene) {
  const Json& area = fields["area"];
  if (area.is_string()) {
    scene->area_file = area.get<std::string>();
    return scene->area_file.empty() ? fields.Error("area", "expected a file name") : absl::OkStatus();
  }
  const bool object = area.is_object() && area.contains("type") && area.contains("coordinates");
  const bool polygon = object && area["type"] == "Polygon", several = object && area["type"] == "MultiPolygon";
  if (!polygon && !several) return fields.Error("area", "expected a GeoJSON Polygon, MultiPolygon or a file name");
  const Json polygons = polygon ? Json::array({area["coordinates"]}) : area["coordinates"];
  for (const Json& rings : polygons) {
    for (const Json& positions : rings) {
      TILEMEND_ASSIGN_OR_RETURN(scene->area.rings.emplace_back(), ReadRing(fields, positions));
    }
  }
  if (scene->area.empty()) return fields.Error("area", "a polygon without rings");
  if (const auto crossing = FindCrossing(scene->area)) return fields.Error("area", TextOf(*crossing));
  return absl::OkStatus();
}

absl::Status ReadHead(const Fields& fields, Scene* scene) {
  if (fields.Has("crs")) {
    if (!fields["crs"].is_string()) return fields.Error("crs", "expected a text");
    scene->crs = fields["crs"].get<std::string>();
  }
  if (fields.Has("origin")) TILEMEND_RETURN_IF_ERROR(fields.Numbers("origin", 3, scene->origin.data()));
  scene->area_known = true;
  if (fields.Has("area_known")) {
    if (!fields["area_known"].is_boolean()) return fields.Error("area_known", "expected true or false");
    scene->area_known = fields["area_known"].get<bool>();
  }
  if (fields.Has("tileset")) {
    if (!fields["tileset"].is_string() || !IsTileset(fields["tileset"].get<std::string>())) {
      return fields.Error("tileset", "expected the name of a .json file");
    }
    scene->tileset = fields["tileset"].get<std::string>();
    if (scene->tileset.find('/') != std::string::npos) return fields.Error("tileset", "expected a name without folder");
  }
  if (fields.Has("area")) TILEMEND_RETURN_IF_ERROR(ReadArea(fields, scene));
  return ReadGrid(fields, scene);
}

// Other fields are ignored; one that is nearly called as a field that is not there is likely meant for it.
void WarnOfNearMisses(const Json& json, const std::string& name, Scene* scene) {
  constexpr std::string_view kOptional[] = {"crs", "origin", "grid_corner", "area", "area_known"};
  constexpr size_t kLettersForAnEdit = 4, kLongest = 20;
  for (const auto& [field, value] : json.items()) {
    for (const std::string_view meant : kOptional) {
      const bool near = field.size() <= kLongest && field != meant &&
                        EditDistance(field, meant) <= std::max<size_t>(1, meant.size() / kLettersForAnEdit);
      if (!near || json.contains(meant) || std::ranges::count(kOptional, field) > 0) continue;
      scene->warnings.push_back(absl::StrCat(name, ": the field ", Text(field), " has no effect; one that has is ",
                                             Text(std::string(meant))));
    }
  }
}

// The tile's path, normalised; empty for null.
absl::StatusOr<std::string> ReadPath(const Fields& tile) {
  const absl::Status wrong_type = tile.Error("path", "expected a file name or null");
  const Json& value = tile["path"];
  if (value.is_null()) return std::string();
  if (!value.is_string()) return wrong_type;
  const std::string text = value.get<std::string>();
  const std::filesystem::path path(text);
  if (text.empty() || text.find('\0') != std::string::npos) return wrong_type;
  if (path.is_absolute())
    return tile.Error("path", absl::StrCat("\"", text, "\" is absolute; give it relative to the scene"));
  for (const std::filesystem::path& part : path) {
    if (part == "..") return tile.Error("path", absl::StrCat("\"", text, "\" leaves the scene's folder"));
  }
  if (!IsTileFormat(text) && !IsTileset(text)) {
    const std::string format = path.extension().string();
    return tile.Error("path", absl::StrCat("\"", text, "\": format \"", format,
                                           "\" is not read; tiles are .ply, .obj, .osgb or a tileset.json"));
  }
  return path.lexically_normal().string();
}

absl::StatusOr<SceneTile> ReadTile(const Json& value, const std::string& name, size_t index, const Scene& scene) {
  const std::string place = absl::StrCat(name, ": tiles[", index, "]");
  if (!value.is_object()) return absl::InvalidArgumentError(absl::StrCat(place, ": expected an object"));
  const Fields fields(value, place + ".");
  SceneTile tile;
  TILEMEND_ASSIGN_OR_RETURN(tile.cell.col, fields.Integer("col", 0, scene.cols - 1));
  TILEMEND_ASSIGN_OR_RETURN(tile.cell.row, fields.Integer("row", 0, scene.rows - 1));
  if (!value.contains("path")) return fields.Error("path", "missing (null for a cell without surface)");
  TILEMEND_ASSIGN_OR_RETURN(tile.path, ReadPath(fields));
  if (fields.Has("frame")) {
    constexpr size_t kNumbers = 16;
    tile.frame.resize(kNumbers);
    TILEMEND_RETURN_IF_ERROR(fields.Numbers("frame", kNumbers, tile.frame.data()));
  }
  return tile;
}

// Puts `key` at `index`; an error that names both places if it was there.
template <typename Key>
absl::Status Claim(const Key& key, size_t index, const std::string& what, const std::string& name,
                   std::map<Key, size_t>* seen) {
  const auto [at, fresh] = seen->emplace(key, index);
  if (fresh) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat(name, ": tiles[", at->second, "] and tiles[", index, "] are both ", what));
}

// A tileset has its folder with all below it for itself.
absl::Status CheckTilesets(const std::vector<SceneTile>& tiles, const std::string& name) {
  std::map<std::string, size_t> paths;
  for (size_t i = 0; i < tiles.size(); ++i) paths.emplace(tiles[i].path, i);
  paths.erase("");
  for (const auto& [path, i] : paths) {
    if (!IsTileset(path)) continue;
    const std::string folder = FileBesideTile(path, "");
    for (auto at = paths.lower_bound(folder); at != paths.end() && at->first.starts_with(folder); ++at) {
      if (at->second == i) continue;
      return absl::InvalidArgumentError(absl::StrCat(name, ": tiles[", at->second, "] (", at->first,
                                                     ") lies in the folder of the tileset tiles[", i, "] (", path,
                                                     "), which it has for itself"));
    }
  }
  return absl::OkStatus();
}

std::string PathOrNone(const std::string& path) { return path.empty() ? "no surface" : path; }

absl::Status ReadTiles(const Json& tiles, const std::string& name, Scene* scene) {
  std::map<CellId, size_t> cells;
  std::map<std::string, size_t> files, folders;
  for (size_t i = 0; i < tiles.size(); ++i) {
    TILEMEND_ASSIGN_OR_RETURN(SceneTile tile, ReadTile(tiles[i], name, i, *scene));
    std::string what = absl::StrCat("cell ", ToString(tile.cell));
    if (const auto at = cells.find(tile.cell); at != cells.end()) {
      absl::StrAppend(&what, " (", PathOrNone(scene->tiles[at->second].path), ", ", PathOrNone(tile.path), ")");
    }
    TILEMEND_RETURN_IF_ERROR(Claim(tile.cell, i, what, name, &cells));
    // Two cells of one file would be two outputs of one name.
    if (!tile.path.empty()) TILEMEND_RETURN_IF_ERROR(Claim(tile.path, i, "the file " + tile.path, name, &files));
    if (IsTileTree(tile.path)) {
      const std::string folder = FileBesideTile(tile.path, "");
      TILEMEND_RETURN_IF_ERROR(Claim(folder, i, "all files of trees in the folder " + folder, name, &folders));
    }
    scene->tiles.push_back(std::move(tile));
  }
  TILEMEND_RETURN_IF_ERROR(CheckTilesets(scene->tiles, name));
  for (const auto& [cell, i] : cells) {
    const SceneTile& tile = scene->tiles[i];
    const auto taken = files.find(OutputPath(tile));
    if (!tile.path.empty() || taken == files.end()) continue;
    return absl::InvalidArgumentError(
        absl::StrCat(name, ": tiles[", i, "] (cell ", ToString(cell), ", no surface) would be written as ",
                     taken->first, ", which is the file of tiles[", taken->second, "]; rename that file"));
  }
  SortTiles(&scene->tiles);
  return absl::OkStatus();
}

std::string Number(double value) { return Json(value).dump(); }

Json RingJson(const std::vector<Point2>& ring) {
  Json positions = Json::array();
  for (size_t i = 0; i <= ring.size(); ++i) {
    const Point2& p = ring[i % ring.size()];
    positions.push_back({p.x(), p.y()});
  }
  return positions;
}

// A Polygon, or a MultiPolygon of parts in the order of their outlines. Precondition: as of PolygonsOf.
std::string AreaText(const PlanePolygon& area) {
  std::vector<RingPolygon> parts = PolygonsOf(area.rings);
  std::ranges::sort(parts, {}, &RingPolygon::outline);
  Json polygons = Json::array();
  for (const RingPolygon& part : parts) {
    Json& rings = polygons.emplace_back(Json::array());
    rings.push_back(RingJson(area.rings[part.outline]));
    for (const int32_t island : part.islands) rings.push_back(RingJson(area.rings[island]));
  }
  if (polygons.size() == 1) return Json{{"type", "Polygon"}, {"coordinates", polygons[0]}}.dump();
  return Json{{"type", "MultiPolygon"}, {"coordinates", polygons}}.dump();
}

}  // namespace

absl::StatusOr<Scene> ParseSceneJson(const std::string& text, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const Json json, ParseJson(text, name));
  if (!json.is_object()) return absl::InvalidArgumentError(absl::StrCat(name, ": expected an object"));
  const Fields fields(json, name + ": ");
  Scene scene;
  TILEMEND_RETURN_IF_ERROR(ReadHead(fields, &scene));
  WarnOfNearMisses(json, name, &scene);
  if (!fields.Has("tiles")) return fields.Error("tiles", "missing");
  if (!json["tiles"].is_array()) return fields.Error("tiles", "expected an array");
  if (json["tiles"].empty()) return fields.Error("tiles", "no cell is listed");
  TILEMEND_RETURN_IF_ERROR(ReadTiles(json["tiles"], name, &scene));
  return scene;
}

absl::StatusOr<Scene> ReadSceneJson(const std::string& json_path, const std::string& root) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadFileUpTo(json_path, kMostSceneBytes));
  TILEMEND_ASSIGN_OR_RETURN(Scene scene, ParseSceneJson(text, json_path));
  scene.root = root;
  if (!scene.area_file.empty()) scene.area_file = (std::filesystem::path(root) / scene.area_file).string();
  for (const SceneTile& tile : scene.tiles) {
    if (tile.path.empty()) continue;
    const std::filesystem::path file = std::filesystem::path(root) / tile.path;
    const auto look = LookAt(file.string());
    // Not to be reached is not missing.
    if (IsObjectPath(root) && !look.ok() && !absl::IsNotFound(look.status())) return look.status();
    const PathKind kind = look.ok() ? look->kind : PathKind::kNothing;
    const std::string place = absl::StrCat(json_path, ": cell ", ToString(tile.cell), ": ", file.string());
    if (kind == PathKind::kNothing) return absl::NotFoundError(absl::StrCat(place, ": no such file"));
    if (kind != PathKind::kFile) return absl::InvalidArgumentError(absl::StrCat(place, ": not a file"));
  }
  return scene;
}

std::string SceneJson(const Scene& scene) {
  const Grid& grid = scene.grid;
  std::string out = absl::StrCat("{\n \"crs\": ", Text(scene.crs), ",\n \"origin\": [", Number(scene.origin.x()), ", ",
                                 Number(scene.origin.y()), ", ", Number(scene.origin.z()), "],\n");
  absl::StrAppend(&out, " \"grid_corner\": [", Number(grid.corner.x()), ", ", Number(grid.corner.y()), "],\n");
  if (grid.cell_size.x() == grid.cell_size.y()) {
    absl::StrAppend(&out, " \"cell_size\": ", Number(grid.cell_size.x()), ",\n");
  } else {
    absl::StrAppend(&out, " \"cell_size\": [", Number(grid.cell_size.x()), ", ", Number(grid.cell_size.y()), "],\n");
  }
  if (!scene.tileset.empty()) absl::StrAppend(&out, " \"tileset\": ", Text(scene.tileset), ",\n");
  if (!scene.area_known) out += " \"area_known\": false,\n";
  if (!scene.area.empty()) absl::StrAppend(&out, " \"area\": ", AreaText(scene.area), ",\n");
  absl::StrAppend(&out, " \"cols\": ", scene.cols, ",\n \"rows\": ", scene.rows, ",\n \"tiles\": [");
  const char* separator = "\n";
  for (const SceneTile& tile : scene.tiles) {
    absl::StrAppend(&out, separator, "  {\"col\": ", tile.cell.col, ", \"row\": ", tile.cell.row,
                    ", \"path\": ", tile.path.empty() ? "null" : Text(tile.path),
                    tile.frame.empty() ? "" : absl::StrCat(", \"frame\": ", Json(tile.frame).dump()), "}");
    separator = ",\n";
  }
  out += "\n ]\n}\n";
  return out;
}

}  // namespace tilemend
