// Whether the textures of fills can be shown.
#ifndef TILEMEND_CLIENT_FILL_TEXTURES_H_
#define TILEMEND_CLIENT_FILL_TEXTURES_H_

#include <string>
#include <vector>

#include "client/compared_tile.h"

namespace tilemend {

// What is wrong with the look of the fills in the tile `path` of the output `out`. Each is a line that begins with
// `path`. Materials that are not defined are named, and images that cannot be read. So is the number of `added`
// triangles with texture coordinates that are no numbers or outside the image. What the tile had before does not count.
// Nothing tells whether an image is that of these fills. Images in trees of files are not looked at. Linear in the new
// images and the triangles. Precondition: the pair has a tile after.
std::vector<std::string> FillTextureFaults(const std::string& out, const std::string& path, const ComparedTile& pair,
                                           const std::vector<bool>& added);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_FILL_TEXTURES_H_
