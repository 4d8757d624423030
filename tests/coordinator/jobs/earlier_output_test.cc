#include "coordinator/jobs/earlier_output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "common/util/error_info.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

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

TEST_F(EarlierOutputTest, SaysHowManyDecisionsAFileWithFewerUndoes) {
  const auto warnings = [&](std::vector<WaterArea> areas) {
    WaterChoice water;
    water.options.areas = std::move(areas);
    WarnOfUndoneDecisions(spec_, water);
    return water.warnings;
  };
  EXPECT_THAT(warnings({}), IsEmpty());
  folder_.Write("out/report.json", R"({"per_hole": [{"decision": "open"}, {"decision": "water"}, {}]})");
  EXPECT_THAT(warnings({}), ElementsAre("/marks.geojson: the decisions of the last run on 2 holes are undone"));
  WaterArea polygon;
  EXPECT_THAT(warnings({polygon}), SizeIs(1));
  polygon.decision = ReviewDecision::kAccept;
  EXPECT_THAT(warnings({polygon}),
              ElementsAre("/marks.geojson: it has 1 decision, and the last run had some on 2 holes; those that are not "
                          "in the file are undone"));
  EXPECT_THAT(warnings({polygon, polygon}), IsEmpty());
  spec_.clear_decisions();
  EXPECT_THAT(warnings({}), IsEmpty());
}

}  // namespace
}  // namespace tilemend
