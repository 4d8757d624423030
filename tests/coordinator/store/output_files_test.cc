#include "coordinator/store/output_files.h"

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
#include "coordinator/store/output_folder.h"
#include "tests/coordinator/store/notes_in_memory.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

// A scene of one tile, tiles/a.ply, in the folder `scene`; the output goes to `out`.
class PlacedFilesTest : public ::testing::Test {
 protected:
  PlacedFilesTest() {
    folder_.Write("scene/tiles/a.ply", "the original");
    scene_.root = folder_ / "scene";
    scene_.tiles = {{{0, 0}, "tiles/a.ply"}};
    auto claimed = Claim(out_);
    EXPECT_TRUE(claimed.ok()) << claimed.status();
    output_.emplace(*std::move(claimed));
    EXPECT_TRUE(output_->BeginWriting().ok());
  }
  absl::StatusOr<OutputFolder> Claim(const std::string& path, bool overwrite = false, const std::string& key = "key") {
    return OutputFolder::Claim(path, scene_, overwrite, key);
  }
  bool Exists(const std::string& name) const { return fs::exists(folder_ / name); }
  // As a worker leaves it.
  AttemptFile Attempt(const std::string& content = "filled") {
    AttemptFile file{absl::StrCat(std::string(32, 'a'), "-", ++attempts_), "tiles/a.ply",
                     static_cast<int64_t>(content.size()), FileDigest(content)};
    folder_.Write(absl::StrCat("deep/out/.tilemend-attempts/", file.attempt), content);
    return file;
  }
  absl::Status SeeAll() {
    return output_->files().SeeAll([] { return false; });
  }

  const TemporaryFolder folder_;
  const std::string out_ = folder_ / "deep/out";
  const std::string tile_ = out_ + "/tiles/a.ply";
  Scene scene_;
  std::optional<OutputFolder> output_;
  int attempts_ = 0;
};

TEST_F(PlacedFilesTest, GetTheirNames) {
  const AttemptFile file = Attempt();
  ASSERT_TRUE(output_->files().Place({file}, output_->attempts()).ok());
  EXPECT_EQ(ReadFile(out_ + "/tiles/a.ply").value(), "filled");
  EXPECT_TRUE(output_->files().Place({file}, output_->attempts()).ok()) << "again, after a restart";
  EXPECT_TRUE(SeeAll().ok());
  EXPECT_EQ(output_->files().TidyUp(), 0);
  output_->Finish();
  EXPECT_FALSE(Exists("deep/out/.tilemend-attempts"));
}

TEST_F(PlacedFilesTest, MustBeThereAndOfThisOutput) {
  AttemptFile gone = Attempt();
  ASSERT_TRUE(output_->files().Place({gone}, output_->attempts()).ok());
  gone.bytes += 1;
  EXPECT_TRUE(absl::IsUnavailable(output_->files().Place({gone}, output_->attempts()))) << "another file has the name";
  AttemptFile strange = Attempt();
  strange.path = "../mine.txt";
  EXPECT_TRUE(absl::IsInvalidArgument(output_->files().Place({strange}, output_->attempts())));
  AttemptFile outside = Attempt();
  outside.attempt = "../../../scene/tiles/a.ply";
  EXPECT_TRUE(absl::IsInvalidArgument(output_->files().Place({outside}, output_->attempts())));
  outside.attempt = "key";
  EXPECT_TRUE(absl::IsInvalidArgument(output_->files().Place({outside}, output_->attempts())));
  EXPECT_TRUE(Exists("scene/tiles/a.ply"));
}

TEST_F(PlacedFilesTest, AreMissedWhenTheyAreGoneOrChanged) {
  ASSERT_TRUE(output_->files().Place({Attempt()}, output_->attempts()).ok());
  EXPECT_TRUE(SeeAll().ok());
  folder_.Write("deep/out/tiles/a.ply", "cut");
  EXPECT_TRUE(absl::IsAborted(SeeAll()));
  fs::remove_all(out_);
  const absl::Status status = SeeAll();
  EXPECT_TRUE(absl::IsAborted(status)) << status;
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("1 of 1 files"));
}

