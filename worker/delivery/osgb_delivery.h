// A tile written as a tree of OSGB files.
#ifndef TILEMEND_WORKER_DELIVERY_OSGB_DELIVERY_H_
#define TILEMEND_WORKER_DELIVERY_OSGB_DELIVERY_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "worker/delivery/delivery_tile.h"
#include "worker/delivery/tileset_delivery.h"

namespace tilemend {

// The file "`stem`.osgb" with the pieces that have no parent (first), and a file for the pieces that take the place of
// one piece. Coordinates are rounded to float32. A viewer refines where a pixel on its screen is larger than a
// sixteenth of the geometric error, as one of 3D Tiles does. Precondition: images are JPEG or PNG (KeepJpegAndPng).
// Errors of NewOsgb. Linear.
absl::StatusOr<std::vector<DeliveryFile>> OsgbFilesOf(const DeliveryTile& tile, const std::string& stem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_DELIVERY_OSGB_DELIVERY_H_
