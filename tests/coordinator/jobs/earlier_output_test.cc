#include "coordinator/jobs/earlier_output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "common/util/error_info.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class EarlierOutputTest : public ::testing::Test {
 protected:
  EarlierOutputTest() {
    spec_.set_out(folder_ / "out");
    spec_.set_decisions("/marks.geojson");
  }
  void WriteReport(const std::string& key) {
    folder_.Write("out/report.json",
                  R"({"version": "1", "per_hole": [{"key": "no"}], "options": {"key": "no"}, "key": ")" + key + "\"}");
  }

  const TemporaryFolder folder_;
  JobSpec spec_;
};

TEST_F(EarlierOutputTest, DecisionsReplaceFilesOfTheSameJob) {
  WriteReport(OutputKey("scene"));
  EXPECT_EQ(*MayReplace(spec_, OutputKey("scene")), true);
}

TEST_F(EarlierOutputTest, DecisionsOnAnotherOutputAreRefused) {
  for (const char* key : {"", "other"}) {
    WriteReport(key);
    const absl::Status status = MayReplace(spec_, OutputKey("scene")).status();
    EXPECT_TRUE(absl::IsAlreadyExists(status)) << status;
    EXPECT_EQ(ErrorReason(status), "OUTPUT_EXISTS");
    EXPECT_THAT(std::string(status.message()), HasSubstr("another scene or other options"));
  }
  folder_.Write("out/report.json", "[3");
  EXPECT_TRUE(absl::IsAlreadyExists(MayReplace(spec_, OutputKey("scene")).status()));
  spec_.set_overwrite(true);
  EXPECT_EQ(*MayReplace(spec_, OutputKey("scene")), true);
}

TEST_F(EarlierOutputTest, WithoutDecisionsOrWithoutAReportNothingIsReplaced) {
  EXPECT_EQ(*MayReplace(spec_, OutputKey("scene")), false);
  WriteReport(OutputKey("scene"));
  spec_.clear_decisions();
  EXPECT_EQ(*MayReplace(spec_, OutputKey("scene")), false);
}

// A hole and its decision count, not the polygons: one may be drawn over several holes.
TEST_F(EarlierOutputTest, SaysOnWhichHolesDecisionsAreUndone) {
  Scene scene;
  scene.tiles = {{{0, 0}, "a.ply"}};
  spec_.set_overwrite(true);
  const auto job = [&] { return OnOutput(spec_, {}, "", scene).value(); };
  const std::string key = job().key;
  EXPECT_THAT(job().decided_before, IsEmpty());
  const auto write = [&](const std::string& of_key) {
    folder_.Write("out/report.json", R"({"per_hole": [{"id": 3, "decision": "open"}, {"id": 4, "decision": "water"},
                                        {"id": 5}], "key": ")" +
                                         of_key + "\"}");
  };
  write("other");
  EXPECT_THAT(job().decided_before, IsEmpty());
  write(key);
  EXPECT_THAT(job().decided_before, ElementsAre(3, 4));
  std::map<int32_t, int32_t> decisions = {{3, 0}, {4, 0}, {5, 0}};
  EXPECT_EQ(UndoneDecisions(job(), decisions), "");
  decisions.erase(4);
  EXPECT_EQ(UndoneDecisions(job(), decisions),
            "/marks.geojson: the decisions of the last run on 1 hole are undone, as the file has none on it: hole 4");
  decisions.clear();
  EXPECT_EQ(UndoneDecisions(job(), decisions),
            "/marks.geojson: the decisions of the last run on 2 holes are undone, as the file has none on them: holes "
            "3, 4");
  spec_.clear_decisions();
  EXPECT_THAT(job().decided_before, IsEmpty());
}

}  // namespace
}  // namespace tilemend
