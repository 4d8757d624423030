#include "coordinator/store/output_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "tests/coordinator/store/notes_in_memory.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

// A scene of one tile, tiles/a.ply, in the folder `scene`; the output goes to `out`.
class OutputFolderTest : public ::testing::Test {
 protected:
  OutputFolderTest() {
    folder_.Write("scene/tiles/a.ply", "the original");
    scene_.root = folder_ / "scene";
    scene_.tiles = {{{0, 0}, "tiles/a.ply"}};
  }
  absl::StatusOr<OutputFolder> Claim(const std::string& path, bool overwrite = false, const std::string& key = "key") {
    return OutputFolder::Claim(path, scene_, overwrite, key);
  }
  bool Exists(const std::string& name) const { return fs::exists(folder_ / name); }

  const TemporaryFolder folder_;
  const std::string out_ = folder_ / "deep/out";
  Scene scene_;
};

TEST_F(OutputFolderTest, MakesItsFolderAndTakesItAwayIfNothingIsWritten) {
  {
    const auto claimed = Claim(out_);
    ASSERT_TRUE(claimed.ok()) << claimed.status();
    EXPECT_TRUE(Exists("deep/out/.tilemend-job"));
  }
  EXPECT_FALSE(Exists("deep"));
}

// The next search for tiles would find the output's as well.
TEST_F(OutputFolderTest, NothingIsWrittenIntoASceneThatWasFoundByNames) {
  EXPECT_TRUE(Claim(folder_ / "scene/Data").ok());
  scene_.found_by_name = true;
  for (const char* inside : {"scene/Data", "scene/deep/out"}) {
    EXPECT_TRUE(absl::IsInvalidArgument(Claim(folder_ / inside).status())) << inside;
  }
  EXPECT_TRUE(Claim(out_).ok());
  scene_.tiles[0].path = "tiles/a.json";  // a tileset names its tiles
  EXPECT_TRUE(Claim(folder_ / "scene/deep/out").ok());
}

TEST_F(OutputFolderTest, ASecondLivingJobIsRefusedWhateverItMayOverwrite) {
  const auto first = Claim(out_);
  ASSERT_TRUE(first.ok());
  for (const bool overwrite : {false, true}) {
    const absl::Status status = Claim(out_, overwrite).status();
    EXPECT_TRUE(absl::IsAborted(status)) << status;
    EXPECT_EQ(ErrorReason(status), "OUTPUT_IN_USE");
  }
  EXPECT_TRUE(Exists("deep/out/.tilemend-job"));
}

TEST_F(OutputFolderTest, TheSameJobGoesOnWithAnUnfinishedOutputAndAnotherDoesNot) {
  {
    auto first = Claim(out_);
    ASSERT_TRUE(first.ok() && first->BeginWriting().ok());
    folder_.Write("deep/out/tiles/a.ply", "filled");
  }
  EXPECT_TRUE(Exists("deep/out/.tilemend-job"));
  EXPECT_TRUE(Claim(out_).ok());
  EXPECT_TRUE(absl::IsAlreadyExists(Claim(out_, false, "another key").status()));
  EXPECT_TRUE(Claim(out_, true, "another key").ok());
}

TEST_F(OutputFolderTest, AFolderOfAJobThatWasKilledBeforeItsFirstTileIsThatJobs) {
  std::string marker;
  {
    const auto first = Claim(out_);
    ASSERT_TRUE(first.ok());
    marker = ReadFile(out_ + "/.tilemend-job").value();
  }
  folder_.Write("deep/out/.tilemend-job", marker);  // as the kill leaves it
  EXPECT_TRUE(absl::IsAlreadyExists(Claim(out_, false, "another key").status()));
  EXPECT_TRUE(Exists("deep/out/.tilemend-job"));
  EXPECT_TRUE(Claim(out_).ok());
  EXPECT_TRUE(Claim(out_, true, "another key").ok());
}

TEST_F(OutputFolderTest, AFolderWithOtherFilesIsOverwrittenOnlyIfAsked) {
  folder_.Write("deep/out/notes.txt", "mine");
  const absl::Status refused = Claim(out_).status();
  EXPECT_TRUE(absl::IsAlreadyExists(refused));
  EXPECT_THAT(std::string(refused.message()), testing::Not(testing::HasSubstr("--decisions")));
  EXPECT_TRUE(Claim(out_, true).ok());
  EXPECT_TRUE(Exists("deep/out/notes.txt"));
}

