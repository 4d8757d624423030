// A tile written as a PLY file, with its images beside it.
#ifndef TILEMEND_WORKER_DELIVERY_PLY_DELIVERY_H_
#define TILEMEND_WORKER_DELIVERY_PLY_DELIVERY_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "worker/delivery/delivery_tile.h"
#include "worker/delivery/tileset_delivery.h"

namespace tilemend {

// What a tile's fills may add to the file, though the tile itself does not need it.
struct PlyColumns {
  bool images = false;   // images in place of colours of vertices
  bool float64 = false;  // coordinates
};

// Whether the file of the tile has images.
bool HasImages(const DeliveryTile& tile, const PlyColumns& columns);

// The binary file "`stem`.ply" (first) and the images, with their bytes; those of filled surface last. All pieces are
// written; equal positions are one vertex, but not in one triangle, nor of two pieces unless both have it on their
// rims: where these overlap they stay two. Coordinates are float32 if that keeps their bits, else float64.
//
// A tile with images has them as MeshLab does: "comment TextureFile NAME", and for each face the image's number
// (texnumber) and the places of its corners (texcoord). Its faces of one colour get an image of that colour. In a tile
// without images, vertices have the colours, so that one at the border of two colours is written for each. If there
// is filled surface, faces have the property tilemend_filled. Errors of EncodeJpeg. O(n log n).
absl::StatusOr<std::vector<DeliveryFile>> PlyFilesOf(const DeliveryTile& tile, const std::string& stem,
                                                     const PlyColumns& columns = {});

}  // namespace tilemend

#endif  // TILEMEND_WORKER_DELIVERY_PLY_DELIVERY_H_
