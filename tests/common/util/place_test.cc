#include "common/util/place.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>

#include "common/util/roots.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::EndsWith;
using ::testing::StartsWith;

TEST(PlaceTest, IsThePathItselfWhereNothingIsConfined) {
  const Place place("/not/there");
  EXPECT_TRUE(place.ok());
  EXPECT_EQ(place.at(), AT_FDCWD);
  EXPECT_EQ(place.name, "/not/there");
}

TEST(PlaceTest, IsAnOpenFolderAndANameBelowTheRoots) {
  const TemporaryFolder folder;
  KeepFilesTo(*Roots::Open({folder.path()}));
  const Place inside(folder / "x/../name"), below(folder / "name"), outside("/etc/passwd");
  KeepFilesTo(nullptr);
  EXPECT_FALSE(inside.ok());
  EXPECT_TRUE(below.ok());
  EXPECT_GE(below.at(), 0);
  EXPECT_EQ(below.name, "name");
  EXPECT_FALSE(outside.ok());
  EXPECT_EQ(outside.error, EXDEV);
}

TEST(ErrnoStatusTest, NamesThePathAndTellsReadingFromWriting) {
  EXPECT_TRUE(absl::IsNotFound(ErrnoStatus(ENOENT, "cannot open", "f")));
  EXPECT_TRUE(absl::IsPermissionDenied(WriteErrnoStatus(ENOENT, "cannot create", "f")));
  EXPECT_TRUE(absl::IsInvalidArgument(WriteErrnoStatus(ENOTDIR, "cannot create", "f")));
  const absl::Status full = WriteErrnoStatus(ENOSPC, "cannot write", "f");
  EXPECT_TRUE(absl::IsResourceExhausted(full));
  EXPECT_THAT(std::string(full.message()), EndsWith("; make room there"));
  EXPECT_TRUE(absl::IsResourceExhausted(WriteErrnoStatus(EFBIG, "cannot write", "f"))) << "a limit, as a full disk";
  EXPECT_TRUE(absl::IsUnavailable(ErrnoStatus(EIO, "cannot read", "f"))) << "the machine's failure, not the file's";
  EXPECT_TRUE(absl::IsUnavailable(ErrnoStatus(ESTALE, "cannot read", "f"))) << "the mount's";
  EXPECT_THAT(std::string(ErrnoStatus(EIO, "cannot read", "f").message()), StartsWith("f: cannot read: "));
}

}  // namespace
}  // namespace tilemend
