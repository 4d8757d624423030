// The kinds of findings of the acceptance check, and what they are called.
#ifndef TILEMEND_CLIENT_ACCEPTANCE_KINDS_H_
#define TILEMEND_CLIENT_ACCEPTANCE_KINDS_H_

#include <array>

namespace tilemend {

enum AcceptanceKind {
  kMissingTile,
  kDamagedTile,
  kMissingFace,
  kClearedFaces,
  kMissingFile,
  kChangedFile,
  kFillTexture,
  kPlacement,
  kOpenEdge,
  kCrossedFill,
  kCrossedSurface,
  kNonManifoldEdge,
  kTurnedEdge,
  kFlatTriangle,
  kFoldedFill,
  kFillArea,
  kUnfilledLevel,
  kWaterOffLevel,
  kWaterWithoutFill,
  kFillsApart,
  kReport,
  kLeftHole,
  kCrossedRim,
  kOtherMesh,
  kAcceptanceKindCount
};

struct AcceptanceKindText {
  const char *name, *one, *many;  // for programs; for people, of one finding and of several
  bool is_fault;
  bool is_of_fill;  // its places are in fills or on their rims
};
inline constexpr std::array<AcceptanceKindText, kAcceptanceKindCount> kAcceptanceKinds = {{
    {"missing_tiles", "missing tile", "missing tiles", true, false},
    {"damaged_tiles", "tile that cannot be read", "tiles that cannot be read", true, false},
    {"missing_faces", "original face that is missing or changed", "original faces that are missing or changed", true,
     false},
    {"cleared_faces", "tile with more faces taken out than reported", "tiles with more faces taken out than reported",
     true, false},
    {"missing_files", "missing material file or image", "missing material files and images", true, false},
    {"changed_files", "changed material file or image", "changed material files and images", true, false},
    {"fill_textures", "broken texture of fills", "broken textures of fills", true, false},
    {"placement", "changed or missing file that says where tiles lie",
     "changed or missing files that say where tiles lie", true, false},
    {"open_edges", "new open edge", "new open edges", true, true},
    {"crossed_fills", "filled triangle that crosses another", "filled triangles that cross each other", true, true},
    {"crossed_surface", "filled triangle that crosses the original surface",
     "filled triangles that cross the original surface", true, true},
    {"nonmanifold_edges", "new edge with more than two triangles", "new edges with more than two triangles", true,
     true},
    {"turned_edges", "new edge whose triangles face opposite ways", "new edges whose triangles face opposite ways",
     true, true},
    {"flat_triangles", "filled triangle without area", "filled triangles without area", true, true},
    {"folded_fills", "filled triangle over the ground that faces down",
     "filled triangles over the ground that face down", true, true},
    {"fill_areas", "tile whose fills are larger or smaller than its holes",
     "tiles whose fills are larger or smaller than their holes", true, false},
    {"unfilled_levels", "level of detail of tiles that was not filled",
     "levels of detail of tiles that were not filled", true, false},
    {"water_off_level", "point of water that is not at its level", "points of water that are not at its level", true,
     true},
    {"water_without_fill", "water without a fill", "waters without a fill", true, true},
    {"fills_apart", "place where fills of two tiles are more than 2 cm apart",
     "places where fills of two tiles are more than 2 cm apart", true, true},
    {"report", "contradiction in report.json", "contradictions in report.json", true, false},
    {"left_holes", "hole left open, as reported", "holes left open, as reported", false, false},
    {"crossed_rims", "filled triangle at a rim that the input's surface passes through",
     "filled triangles at rims that the input's surface passes through", false, true},
    {"other_meshes", "other mesh among the tiles", "other meshes among the tiles", false, false},
}};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_ACCEPTANCE_KINDS_H_
