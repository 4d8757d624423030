// The files of an output that say where its tiles lie; where delivered tilesets lie on the Earth.
#ifndef TILEMEND_COORDINATOR_JOBS_DELIVERY_ENTRY_H_
#define TILEMEND_COORDINATOR_JOBS_DELIVERY_ENTRY_H_

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/grid/scene.h"
#include "coordinator/store/output_folder.h"

namespace tilemend {

inline constexpr char kEntryFile[] = "tileset.json";

struct DeliveryPlaces {
  std::optional<Eigen::Matrix4d> root;      // from the plane at the middle of the scene to the Earth-centred frame
  std::map<CellId, Eigen::Matrix4d> cells;  // from the scene's frame to the Earth-centred one, or to itself
  std::string warning;                      // why there is no place on the Earth; or empty
};

// For a scene whose tiles are delivered as 3D Tiles; else nothing. Each cell has a plane of its own that touches the
// Earth at its middle, with the scale of the CRS. So tiles of 250 m are within 3 mm of where the CRS has them, in
// height and along their borders. Heights are taken as above the ellipsoid of WGS 84. A scene without a CRS is not on
// the Earth. Errors of LonLatOf. O(cells).
absl::StatusOr<DeliveryPlaces> PlaceDelivery(const Scene& scene);

// The text of the entry for those tiles that are in the folder `out`. Errors of NewEntry; kInvalidArgument if there is
// none.
absl::StatusOr<std::string> DeliveryEntry(const Scene& scene, const DeliveryPlaces& places, const std::string& out);

// The metadata.xml of an output in another format: that of the scene; else, for OSGB, which needs it, one like it; else
// "". Errors of ReadFile.
absl::StatusOr<std::string> MetadataOf(const Scene& scene);

// Writes what says where the tiles of an output lie: scene.json, metadata.xml, the tileset of the scene, or the entry.
absl::Status WriteScene(const Scene& scene, OutputFolder& output);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_DELIVERY_ENTRY_H_
