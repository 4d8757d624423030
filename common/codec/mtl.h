// Material files of Wavefront OBJ (.mtl): what a surface looks like, and which images lie on it.
#ifndef TILEMEND_COMMON_CODEC_MTL_H_
#define TILEMEND_COMMON_CODEC_MTL_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/util/colour.h"

namespace tilemend {

struct MtlMaterial {
  std::string name;
  std::optional<Rgb> diffuse;  // Kd, where it is three numbers
  std::string image;           // of map_Kd, as it is written; empty: none
};

struct MtlFile {
  std::vector<MtlMaterial> materials;
  std::vector<std::string> images;   // of all maps (map_Kd, bump, refl, ...), as they are written, each once
  std::vector<int64_t> image_lines;  // where each is named first, from 1
};

// What a material file says. Statements that it does not know, or that are damaged, are skipped: the look of a surface
// is no reason to fail. Options before an image's name (-s 1 1 1, -clamp on) are no part of it; blanks within the name
// are. Linear.
MtlFile ParseMtl(std::string_view text);

// A material of filled faces.
struct FillMaterial {
  std::string name;
  Rgb colour;
  std::string image = {};  // that lies on the faces, as a material file names it; empty: the colour alone
  bool operator==(const FillMaterial&) const = default;
};

// `text` unchanged, then the materials that it does not define: opaque, of one colour or with an image,
// without highlights.
std::string AppendToMtl(std::string_view text, const std::vector<FillMaterial>& materials);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_MTL_H_
