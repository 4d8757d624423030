#include "common/util/job_log_tail.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "tests/support/list_log.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

TEST(JobLogTailTest, KeepsTheLinesOfEachJobAndPassesAllOn) {
  ListLog log;
  JobLogTail tail(log, [] { return absl::UnixEpoch(); });
  tail.Warn("attempt lost", {{"job", "a"}, {"worker", "w"}});
  tail.Info("starting");
  tail.Info("job created", {{"job", "b"}});
  EXPECT_THAT(log.lines(), SizeIs(3));
  EXPECT_THAT(tail.LinesOf("a"), ElementsAre("1970-01-01T00:00:00.000Z warning attempt lost job=a worker=w"));
  EXPECT_THAT(tail.LinesOf("b"), SizeIs(1));
  EXPECT_THAT(tail.LinesOf("c"), SizeIs(0));
}

TEST(JobLogTailTest, IsBounded) {
  JobLogTail tail(*Log::Null());
  for (size_t k = 0; k <= JobLogTail::kMostLines; ++k) tail.Info(absl::StrCat("line ", k), {{"job", "a"}});
  EXPECT_THAT(tail.LinesOf("a"), SizeIs(JobLogTail::kMostLines));
  EXPECT_THAT(tail.LinesOf("a").front(), ::testing::HasSubstr("line 1"));
  for (size_t k = 0; k < JobLogTail::kMostJobs; ++k) tail.Info("x", {{"job", absl::StrCat("job", k)}});
  EXPECT_THAT(tail.LinesOf("a"), SizeIs(0));
  EXPECT_THAT(tail.LinesOf("job0"), SizeIs(1));
}

}  // namespace
}  // namespace tilemend
