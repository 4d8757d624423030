// The loops of single meshes for tests of what they bound.
#ifndef TILEMEND_TESTS_SUPPORT_MESH_READING_H_
#define TILEMEND_TESTS_SUPPORT_MESH_READING_H_

#include <vector>

#include "coordinator/plan/mesh/loop_groups.h"
#include "coordinator/plan/mesh/mesh_loops.h"
#include "coordinator/plan/mesh/outlines.h"
#include "worker/survey/survey.h"

namespace tilemend {

// The boundary of a mesh, read step by step.
struct MeshReading {
  explicit MeshReading(const TriMesh& mesh) : record(SurveyTile(mesh, false)) {
    input.has_grid = false;
    input.cells[CellId{0, 0}] = &record;
    rim = BuildRim(input, RimPoints::kOfEdges);
    LinkLoops(rim, record.edge_after);
    loops = ReadMeshLoops(rim, record);
    outlines = FindOutlines(loops, record.piece_areas);
    groups = GroupLoops(rim, loops, outlines);
  }
  std::vector<SingleType> Kinds() const {
    std::vector<SingleType> kinds;
    for (const MeshHole& hole : groups.holes) kinds.push_back(hole.single);
    return kinds;
  }

  SurveyRecord record;
  PlanInput input;
  Rim rim;
  std::vector<MeshLoop> loops;
  std::vector<bool> outlines;
  LoopGroups groups;
};

inline bool Everywhere(int32_t, int32_t) { return true; }

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_MESH_READING_H_
