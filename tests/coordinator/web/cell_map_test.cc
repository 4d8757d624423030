#include "coordinator/web/cell_map.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "absl/time/clock.h"
#include "common/util/error_info.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

Json MapOf(const JobCells& job, const Scene* scene) {
  const auto text = CellMapJson(job, scene);
  EXPECT_TRUE(text.ok()) << text.status();
  return text.ok() ? Json::parse(*text) : Json();
}

TEST(CellMapTest, HasOneLetterForEachSquareFromTheSouthWest) {
  Scene scene;
  scene.grid.cell_size = {250, 200};
  scene.tiles = {{{3, 5}, "a.obj"}, {{4, 5}, ""}, {{3, 6}, "b.obj"}};
  JobCells job;
  job.cells[{3, 5}] = CellProgress::kFilling;
  job.held = {{3, 5}};
  job.failures = {{{3, 6}, Stage::kFill, "no memory"}};
  const Json map = MapOf(job, &scene);
  EXPECT_EQ(map["cells"], "f-. ");
  EXPECT_EQ(map["column"], 3);
  EXPECT_EQ(map["row"], 5);
  EXPECT_EQ(map["columns"], 2);
  EXPECT_EQ(map["rows"], 2);
  EXPECT_EQ(map["cellSize"], Json({250, 200}));
  EXPECT_EQ(map["held"], Json::parse("[[3, 5]]"));
  EXPECT_EQ(map["failures"][0]["reason"], "no memory");
}

TEST(CellMapTest, WithoutASceneItHasTheCellsOfTasks) {
  JobCells job;
  EXPECT_EQ(MapOf(job, nullptr)["cells"], "");
  job.cells[{-1, 0}] = CellProgress::kWritten;
  job.cells[{1, 0}] = CellProgress::kFailed;
  EXPECT_EQ(MapOf(job, nullptr)["cells"], "w x");
  EXPECT_EQ(MapOf(job, nullptr)["column"], -1);
}

TEST(CellMapTest, OfAJobOfAnEarlierProcessAllIsWrittenIfItWasDone) {
  Scene scene;
  scene.tiles = {{{0, 0}, "a.obj"}, {{1, 0}, ""}};
  JobCells job;
  job.state = JobState::kPartial;
  EXPECT_EQ(MapOf(job, &scene)["cells"], "w-");
  job.state = JobState::kCancelled;
  EXPECT_EQ(MapOf(job, &scene)["cells"], ".-");
}

TEST(CellMapTest, RefusesAMapThatIsTooLarge) {
  JobCells job;
  job.cells[{0, 0}] = job.cells[{2'000'000'000, 2'000'000'000}] = CellProgress::kWritten;
  EXPECT_EQ(ErrorReason(CellMapJson(job, nullptr).status()), "TOO_LARGE");
}

TEST(CellMapTest, ReasonsThatAreNoUtf8AreShown) {
  JobCells job;
  job.failures = {{{0, 0}, Stage::kFill, "\xff"}};
  EXPECT_TRUE(CellMapJson(job, nullptr).ok());
}

}  // namespace
}  // namespace tilemend