TEST_F(PlacedFilesTest, AreMissedWhenTheyHaveOtherBytesOfTheSameSize) {
  const fs::file_time_type later = fs::file_time_type::clock::now() + std::chrono::hours(1);
  ASSERT_TRUE(output_->files().Place({Attempt()}, output_->attempts()).ok());
  fs::last_write_time(tile_, later);
  EXPECT_TRUE(SeeAll().ok()) << "other times alone";
  folder_.Write("deep/out/tiles/a.ply", "killed");
  fs::last_write_time(tile_, later);
  const absl::Status status = SeeAll();
  EXPECT_TRUE(absl::IsAborted(status)) << status;
  EXPECT_EQ(GetErrorInfo(status)->metadata.at("file"), tile_);
  fs::remove(tile_);
  folder_.Write("deep/out/tiles/a.ply", "filled");
  EXPECT_TRUE(SeeAll().ok()) << "another file with the same bytes";
}

TEST_F(PlacedFilesTest, AreMissedWhereALinkIsInTheirPlace) {
  ASSERT_TRUE(output_->files().Place({Attempt()}, output_->attempts()).ok());
  fs::rename(tile_, folder_ / "moved.ply");
  fs::create_symlink(folder_ / "moved.ply", tile_);
  EXPECT_TRUE(absl::IsAborted(SeeAll()));
}

TEST_F(PlacedFilesTest, AreLookedAtUntilTheJobIsToEnd) {
  ASSERT_TRUE(output_->files().Place({Attempt()}, output_->attempts()).ok());
  EXPECT_TRUE(absl::IsCancelled(output_->files().SeeAll([] { return true; })));
}

TEST_F(PlacedFilesTest, OutliveTheProcessUntilTheyArePlaced) {
  const AttemptFile file = Attempt();
  output_.reset();
  auto again = Claim(out_);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_TRUE(again->files().Place({file}, again->attempts()).ok());
}

TEST_F(PlacedFilesTest, OfOthersAreLeftAndOwnOnesReplaced) {
  const auto notes = std::make_shared<NotesInMemory>();
  output_->files().LeaveFiles(notes);
  folder_.Write("deep/out/tiles/a.ply", "theirs");
  const auto other = output_->files().Place({Attempt("filled")}, output_->attempts());
  EXPECT_EQ(ErrorReason(other), "OUTPUT_EXISTS") << other;
  EXPECT_TRUE(output_->files().Place({Attempt("theirs")}, output_->attempts()).ok()) << "the same bytes";
  fs::remove(tile_);
  ASSERT_TRUE(output_->files().Place({Attempt("wrong")}, output_->attempts()).ok());
  ASSERT_TRUE(output_->files().Place({Attempt("filled")}, output_->attempts()).ok());
  EXPECT_EQ(ReadFile(tile_).value(), "filled");
  for (const bool is_known : {true, false}) {
    output_.reset();
    output_.emplace(*Claim(out_));
    output_->files().LeaveFiles(is_known ? notes : std::make_shared<NotesInMemory>());
    EXPECT_EQ(output_->files().Place({Attempt(is_known ? "mended" : "of another job")}, output_->attempts()).ok(),
              is_known);
    EXPECT_EQ(ReadFile(tile_).value(), "mended");
  }
}

TEST_F(PlacedFilesTest, HaveAKeyThatStays) {
  const std::string key = ReadFile(output_->attempts().key_file()).value();
  EXPECT_EQ(key.size(), 32U);
  output_.reset();
  EXPECT_EQ(ReadFile(Claim(out_)->attempts().key_file()).value(), key);
}

}  // namespace
}  // namespace tilemend
