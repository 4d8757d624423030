#include "coordinator/jobs/preparations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <thread>

#include "common/util/files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class PreparationsTest : public ::testing::Test {
 protected:
  // As if so many coordinators had ended while they prepared the job.
  void SetEnds(const std::string& job, const std::string& count) {
    ASSERT_TRUE(WriteFileAtomically(folder_ / job, count).ok());
  }
  std::string Count(const std::string& job) { return ReadFile(folder_ / job).value_or("none"); }

  const TemporaryFolder folder_;
  Preparations preparations_{folder_.path()};
  std::stop_source stop_;
};

TEST_F(PreparationsTest, CountsWhileItIsPrepared) {
  {
    const auto attempt = preparations_.Begin("a", {});
    ASSERT_TRUE(attempt.ok()) << attempt.status();
    EXPECT_EQ(Count("a"), "1");
  }
  EXPECT_EQ(Count("a"), "none");
}

TEST_F(PreparationsTest, FailsAfterThreeThatDidNotEnd) {
  SetEnds("a", "2");
  EXPECT_TRUE(preparations_.Begin("a", {}).ok());
  SetEnds("a", "3");
  const absl::Status status = preparations_.Begin("a", {}).status();
  EXPECT_TRUE(absl::IsAborted(status));
  EXPECT_THAT(std::string(status.message()), HasSubstr("ended 3 times while it read the scene"));
  EXPECT_EQ(Count("a"), "none");
}

TEST_F(PreparationsTest, ADamagedCountIsNone) {
  SetEnds("a", "many");
  EXPECT_TRUE(preparations_.Begin("a", {}).ok());
}

TEST_F(PreparationsTest, JobsThatWereThereAtAnEndAreOneAfterAnother) {
  SetEnds("a", "1");
  SetEnds("b", "1");
  auto first = std::make_optional(preparations_.Begin("a", {}));
  ASSERT_TRUE((*first).ok());
  EXPECT_TRUE(preparations_.Begin("new", {}).ok());  // does not wait
  absl::Status second;
  std::jthread waiting([&] { second = preparations_.Begin("b", stop_.get_token()).status(); });
  EXPECT_EQ(Count("b"), "1");  // not counted while it waits
  first.reset();
  waiting.join();
  EXPECT_TRUE(second.ok()) << second;
}

TEST_F(PreparationsTest, AStopEndsTheWaiting) {
  SetEnds("a", "1");
  SetEnds("b", "1");
  const auto first = preparations_.Begin("a", {});
  stop_.request_stop();
  EXPECT_TRUE(absl::IsCancelled(preparations_.Begin("b", stop_.get_token()).status()));
}

}  // namespace
}  // namespace tilemend
