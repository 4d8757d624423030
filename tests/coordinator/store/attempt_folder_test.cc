#include "coordinator/store/attempt_folder.h"

#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

TEST(AttemptFolderTest, ChecksWhatAWorkerSaysItWrote) {
  const TemporaryFolder folder;
  const auto attempts = AttemptFolder::Make(folder.path());
  ASSERT_TRUE(attempts.ok()) << attempts.status();
  const std::string name(34, 'b');
  const auto check = [&](const std::string& attempt, int64_t bytes) {
    return AttemptFolder::Check(attempts->path(), {attempt, "tiles/a.ply", bytes});
  };
  EXPECT_TRUE(absl::IsDataLoss(check(name, 4)));
  folder.Write(absl::StrCat(".tilemend-attempts/", name), "tile");
  EXPECT_TRUE(check(name, 4).ok());
  EXPECT_TRUE(absl::IsDataLoss(check(name, 5)));
  EXPECT_TRUE(absl::IsInvalidArgument(check("../" + name, 4)));
  attempts->Remove();
  EXPECT_TRUE(absl::IsUnavailable(check(name, 4))) << "this machine does not see the folder";
}

}  // namespace
}  // namespace tilemend
