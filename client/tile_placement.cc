#include "client/tile_placement.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/tiles3d/bounding_volume.h"
#include "common/codec/tiles3d/tileset.h"
#include "common/grid/delivery_paths.h"
#include "common/grid/scene_sources.h"
#include "common/records/output_names.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/tile_files.h"
#include "coordinator/jobs/delivery_entry.h"

namespace tilemend {
namespace {

constexpr int64_t kMostPlacingBytes = int64_t{64} << 20;  // of scene.json and metadata.xml, as when they are read
constexpr double kOfNumber = 1e-9;                        // of the larger of two numbers, for rounding in texts

bool IsNear(double a, double b) { return std::abs(a - b) <= kOfNumber * std::max({1.0, std::abs(a), std::abs(b)}); }

template <typename Numbers>
bool AreNear(const Numbers& a, const Numbers& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), IsNear);
}

// Without the bytes that are no UTF-8.
std::string AsInJson(const std::string& text) {
  constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
  return nlohmann::json::parse(nlohmann::json(text).dump(-1, ' ', false, kReplace)).get<std::string>();
}

std::string Normal(const std::string& path) { return std::filesystem::path(path).lexically_normal().string(); }

std::string MetadataChange(const std::string& in, const std::string& out) {
  const auto before = ReadFileUpTo(in, kMostPlacingBytes), after = ReadFileUpTo(out, kMostPlacingBytes);
  if (!before.ok()) return "";
  if (!after.ok()) return "missing";
  return *before == *after ? "" : "changed";
}

// `after` has the tiles that the output has.
std::string TilesChange(const Scene& scene, const Scene& after, const std::string& out) {
  std::map<CellId, const SceneTile*> tiles;
  for (const SceneTile& tile : after.tiles) tiles[tile.cell] = &tile;
  for (const SceneTile& tile : scene.tiles) {
    const std::string path = OutputPath(tile);
    if (KindOf(absl::StrCat(out, "/", path)) != PathKind::kFile) continue;
    const auto found = tiles.find(tile.cell);
    if (found == tiles.end() || Normal(found->second->path) != Normal(path)) {
      return absl::StrCat("it does not have ", path, " in cell ", tile.cell.col, ",", tile.cell.row);
    }
    if (!AreNear(found->second->frame, tile.frame)) return absl::StrCat("another frame of ", path);
  }
  return "";
}

std::string SceneChange(const Scene& scene, const std::string& out, bool has_area) {
  const std::string path = absl::StrCat(out, "/", kSceneFile);
  const auto text = ReadFileUpTo(path, kMostPlacingBytes);
  if (!text.ok()) return "missing";
  const auto after = ParseSceneJson(*text, path);
  if (!after.ok()) return std::string(after.status().message());
  if (after->crs != AsInJson(scene.crs)) return "another CRS";
  if (!AreNear(after->origin, scene.origin)) return "another origin";
  if (!has_area) return "";
  if (!AreNear(after->grid.corner, scene.grid.corner) || !AreNear(after->grid.cell_size, scene.grid.cell_size)) {
    return "another grid";
  }
  return TilesChange(scene, *after, out);
}

// Takes the bounding volumes out of a tileset, in the order of the text.
void TakeVolumes(nlohmann::json& json, std::vector<nlohmann::json>& volumes) {
  if (json.is_object()) {
    if (const auto volume = json.find("boundingVolume"); volume != json.end()) {
      volumes.push_back(std::move(*volume));
      *volume = nullptr;
    }
  }
  if (!json.is_structured()) return;
  for (nlohmann::json& member : json) TakeVolumes(member, volumes);
}

