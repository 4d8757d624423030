#include "worker/materials/tree_look.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/image/image.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

// An image of one file of the tile.
struct ImagePlace {
  int32_t file = 0;
  int32_t image = 0;
  auto operator<=>(const ImagePlace&) const = default;
};

struct TreeTexel {
  int32_t vertex = 0;
  double u = 0, v = 0;
};

// Finds the geometry of a triangle of the finest level.
class GeometryFinder {
 public:
  GeometryFinder(const TileTree& tile, const TreeLevel& finest) {
    for (const TreeLevel::Part& part : finest.parts) {
      const int32_t file = tile.pieces[part.piece].file;
      int32_t first = part.first_triangle;
      for (const int32_t g : part.geometries) {
        const TreeGeometry& geometry = tile.files[file].geometries[g];
        runs_.push_back({first, file, g});
        first += geometry.triangle_count;
      }
    }
  }

  struct Run {
    int32_t first = 0;  // triangle of the level
    int32_t file = 0, geometry = 0;
  };
  const Run& Of(int32_t triangle) const {
    const auto after =
        std::upper_bound(runs_.begin(), runs_.end(), triangle, [](int32_t t, const Run& run) { return t < run.first; });
    return *std::prev(after);
  }

 private:
  std::vector<Run> runs_;
};

absl::Status SampleTreeImage(const TileTree& tile, const ImagePlace& place, const std::vector<TreeTexel>& texels,
                             const std::string& name, RimColours& result) {
  const TreeImage& image = tile.files[place.file].images[place.image];
  const std::string image_name = absl::StrCat(name, ": image \"", Printable(image.name), "\"");
  if (!image.is_encoded) {
    return absl::InvalidArgumentError(absl::StrCat(image_name, ": not in the file as JPEG or PNG"));
  }
  const std::string_view bytes = tile.packed[place.file].bytes.substr(image.offset, image.size);
  TILEMEND_ASSIGN_OR_RETURN(const Image pixels, DecodeImage(bytes, image_name));
  for (const TreeTexel& t : texels) result.colours[static_cast<size_t>(t.vertex)] = TexelAt(pixels, t.u, t.v);
  return absl::OkStatus();
}

}  // namespace

TileLook ReadTreeLook(const std::string& path, const TileTree& tile) {
  TileLook look;
  for (size_t f = 1; f < tile.packed.size(); ++f) {
    if (tile.packed[f].name != kFrameFile) look.files.images.push_back(FileBesideTile(path, tile.packed[f].name));
  }
  return look;
}

RimColours SampleTreeRim(const TileTree& tile, const TreeLevel& finest, const std::vector<RimSpot>& spots,
                         size_t vertices, const std::string& name) {
  RimColours result;
  result.colours.resize(vertices);
  const GeometryFinder finder(tile, finest);
  std::map<ImagePlace, std::vector<TreeTexel>> texels;
  for (const RimSpot& spot : spots) {
    const GeometryFinder::Run& run = finder.Of(spot.triangle);
    const TreeFile& file = tile.files[run.file];
    const TreeGeometry& geometry = file.geometries[run.geometry];
    if (geometry.texture < 0) {
      if (geometry.has_colour) result.colours[static_cast<size_t>(spot.vertex)] = geometry.colour;
      continue;
    }
    const Triangle& corners = file.triangles[geometry.first_triangle + spot.triangle - run.first];
    double u = 0, v = 0;
    for (size_t k = 0; k < 3; ++k) {
      u += spot.weights[k] * static_cast<double>(file.uv[corners[k]][0]);
      v += spot.weights[k] * static_cast<double>(file.uv[corners[k]][1]);
    }
    if (std::isfinite(u) && std::isfinite(v)) texels[{run.file, geometry.texture}].push_back({spot.vertex, u, v});
  }
  for (const auto& [place, of_image] : texels) {
    const absl::Status status = SampleTreeImage(tile, place, of_image, name, result);
    if (!status.ok()) {
      result.warnings.push_back(absl::StrCat(status.message(), ": fills beside it get no colour from it"));
    }
  }
  return result;
}

}  // namespace tilemend
