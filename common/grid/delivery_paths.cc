#include "common/grid/delivery_paths.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/folders.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

// What keeps `from` from being written as `to`; empty if nothing does.
std::string WhyNot(std::string_view from, std::string_view to) {
  if (to == "3dtiles" && (from == "osgb" || from == "obj")) return "";
  if (to == "obj" && (from == "osgb" || from == "3dtiles")) return "";
  if (from == "ply") return "PLY tiles have their colours at vertices, which no other format here takes over";
  if (to == "ply") return "PLY has no place for their images";
  return "OSGB is written for OSGB tiles alone";
}

absl::Status Refusal(const SceneTile& tile, std::string_view from, std::string_view to) {
  const absl::Status status = absl::InvalidArgumentError(absl::StrCat(tile.path, ": --output-format ", std::string(to),
                                                                      " is not possible: ", WhyNot(from, to),
                                                                      "; leave the option out, or choose ",
                                                                      from == "osgb"      ? "3dtiles or obj"
                                                                      : from == "obj"     ? "3dtiles"
                                                                      : from == "3dtiles" ? "obj"
                                                                                          : "same"));
  return WithErrorInfo(status, {"FORMAT_NOT_SUPPORTED", {{"file", tile.path}}});
}

// "_+000_-001" as "_p000_m001".
std::string WithLettersForSigns(std::string name) {
  for (size_t i = 1; i + 1 < name.size(); ++i) {
    if (name[i - 1] != '_' || !absl::ascii_isdigit(static_cast<unsigned char>(name[i + 1]))) continue;
    if (name[i] == '+') name[i] = 'p';
    if (name[i] == '-') name[i] = 'm';
  }
  return name;
}

std::string PathFor(const std::string& path, std::string_view format) {
  const bool is_tileset = format == "3dtiles";
  const fs::path file(path);
  const std::string stem = file.stem().string();
  fs::path folder = file.parent_path();
  if (folder.filename() != stem) folder /= stem;
  const std::string own = is_tileset ? WithLettersForSigns(stem) : stem;
  const fs::path to = folder.parent_path() / (is_tileset ? WithLettersForSigns(folder.filename().string()) : stem);
  return (to / absl::StrCat(own, is_tileset ? ".json" : ".obj")).string();
}

}  // namespace

std::string_view DeliveryFormatOf(std::string_view path) {
  if (IsTileset(path)) return "3dtiles";
  const std::string ending = absl::AsciiStrToLower(fs::path(path).extension().string());
  return ending == ".osgb" ? "osgb" : ending == ".obj" ? "obj" : ending == ".ply" ? "ply" : "";
}

absl::Status SetDeliveryPaths(std::string_view format, Scene& scene) {
  if (format.empty() || format == "same") return absl::OkStatus();
  const SceneTile* other = nullptr;  // of another format
  for (const SceneTile& tile : scene.tiles) {
    const std::string_view own = DeliveryFormatOf(tile.path);
    if (tile.path.empty() || own == format) continue;
    if (!WhyNot(own, format).empty()) return Refusal(tile, own, format);
    other = &tile;
  }
  if (other == nullptr) return absl::OkStatus();
  std::set<std::string> paths;
  for (SceneTile& tile : scene.tiles) {
    const std::string_view own = DeliveryFormatOf(tile.path);
    if (own == format) {
      return absl::InvalidArgumentError(absl::StrCat(tile.path, " and ", other->path, ": --output-format ",
                                                     std::string(format), " needs tiles of one format"));
    }
    std::string path = PathFor(OutputPath(tile), format);
    if (!paths.insert(absl::AsciiStrToLower(path)).second) {
      return absl::InvalidArgumentError(
          absl::StrCat(tile.path, ": would be written to ", path, " as another tile; rename one of the files"));
    }
    tile.delivered = std::move(path);
  }
  return absl::OkStatus();
}

bool IsDelivered(const Scene& scene) {
  return std::any_of(scene.tiles.begin(), scene.tiles.end(),
                     [](const SceneTile& tile) { return !tile.delivered.empty(); });
}

Scene DeliveredScene(Scene scene, const std::string& root) {
  for (SceneTile& tile : scene.tiles) {
    const bool is_there = KindOf(absl::StrCat(root, "/", tile.delivered)) == PathKind::kFile;
    tile.path = is_there ? tile.delivered : "";
    tile.frame.clear();
  }
  scene.tileset.clear();
  return scene;
}

}  // namespace tilemend