bool BoxHolds(const std::vector<double>& outer, const std::vector<double>& inner) {
  std::vector<Point3> corners;
  const Eigen::Map<const Eigen::Matrix3d> axes(inner.data() + 3);
  for (int corner = 0; corner < 8; ++corner) {
    const Point3 sides((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    corners.emplace_back(Point3(inner[0], inner[1], inner[2]) + axes * sides);
  }
  const BoundingVolume grown = GrownVolume({BoundingVolume::Kind::kBox, outer}, corners);
  double longest = 0;
  for (const double number : outer) longest = std::max(longest, std::abs(number));
  constexpr double kSlack = 1e-6;  // of the box: its axes were added up anew
  return std::equal(outer.begin(), outer.end(), grown.numbers.begin(),
                    [&](double a, double b) { return std::abs(a - b) <= kSlack * longest; });
}

// From one longitude to another, to the east.
double Eastward(double from, double to) { return to >= from ? to - from : to - from + 2 * std::numbers::pi; }

bool RegionHolds(const std::vector<double>& outer, const std::vector<double>& inner) {
  constexpr double kAngle = 1e-12, kHeight = 1e-6;  // radians, metres
  const double whole = Eastward(outer[0], outer[2]);
  const double west = IsNear(outer[0], inner[0]) ? 0 : Eastward(outer[0], inner[0]);
  return west + Eastward(inner[0], inner[2]) <= whole + 2 * kOfNumber && inner[1] >= outer[1] - kAngle &&
         inner[3] <= outer[3] + kAngle && inner[4] >= outer[4] - kHeight && inner[5] <= outer[5] + kHeight;
}

bool SphereHolds(const std::vector<double>& outer, const std::vector<double>& inner) {
  const Point3 a(outer[0], outer[1], outer[2]), b(inner[0], inner[1], inner[2]);
  return (a - b).norm() + inner[3] <= outer[3] * (1 + kOfNumber);
}

bool Holds(const nlohmann::json& outer, const nlohmann::json& inner) {
  if (outer == inner) return true;
  constexpr std::pair<const char*, size_t> kKindsOfVolumes[] = {{"box", 12}, {"region", 6}, {"sphere", 4}};
  for (const auto& [kind, count] : kKindsOfVolumes) {
    if (!inner.is_object() || !inner.contains(kind)) continue;
    if (!outer.is_object() || !outer.contains(kind)) return false;
    const auto numbers = [kind = kind](const nlohmann::json& volume) {
      std::vector<double> list;
      for (const nlohmann::json& number : volume.at(kind))
        list.push_back(number.is_number() ? number.get<double>() : 0);
      return list;
    };
    const std::vector<double> out = numbers(outer), in = numbers(inner);
    if (out.size() != count || in.size() != count) return out == in;
    return count == 12 ? BoxHolds(out, in) : count == 6 ? RegionHolds(out, in) : SphereHolds(out, in);
  }
  return true;  // a kind that is not known
}

// Compares the files of the tileset `entry` that were not compared yet.
void CompareTilesets(const std::string& in, const std::string& out, const std::string& entry, bool follows,
                     std::set<std::string>& compared, std::vector<std::string>& notes) {
  TilesetLimits limits;
  limits.follows = follows;
  const auto before = ReadTileset(FolderSource(in), entry, limits);
  if (!before.ok()) return;  // this check does not tell what is wrong with the scene
  const auto after = ReadTileset(FolderSource(out), entry, limits);
  if (absl::IsOutOfRange(after.status())) return;  // a link that leads out
  if (!after.ok()) {
    notes.push_back(absl::StrCat(entry, ": ", std::string(after.status().message())));
    return;
  }
  std::map<std::string, const std::string*> texts;
  for (const TilesetDocument& document : after->documents) texts[document.file] = &document.text;
  for (const TilesetDocument& document : before->documents) {
    if (!compared.insert(document.file).second) continue;
    const auto text = texts.find(document.file);
    const std::string change = text == texts.end() ? "missing" : TilesetChange(document.text, *text->second);
    if (!change.empty()) notes.push_back(absl::StrCat(document.file, ": ", change));
  }
}

// Whether two texts are the same JSON but for rounding of numbers.
bool IsSameJson(const nlohmann::json& a, const nlohmann::json& b) {
  if (a.is_number() && b.is_number()) return IsNear(a.get<double>(), b.get<double>());
  if (a.type() != b.type() || a.size() != b.size()) return false;
  if (a.is_array()) return std::equal(a.begin(), a.end(), b.begin(), IsSameJson);
  if (!a.is_object()) return a == b;
  return std::all_of(a.items().begin(), a.items().end(), [&](const auto& member) {
    const auto other = b.find(member.key());
    return other != b.end() && IsSameJson(member.value(), *other);
  });
}

std::string EntryChange(const Scene& scene, const std::string& out, bool has_area) {
  const auto after = ReadFileUpTo(absl::StrCat(out, "/", kEntryFile), kMostPlacingBytes);
  if (!after.ok()) return "missing";
  const auto places = PlaceDelivery(scene);
  if (!has_area || !places.ok()) return "";  // the places of cells are not known
  const auto before = DeliveryEntry(scene, *places, out);
  if (!before.ok()) return "";  // a tile is missing or damaged, which is found where tiles are compared
  const nlohmann::json is = nlohmann::json::parse(*after, nullptr, false);
  return IsSameJson(nlohmann::json::parse(*before), is) ? "" : "changed";
}

// Of an output in another format.
std::vector<std::string> ChangedDelivery(const Scene& scene, const std::string& out, bool has_area) {
  std::vector<std::string> notes;
  const auto add = [&](const char* path, const std::string& change) {
    if (!change.empty()) notes.push_back(absl::StrCat(path, ": ", change));
  };
  const auto delivered = DeliveredScene(scene, out);
  add(kSceneFile, delivered.ok() ? SceneChange(*delivered, out, has_area) : std::string(delivered.status().message()));
  const bool is_tileset = std::ranges::any_of(scene.tiles, [](const SceneTile& t) { return IsTileset(t.delivered); });
  if (is_tileset) {
    add(kEntryFile, EntryChange(scene, out, has_area));
    return notes;
  }
  const auto before = MetadataOf(scene);
  if (!before.ok() || before->empty()) return notes;
  const auto after = ReadFileUpTo(absl::StrCat(out, "/", kMetadataFile), kMostPlacingBytes);
  if (!after.ok() || *after != *before) add(kMetadataFile, after.ok() ? "changed" : "missing");
  return notes;
}

}  // namespace

std::string TilesetChange(const std::string& before, const std::string& after) {
  if (before == after) return "";
  nlohmann::json in = nlohmann::json::parse(before, nullptr, false), out = nlohmann::json::parse(after, nullptr, false);
  std::vector<nlohmann::json> in_volumes, out_volumes;
  TakeVolumes(in, in_volumes);
  TakeVolumes(out, out_volumes);
  if (in != out) return "other tiles, transforms, contents or geometric errors";
  for (size_t v = 0; v < in_volumes.size(); ++v) {
    if (!Holds(out_volumes[v], in_volumes[v])) return "a bounding volume does not hold the one that it was";
  }
  return "";
}

std::vector<std::string> ChangedPlacement(const Scene& scene, const std::string& out, bool has_area) {
  if (IsDelivered(scene)) return ChangedDelivery(scene, out, has_area);
  std::vector<std::string> notes;
  const auto add = [&](const char* path, const std::string& change) {
    if (!change.empty()) notes.push_back(absl::StrCat(path, ": ", change));
  };
  add(kMetadataFile,
      MetadataChange(absl::StrCat(scene.root, "/", kMetadataFile), absl::StrCat(out, "/", kMetadataFile)));
  add(kSceneFile, SceneChange(scene, out, has_area));
  std::set<std::string> compared;
  for (const SceneTile& tile : scene.tiles) {
    const bool is_there = !tile.path.empty() && KindOf(absl::StrCat(out, "/", tile.path)) == PathKind::kFile;
    if (is_there && IsTileset(tile.path)) CompareTilesets(scene.root, out, tile.path, true, compared, notes);
  }
  if (!scene.tileset.empty()) CompareTilesets(scene.root, out, scene.tileset, false, compared, notes);
  return notes;
}

}  // namespace tilemend
