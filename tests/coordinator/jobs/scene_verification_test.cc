#include "coordinator/jobs/scene_verification.h"

#include <gtest/gtest.h>

#include <utility>

#include "absl/time/clock.h"
#include "common/store/digest.h"
#include "common/store/tile_stamp.h"
#include "common/util/error_info.h"
#include "tests/coordinator/store/notes_in_memory.h"
#include "tests/support/temporary_folder.h"
#include "tilemend/v1/verify.pb.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

class SceneVerificationTest : public ::testing::Test {
 protected:
  SceneVerification Make(const std::string& output) { return {{1, 1}, output, ScratchFile::Create("").value()}; }
  // "surveyor" gives a survey of the tile of cell 0, 0 with this digest.
  void AddSurvey(SceneVerification& verification, const std::string& digest) {
    const NewTask task{{0, 0}, Stage::kSurvey, "the tile", {}};
    ASSERT_TRUE(verification.AddTask(task).ok());
    v1::SurveyOutput survey;
    survey.set_digest(digest);
    const TaskResult result{task.cell, task.stage, survey.SerializeAsString(), "surveyor", Sha256Hex(task.input)};
    verification.AddResult(result);
    SceneVerification::Report report = SceneVerification::ReportOf(result);
    report.tile.set_root(folder_.path());
    report.tile.set_path("a.ply");
    report.tile.set_digest(digest);
    report.stamp = StampOfTile(tile_, absl::Now() + absl::Minutes(1));
    verification.AddReport(std::move(report), folder_.path());
  }

  const TemporaryFolder folder_;
  const std::string tile_ = folder_.Write("a.ply", "tile");
};

TEST_F(SceneVerificationTest, WithoutAnOutputNothingIsVerified) {
  SceneVerification verification = Make("");
  AddSurvey(verification, FileDigest("tile"));
  EXPECT_TRUE(verification.is_over());
  EXPECT_FALSE(verification.Next(true).value().has_value());
  EXPECT_FALSE(verification.is_wanted());
}

TEST_F(SceneVerificationTest, ResultsAreComputedAgainAndTilesAreRead) {
  SceneVerification verification = Make(folder_.path());
  AddSurvey(verification, FileDigest("other"));
  EXPECT_TRUE(verification.is_wanted());
  const NewTask again = verification.Next(false).value().value(), read = verification.Next(true).value().value();
  EXPECT_FALSE(verification.Next(true).value().has_value());
  v1::VerifyInput input;
  ASSERT_TRUE(input.ParseFromString(again.input));
  EXPECT_EQ(input.tasks_size(), 1);
  ASSERT_TRUE(input.ParseFromString(read.input));
  EXPECT_EQ(input.tiles_size(), 1);
  EXPECT_TRUE(verification.Take({again.cell, again.stage, absl::InternalError("no"), "", Sha256Hex(again.input)}).ok());
  EXPECT_FALSE(verification.caught());
  EXPECT_TRUE(verification
                  .Take({read.cell, read.stage, SceneStageRunner()(read.stage, read.input, CancelToken()), "verifier",
                         Sha256Hex(read.input)})
                  .ok());
  EXPECT_EQ(verification.caught()->worker, "surveyor");
  EXPECT_TRUE(verification.is_over());
}

TEST_F(SceneVerificationTest, ATileThatSeemsToHaveChangedMayHaveBeenReportedWrongly) {
  SceneVerification verification = Make(folder_.path());
  AddSurvey(verification, FileDigest("other"));
  const auto fail = [&](CellId cell, const absl::Status& error) {
    verification.AddResult({cell, Stage::kFill, error, "honest"});
    return verification.caught().has_value();
  };
  EXPECT_FALSE(fail({0, 0}, absl::InternalError("no")));
  EXPECT_FALSE(fail({0, 0}, WithErrorInfo(absl::AbortedError("no"), {"QUARANTINED", {}})));
  EXPECT_FALSE(fail({2, 0}, absl::AbortedError("it changed")));
  EXPECT_TRUE(fail({1, 0}, absl::AbortedError("it changed")));
  EXPECT_EQ(verification.caught()->worker, "surveyor");
}

TEST_F(SceneVerificationTest, AllProcessesOfAJobHaveOneKey) {
  const auto notes = std::make_shared<NotesInMemory>();
  SceneVerification first = Make(folder_.path());
  first.UseNotes(notes);
  const std::string key = notes->Find("key of the shares").value();
  SceneVerification second = Make(folder_.path());
  second.UseNotes(notes);
  EXPECT_EQ(notes->Find("key of the shares"), key);
  const auto others = std::make_shared<NotesInMemory>();
  second.UseNotes(others);
  EXPECT_NE(others->Find("key of the shares"), key);
}

}  // namespace
}  // namespace tilemend
