// What a dry run of a scene says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/options/job_options.h"
#include "common/util/files.h"
#include "coordinator/jobs/scene_pipeline.h"
#include "tests/support/output_checks.h"
#include "tests/support/temporary_folder.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class DryRunTest : public ::testing::Test {
 protected:
  absl::StatusOr<JobOutcome> Run() {
    spec_.set_dry_run(true);
    auto pipeline = ScenePipelineFactory()(spec_, {});
    if (!pipeline.ok()) return pipeline.status();
    auto first = (*pipeline)->Start();
    if (!first.ok()) return first.status();
    std::deque<NewTask> open(first->begin(), first->end());
    for (; !open.empty(); open.pop_front()) {
      const NewTask& task = open.front();
      auto next = (*pipeline)->OnTaskDone(
          {task.cell, task.stage, SceneStageRunner()(task.stage, WholeInput(task).value(), CancelToken())});
      if (!next.ok()) return next.status();
      for (NewTask& t : *next) open.push_back(std::move(t));
    }
    return (*pipeline)->Finish();
  }

  const TemporaryFolder folder_;
  JobSpec spec_ = WithDefaults({});
};

TEST_F(DryRunTest, ADryRunSaysWhatStaysOpenAndWarns) {
  SceneMakerOptions options = SmallScene(Cut::kClipped);
  options.ellipses = {{{30, 0}, {6, 4}}, {{70, 50}, {2, 3}}};  // one at the rim
  spec_.set_scene(WriteMade(options, folder_ / "rim"));
  const auto known = Run();
  ASSERT_TRUE(known.ok()) << known.status();
  EXPECT_THAT(known->message, HasSubstr("2 to fill (filling may find some that stay open), 0 that stay open"));
  EXPECT_THAT(known->warnings, testing::IsEmpty());
  std::filesystem::remove(spec_.scene() + "/scene.json");
  const auto unknown = Run();
  ASSERT_TRUE(unknown.ok()) << unknown.status();
  EXPECT_THAT(unknown->message, HasSubstr("1 to fill (filling may find some that stay open), 1 that stays open"));
  EXPECT_THAT(unknown->warnings, testing::Contains(HasSubstr("the area is not known")));
}

TEST_F(DryRunTest, ADryRunSaysWhichHolesAreChosen) {
  spec_.set_scene(WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"));
  spec_.set_cells("1,1");
  EXPECT_THAT(Run()->message, HasSubstr("1 of 8 holes is in the 1 of 12 cells that was chosen"));
}

TEST_F(DryRunTest, ALevelFarFromAllSurfaceIsRefused) {
  spec_.set_scene(WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"));
  spec_.set_water(folder_.Write("water.geojson",
                                R"({"type": "Feature", "properties": {"level_m": 99999}, "geometry": {"type": "Polygon",
                           "coordinates": [[[10, 10], [90, 10], [90, 90], [10, 90], [10, 10]]]}})"));
  const absl::Status refused = Run().status();
  EXPECT_TRUE(absl::IsInvalidArgument(refused)) << refused;
  EXPECT_THAT(std::string(refused.message()), HasSubstr("m above all surface of the scene"));
}

TEST_F(DryRunTest, WarningsOfADryRunAreCounted) {
  spec_.set_scene(WriteMade(SmallScene(Cut::kClipped), folder_ / "scene"));
  std::string fields;
  for (int k = 10; k < 35; ++k) absl::StrAppend(&fields, "\"area_kno", k, "\": 1, ");
  const std::string path = spec_.scene() + "/scene.json";
  std::string json = ReadFile(path).value();
  json.insert(json.find('{') + 1, fields);
  ASSERT_TRUE(WriteFileAtomically(path, json, Sync::kNo).ok());
  const auto outcome = Run();
  ASSERT_TRUE(outcome.ok()) << outcome.status();
  ASSERT_EQ(outcome->warnings.size(), 21U);
  EXPECT_EQ(outcome->warnings.back(), "and 5 more; tilemend inspect prints all");
}

}  // namespace
}  // namespace tilemend