TEST_F(OutputFolderTest, ACompleteOutputIsThereAlreadyForTheSameJob) {
  {
    auto first = Claim(out_);
    ASSERT_TRUE(first.ok() && first->BeginWriting().ok());
    folder_.Write("deep/out/tiles/a.ply", "filled");
    first->Finish();
  }
  EXPECT_FALSE(Exists("deep/out/.tilemend-job"));
  EXPECT_TRUE(absl::IsAlreadyExists(Claim(out_).status()));
}

TEST_F(OutputFolderTest, BeginningToWriteTakesAnOldReportAway) {
  folder_.Write("deep/out/report.json", "{}");
  auto claimed = Claim(out_, true);
  ASSERT_TRUE(claimed.ok());
  EXPECT_TRUE(Exists("deep/out/report.json"));
  ASSERT_TRUE(claimed->BeginWriting().ok());
  EXPECT_FALSE(Exists("deep/out/report.json"));
}

TEST_F(OutputFolderTest, TidiesHalfWrittenFilesOfItsOwnAndCountsOthers) {
  auto claimed = Claim(out_);
  ASSERT_TRUE(claimed.ok());
  folder_.Write("deep/out/tiles/a.ply", "filled");
  folder_.Write("deep/out/tiles/a.ply" + std::string(kPartSuffix) + "1", "half");
  folder_.Write("deep/out/tiles/b.ply" + std::string(kPartSuffix) + "1", "of another program");
  folder_.Write("deep/out/notes.txt", "mine");
  folder_.Write("deep/out/more/a.txt", "mine");
  folder_.Write("deep/out/more/b.txt", "mine");
  EXPECT_EQ(claimed->files().TidyUp(), 3) << "a folder of others is not looked through";
  EXPECT_FALSE(Exists("deep/out/tiles/a.ply" + std::string(kPartSuffix) + "1"));
  EXPECT_TRUE(Exists("deep/out/tiles/a.ply"));
  EXPECT_TRUE(Exists("deep/out/notes.txt"));
}

TEST_F(OutputFolderTest, NeverWritesAmongTheTilesOfTheScene) {
  for (const bool overwrite : {false, true}) {
    for (const std::string& path :
         {folder_ / "scene", folder_ / "scene/tiles", folder_ / "scene/../scene", folder_ / "scene/tiles/deeper"}) {
      EXPECT_TRUE(absl::IsInvalidArgument(Claim(path, overwrite).status())) << path;
    }
  }
  fs::create_directory(folder_ / "links");
  fs::create_directory_symlink(folder_ / "scene/tiles", folder_ / "links/tiles");
  EXPECT_TRUE(absl::IsInvalidArgument(Claim(folder_ / "links", true).status())) << "tiles lead there over a link";
  EXPECT_TRUE(Claim(folder_ / "scene/out").ok()) << "a folder of its own beside the tiles' folder";
}

