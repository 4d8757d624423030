#include "client/demo_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/codec/mesh_file.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr int kSquares = 50;  // of a cell's side
constexpr double kStep = kDemoCell / kSquares;

struct Disk {
  double x, y, radius;  // metres
};

// The lake lies over four cells.
constexpr Disk kLake = {110, 95, 38};
constexpr std::array<Disk, 6> kSmallHoles = {
    {{30, 40, 5}, {60, 160, 7}, {170, 30, 4}, {240, 60, 6}, {215, 150, 8}, {270, 175, 5}}};

// How far beyond the edge, in metres; below 0 inside.
double Beyond(const Disk& disk, double x, double y) { return std::hypot(x - disk.x, y - disk.y) - disk.radius; }

// Hills that rise from a level shore.
double HeightAt(double x, double y) {
  const double far = std::max(0.0, Beyond(kLake, x, y) - kStep / 2);
  const double hills = 6 + 4 * std::sin(x / 37) * std::cos(y / 29) + 1.5 * std::sin((x + y) / 17);
  return kDemoLakeLevel + hills * (1 - std::exp(-far / 15));
}

bool IsHole(double x, double y) {
  if (Beyond(kLake, x, y) < 0) return true;
  return std::ranges::any_of(kSmallHoles, [&](const Disk& disk) { return Beyond(disk, x, y) < 0; });
}

// The tile's surface, without vertices that no triangle has.
FilePatch TileAt(int col, int row) {
  FilePatch tile;
  std::map<std::pair<int, int>, int32_t> numbers;
  const auto vertex = [&](int i, int j) {
    const auto [it, is_new] = numbers.try_emplace({i, j}, static_cast<int32_t>(tile.new_points.size()));
    if (is_new) {
      const double x = (col * kSquares + i) * kStep, y = (row * kSquares + j) * kStep;
      tile.new_points.emplace_back(x, y, HeightAt(x, y));
      tile.like.push_back(-1);
    }
    return it->second;
  };
  for (int j = 0; j < kSquares; ++j) {
    for (int i = 0; i < kSquares; ++i) {
      if (IsHole((col * kSquares + i + 0.5) * kStep, (row * kSquares + j + 0.5) * kStep)) continue;
      const int32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      tile.triangles.push_back({a, b, c});
      tile.triangles.push_back({a, c, d});
    }
  }
  return tile;
}

}  // namespace

absl::Status WriteDemoScene(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder + "/tiles", error);
  if (error) return absl::InternalError(absl::StrCat(folder, ": cannot be made: ", error.message()));
  nlohmann::ordered_json scene = {{"crs", "EPSG:25832"},    {"origin", {500000, 5400000, 0}},
                                  {"cell_size", kDemoCell}, {"cols", kDemoCols},
                                  {"rows", kDemoRows},      {"tiles", nlohmann::ordered_json::array()}};
  for (int row = 0; row < kDemoRows; ++row) {
    for (int col = 0; col < kDemoCols; ++col) {
      const std::string path = absl::StrFormat("tiles/Tile_+%03d_+%03d.ply", col, row);
      scene["tiles"].push_back({{"col", col}, {"row", row}, {"path", path}});
      TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(
          absl::StrCat(folder, "/", path), NewPlyFile(TileAt(col, row), NumberType::kFloat64, FaceMark::kNone)));
    }
  }
  return WriteFileAtomically(folder + "/scene.json", scene.dump(1) + "\n");
}

}  // namespace tilemend
