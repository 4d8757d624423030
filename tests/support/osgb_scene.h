// A made scene of OSGB tiles with levels of detail, for tests.
#ifndef TILEMEND_TESTS_SUPPORT_OSGB_SCENE_H_
#define TILEMEND_TESTS_SUPPORT_OSGB_SCENE_H_

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/util/file_pack.h"
#include "tests/support/osgb_builder.h"

namespace tilemend {

// Ground at 3 m with low waves and a round pond over the border of two cells of 64 m. The tiles overlap by 0.5 m on
// each side. Each tile has three levels: edges of 4 m and 2 m in one piece, 1 m in four. What lies in the pond is left
// out, or is there as noise.
class OsgbScene {
 public:
  static constexpr double kCell = 64, kReach = 0.5, kRadius = 17, kLevel = 2;
  enum class Pond { kHole, kNoise };

  explicit OsgbScene(Pond pond = Pond::kHole, uint32_t version = 80, std::string image = "\xff\xd8\xff no image")
      : pond_(pond), version_(version), image_(std::move(image)) {}

  static bool InPond(double x, double y) { return std::hypot(x - kCell, y - kCell / 2) < kRadius; }
  static double HeightAt(double x, double y) {
    const double beyond = std::hypot(x - kCell, y - kCell / 2) - kRadius;
    return beyond <= 0 ? kLevel : kLevel + std::min(1.0, beyond / 3) * (1 + 0.1 * std::sin(x / 5) * std::cos(y / 7));
  }

  static std::string TileName(int col) { return absl::StrFormat("Tile_%+04d_%+04d", col, 0); }
  // The files by their paths in the scene: two tiles and metadata.xml.
  std::map<std::string, std::string> Files() const {
    std::map<std::string, std::string> files;
    files["metadata.xml"] =
        "<ModelMetadata><SRS>EPSG:25832</SRS><SRSOrigin>500000,5600000,0</SRSOrigin></ModelMetadata>";
    for (const int col : {0, 1}) {
      const std::string name = TileName(col), folder = absl::StrCat("Data/", name, "/", name);
      const double x = col * kCell - kReach, y = -kReach, side = kCell + 2 * kReach;
      files[folder + ".osgb"] = File({{name + "_L1.osgb", Ground(x, y, side, 4)}});
      std::vector<Piece> pieces;
      for (const int k : {0, 1, 2, 3}) {
        const double half = side / 2, px = x + (k % 2) * half, py = y + (k / 2) * half;
        files[absl::StrCat(folder, "_L2_", k, ".osgb")] = File({{"", Ground(px, py, half, 1)}});
        pieces.push_back({absl::StrCat(name, "_L2_", k, ".osgb"), Ground(px, py, half, 2)});
      }
      files[folder + "_L1.osgb"] = File(pieces);
    }
    return files;
  }

  // The files of one tile as the program reads them, but for the file whose name ends in `without`.
  std::string Pack(int col, const std::string& without = "none") const {
    const std::map<std::string, std::string> files = Files();
    const std::string name = TileName(col), folder = absl::StrCat("Data/", name, "/"), own = folder + name + ".osgb";
    std::vector<PackedFile> packed = {{name + ".osgb", files.at(own)}};
    for (const auto& [path, bytes] : files) {
      const bool is_of_tile = path.starts_with(folder) && path != own && !path.ends_with(without);
      if (is_of_tile) packed.push_back({path.substr(folder.size()), bytes});
    }
    return PackFiles(packed);
  }

 private:
  struct Piece {
    std::string finer;  // file; empty: none
    BuiltGeometry ground;
  };

  // A square from (x0, y0) of about `step` metres an edge.
  BuiltGeometry Ground(double x0, double y0, double side, double step) const {
    BuiltGeometry ground;
    ground.points.clear();
    ground.uv.clear();
    ground.indices.clear();
    ground.image = image_;
    const auto n = static_cast<uint32_t>(std::lround(side / step));
    const auto at = [&](uint32_t i) { return side * i / n; };
    for (uint32_t j = 0; j <= n; ++j) {
      for (uint32_t i = 0; i <= n; ++i) {
        const double x = x0 + at(i), y = y0 + at(j);
        const double noise = InPond(x, y) ? 0.3 * std::pow(std::sin(12.9898 * x + 78.233 * y), 3) : 0;
        ground.points.push_back(
            {static_cast<float>(x), static_cast<float>(y), static_cast<float>(HeightAt(x, y) + noise)});
        ground.uv.push_back(
            {static_cast<float>(i) / static_cast<float>(n), static_cast<float>(j) / static_cast<float>(n)});
      }
    }
    for (uint32_t j = 0; j < n; ++j) {
      for (uint32_t i = 0; i < n; ++i) {
        const uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
        for (const auto& t : {std::array{a, b, d}, std::array{a, d, c}}) AddTriangle(t, ground);
      }
    }
    return ground;
  }

  void AddTriangle(const std::array<uint32_t, 3>& t, BuiltGeometry& ground) const {
    double x = 0, y = 0;
    for (const uint32_t v : t) {
      x += static_cast<double>(ground.points[v][0]) / 3;
      y += static_cast<double>(ground.points[v][1]) / 3;
    }
    if (pond_ == Pond::kHole && InPond(x, y)) return;
    ground.indices.insert(ground.indices.end(), t.begin(), t.end());
  }

  std::string File(const std::vector<Piece>& pieces) const {
    OsgbBuilder builder(version_);
    std::vector<OsgbBuilder::Body> children;
    for (const Piece& piece : pieces) {
      const auto geode = [&builder, &piece] { builder.Geode({[&] { builder.Geometry(piece.ground); }}); };
      if (piece.finer.empty()) {
        children.emplace_back(geode);
      } else {
        children.emplace_back([&builder, &piece, geode] { builder.PagedLod(piece.finer, geode); });
      }
    }
    return builder.Scene([&] {
      if (children.size() == 1) {
        children[0]();
      } else {
        builder.Group(children);
      }
    });
  }

  const Pond pond_;
  const uint32_t version_;
  const std::string image_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_OSGB_SCENE_H_
