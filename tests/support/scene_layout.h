// Layouts of holes as JSON, in cells, so that one layout makes scenes of any cell size and cut.
#ifndef TILEMEND_TESTS_SUPPORT_SCENE_LAYOUT_H_
#define TILEMEND_TESTS_SUPPORT_SCENE_LAYOUT_H_

#include <string>

#include "absl/status/status.h"
#include "tests/support/scene_maker.h"

namespace tilemend {

// Sets in `options` what the layout `text` says; `name` is for errors. Sizes are cells of options.cell_size:
//   cols, rows       of the scene
//   holes            list of {kind: "box", at: [x0, y0, x1, y1]}, {kind: "disc", at: [x, y, radius x, radius y]} or
//                    {kind: "strip", through: [[x, y], ...], half_width}; each may have only_cell: [column, row]
//   closed           optional: closed holes in cells that no other hole reaches
//   relief           optional, metres
//   out_of_area      optional, list of [column, row]
// The outlines of shapes are bent a little. kInvalidArgument for any other text.
absl::Status ApplyLayout(const std::string& text, const std::string& name, SceneMakerOptions* options);

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_SCENE_LAYOUT_H_
