#include "tests/support/tileset_scene.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/util/file_pack.h"
#include "tests/support/gltf_samples.h"
#include "tests/support/osgb_scene.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// A square of ground.
struct Square {
  double x = 0, y = 0, side = 0, step = 0;
};

template <typename T>
std::string Raw(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

void AddView(const std::string& bytes, int target, GltfSample& glb) {
  Json view = {{"buffer", 0}, {"byteOffset", glb.bin.size()}, {"byteLength", bytes.size()}};
  if (target != 0) view["target"] = target;
  glb.json["bufferViews"].push_back(view);
  glb.bin += bytes;
  glb.bin.append((4 - glb.bin.size() % 4) % 4, '\0');
}

// The corners of a square's triangles, z up, and their texture coordinates.
struct Ground {
  std::vector<float> points, uv;
  std::vector<uint32_t> indices;
};

Ground GroundOf(const Square& square, TilesetScene::Pond pond) {
  Ground ground;
  const auto n = static_cast<uint32_t>(std::lround(square.side / square.step));
  const auto at = [&](double from, uint32_t i) { return from + square.side * i / n; };
  for (uint32_t j = 0; j <= n; ++j) {
    for (uint32_t i = 0; i <= n; ++i) {
      const double x = at(square.x, i), y = at(square.y, j);
      const double noise = OsgbScene::InPond(x, y) ? 0.3 * std::pow(std::sin(12.9898 * x + 78.233 * y), 3) : 0;
      for (const double value : {x, y, OsgbScene::HeightAt(x, y) + noise}) {
        ground.points.push_back(static_cast<float>(value));
      }
      for (const uint32_t k : {i, n - j}) ground.uv.push_back(static_cast<float>(k) / static_cast<float>(n));
    }
  }
  for (uint32_t j = 0; j < n; ++j) {
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      for (const auto& t : {std::array{a, b, d}, std::array{a, d, c}}) {
        double x = 0, y = 0;
        for (const uint32_t v : t) {
          x += static_cast<double>(ground.points[3 * v]) / 3;
          y += static_cast<double>(ground.points[3 * v + 1]) / 3;
        }
        const bool is_water = pond == TilesetScene::Pond::kHole && OsgbScene::InPond(x, y);
        if (!is_water) ground.indices.insert(ground.indices.end(), t.begin(), t.end());
      }
    }
  }
  return ground;
}

// A node turns z up to the y up of glTF.
std::string Model(const Square& square, TilesetScene::Pond pond, const std::string& image) {
  const Ground ground = GroundOf(square, pond);
  GltfSample glb;
  glb.json = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "matrix": [1,0,0,0, 0,0,-1,0, 0,1,0,0, 0,0,0,1]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0.0}}],
    "textures": [{"source": 0}], "images": [{"mimeType": "image/png", "bufferView": 3}]})");
  AddView(Raw(ground.points), 34962, glb);
  AddView(Raw(ground.uv), 34962, glb);
  AddView(Raw(ground.indices), 34963, glb);
  AddView(image, 0, glb);
  const size_t count = ground.points.size() / 3;
  std::vector<float> lo(3, 1e9F), hi(3, -1e9F);
  for (size_t i = 0; i < ground.points.size(); ++i) {
    lo[i % 3] = std::min(lo[i % 3], ground.points[i]);
    hi[i % 3] = std::max(hi[i % 3], ground.points[i]);
  }
  const Json float_type = {{"componentType", 5126}, {"count", count}};
  Json points = float_type, uv = float_type;
  points.update({{"bufferView", 0}, {"type", "VEC3"}, {"min", lo}, {"max", hi}});
  uv.update({{"bufferView", 1}, {"type", "VEC2"}});
  glb.json["accessors"] = {
      points, uv, {{"bufferView", 2}, {"componentType", 5125}, {"count", ground.indices.size()}, {"type", "SCALAR"}}};
  glb.json["buffers"] = Json::array({{{"byteLength", glb.bin.size()}}});
  return glb.Glb();
}

Json Node(const Square& s, double error, const std::string& uri) {
  const double half = s.side / 2;
  Json node = {{"boundingVolume", {{"box", {s.x + half, s.y + half, 2.5, half, 0, 0, 0, half, 0, 0, 0, 1}}}},
               {"geometricError", error},
               {"refine", "REPLACE"}};
  if (!uri.empty()) node["content"] = {{"uri", uri}};
  return node;
}

Json Numbers(const Eigen::Matrix4d& matrix) { return std::vector<double>(matrix.data(), matrix.data() + 16); }

std::string Document(const Json& root) {
  return Json({{"asset", {{"version", "1.1"}}}, {"geometricError", 128}, {"root", root}}).dump();
}

