#include "client/left_table.h"

#include <gtest/gtest.h>

#include <string>

#include "coordinator/plan/types/left_reasons.h"

namespace tilemend {
namespace {

TEST(LeftTableTest, SaysWhereWhyAndWhatWasChosen) {
  Plan plan;
  for (const Point3& p : {Point3(0, 0, 1), Point3(6, 0, 1), Point3(0, 6, 4)}) {
    plan.vertices.emplace_back();
    plan.vertices.back().position = p;
  }
  PlannedHole hole;
  hole.segments = {{0, 1, false}, {1, 2, false}, {2, 0, false}};
  hole.boundary_vertices = 3;
  plan.holes.push_back(hole);
  plan.left.push_back({{0, 0}, "no loop", -1, 5});
  plan.left.push_back({{0, 0}, kLongerThanChosen, -1, 22, false});
  SceneReportInput report;
  report.plan = &plan;
  report.outcome.failures[0] = "folds back";
  EXPECT_EQ(LeftLines(report),
            "left: 5 edges: no loop\nleft: 3 edges around (2, 2, 2): folds back\n"
            "left as chosen: 1 hole longer than --largest-hole\n");
}

}  // namespace
}  // namespace tilemend
