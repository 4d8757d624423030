// The surface around a fill, small enough to be shown in a page.
#ifndef TILEMEND_CLIENT_HOLE_CROP_H_
#define TILEMEND_CLIENT_HOLE_CROP_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "client/picture_tile.h"

namespace tilemend {

enum class FaceState : uint8_t { kKept = 0, kAdded = 1, kCleared = 2 };

// A tile before and after, and what changed.
struct TilePair {
  PictureTile before, after;
  TileChange change;
};

struct HoleCrop {
  struct Face {
    int32_t triangle = 0;  // of `before` where it was cleared, else of `after`
    FaceState state = FaceState::kKept;
    SpaceTriangle corners;  // where the picture has them: maybe not to the millimetre
  };
  std::vector<Face> faces;
  int64_t faces_there = 0;  // before those were left out that are too small to be seen
};

inline constexpr int64_t kMostCropFaces = 12000;

// Added triangles that are connected over edges: the fill of a hole, or a part of it.
struct AddedPiece {
  Eigen::AlignedBox3d box;
  Eigen::Vector3d vector_area{0, 0, 0};  // m2; depends on the boundary alone
};

// The pieces of added triangles of a tile. O(n log n).
std::vector<AddedPiece> AddedPieces(const TriMesh& mesh, const std::vector<bool>& added);

// The box of the piece that has `centre` in its box seen from above and whose area is nearest to `area`. An empty box
// if there is none, or if its area differs by more than half of `area`: it is another fill. A fill that is exactly what
// was cleared has no piece. `area`: of the hole, from above or along its own normal. O(pieces).
Eigen::AlignedBox3d PieceAt(const std::vector<AddedPiece>& pieces, const Point2& centre, double area);

// The triangles that meet the box of a fill grown by a third of its width, by 3 to 60 metres. Where they are more than
// kMostCropFaces, vertices are moved together on a grid that is as fine as that number allows. O(n).
HoleCrop CropAround(const TilePair& tile, const Eigen::AlignedBox3d& fill);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_HOLE_CROP_H_
