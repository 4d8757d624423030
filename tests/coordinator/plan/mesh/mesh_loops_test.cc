#include "coordinator/plan/mesh/mesh_loops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_join.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/mesh_reading.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

using testing::UnorderedElementsAre;

TEST(ReadMeshLoopsTest, TellsHolesTubesAndSheetsApartByTheirTurn) {
  const auto turn = [](const TriMesh& mesh) { return MeshReading(mesh).loops[0].Turn(); };
  EXPECT_NEAR(turn(WithoutHole(BoxMesh(6), [](const Point3& p) { return (p - Point3(3, 3, 0)).norm() < 1.2; })), 1,
              1e-9);
  EXPECT_NEAR(turn(SquaresMesh(0, 3, 0, 3, Everywhere)), -1, 1e-9);
  EXPECT_NEAR(turn(Tube(16, 4, 1, 0, 2)), 0, 1e-9);
}

TEST(ReadMeshLoopsTest, FindsContinuousHoles) {
  // Two squares that touch at a corner, and one that does not.
  const auto keep = [](int32_t i, int32_t j) {
    return !(i == 2 && j == 2) && !(i == 3 && j == 3) && !(i == 7 && j == 7);
  };
  const MeshReading read(SquaresMesh(0, 10, 0, 10, keep));
  ASSERT_EQ(read.loops.size(), 4u);
  EXPECT_EQ(CountContinuous(read.loops), 1);
  EXPECT_EQ(std::ranges::count_if(read.loops, &MeshLoop::touches), 2);
}

// A loop as Zhang writes it, from its first named point, by those alone.
std::string NamedWalk(const MeshReading& read, const MeshLoop& loop,
                      const std::map<std::pair<double, double>, std::string>& names) {
  std::vector<std::string> walk;
  for (const RimSegment& s : loop.segments) {
    const Point3& p = read.rim.points[s.from].position;
    if (const auto name = names.find({p.x(), p.y()}); name != names.end()) walk.push_back(name->second);
  }
  if (walk.empty()) return "";
  std::rotate(walk.begin(), std::min_element(walk.begin(), walk.end()), walk.end());
  walk.push_back(walk.front());
  return absl::StrJoin(walk, "-");
}

TEST(ReadMeshLoopsTest, SegmentsTheContinuousHoleOfZhangsFigure2b) {
  // Holes touch the large one at A, B and D, and in it an island at C: the large one goes around the island.
  const TriMesh mesh = PictureMesh({"############",  //
                                    "#.##########",  //
                                    "##.....#####",  //
                                    "##....######",  //
                                    "##...#..####",  //
                                    "##......####",  //
                                    "##......####",  //
                                    "##......####",  //
                                    "#.######.###",  //
                                    "############"});
  const MeshReading read(mesh);
  const std::map<std::pair<double, double>, std::string> names = {
      {{2, 2}, "A"},  {{8, 2}, "B"},  {{6, 6}, "C"},  {{2, 8}, "D"},  {{1, 1}, "P1"},
      {{1, 9}, "P2"}, {{4, 8}, "P3"}, {{5, 6}, "P4"}, {{9, 1}, "P5"}, {{6, 5}, "P6"}};
  std::vector<std::string> walks;
  for (const MeshLoop& loop : read.loops) {
    if (loop.touches) walks.push_back(NamedWalk(read, loop, names));
  }
  EXPECT_THAT(walks, UnorderedElementsAre("A-P1-A", "B-P5-B", "D-P2-D", "A-B-C-P6-P4-C-P3-D-A"));
  EXPECT_EQ(CountContinuous(read.loops), 1);
}

}  // namespace
}  // namespace tilemend
