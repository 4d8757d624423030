// The images of a crop in one small JPEG.
#ifndef TILEMEND_CLIENT_PICTURE_ATLAS_H_
#define TILEMEND_CLIENT_PICTURE_ATLAS_H_

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/image/image.h"

namespace tilemend {

// A part of an image by texture coordinates, u to the right and v upward, inside [0, 1].
struct ImagePart {
  std::string path;
  std::array<float, 2> lo{1, 1}, hi{0, 0};
  int32_t number = -1;  // of the image in a file of a tree; -1: the file is the image
};

struct PictureAtlas {
  // Where a part lies: as fractions of the atlas, v downward.
  struct Square {
    double u = 0, v = 0, width = 0, height = 0;
  };
  std::string jpeg;                   // empty: there is no image that can be read
  std::vector<Square> squares;        // of each part; width 0: its image cannot be read
  std::array<double, 2> white{0, 0};  // a place that is white

  // The place of the texture coordinates `uv` of a part. Precondition: its square has a width.
  std::array<double, 2> PlaceOf(const ImagePart& part, size_t number, std::array<float, 2> uv) const;
};

// Puts the parts side by side, each scaled down, into one image of at most kAtlasSide pixels a side. The paths of the
// parts are relative to the folder `root`. Decodes one image after another. Images that cannot be read are left out.
PictureAtlas MakePictureAtlas(const std::string& root, const std::vector<ImagePart>& parts);

inline constexpr int32_t kAtlasSide = 768;

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_PICTURE_ATLAS_H_
