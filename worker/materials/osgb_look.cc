#include "worker/materials/osgb_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
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

struct OsgbTexel {
  int32_t vertex = 0;
  double u = 0, v = 0;
};

// Finds the geometry of a triangle of the finest level.
class GeometryFinder {
 public:
  GeometryFinder(const OsgbTile& tile, const OsgbLevel& finest) {
    for (const OsgbLevel::Part& part : finest.parts) {
      const int32_t file = tile.pieces[part.piece].file;
      int32_t first = part.first_triangle;
      for (const int32_t g : part.geometries) {
        const OsgbGeometry& geometry = tile.files[file].geometries[g];
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

absl::Status SampleOsgbImage(const OsgbTile& tile, const ImagePlace& place, const std::vector<OsgbTexel>& texels,
                             const std::string& name, RimColours& result) {
  const OsgbImage& image = tile.files[place.file].images[place.image];
  const std::string image_name = absl::StrCat(name, ": image \"", Printable(image.name), "\"");
  if (image.storage != OsgbImage::Storage::kEncoded) {
    return absl::InvalidArgumentError(absl::StrCat(image_name, ": not a JPEG or PNG in the file"));
  }
  const std::string_view bytes = tile.packed[place.file].bytes.substr(image.offset, image.size);
  TILEMEND_ASSIGN_OR_RETURN(const Image pixels, DecodeImage(bytes, image_name));
  for (const OsgbTexel& t : texels) result.colours[static_cast<size_t>(t.vertex)] = TexelAt(pixels, t.u, t.v);
  return absl::OkStatus();
}

}  // namespace

TileLook ReadOsgbLook(const std::string& path, const OsgbTile& tile) {
  TileLook look;
  for (size_t f = 1; f < tile.packed.size(); ++f) {
    look.files.images.push_back(FileBesideTile(path, tile.packed[f].name));
  }
  return look;
}

RimColours SampleOsgbRim(const OsgbTile& tile, const OsgbLevel& finest, const std::vector<RimSpot>& spots,
                         size_t vertices, const std::string& name) {
  RimColours result;
  result.colours.resize(vertices);
  const GeometryFinder finder(tile, finest);
  std::map<ImagePlace, std::vector<OsgbTexel>> texels;
  for (const RimSpot& spot : spots) {
    const GeometryFinder::Run& run = finder.Of(spot.triangle);
    const OsgbFile& file = tile.files[run.file];
    const OsgbGeometry& geometry = file.geometries[run.geometry];
    if (geometry.texture < 0) continue;
    const Triangle& corners = file.triangles[geometry.first_triangle + spot.triangle - run.first];
    double u = 0, v = 0;
    for (size_t k = 0; k < 3; ++k) {
      u += spot.weights[k] * static_cast<double>(file.uv[corners[k]][0]);
      v += spot.weights[k] * static_cast<double>(file.uv[corners[k]][1]);
    }
    if (std::isfinite(u) && std::isfinite(v)) texels[{run.file, geometry.texture}].push_back({spot.vertex, u, v});
  }
  for (const auto& [place, of_image] : texels) {
    const absl::Status status = SampleOsgbImage(tile, place, of_image, name, result);
    if (!status.ok()) {
      result.warnings.push_back(absl::StrCat(status.message(), ": fills beside it get no colour from it"));
    }
  }
  return result;
}

}  // namespace tilemend
