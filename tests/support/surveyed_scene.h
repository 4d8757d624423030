// Scenes in memory: tiles and their survey records, ready for planning.
#ifndef TILEMEND_TESTS_SUPPORT_SURVEYED_SCENE_H_
#define TILEMEND_TESTS_SUPPORT_SURVEYED_SCENE_H_

#include <map>
#include <string>
#include <vector>

#include "common/grid/scene.h"
#include "common/mesh/tri_mesh.h"
#include "common/records/survey_record.h"
#include "coordinator/plan/plan.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/scene_maker.h"

namespace tilemend {

// The records must stay where they are while a PlanInput is in use.
struct SurveyedScene {
  Grid grid;
  bool area_known = true;
  std::map<CellId, TriMesh> tiles;         // the cells of the area; without triangles: no tile
  std::map<CellId, SurveyRecord> records;  // of the tiles

  PlanInput Input() const;
  // As SceneWaves takes it. Tiles have paths that are not there.
  Scene AsScene() const;
};

SurveyedScene SurveyScene(const Grid& grid, std::map<CellId, TriMesh> tiles);
SurveyedScene SurveyScene(const MadeScene& made);

// A scene by a picture, north at the top, clipped on the grid lines. In it '#' is a square of surface with sides of 1
// m, '.' one without, ' ' one outside the area (whole cells only). A cell's side has `squares` squares.
// The marks '|' and rows of '-' and '+' are decoration.
SurveyedScene PictureScene(const std::vector<std::string>& picture, int32_t squares,
                           const HeightFunction& height = Flat);

// The holes of a plan in words, failed ones left out: "2 closed, 1 IA, 4 IIB"; "none".
std::string CountsOf(const Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_SURVEYED_SCENE_H_
