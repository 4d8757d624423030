// The acceptance check: whether an output is its input with its holes filled, and nothing else.
#ifndef TILEMEND_CLIENT_ACCEPTANCE_H_
#define TILEMEND_CLIENT_ACCEPTANCE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "client/step_watcher.h"
#include "common/grid/scene.h"

namespace tilemend {

// One place where something was found.
struct AcceptancePlace {
  CellId cell;
  std::optional<Point3> at;                    // none for a whole tile or file
  std::string note;                            // a path, a reason, a height; may be empty
  std::optional<int64_t> hole = std::nullopt;  // its number, if known
};

struct AcceptanceFinding {
  std::string name;  // for programs: "open_edges"
  std::string one;   // for people: "new open edge"
  std::string many;  // "new open edges"
  bool is_fault = true;
  int64_t count = 0;
  std::vector<AcceptancePlace> places;  // at most kMostAcceptancePlaces
};

inline constexpr size_t kMostAcceptancePlaces = 1000;  // of one kind

struct Acceptance {
  int64_t tiles = 0;
  int64_t cells_left_out = 0;                                      // with a tile that the job was not to write: --cells
  int64_t original_faces = 0, added_faces = 0, cleared_faces = 0;  // triangles
  int64_t files = 0;                                               // material files and images that were compared
  int64_t water_fills = 0;
  int64_t overlap_places = 0;               // where fills of two tiles lie over each other
  std::vector<AcceptanceFinding> findings;  // all kinds, also those without a place, in a fixed order
  std::vector<std::string> warnings;

  bool IsAccepted() const;
};

// Compares the output `out` of `tilemend run` with the scene `in`. Faults are
//   an original face that its tile does not have to the bit, unless the report says that it was cleared;
//   a changed image or material file, a material that is defined again, other names of them in a tile, and files that
//   fills name and that are not there;
//   a fill whose material is not defined, whose image cannot be read, or whose texture coordinates are off the image
//   (client/fill_textures.h);
//   a file that says where tiles lie and is missing or says another thing (client/tile_placement.h);
//   self-intersections, edges with more than two triangles, turned edges and triangles without area, with added faces;
//   an open edge, over all tiles together, that the input does not have (exceptions: on the rim of the area, at holes
//   that the report lists as left, and where tiles overlap and the neighbour covers it);
//   the open edges around a hole that was filled, by the report, and has no fill;
//   a filled triangle that faces down, where the report says that its hole was filled over the ground;
//   fills of a tile that are larger or smaller than the holes in the report;
//   a coarser level of detail without new faces in a tile with fills, where the report says of the level that more were
//   added than it has; a level of cleared tiles that lacks more faces than the report says;
//   water off its level;
//   fills of overlapping tiles that are more than 2 cm apart at more than 1 % of the places of a border;
//   a report that contradicts itself (client/report_agreement.h).
//
// Tiles are read one after another; memory is bounded by three rows of border edges and one tile. Cost O(n log n).
// kNotFound and kInvalidArgument if `in` is no scene or `out` no complete output, or a tile of one cannot be read.
absl::StatusOr<Acceptance> CheckAcceptance(const std::string& in, const std::string& out,
                                           const StepWatcher& watcher = {});

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_ACCEPTANCE_H_
