// A scene with everything that seams are laid in.
#ifndef TILEMEND_TESTS_SUPPORT_SEAM_SCENE_H_
#define TILEMEND_TESTS_SUPPORT_SEAM_SCENE_H_

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/rim/rim_index.h"
#include "coordinator/plan/seam/seam_site.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {

struct SeamScene {
  explicit SeamScene(SurveyedScene surveyed)
      : scene(std::move(surveyed)),
        input(scene.Input()),
        lines(FindGridLines(input, AuditBorders(input), 0x1p-10)),
        rim(BuildRim(input)),
        index(rim),
        closing(FindClosingCells(input, lines, rim)) {
    for (const auto& [cell, record] : input.cells) area.insert(cell);
  }
  SeamScene(const std::vector<std::string>& picture, int32_t squares) : SeamScene(PictureScene(picture, squares)) {}
  SeamScene(const SeamScene&) = delete;

  SeamSite Site() const { return {area, lines, rim, index, options, 0x1p-10}; }

  SurveyedScene scene;
  PlanInput input;
  GridLines lines;
  Rim rim;
  RimIndex index;
  ClosingCells closing;
  std::set<CellId> area;
  PlanOptions options;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_SEAM_SCENE_H_
