#include "client/output_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class OutputFileTest : public testing::Test {
 protected:
  std::string Path(const std::string& name) const { return folder_ / name; }
  size_t CountFiles() const {
    return static_cast<size_t>(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }

  TemporaryFolder folder_;
};

using OutputFileDeathTest = OutputFileTest;

TEST_F(OutputFileTest, TakesANameThatIsFree) {
  EXPECT_TRUE(CheckOutputFile(Path("new.ply"), false).ok());
  EXPECT_TRUE(CheckOutputFile(Path("no folder/new.ply"), false).ok());
}

TEST_F(OutputFileTest, ReplacesAFileOnlyWhenTold) {
  folder_.Write("old.ply", "text");
  EXPECT_TRUE(absl::IsAlreadyExists(CheckOutputFile(Path("old.ply"), false)));
  EXPECT_TRUE(CheckOutputFile(Path("old.ply"), true).ok());
  EXPECT_THAT(std::string(CheckOutputFile(Path("old.ply"), false).message()), HasSubstr("another --out, or"));
  EXPECT_THAT(std::string(CheckOutputFile(Path("old.ply"), false, "--holes").message()),
              HasSubstr("another --holes, or"));
}

TEST_F(OutputFileTest, TellsPolygonsFromOtherFiles) {
  const std::string feature = R"({"type": "Feature", "geometry": null})";
  for (const std::string& text :
       {feature, R"({"name": "x", "features": [)" + feature + R"(], "type": "FeatureCollection"})",
        std::string("SQLite format 3"), std::string()}) {
    EXPECT_TRUE(HoldsPolygons(folder_.Write("polygons", text))) << text;
  }
  for (const std::string& text : {std::string(R"({"cell_size": 10, "area": {"type": "Polygon"}, "tiles": []})"),
                                  std::string(R"({"type": "module"})"), std::string("ply\n"), std::string("[3")}) {
    EXPECT_FALSE(HoldsPolygons(folder_.Write("other", text))) << text;
  }
  EXPECT_FALSE(HoldsPolygons(Path("nothing")));
}

TEST_F(OutputFileTest, NeverReplacesWhatIsNoFile) {
  fs::create_directory(Path("folder.ply"));
  ASSERT_EQ(::mkfifo(Path("pipe.ply").c_str(), 0600), 0);
  fs::create_symlink("nowhere", Path("link.ply"));
  for (const std::string& path : {Path("folder.ply"), Path("pipe.ply"), Path("link.ply"), std::string("/dev/null")}) {
    for (const bool overwrite : {false, true}) {
      EXPECT_TRUE(absl::IsInvalidArgument(CheckOutputFile(path, overwrite))) << path;
    }
  }
}

TEST_F(OutputFileTest, IsHeldByOneAtATime) {
  std::optional<absl::StatusOr<OutputLock>> first = OutputLock::Take(Path("new/out.ply"));
  ASSERT_TRUE(first->ok());
  const absl::Status second = OutputLock::Take(Path("new/out.ply")).status();
  EXPECT_TRUE(absl::IsAborted(second));
  EXPECT_THAT(std::string(second.message()), HasSubstr("another command is writing it"));
  EXPECT_TRUE(OutputLock::Take(Path("new/other.ply")).ok());
  first.reset();
  EXPECT_TRUE(OutputLock::Take(Path("new/out.ply")).ok());
}

TEST_F(OutputFileTest, LeavesNothingBehind) {
  { ASSERT_TRUE(OutputLock::Take(Path("a/b/out.ply")).ok()); }
  EXPECT_EQ(CountFiles(), 0);
}

TEST_F(OutputFileTest, TakesOverWhatAKilledProcessLeft) {
  folder_.Write(".out.ply.tilemend-lock", "");
  EXPECT_TRUE(OutputLock::Take(Path("out.ply")).ok());
}

// In a folder that many may write to.
TEST_F(OutputFileDeathTest, TakesOverWhatAProcessOfAnotherUserLeft) {
  if (::geteuid() != 0) GTEST_SKIP() << "root alone can become another user";
  const std::string lock = folder_.Write(".out.ply.tilemend-lock", "");
  fs::permissions(folder_.path(), fs::perms::all);
  const auto as_another = [&](fs::perms of_lock) {
    fs::permissions(lock, of_lock);
    constexpr uid_t kNobody = 65534;
    if (::setuid(kNobody) != 0) std::abort();
    const absl::Status status = OutputLock::Take(Path("out.ply")).status();
    std::fprintf(stderr, "%s\n", std::string(status.message()).c_str());
    std::exit(status.ok() ? 0 : 1);
  };
  EXPECT_EXIT(as_another(fs::perms::owner_read), testing::ExitedWithCode(1), "/.out.ply.tilemend-lock: cannot open");
  EXPECT_EXIT(as_another(fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read),
              testing::ExitedWithCode(0), "");
}

TEST_F(OutputFileTest, SaysWhereItCannotWrite) {
  folder_.Write("file", "text");
  EXPECT_TRUE(absl::IsInvalidArgument(OutputLock::Take(Path("file/out.ply")).status()));
}

}  // namespace
}  // namespace tilemend
