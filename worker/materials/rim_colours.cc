#include "worker/materials/rim_colours.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "absl/strings/str_cat.h"
#include "common/image/image.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

// The material of each run; null where the tile's material files do not define it.
std::vector<const TileMaterial*> MaterialsOf(const TileLook& look, const ObjTextures& textures) {
  std::vector<const TileMaterial*> materials;
  for (const ObjTextures::Run& run : textures.runs) {
    const auto it = look.materials.find(textures.materials[static_cast<size_t>(run.material)]);
    materials.push_back(it == look.materials.end() ? nullptr : &it->second);
  }
  return materials;
}

// The texture coordinates of a spot; NaN where the triangle has none.
std::array<double, 2> CoordinatesAt(const ObjTextures& textures, const RimSpot& spot) {
  std::array<double, 2> result{};
  for (size_t k = 0; k < 3; ++k) {
    const int32_t corner = textures.corners[static_cast<size_t>(spot.triangle)][k];
    if (corner < 0) return {NAN, NAN};
    const std::array<float, 2>& t = textures.coordinates[static_cast<size_t>(corner)];
    for (size_t axis = 0; axis < 2; ++axis) result[axis] += spot.weights[k] * static_cast<double>(t[axis]);
  }
  return result;
}

struct Texel {
  int32_t vertex = 0;
  double u = 0, v = 0;
};

absl::Status SampleImage(const std::string& root, const std::string& path, const std::vector<Texel>& texels,
                         RimColours& result) {
  FileWitness::Read& read = result.reads.emplace_back(FileWitness::Read{path, ""});
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(absl::StrCat(root, "/", path)));
  read.digest = FileDigest(bytes);
  TILEMEND_ASSIGN_OR_RETURN(const Image image, DecodeImage(bytes, path));
  for (const Texel& t : texels) result.colours[static_cast<size_t>(t.vertex)] = TexelAt(image, t.u, t.v);
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<RimColours> SampleRim(const std::string& root, const TileLook& look, const ObjTextures& textures,
                                     const std::vector<RimSpot>& spots, const std::vector<BoundaryVertex>& vertices) {
  RimColours result;
  if (look.materials.empty() && textures.vertex_colours.empty()) return result;
  result.colours.resize(vertices.size());
  const std::vector<const TileMaterial*> materials = MaterialsOf(look, textures);
  std::map<std::string, std::vector<Texel>> texels;  // by image
  for (const RimSpot& spot : spots) {
    const auto run = std::upper_bound(textures.runs.begin(), textures.runs.end(), spot.triangle,
                                      [](int32_t t, const ObjTextures::Run& r) { return t < r.first; });
    const TileMaterial* const material =
        run == textures.runs.begin() ? nullptr : materials[static_cast<size_t>(run - textures.runs.begin() - 1)];
    const auto vertex = static_cast<size_t>(spot.vertex);
    if (material == nullptr) {
      if (textures.vertex_colours.empty()) continue;
      result.colours[vertex] = textures.vertex_colours[static_cast<size_t>(vertices[vertex].index)];
      continue;
    }
    if (material->image.empty()) {
      result.colours[vertex] = material->diffuse;
      continue;
    }
    const std::array<double, 2> uv = CoordinatesAt(textures, spot);
    if (std::isfinite(uv[0]) && std::isfinite(uv[1])) texels[material->image].push_back({spot.vertex, uv[0], uv[1]});
  }
  for (const auto& [path, places] : texels) {
    const absl::Status status = SampleImage(root, path, places, result);
    if (IsStoreError(root, status)) return status;
    if (!status.ok()) {
      result.warnings.push_back(
          absl::StrCat(Printable(std::string(status.message())), ": fills beside it get no colour from it"));
    }
  }
  return result;
}

}  // namespace tilemend