// In a mount namespace of its own, by a process of its own. 0: refused for its place; 1: it is not; 2: it cannot mount.
int ClaimOverASecondMount(const std::string& scene, const std::string& mount,
                          const std::function<absl::Status()>& claim) {
  const pid_t child = fork();
  if (child == 0) {
    const bool mounted = unshare(CLONE_NEWNS) == 0 &&
                         ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                         ::mount(scene.c_str(), mount.c_str(), nullptr, MS_BIND, nullptr) == 0;
    _exit(!mounted ? 2 : absl::IsInvalidArgument(claim()) ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(OutputFolderTest, NeverWritesAmongTheTilesOverASecondMount) {
  fs::create_directory(folder_ / "mount");
  for (const char* path : {"mount", "mount/tiles", "mount/tiles/deeper"}) {
    const int refused =
        ClaimOverASecondMount(scene_.root, folder_ / "mount", [&] { return Claim(folder_ / path, true).status(); });
    if (refused == 2) GTEST_SKIP() << "may not mount here";
    EXPECT_EQ(refused, 0) << path;
  }
}

TEST_F(OutputFolderTest, NeverWritesToAFolderThatHoldsFoldersOfTiles) {
  folder_.Write("scene/Data/Tile_+000_+000/a.ply", "the original");
  folder_.Write("scene/b.ply", "beside the others");
  scene_.tiles = {{{0, 0}, "Data/Tile_+000_+000/a.ply"}, {{1, 0}, "b.ply"}};
  fs::create_directory_symlink(folder_ / "scene/Data", folder_ / "link");
  for (const bool overwrite : {false, true}) {
    for (const char* path : {"scene/Data", "scene/Data/out", "scene/Data/Tile_+000_+000", "link", "link/new/out"}) {
      const absl::Status status = Claim(folder_ / path, overwrite).status();
      EXPECT_TRUE(absl::IsInvalidArgument(status)) << path;
      EXPECT_THAT(std::string(status.message()), testing::HasSubstr(folder_ / "scene/Data")) << path;
    }
  }
  EXPECT_FALSE(Exists("scene/Data/out"));
  for (const char* path : {"scene/Data-filled", "scene/out", "scene/out/Data"}) EXPECT_TRUE(Claim(folder_ / path).ok());
}

TEST_F(OutputFolderTest, RefusesAPathThatCannotBeAFolder) {
  EXPECT_TRUE(absl::IsInvalidArgument(Claim(folder_.Write("file", "x")).status()));
  EXPECT_TRUE(absl::IsInvalidArgument(Claim(folder_ / "file/below").status()));
  EXPECT_TRUE(absl::IsInvalidArgument(Claim("gs://bucket/out").status()));
}

TEST_F(OutputFolderTest, ANewClaimOfAKilledJobThatWroteNothingLeavesNothing) {
  std::string marker;
  {
    const auto first = Claim(out_);
    ASSERT_TRUE(first.ok());
    marker = ReadFile(out_ + "/.tilemend-job").value();
  }
  folder_.Write("deep/out/.tilemend-job", marker);  // as the kill leaves it
  folder_.Write("deep/out/.tilemend-attempts/key", "12345678");
  ASSERT_TRUE(Claim(out_).ok());
  EXPECT_FALSE(Exists("deep/out/.tilemend-job"));
  EXPECT_FALSE(Exists("deep/out/.tilemend-attempts"));
}

TEST_F(OutputFolderTest, WhatIsInTheWayIsNamedAndStays) {
  struct Case {
    const char* name;
    void (*make)(const std::string& path);
  };
  const auto link = [](const std::string& path) { fs::create_directory_symlink("/tmp", path); };
  const auto folder = [](const std::string& path) { fs::create_directories(path + "/mine"); };
  const auto pipe = [](const std::string& path) { ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0); };
  const auto file = [](const std::string& path) { ASSERT_TRUE(WriteFileAtomically(path, "mine").ok()); };
  const Case cases[] = {{".tilemend-job", folder},
                        {".tilemend-job", link},
                        {".tilemend-job", pipe},
                        {".tilemend-results", folder},
                        {".tilemend-results", link},
                        {".tilemend-results", pipe},
                        {".tilemend-attempts", link},
                        {".tilemend-attempts", file},
                        {"tiles/a.ply", folder},
                        {"report.json", folder},
                        {"tiles", file},
                        {"tiles", link}};
  for (const auto& [name, make] : cases) {
    const std::string path = out_ + "/" + name;
    fs::create_directories(fs::path(path).parent_path());
    make(path);
    for (const bool overwrite : {false, true}) {
      const absl::Status status = Claim(out_, overwrite).status();
      EXPECT_TRUE(absl::IsInvalidArgument(status) || (!overwrite && absl::IsAlreadyExists(status))) << status;
      EXPECT_THAT(std::string(status.message()), testing::HasSubstr(overwrite ? path + ": a " : out_));
    }
    EXPECT_TRUE(fs::exists(fs::symlink_status(path))) << path;
    fs::remove_all(out_);
  }
}

TEST_F(OutputFolderTest, AFolderInPlaceOfTheMetadataIsNamed) {
  folder_.Write("deep/out/metadata.xml/mine", "");
  EXPECT_TRUE(Claim(out_, true).ok()) << "the scene has none";
  folder_.Write("scene/metadata.xml", "<ModelMetadata/>");
  const absl::Status status = Claim(out_, true).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr(out_ + "/metadata.xml: a folder where the job makes"));
}

TEST_F(OutputFolderTest, SaysWhatIsInTheWayOfFilesThatAreCarried) {
  const auto output = Claim(out_);
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_TRUE(output->CheckRoomFor({"a.jpg", "images/b.jpg"}).ok());
  fs::create_symlink(folder_ / "scene/tiles/a.ply", out_ + "/a.jpg");
  EXPECT_TRUE(output->CheckRoomFor({"a.jpg"}).ok()) << "is replaced";
  fs::create_directory_symlink("/tmp", out_ + "/images");
  const absl::Status status = output->CheckRoomFor({"a.jpg", "images/b.jpg"});
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr(out_ + "/images: a link"));
}

}  // namespace
}  // namespace tilemend
