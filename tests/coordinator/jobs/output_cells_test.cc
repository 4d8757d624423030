#include "coordinator/jobs/output_cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "common/options/job_options.h"
#include "common/util/error_info.h"
#include "coordinator/report/scene_report.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using FileDigests = std::map<std::string, std::string>;

JobIdentity IdentityWith(const JobSpec& spec, const FileDigests& files) {
  JobIdentity identity = IdentityOf(spec);
  for (const auto& [option, digest] : files) AddFileDigest(option, digest, identity);
  return identity;
}

TEST(JobKeyTest, TellsApartWhatGivesOtherBytes) {
  std::set<std::string> keys;
  const auto add = [&](auto change) {
    JobSpec spec = WithDefaults({});
    FileDigests files;
    change(spec, files);
    EXPECT_TRUE(keys.insert(JobKey(IdentityWith(spec, files))).second);
  };
  add([](JobSpec&, auto&) {});
  add([](JobSpec& spec, auto&) { spec.set_gradation(std::nextafter(spec.gradation(), 2)); });
  add([](JobSpec& spec, auto&) { spec.set_tension(0); });
  add([](JobSpec& spec, auto&) { spec.set_surface("wang"); });
  add([](JobSpec& spec, auto&) {
    spec.set_surface("wang");
    spec.set_closure("line");
  });
  add([](JobSpec& spec, auto&) { spec.set_cells("1,1"); });
  add([](JobSpec&, auto& files) { files["water"] = "other content"; });
  add([](JobSpec&, auto& files) { files["area"] = "other content"; });
}

TEST(JobKeyTest, ForgetsWhereToAndWhetherToOverwrite) {
  JobSpec a = WithDefaults({}), b = a;
  a.set_out("/a");
  b.set_overwrite(true);
  EXPECT_EQ(JobKey(IdentityOf(a)), JobKey(IdentityWith(b, {{"water", ""}})));
}

TEST(JobKeyTest, IsReadBack) {
  const JobIdentity identity = IdentityWith(WithDefaults({}), {{"clear", "abc"}});
  EXPECT_EQ(IdentityOfKey(JobKey(identity)), identity);
  EXPECT_EQ(FileDigestsOf(identity), (FileDigests{{"clear", "abc"}}));
}

// A scene of 3 x 2 cells, and a folder for its output.
class OutputCellsTest : public ::testing::Test {
 protected:
  OutputCellsTest() {
    for (int32_t row = 0; row < 2; ++row) {
      for (int32_t col = 0; col < 3; ++col) scene_.tiles.push_back({{col, row}, "a.ply"});
    }
  }
  JobSpec Spec(const std::string& cells) {
    JobSpec spec;
    spec.set_scene("/data/city");
    spec.set_out(folder_ / "out");
    spec.set_cells(cells);
    return WithDefaults(spec);
  }
  // The output that a job has left.
  void Complete(const JobSpec& spec, const FileDigests& files = {}) {
    const Plan plan;
    SceneReportInput input;
    input.plan = &plan;
    input.scene = spec.scene();
    input.options = ReportedOptions(spec, kOfJobs);
    input.files = files;
    folder_.Write("out/report.json", SceneReport(input));
  }
  void Unfinished(const JobSpec& spec) { folder_.Write("out/.tilemend-job", JobKey(IdentityOf(spec))); }
  absl::StatusOr<OutputCells> Look(const JobSpec& spec, const FileDigests& files = {}) {
    return CellsWithOutput(spec, IdentityWith(spec, files), scene_);
  }
  // What is said of a job that is refused, before it starts and when it does.
  std::string Refusal(const JobSpec& spec, bool early = true, const FileDigests& files = {}) {
    const absl::Status status = Look(spec, files).status();
    EXPECT_TRUE(absl::IsAlreadyExists(status)) << status;
    EXPECT_EQ(ErrorReason(status), "OUTPUT_EXISTS");
    EXPECT_EQ(CheckOutputTakes(spec).ok(), !early);
    return std::string(status.message());
  }
  void ExpectAdds(const JobSpec& spec, const std::string& cells) {
    const auto found = Look(spec);
    ASSERT_TRUE(found.ok()) << found.status();
    EXPECT_TRUE(found->adds);
    EXPECT_EQ(found->cells, cells);
    EXPECT_TRUE(CheckOutputTakes(spec).ok());
  }
  void ExpectAlone(const JobSpec& spec) {
    const auto found = Look(spec);
    ASSERT_TRUE(found.ok()) << found.status();
    EXPECT_FALSE(found->adds);
    EXPECT_EQ(found->cells, spec.cells());
    EXPECT_TRUE(CheckOutputTakes(spec).ok());
  }

  const TemporaryFolder folder_;
  Scene scene_;
};

TEST_F(OutputCellsTest, WithoutAnOutputThereIsNothingToAddTo) {
  ExpectAlone(Spec("0,0"));
  folder_.Write("out/notes.txt", "mine");
  ExpectAlone(Spec(""));
}

TEST_F(OutputCellsTest, OtherCellsAreAddedToACompleteOutput) {
  Complete(Spec("0,0"));
  ExpectAdds(Spec("1,0-2,1"), "0,0 1,0-2,1");
  ExpectAdds(Spec("0,0-1,0"), "0,0 0,0-1,0");
  ExpectAdds(Spec(""), "");
}

