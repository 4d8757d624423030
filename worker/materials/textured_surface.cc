#include "worker/materials/textured_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/tree/tile_tree.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

bool HasPlaces(const ObjTextures& textures, size_t triangle) {
  return std::all_of(textures.corners[triangle].begin(), textures.corners[triangle].end(), [&](int32_t corner) {
    if (corner < 0) return false;
    const std::array<float, 2>& place = textures.coordinates[static_cast<size_t>(corner)];
    return std::isfinite(place[0]) && std::isfinite(place[1]);
  });
}

bool ArePlaces(const TreeFile& file, const Triangle& corners) {
  return std::all_of(corners.begin(), corners.end(), [&](int32_t corner) {
    const std::array<float, 2>& place = file.uv[static_cast<size_t>(corner)];
    return std::isfinite(place[0]) && std::isfinite(place[1]);
  });
}

// The name of a geometry's image among those of its tile; empty if there is none that can be read. Keeps its bytes.
std::string KeepImage(const TileTree& tile, int32_t file_number, const TreeGeometry& geometry, const std::string& name,
                      TexturedSurface& surface) {
  if (geometry.texture < 0) return "";
  const auto file = static_cast<size_t>(file_number);
  const TreeImage& image = tile.files[file].images[static_cast<size_t>(geometry.texture)];
  if (!image.is_encoded) return "";
  std::string key = absl::StrCat(name, ": ", tile.packed[file].name, ": image ", geometry.texture);
  const auto [at, fresh] = surface.encoded.try_emplace(key);
  if (fresh) at->second = std::string(tile.packed[file].bytes.substr(image.offset, image.size));
  return key;
}

using GroupKey = std::pair<std::string, int32_t>;  // image, colour

int32_t NumberOf(Rgb c) { return c.r << 16 | c.g << 8 | c.b; }

}  // namespace

std::array<std::array<float, 2>, 3> TexturedSurface::PlacesOf(int32_t triangle) const {
  std::array<std::array<float, 2>, 3> places;
  for (size_t k = 0; k < 3; ++k) {
    places[k] = coordinates[static_cast<size_t>(corners[static_cast<size_t>(triangle)][k])];
  }
  return places;
}

TexturedSurface TexturedSurfaceOf(ObjFile obj, const TileLook& look) {
  TexturedSurface surface;
  surface.mesh = std::move(obj.file.mesh);
  std::map<GroupKey, TexturedSurface::Group> groups;
  const TileMaterial none;
  const TileMaterial* material = &none;
  auto run = obj.textures.runs.begin();
  for (size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    for (; run != obj.textures.runs.end() && run->first <= static_cast<int64_t>(t); ++run) {
      const auto found = look.materials.find(obj.textures.materials[static_cast<size_t>(run->material)]);
      material = found == look.materials.end() ? &none : &found->second;
    }
    const bool has_image = !material->image.empty();
    GroupKey key{has_image && HasPlaces(obj.textures, t) ? material->image : "", -1};
    if (const std::optional<Rgb>& c = material->diffuse; !has_image && c) key.second = NumberOf(*c);
    TexturedSurface::Group& group = groups[key];
    if (group.triangles.empty()) {
      group.image = key.first;
      if (key.second >= 0) group.colour = material->diffuse;
    }
    group.triangles.push_back(static_cast<int32_t>(t));
  }
  for (auto& [key, group] : groups) surface.groups.push_back(std::move(group));
  surface.coordinates = std::move(obj.textures.coordinates);
  surface.corners = std::move(obj.textures.corners);
  return surface;
}

absl::StatusOr<TexturedSurface> TexturedSurfaceOfTree(std::string_view pack, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const TileTree tile, ReadTileTree(pack, name));
  TexturedSurface surface;
  TreeLevel finest = LevelOf(tile, tile.levels - 1);
  std::map<GroupKey, TexturedSurface::Group> groups;
  int32_t triangle = 0;
  for (const TreeLevel::Part& part : finest.parts) {
    const int32_t number = tile.pieces[static_cast<size_t>(part.piece)].file;
    const TreeFile& file = tile.files[static_cast<size_t>(number)];
    for (const int32_t g : part.geometries) {
      const TreeGeometry& geometry = file.geometries[static_cast<size_t>(g)];
      const std::string image = KeepImage(tile, number, geometry, name, surface);
      const bool is_plain = geometry.texture < 0 && geometry.has_colour;
      for (int32_t t = 0; t < geometry.triangle_count; ++t, ++triangle) {
        const Triangle& corners = file.triangles[static_cast<size_t>(geometry.first_triangle + t)];
        const bool has_image = !image.empty() && ArePlaces(file, corners);
        TexturedSurface::Group& group = groups[{has_image ? image : "", is_plain ? NumberOf(geometry.colour) : -1}];
        group.image = has_image ? image : "";
        if (is_plain) group.colour = geometry.colour;
        group.triangles.push_back(triangle);
        Triangle& own = surface.corners.emplace_back();
        for (size_t k = 0; k < 3; ++k) {
          own[k] = static_cast<int32_t>(surface.coordinates.size());
          surface.coordinates.push_back(file.uv[static_cast<size_t>(corners[k])]);
        }
      }
    }
  }
  surface.mesh = std::move(finest.mesh);
  for (auto& [key, group] : groups) surface.groups.push_back(std::move(group));
  return surface;
}

}  // namespace tilemend
