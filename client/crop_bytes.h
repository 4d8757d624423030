// A crop as the page reads it.
#ifndef TILEMEND_CLIENT_CROP_BYTES_H_
#define TILEMEND_CLIENT_CROP_BYTES_H_

#include <string>

#include "client/hole_crop.h"

namespace tilemend {

// Little-endian: "TMC1", uint32 vertices, triangles and bytes of the JPEG; double lo[3], hi[3] in metres; uint16
// position[3] of each vertex from lo to hi; uint16 texture place[2], v downward; uint8 colour[4]; uint8 FaceState of
// each triangle; zeros up to a multiple of 4; uint32 corners[3] of each triangle; the JPEG. web/src/crop.ts reads it.
// `before` and `after`: the folders that image paths are relative to.
std::string CropBytes(const HoleCrop& crop, const TilePair& tile, const std::string& before, const std::string& after);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_CROP_BYTES_H_