TEST_F(OutputCellsTest, CellsThatAreThereAreRefused) {
  Complete(Spec("0,0-1,1"));
  EXPECT_THAT(Refusal(Spec("0,0-1,1")), HasSubstr("complete"));
  EXPECT_THAT(Refusal(Spec("1,1"), false), HasSubstr("complete"));
  Complete(Spec("0,0-2,0 0,1-2,1"));
  EXPECT_THAT(Refusal(Spec(""), false), HasSubstr("complete"));
  Complete(Spec(""));
  EXPECT_THAT(Refusal(Spec("1,1")), HasSubstr("complete"));
  EXPECT_THAT(Refusal(Spec("")), HasSubstr("complete"));
}

TEST_F(OutputCellsTest, OtherOptionsAreNamed) {
  Complete(Spec("0,0"), {{"water", "abc"}});
  JobSpec spec = Spec("1,0");
  spec.set_gradation(1.5);
  EXPECT_THAT(Refusal(spec), HasSubstr("differs in --gradation"));
  spec = Spec("1,0");
  spec.set_scene("/data/town");
  EXPECT_THAT(Refusal(spec), HasSubstr("differs in the scene"));
  EXPECT_THAT(Refusal(Spec("1,0"), false, {{"water", "abd"}}), HasSubstr("differs in --water file;"));
  EXPECT_THAT(Refusal(Spec("1,0"), false), HasSubstr("differs in --water file;"));
}

TEST_F(OutputCellsTest, OneSceneMayHaveSeveralPaths) {
  folder_.Write("city/scene.json", "{}");
  std::filesystem::create_directory_symlink(folder_ / "city", folder_ / "link");
  JobSpec spec = Spec("0,0");
  spec.set_scene(folder_ / "city");
  Complete(spec);
  const std::string key = JobKey(IdentityOf(spec));
  for (const char* path : {"city/scene.json", "link", "link/scene.json", "city/"}) {
    spec = Spec("1,0");
    spec.set_scene(folder_ / path);
    ExpectAdds(spec, "0,0 1,0");
    spec.set_cells("0,0");
    EXPECT_EQ(JobKey(IdentityOf(spec)), key) << path;
  }
  folder_.Write("city/other.json", "{}");
  spec.set_scene(folder_ / "city/other.json");
  EXPECT_THAT(Refusal(spec), HasSubstr("differs in the scene"));
}

TEST_F(OutputCellsTest, AJobThatWasKilledGoesOnOrGetsCells) {
  Unfinished(Spec("0,0"));
  ExpectAlone(Spec("0,0"));
  ExpectAdds(Spec("1,0"), "0,0 1,0");
  // As the kill of an addition leaves it.
  Unfinished(Spec("0,0 1,0"));
  ExpectAdds(Spec("1,0"), "0,0 1,0");
  JobSpec spec = Spec("1,0");
  spec.set_uniform(true);
  EXPECT_THAT(Refusal(spec, false), HasSubstr("an unfinished output of a job that differs in --uniform"));
}

TEST_F(OutputCellsTest, CellsWithoutTheDecisionsOfAnOutputAreNotAddedToIt) {
  Complete(Spec("0,0"), {{"decisions", "abc"}});
  EXPECT_THAT(Refusal(Spec("1,0"), false), HasSubstr("differs in --decisions file;"));
  JobSpec spec = Spec("1,0");
  spec.set_decisions("/marks.geojson");
  ExpectAlone(spec);
}

TEST_F(OutputCellsTest, DryRunsTakeTheFolderAsItIs) {
  Complete(Spec(""));
  JobSpec dry = Spec("1,0");
  dry.set_dry_run(true);
  ExpectAlone(dry);
}

// The report keeps the cells that are not done again.
TEST_F(OutputCellsTest, CellsThatAreDoneAgainAreThoseOfTheOutput) {
  JobSpec over = Spec("1,0"), decide = Spec("1,0");
  over.set_overwrite(true);
  decide.set_decisions("/marks.geojson");
  for (const JobSpec& spec : {over, decide}) {
    for (const std::string before : {"", "0,0-1,1"}) {
      Complete(Spec(before), {{"decisions", spec.decisions().empty() ? "" : "abc"}});
      const auto found = Look(spec);
      ASSERT_TRUE(found.ok()) << found.status();
      EXPECT_FALSE(found->adds);
      EXPECT_EQ(found->cells, before);
    }
    Complete(Spec("0,0"));
    ExpectAlone(spec);
    Unfinished(Spec(""));
    ExpectAlone(spec);
    std::filesystem::remove(folder_ / "out/.tilemend-job");
  }
  Complete(Spec(""));
  over.set_gradation(1.5);
  ExpectAlone(over);
}

TEST_F(OutputCellsTest, AFileThatIsNoReportIsNotAddedTo) {
  folder_.Write("out/report.json", "[1, 2]");
  EXPECT_THAT(Refusal(Spec("")), HasSubstr("exists already;"));
}

}  // namespace
}  // namespace tilemend
