// Bounding volumes of 3D Tiles, which grow to hold more points.
#ifndef TILEMEND_COMMON_CODEC_TILES3D_BOUNDING_VOLUME_H_
#define TILEMEND_COMMON_CODEC_TILES3D_BOUNDING_VOLUME_H_

#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

struct BoundingVolume {
  enum class Kind {
    kBox,     // centre, then three half axes: 12 numbers, metres, frame of the tile
    kRegion,  // west, south, east, north in radians, lowest and highest height in metres above WGS 84: 6 numbers
    kSphere,  // centre and radius: 4 numbers, metres, frame of the tile
  };
  Kind kind = Kind::kBox;
  std::vector<double> numbers;
  bool operator==(const BoundingVolume&) const = default;
};

// Longitude and latitude in radians, and height in metres above the ellipsoid of WGS 84, of an Earth-centred point.
// Exact to 1e-9 m within 10 km of the ellipsoid. Source: Bowring 1985, "The accuracy of geodetic latitude and height
// equations".
Point3 GeodeticOf(const Point3& earth_centred);

// The smallest volume of the same kind that holds `volume` and the points. A box keeps the directions of its axes, a
// sphere its centre. The points are in the frame of the tile; for a region they are Earth-centred. Returns the same
// numbers if it holds the points already. Linear.
BoundingVolume GrownVolume(const BoundingVolume& volume, const std::vector<Point3>& points);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_TILES3D_BOUNDING_VOLUME_H_
