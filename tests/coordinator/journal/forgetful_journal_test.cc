#include <gtest/gtest.h>

#include "coordinator/journal/journal.h"

namespace tilemend {
namespace {

TEST(ForgetfulJournalTest, KeepsNothingAndWaitsForNothing) {
  const auto journal = NewForgetfulJournal();
  EXPECT_FALSE(journal->is_durable());
  EXPECT_GE(journal->epoch(), 1U);
  journal->PutJob({.number = 1, .body = "a job"});
  journal->PutResult(1, {{0, 0}, Stage::kSurvey, "input"}, {});
  journal->PutSetAside({"worker", "reason"});
  journal->DropJob(1);
  journal->Await();
  EXPECT_TRUE(journal->TakeSetAside().empty());
  EXPECT_TRUE(journal->TakeJobs().empty());
  EXPECT_FALSE(journal->Find(1, {{0, 0}, Stage::kSurvey, "input"})->has_value());
  EXPECT_TRUE(journal->Outputs(1)->empty());
}

}  // namespace
}  // namespace tilemend
