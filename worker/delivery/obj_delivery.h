// A tile written as an OBJ file with a material file and images.
#ifndef TILEMEND_WORKER_DELIVERY_OBJ_DELIVERY_H_
#define TILEMEND_WORKER_DELIVERY_OBJ_DELIVERY_H_

#include <string>
#include <vector>

#include "worker/delivery/delivery_tile.h"
#include "worker/delivery/tileset_delivery.h"

namespace tilemend {

// The files "`stem`.obj" (first), "`stem`.mtl" and an image for each image of the tile, with its bytes. All pieces are
// written, in their order, and filled surface after all others, in the group tilemend_filled. So are its materials.
// Numbers are the shortest that give the same coordinates again. Linear.
std::vector<DeliveryFile> ObjFilesOf(const DeliveryTile& tile, const std::string& stem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_DELIVERY_OBJ_DELIVERY_H_
