#include "coordinator/journal/work_lock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST(WorkLockTest, ASecondOneIsRefusedWithFolderAndProcess) {
  const TemporaryFolder folder;
  const auto first = WorkLock::Take(folder / "work");
  ASSERT_TRUE(first.ok()) << first.status();
  const absl::Status second = WorkLock::Take(folder / "work").status();
  EXPECT_TRUE(absl::IsAborted(second)) << second;
  EXPECT_EQ(ErrorReason(second), "WORK_IN_USE");
  EXPECT_THAT(std::string(second.message()), HasSubstr(folder / "work"));
  EXPECT_THAT(std::string(second.message()), HasSubstr(absl::StrCat("process ", ::getpid(), " ")));
}

TEST(WorkLockTest, EndsWithItsHolder) {
  const TemporaryFolder folder;
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(WorkLock::Take(folder.path()).ok());
}

TEST(WorkLockTest, NamesAFolderThatCannotBe) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("file", "x");
  const absl::Status status = WorkLock::Take(file + "/work").status();
  EXPECT_TRUE(absl::IsPermissionDenied(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr(file));
}

}  // namespace
}  // namespace tilemend
