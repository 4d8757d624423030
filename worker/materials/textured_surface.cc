#include "worker/materials/textured_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tilemend {
namespace {

bool HasPlaces(const ObjTextures& textures, size_t triangle) {
  return std::all_of(textures.corners[triangle].begin(), textures.corners[triangle].end(), [&](int32_t corner) {
    if (corner < 0) return false;
    const std::array<float, 2>& place = textures.coordinates[static_cast<size_t>(corner)];
    return std::isfinite(place[0]) && std::isfinite(place[1]);
  });
}

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
  using Key = std::pair<std::string, int32_t>;  // image, colour
  std::map<Key, TexturedSurface::Group> groups;
  const TileMaterial none;
  const TileMaterial* material = &none;
  auto run = obj.textures.runs.begin();
  for (size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    for (; run != obj.textures.runs.end() && run->first <= static_cast<int64_t>(t); ++run) {
      const auto found = look.materials.find(obj.textures.materials[static_cast<size_t>(run->material)]);
      material = found == look.materials.end() ? &none : &found->second;
    }
    const bool has_image = !material->image.empty();
    Key key{has_image && HasPlaces(obj.textures, t) ? material->image : "", -1};
    if (const std::optional<Rgb>& c = material->diffuse; !has_image && c) {
      key.second = c->r << 16 | c->g << 8 | c->b;
    }
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

}  // namespace tilemend
