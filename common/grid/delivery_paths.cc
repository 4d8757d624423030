#include "common/grid/delivery_paths.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/util/error_info.h"
#include "common/util/folders.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

// The coordinate of the grid that is the farthest from the origin, metres.
double FarthestOf(const Scene& scene) {
  const Point2 far = scene.grid.corner + scene.grid.cell_size.cwiseProduct(Point2(scene.cols, scene.rows));
  return std::max(scene.grid.corner.cwiseAbs().maxCoeff(), far.cwiseAbs().maxCoeff());
}

// From one float32 to the next at a coordinate.
double Float32StepAt(double metres) {
  const auto value = static_cast<float>(metres);
  return static_cast<double>(std::nextafter(value, std::numeric_limits<float>::infinity())) -
         static_cast<double>(value);
}

// What keeps `from` from being written as `to`; empty if nothing does.
std::string WhyNot(std::string_view from, std::string_view to, const Scene& scene) {
  if (from == "ply") return "PLY tiles have their colours at vertices, which no other format here takes over";
  if (to != "osgb") return "";
  constexpr double kMaxStep = 1.0 / 1024;  // the lattice that new vertices lie on
  const double farthest = FarthestOf(scene), step = Float32StepAt(farthest);
  if (step <= kMaxStep) return "";
  return absl::StrFormat(
      "OSGB has float32 coordinates, and they reach %.0f m, where these are %.3g m apart; take the scene's origin "
      "nearer "
      "to its tiles",
      farthest, step);
}

absl::Status Refusal(const SceneTile& tile, std::string_view to, const std::string& why) {
  const absl::Status status = absl::InvalidArgumentError(absl::StrCat(
      tile.path, ": --output-format ", std::string(to), " is not possible: ", why, "; or leave the option out"));
  return WithErrorInfo(status, {"FORMAT_NOT_SUPPORTED", {{"file", tile.path}}});
}

std::vector<std::string> LossesOf(std::string_view from, std::string_view to, const Scene& scene) {
  std::vector<std::string> losses;
  if (HasLevelsOfDetail(from) && !HasLevelsOfDetail(to))
    losses.push_back("the finest level of detail alone is written");
  if (from == "obj") losses.push_back("of each material its image is written, or its diffuse colour");
  if (to == "osgb") {
    losses.push_back(
        absl::StrFormat("coordinates are rounded to float32, by %.3g m at most", Float32StepAt(FarthestOf(scene)) / 2));
  }
  for (std::string& loss : losses) loss = absl::StrCat("--output-format ", std::string(to), ": ", loss);
  return losses;
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

// "_p000_m001" as "_+000_-001".
std::string WithSignsForLetters(std::string name) {
  for (size_t i = 1; i + 1 < name.size(); ++i) {
    if (name[i - 1] != '_' || !absl::ascii_isdigit(static_cast<unsigned char>(name[i + 1]))) continue;
    if (name[i] == 'p') name[i] = '+';
    if (name[i] == 'm') name[i] = '-';
  }
  return name;
}

std::string PathFor(const std::string& path, std::string_view format) {
  const bool is_tileset = format == "3dtiles";
  const fs::path file(path);
  if (format == "osgb") {
    const std::string name = WithSignsForLetters(file.stem().string());
    return absl::StrCat("Data/", name, "/", name, ".osgb");
  }
  const std::string stem = file.stem().string();
  fs::path folder = file.parent_path();
  if (folder.filename() != stem) folder /= stem;
  const std::string own = is_tileset ? WithLettersForSigns(stem) : stem;
  const fs::path to = folder.parent_path() / (is_tileset ? WithLettersForSigns(folder.filename().string()) : stem);
  return (to / absl::StrCat(own, ".", is_tileset ? "json" : std::string(format))).string();
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
    if (const std::string why = WhyNot(own, format, scene); !why.empty()) return Refusal(tile, format, why);
    other = &tile;
  }
  if (other == nullptr) return absl::OkStatus();
  for (std::string& loss : LossesOf(DeliveryFormatOf(other->path), format, scene)) {
    scene.warnings.push_back(std::move(loss));
  }
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

TileFrame OutputFrame(const SceneTile& tile) {
  if (tile.delivered.empty()) return tile.frame;
  return IsTileset(tile.delivered) ? TileFrame{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1} : TileFrame();
}

absl::StatusOr<Scene> DeliveredScene(Scene scene, const std::string& root) {
  for (SceneTile& tile : scene.tiles) {
    TILEMEND_ASSIGN_OR_RETURN(const PathKind kind, FindKind(absl::StrCat(root, "/", tile.delivered)));
    tile.path = kind == PathKind::kFile ? tile.delivered : "";
    tile.frame = tile.path.empty() ? TileFrame() : OutputFrame(tile);
  }
  scene.tileset.clear();
  return scene;
}

absl::StatusOr<Scene> FilledScene(Scene scene, const std::string& root) {
  for (SceneTile& tile : scene.tiles) {
    if (!tile.path.empty()) continue;
    const std::string path = OutputPath(tile);
    TILEMEND_ASSIGN_OR_RETURN(const PathKind kind, FindKind(absl::StrCat(root, "/", path)));
    if (kind == PathKind::kFile) tile.path = path;
  }
  return scene;
}

namespace {

// As photogrammetry names the frame of a place; other programs do not read the projection that stands for it.
std::string SrsOf(const std::string& crs) {
  double latitude = 0, longitude = 0;
  const bool is_place =
      std::sscanf(crs.c_str(), "+proj=ortho +lat_0=%lf +lon_0=%lf +datum=WGS84 +units=m", &latitude, &longitude) == 2;
  return is_place ? absl::StrFormat("ENU:%.12g,%.12g", latitude, longitude) : crs;
}

}  // namespace

std::string MetadataXml(const Scene& scene) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "utf-8";
  pugi::xml_node metadata = document.append_child("ModelMetadata");
  metadata.append_attribute("version") = "1";
  if (!scene.crs.empty()) metadata.append_child("SRS").text() = SrsOf(scene.crs).c_str();
  std::string origin;
  for (int axis = 0; axis < 3; ++axis)
    absl::StrAppendFormat(&origin, "%s%.17g", axis > 0 ? "," : "", scene.origin[axis]);
  metadata.append_child("SRSOrigin").text() = origin.c_str();
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace tilemend