Eigen::Matrix4d TurnOf(const TilesetScene& scene) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(scene.turn).matrix();
  return matrix;
}

// The levels of one cell: its node, and its models by their names.
Json Cell(const TilesetScene& scene, int col, const std::string& folder, std::map<std::string, std::string>& files) {
  const std::string name = TilesetScene::TileName(col), image = scene.image.empty() ? OnePixelPng() : scene.image;
  const double reach = scene.files == TilesetScene::Files::kOfTiles ? OsgbScene::kReach : 0,
               side = OsgbScene::kCell + 2 * reach;
  Square square{col * OsgbScene::kCell - reach, -reach, side, 4};
  const auto add = [&](const std::string& file, const Square& s, double error) {
    files[file] = Model(s, scene.pond, image);
    return Node(s, error, folder + file);
  };
  Json top = add(name + ".glb", square, 32);
  square.step = 2;
  Json middle = add(name + "_L1.glb", square, 16);
  for (const int k : {0, 1, 2, 3}) {
    const double half = side / 2;
    const Square part{square.x + (k % 2) * half, square.y + (k / 2) * half, half, 1};
    middle["children"].push_back(add(absl::StrCat(name, "_L2_", k, ".glb"), part, 0));
  }
  top["children"] = {middle};
  if (scene.place == TilesetScene::Place::kEarthCentred) {
    top["transform"] = Numbers(TilesetScene::ToEarth() * TurnOf(scene));
  } else if (scene.turn != 0) {
    top["transform"] = Numbers(TurnOf(scene));
  }
  return top;
}

}  // namespace

Eigen::Matrix4d TilesetScene::ToEarth() {
  const double lon = 8 * std::numbers::pi / 180, lat = 50 * std::numbers::pi / 180;
  const double squared = 0.00669437999014132, radius = 6378137 / std::sqrt(1 - squared * std::sin(lat) * std::sin(lat));
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.col(0).head<3>() = Eigen::Vector3d(-std::sin(lon), std::cos(lon), 0);
  matrix.col(1).head<3>() =
      Eigen::Vector3d(-std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon), std::cos(lat));
  matrix.col(2).head<3>() =
      Eigen::Vector3d(std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat));
  matrix.col(3).head<3>() =
      Eigen::Vector3d(radius * std::cos(lat) * std::cos(lon), radius * std::cos(lat) * std::sin(lon),
                      radius * (1 - squared) * std::sin(lat));
  return matrix;
}

std::map<std::string, std::string> TilesetScene::OfTile(int col) const {
  std::map<std::string, std::string> result;
  result[TileName(col) + ".json"] = Document(Cell(*this, col, "", result));
  return result;
}

std::map<std::string, std::string> TilesetScene::All() const {
  std::map<std::string, std::string> result;
  Json root = Node({-OsgbScene::kReach, -OsgbScene::kReach, 2 * OsgbScene::kCell + 2 * OsgbScene::kReach, 1}, 64, "");
  if (place == Place::kOnEarth) root["transform"] = Numbers(ToEarth());
  if (place == Place::kEarthCentred) {
    const Eigen::Vector3d middle = (ToEarth() * Eigen::Vector4d(64, 32, 2, 1)).head<3>();
    root["boundingVolume"] = {{"sphere", {middle.x(), middle.y(), middle.z(), 120}}};
  }
  if (place != Place::kEarthCentred && turn != 0) root["boundingVolume"] = {{"sphere", {64, 32, 2, 120}}};
  for (const int col : {0, 1}) {
    const std::string folder = absl::StrCat("Data/", TileName(col), "/");
    std::map<std::string, std::string> own = OfTile(col);
    if (files == Files::kOfTiles) {
      Json child = Json::parse(own.at(TileName(col) + ".json"))["root"];
      child.erase("children");
      child.erase("transform");
      if (place == Place::kEarthCentred || turn != 0) child["boundingVolume"] = root["boundingVolume"];
      child["content"] = {{"uri", absl::StrCat(folder, TileName(col), ".json")}};
      root["children"].push_back(child);
    } else {
      own.clear();
      root["children"].push_back(Cell(*this, col, folder, own));
    }
    for (auto& [name, bytes] : own) result[folder + name] = std::move(bytes);
  }
  result["tileset.json"] = Document(root);
  return result;
}

std::string TilesetScene::Pack() const {
  const std::map<std::string, std::string> all = All();
  std::vector<PackedFile> packed = {{"tileset.json", all.at("tileset.json")}};
  for (const auto& [path, bytes] : all) {
    if (path != "tileset.json") packed.push_back({path, bytes});
  }
  return PackFiles(packed);
}

}  // namespace tilemend
