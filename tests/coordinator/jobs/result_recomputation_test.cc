#include "coordinator/jobs/result_recomputation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/rpc/result_digest.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "tests/coordinator/store/notes_in_memory.h"
#include "tilemend/v1/verify.pb.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ResultRecomputationTest : public ::testing::Test {
 protected:
  static NewTask Fill(int32_t col = 0) { return {{col, 0}, Stage::kFill, absl::StrCat("holes ", col), {}}; }
  // "first" gives a result.
  static void Give(ResultRecomputation& all, const std::string& output, NewTask task = Fill()) {
    ASSERT_TRUE(all.AddTask(task).ok());
    all.AddResult({task.cell, task.stage, output, "first", Sha256Hex(task.input)});
  }
  // The verification of `task` by a worker that comes to `output`.
  static auto Verify(ResultRecomputation& all, const NewTask& task, const std::string& worker,
                     const std::string& output) {
    v1::VerifyOutput verified;
    verified.add_files()->set_digest(ResultDigest(Stage::kFill, output));
    const TaskResult result{task.cell, task.stage, verified.SerializeAsString(), worker, Sha256Hex(task.input)};
    EXPECT_TRUE(all.IsOut(result));
    return all.Take(result);
  }
  static NewTask Next(ResultRecomputation& all) { return all.Next().value().value(); }
  // "first" and "second" give different results, "third" gives `output`.
  absl::StatusOr<std::optional<CaughtWorker>> Third(const std::string& worker, const std::string& output) {
    Give(all_, "lie");
    EXPECT_EQ(Verify(all_, Next(all_), "second", "truth").value(), std::nullopt);
    EXPECT_FALSE(all_.is_over());
    const NewTask task = Next(all_);
    EXPECT_THAT(task.avoid, ElementsAre("first", "second"));
    auto caught = Verify(all_, task, worker, output);
    EXPECT_TRUE(all_.is_over());
    return caught;
  }

  const std::shared_ptr<ScratchFile> scratch_ = ScratchFile::Create("").value();
  ResultRecomputation all_{1, scratch_};
};

TEST_F(ResultRecomputationTest, AnotherWorkerComputesTheSameTask) {
  Give(all_, "truth");
  EXPECT_FALSE(all_.is_over());
  const NewTask task = Next(all_);
  EXPECT_EQ(task.stage, Stage::kVerify);
  EXPECT_THAT(task.avoid, ElementsAre("first"));
  v1::VerifyInput input;
  ASSERT_TRUE(input.ParseFromString(task.input));
  EXPECT_EQ(input.tasks(0).stage(), v1::FILL);
  EXPECT_EQ(input.tasks(0).input(), "holes 0");
  EXPECT_EQ(Verify(all_, task, "second", "truth").value(), std::nullopt);
  EXPECT_TRUE(all_.is_over());
}

TEST_F(ResultRecomputationTest, TheOneThatDiffersFromTwoOthersIsCaught) {
  EXPECT_EQ(Third("third", "truth").value()->worker, "first");
  EXPECT_EQ(Third("third", "lie").value()->worker, "second");
}

TEST_F(ResultRecomputationTest, WithoutAThirdWorkerNobodyCanTell) {
  for (const std::string third : {"first", "second"}) {
    const absl::Status status = Third(third, "truth").status();
    EXPECT_EQ(ErrorReason(status), "RESULTS_DIFFER");
    EXPECT_THAT(std::string(status.message()), HasSubstr("workers first and second"));
  }
  EXPECT_EQ(ErrorReason(Third("third", "neither").status()), "RESULTS_DIFFER");
}

TEST_F(ResultRecomputationTest, WhatNoOtherWorkerCouldComputeCountsAsItIs) {
  Give(all_, "truth");
  const NewTask task = Next(all_);
  const TaskResult failed{task.cell, task.stage, absl::InternalError("no"), "", Sha256Hex(task.input)};
  EXPECT_EQ(all_.Take(failed).value(), std::nullopt);
  EXPECT_TRUE(all_.is_over());
  Give(all_, "lie");
  ASSERT_TRUE(Verify(all_, Next(all_), "second", "truth").ok());
  const NewTask third = Next(all_);
  EXPECT_EQ(ErrorReason(all_.Take({third.cell, third.stage, failed.output, "", Sha256Hex(third.input)}).status()),
            "RESULTS_DIFFER");
}

TEST_F(ResultRecomputationTest, FailedTasksTilesAndResultsOfNobodyAreNotComputedAgain) {
  const NewTask fill = Fill(), tile{{0, 0}, Stage::kAssemble, "patches", {}};
  ASSERT_TRUE(all_.AddTask(fill).ok());
  all_.AddResult({fill.cell, fill.stage, absl::InternalError("failed"), "first", Sha256Hex(fill.input)});
  Give(all_, "tile", tile);
  ASSERT_TRUE(all_.AddTask(fill).ok());
  all_.AddResult({fill.cell, fill.stage, "truth", "", Sha256Hex(fill.input)});
  EXPECT_TRUE(all_.is_over());
}

TEST_F(ResultRecomputationTest, AShareIsComputedAgain) {
  ResultRecomputation none(0, scratch_), some(0.2, scratch_);
  int tasks = 0;
  for (int i = 0; i < 1000; ++i) {
    Give(none, "truth", Fill(i));
    Give(some, "truth", Fill(i));
    tasks += some.Next().value().has_value() ? 1 : 0;
  }
  EXPECT_TRUE(none.is_over());
  EXPECT_NEAR(tasks, 200, 80);
}

TEST(ResultDigestTest, LeavesOutWhenASurveyWasMade) {
  v1::SurveyOutput survey;
  survey.set_vertex_count(7);
  const std::string digest = ResultDigest(Stage::kSurvey, survey.SerializeAsString());
  survey.set_stamp("now");
  EXPECT_EQ(ResultDigest(Stage::kSurvey, survey.SerializeAsString()), digest);
  survey.mutable_files()->add_images("a.png");
  EXPECT_NE(ResultDigest(Stage::kSurvey, survey.SerializeAsString()), digest);
}

TEST_F(ResultRecomputationTest, WhatWasComputedAgainBeforeIsNotOnceMore) {
  const auto notes = std::make_shared<NotesInMemory>();
  const auto another = [&](const std::string& output) {
    ResultRecomputation process(1, scratch_);
    process.UseNotes(notes, 1);
    Give(process, output);
    return !process.is_over();
  };
  all_.UseNotes(notes, 1);
  Give(all_, "truth");
  EXPECT_TRUE(another("truth")) << "not yet";
  EXPECT_EQ(Verify(all_, Next(all_), "second", "truth").value(), std::nullopt);
  EXPECT_FALSE(another("truth"));
  EXPECT_TRUE(another("lie"));
}

TEST_F(ResultRecomputationTest, TheSameKeyChoosesTheSameTasks) {
  const auto chosen = [&](uint64_t key) {
    ResultRecomputation some(0.5, scratch_);
    some.UseNotes(std::make_shared<NotesInMemory>(), key);
    std::vector<bool> is_chosen;
    for (int32_t col = 0; col < 100; ++col) {
      Give(some, "truth", Fill(col));
      is_chosen.push_back(some.Next().value().has_value());
    }
    return is_chosen;
  };
  EXPECT_EQ(chosen(1), chosen(1));
  EXPECT_NE(chosen(1), chosen(2));
}

}  // namespace
}  // namespace tilemend
