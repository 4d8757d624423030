// The metric frame in which a tileset is filled: z up, x to the east where the tileset says where on the Earth it lies.
#ifndef TILEMEND_COMMON_CODEC_TILES3D_TILESET_FRAME_H_
#define TILEMEND_COMMON_CODEC_TILES3D_TILESET_FRAME_H_

#include <Eigen/Core>
#include <string>

#include "common/codec/tiles3d/tileset.h"

namespace tilemend {

// The frame of the scene is one of
//  - that of the root's parent, if the tileset is not on the Earth;
//  - that of the root tile, if its transform puts a frame with z up onto the Earth: coordinates keep their bits;
//  - one at the middle of the root's volume, with x to the east and y to the north, for Earth-centred coordinates.
// Its axes may be turned about the vertical. It is plane. What is level in it sinks below the ellipsoid by 8 cm at 1 km
// from its origin, and by 2 m at 5 km.
struct TilesetFrame {
  bool is_roots = false;                                     // that of the root tile, turned
  Eigen::Matrix4d from_outer = Eigen::Matrix4d::Identity();  // from the frame of the root or of its parent
  std::string crs;    // its plane as a PROJ string, on the ellipsoid of WGS 84; empty: not known
  double height = 0;  // of its origin above that ellipsoid, metres; 0 without a crs
};

// That frame, with axes that are turned counter-clockwise by `turn`, radians. Pure, O(1).
TilesetFrame FrameOf(const Tileset& tileset, double turn = 0);

// From the frame of a tile to that of the scene, metres.
Eigen::Matrix4d ToScene(const TilesetFrame& frame, const TilesetTile& tile);

// East, north and up at a longitude and latitude in radians, as columns in the Earth-centred frame.
Eigen::Matrix3d AxesAt(const Point3& geodetic);

// The Earth-centred point at a longitude and latitude in radians, and a height in metres above the ellipsoid of WGS 84.
Point3 EarthCentred(const Point3& geodetic);

// `point` moved by a matrix.
inline Point3 Moved(const Eigen::Matrix4d& matrix, const Point3& point) {
  return matrix.topLeftCorner<3, 3>() * point + matrix.topRightCorner<3, 1>();
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_TILES3D_TILESET_FRAME_H_
