#include "coordinator/web/cell_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/util/error_info.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

Json MapOf(const JobCells& job, const Scene* scene) {
  std::optional<SceneSight> sight;
  if (scene != nullptr) sight.emplace(*scene);
  const auto text = CellMapJson(job, sight ? &*sight : nullptr);
  EXPECT_TRUE(text.ok()) << text.status();
  return text.ok() ? Json::parse(*text) : Json();
}

TEST(CellMapTest, HasOneLetterForEachSquareFromTheSouthWest) {
  Scene scene;
  scene.grid.cell_size = {250, 200};
  scene.tiles = {{{3, 5}, "a.obj"}, {{4, 5}, ""}, {{3, 6}, "b.obj"}};
  JobCells job;
  job.cells.Set({3, 5}, 'f');
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
  job.cells.Set({-1, 0}, 'w');
  job.cells.Set({1, 0}, 'x');
  EXPECT_EQ(MapOf(job, nullptr)["cells"], "w x");
  EXPECT_EQ(MapOf(job, nullptr)["column"], -1);
}

TEST(CellMapTest, OfAJobOfAnEarlierProcessAllIsWrittenIfItWasDone) {
  Scene scene;
  scene.tiles = {{{0, 0}, "a.obj"}, {{1, 0}, ""}};
  JobCells job;
  job.state = JobState::kPartial;
  EXPECT_EQ(MapOf(job, &scene)["cells"], "w-");
  EXPECT_EQ(MapOf(job, &scene)["isRemembered"], false);
  job.state = JobState::kDone;
  EXPECT_EQ(MapOf(job, &scene)["cells"], "w-");
  EXPECT_EQ(MapOf(job, &scene)["isRemembered"], true);
  job.state = JobState::kCancelled;
  EXPECT_EQ(MapOf(job, &scene)["cells"], "?-");
  EXPECT_EQ(MapOf(job, &scene)["isRemembered"], false);
  job.cells.Set({2, 0}, 'w');
  scene.tiles.push_back({{2, 0}, "c.obj"});
  EXPECT_EQ(MapOf(job, &scene)["cells"], ".-w");  // of this process
  EXPECT_EQ(MapOf(job, &scene)["isRemembered"], true);
}

TEST(CellMapTest, RefusesAMapThatIsTooLarge) {
  JobCells job;
  job.cells.Set({0, 0}, 'w');
  job.cells.Set({2'000'000'000, 2'000'000'000}, 'w');
  EXPECT_EQ(ErrorReason(CellMapJson(job, nullptr).status()), "TOO_LARGE");
}

TEST(CellMapTest, HasAMillionCells) {
  Scene scene;
  for (int32_t row = 0; row < 1000; ++row) {
    for (int32_t col = 0; col < 1000; ++col) scene.tiles.push_back({{col, row}, "a.obj"});
  }
  const SceneSight sight(scene);
  JobCells job;
  for (int32_t k = 0; k < 500'000; ++k) job.cells.Set({k % 1000, k / 1000}, 'F');
  std::vector<absl::Duration> took;
  for (int k = 0; k < 21; ++k) {
    const absl::Time begin = absl::Now();
    const JobCells copy = job;  // as each request takes one
    EXPECT_GT(CellMapJson(copy, &sight)->size(), 1'000'000U);
    took.push_back(absl::Now() - begin);
  }
  std::ranges::sort(took);
  RecordProperty("median_ms", absl::StrCat(absl::ToInt64Milliseconds(took[10])));
}

TEST(CellMapTest, ReasonsThatAreNoUtf8AreShown) {
  JobCells job;
  job.failures = {{{0, 0}, Stage::kFill, "\xff"}};
  EXPECT_TRUE(CellMapJson(job, nullptr).ok());
}

}  // namespace
}  // namespace tilemend
