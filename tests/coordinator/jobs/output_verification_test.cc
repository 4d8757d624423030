#include "coordinator/jobs/output_verification.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/rpc/receipt_payloads.h"
#include "common/store/digest.h"
#include "common/store/tile_stamp.h"
#include "common/util/error_info.h"
#include "common/util/folders.h"
#include "tests/coordinator/store/notes_in_memory.h"
#include "tests/support/temporary_folder.h"
#include "tilemend/v1/verify.pb.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class OutputVerificationTest : public ::testing::Test {
 protected:
  // As "writer" reports a file that it wrote.
  v1::WrittenFile Write(const std::string& name, const std::string& bytes) {
    const std::string path = folder_.Write("out/" + name, bytes);
    v1::WrittenFile file;
    file.set_path(name);
    file.set_bytes(static_cast<int64_t>(bytes.size()));
    file.set_digest(FileDigest(bytes));
    *file.mutable_receipt() = ToProto(ReceiptOf(path).value());
    return file;
  }
  void Add(OutputVerification& verification, CellId cell, const std::vector<v1::WrittenFile>& files,
           bool is_known = false) {
    OutputVerification::Written written{cell, "writer", is_known, {}};
    written.files.mutable_files()->Add(files.begin(), files.end());
    verification.AddWritten(written, folder_ / "out", folder_ / "scene");
  }
  void AddTile(OutputVerification& verification, const std::string& digest, const std::string& stamp = "") {
    verification.AddTile({0, 0}, "surveyor", Tile(digest), stamp);
  }
  v1::TileRef Tile(const std::string& digest) const {
    v1::TileRef tile;
    tile.set_root(folder_ / "scene");
    tile.set_path("a.ply");
    tile.set_digest(digest);
    return tile;
  }

  using Change = std::function<void(v1::VerifyOutput&)>;
  // As "verifier" does the task.
  static TaskResult Run(
      const NewTask& task, const Change& change = [](v1::VerifyOutput&) {}) {
    TaskResult result{task.cell, task.stage, SceneStageRunner()(task.stage, WholeInput(task).value(), CancelToken()),
                      "verifier", Sha256Hex(task.input)};
    v1::VerifyOutput output;
    if (!result.output.ok() || !output.ParseFromString(*result.output)) return result;
    change(output);
    result.output = output.SerializeAsString();
    return result;
  }
  // All tasks. The message about who is caught; "" if nobody is.
  static std::string Verify(
      OutputVerification& verification, const Change& change = [](v1::VerifyOutput&) {}) {
    while (const auto task = verification.Next(true)) {
      EXPECT_FALSE(verification.is_over());
      const auto caught = verification.Take(Run(*task, change));
      if (!caught.ok()) return absl::StrCat(ErrorReason(caught.status()), " ", std::string(caught.status().message()));
      if (caught->has_value()) return (*caught)->worker + ": " + (*caught)->reason;
    }
    EXPECT_TRUE(verification.is_over());
    return "";
  }

  const TemporaryFolder folder_;
  OutputVerification all_{1};
};

TEST_F(OutputVerificationTest, FilesAsReportedAreNobodysFault) {
  Add(all_, {0, 0}, {Write("a.ply", "a"), Write("a.png", "b")});
  Add(all_, {1, 0}, {Write("c.ply", "c")}, true);
  EXPECT_FALSE(all_.is_over());
  EXPECT_EQ(all_.Next(false), std::nullopt) << "more may come";
  EXPECT_EQ(Verify(all_), "");
}

TEST_F(OutputVerificationTest, ATaskAvoidsTheWorkerThatReportedItsFiles) {
  Add(all_, {0, 0}, {Write("a.ply", "a")});
  folder_.Write("scene/a.ply", "tile");
  AddTile(all_, FileDigest("tile"));
  const auto first = all_.Next(true), second = all_.Next(true);
  EXPECT_THAT(first->avoid, ElementsAre("surveyor"));
  EXPECT_THAT(second->avoid, ElementsAre("writer"));
  EXPECT_TRUE(all_.Take(Run(*second)).ok());
  EXPECT_FALSE(all_.is_over());
  EXPECT_TRUE(all_.Take(Run(*first)).ok());
  EXPECT_TRUE(all_.is_over());
  EXPECT_TRUE(absl::IsInternal(all_.Take(Run(*first)).status())) << "it was taken";
}

TEST_F(OutputVerificationTest, AFullTaskDoesNotWaitForTheEnd) {
  const v1::WrittenFile file = Write("a.ply", "a");
  for (int i = 0; i < 257; ++i) Add(all_, {i, 0}, {file});
  v1::VerifyInput input;
  ASSERT_TRUE(input.ParseFromString(all_.Next(false)->input));
  EXPECT_EQ(input.paths_size(), 256);
  EXPECT_EQ(all_.Next(false), std::nullopt);
}

TEST_F(OutputVerificationTest, AWriterThatReportsAnotherDigestIsCaught) {
  v1::WrittenFile file = Write("a.ply", "a");
  file.set_digest(FileDigest("b"));
  Add(all_, {0, 0}, {file});
  EXPECT_THAT(Verify(all_), HasSubstr("writer: worker writer wrote something else than it reported to"));
}

TEST_F(OutputVerificationTest, AVerifierThatReportsAnotherDigestIsCaught) {
  Add(all_, {0, 0}, {Write("a.ply", "a")});
  const auto lie = [](v1::VerifyOutput& output) { output.mutable_files(0)->set_digest(FileDigest("b")); };
  EXPECT_THAT(Verify(all_, lie), HasSubstr("verifier: worker verifier reported a wrong digest of"));
}

TEST_F(OutputVerificationTest, AVerifierThatSeesAnotherFileIsNotBelieved) {
  Add(all_, {0, 0}, {Write("a.ply", "a")});
  const auto lie = [](v1::VerifyOutput& output) {
    output.mutable_files(0)->set_digest(FileDigest("b"));
    output.mutable_files(0)->mutable_receipt()->set_inode(1);
  };
  EXPECT_EQ(Verify(all_, lie), "");
  v1::WrittenFile wrong = Write("c.ply", "c");
  wrong.set_digest(FileDigest("d"));
  Add(all_, {0, 0}, {wrong});
  const auto agree = [&](v1::VerifyOutput& output) {
    output.mutable_files(0)->set_digest(wrong.digest());
    output.mutable_files(0)->mutable_receipt()->set_inode(1);
  };
  EXPECT_THAT(Verify(all_, agree), HasSubstr("writer: worker writer"));
}

TEST_F(OutputVerificationTest, TheCoordinatorReadsAFileThatNoWorkerCouldVerify) {
  v1::WrittenFile wrong = Write("a.ply", "a");
  wrong.set_digest(FileDigest("b"));
  Add(all_, {0, 0}, {Write("c.ply", "c")});
  Add(all_, {0, 0}, {wrong});
  const auto task = all_.Next(true);
  const auto caught =
      all_.Take({task->cell, task->stage, absl::UnavailableError("no worker"), "", Sha256Hex(task->input)});
  ASSERT_TRUE(caught.ok() && caught->has_value());
  EXPECT_EQ((*caught)->worker, "writer");
}

TEST_F(OutputVerificationTest, AFileThatWasChangedOrRemovedFailsTheJob) {
  Add(all_, {0, 0}, {Write("a.ply", "a")});
  Write("a.ply", "b");
  EXPECT_THAT(Verify(all_), HasSubstr("OUTPUT_CHANGED"));
  OutputVerification resumed(1);
  const v1::WrittenFile known = Write("b.ply", "a");
  Write("b.ply", "b");
  Add(resumed, {0, 0}, {known}, true);
  EXPECT_THAT(Verify(resumed), HasSubstr("OUTPUT_CHANGED"));
  OutputVerification removed(1);
  Add(removed, {0, 0}, {Write("c.ply", "a")});
  ASSERT_TRUE(RemoveFile(folder_ / "out/c.ply").ok());
  EXPECT_THAT(Verify(removed), HasSubstr("OUTPUT_CHANGED"));
}

TEST_F(OutputVerificationTest, ACarriedFileMustBeThatOfTheScene) {
  folder_.Write("scene/a.png", "image");
  v1::WrittenFile image = Write("a.png", "image");
  image.set_carried(true);
  Add(all_, {0, 0}, {Write("a.ply", "a"), image});
  EXPECT_EQ(Verify(all_), "");
  image = Write("a.png", "other");
  image.set_carried(true);
  Add(all_, {0, 0}, {Write("a.ply", "a"), image});
  EXPECT_THAT(Verify(all_), HasSubstr("writer: worker writer wrote another file than that of the scene to"));
}

TEST_F(OutputVerificationTest, ALinkNeedsNoVerification) {
  v1::WrittenFile link = Write("a.ply", "a");
  link.clear_digest();
  Add(all_, {0, 0}, {link});
  EXPECT_TRUE(all_.is_over());
}

TEST_F(OutputVerificationTest, ASurveyorThatReportsAnotherDigestIsCaught) {
  const std::string tile = folder_.Write("scene/a.ply", "tile");
  const std::string stamp = StampOfTile(tile, absl::Now() + absl::Minutes(1));  // a young stamp is empty
  AddTile(all_, FileDigest("tile"), stamp);
  EXPECT_EQ(Verify(all_), "");
  EXPECT_EQ(all_.WhoIsWrongNear({1, 1}), std::nullopt);
  AddTile(all_, FileDigest("other"), stamp);
  EXPECT_THAT(Verify(all_), HasSubstr("surveyor: worker surveyor reported a wrong digest of"));
  EXPECT_EQ(all_.WhoIsWrongNear({0, 1})->worker, "surveyor");
}

TEST_F(OutputVerificationTest, ATileThatChangedSinceItsSurveyFailsTheJob) {
  const std::string tile = folder_.Write("scene/a.ply", "tile");
  AddTile(all_, FileDigest("tile"), StampOfTile(tile, absl::Now() + absl::Minutes(1)));
  folder_.Write("scene/a.ply", "new tile");
  EXPECT_THAT(Verify(all_), HasSubstr("changed"));
}

TEST_F(OutputVerificationTest, VerifiesTheShareThatIsAskedFor) {
  const auto count = [&](OutputVerification& verification) {
    for (int i = 0; i < 1000; ++i) {
      v1::TileRef tile = Tile("digest");
      tile.set_path(absl::StrCat(i, ".ply"));
      verification.AddTile({i, 0}, "surveyor", std::move(tile), "");
    }
    int tiles = 0;
    while (const auto task = verification.Next(true)) {
      v1::VerifyInput input;
      EXPECT_TRUE(input.ParseFromString(task->input));
      tiles += input.tiles_size();
    }
    return tiles;
  };
  OutputVerification none(0), some(0.5);
  EXPECT_EQ(count(none), 0);
  EXPECT_NEAR(count(some), 500, 100);
  EXPECT_EQ(count(all_), 1000);
}

TEST_F(OutputVerificationTest, AFileThatLooksDifferentHereIsVerifiedWhateverTheShare) {
  OutputVerification little(1e-9);
  v1::WrittenFile file = Write("a.ply", "a");
  Add(little, {0, 0}, {file});
  EXPECT_TRUE(little.is_over());
  file.mutable_receipt()->set_modified(1);
  Add(little, {0, 0}, {file});
  EXPECT_FALSE(little.is_over());
  EXPECT_EQ(Verify(little), "");
}

class NotedVerificationTest : public OutputVerificationTest {
 protected:
  // Another process of the job, in which everything is known. Whether something is to be verified.
  bool VerifiesAgain(const std::vector<v1::WrittenFile>& files, const std::string& tile, const std::string& stamp) {
    OutputVerification again(1);
    again.UseNotes(notes_, 1);
    Add(again, {0, 0}, files, true);
    AddTile(again, tile, stamp);
    return !again.is_over();
  }

  const std::shared_ptr<NotesInMemory> notes_ = std::make_shared<NotesInMemory>();
};

TEST_F(NotedVerificationTest, WhatWasVerifiedIsVerifiedAgainOnlyIfItChanged) {
  folder_.Write("scene/a.ply", "tile");
  const std::string digest = FileDigest("tile");
  const std::string stamp = StampOfTile(folder_ / "scene/a.ply", absl::Now() + absl::Minutes(1));
  const v1::WrittenFile file = Write("a.ply", "a");
  all_.UseNotes(notes_, 1);
  Add(all_, {0, 0}, {file});
  AddTile(all_, digest, stamp);
  EXPECT_TRUE(VerifiesAgain({file}, digest, stamp)) << "it is not yet";
  ASSERT_EQ(Verify(all_), "");
  EXPECT_FALSE(VerifiesAgain({file}, digest, stamp));
  EXPECT_TRUE(VerifiesAgain({file}, digest, "")) << "nobody can tell if the tile changed";
  EXPECT_TRUE(VerifiesAgain({file}, FileDigest("other"), stamp));
  EXPECT_TRUE(VerifiesAgain({file, Write("b.ply", "b")}, digest, stamp));
  EXPECT_TRUE(VerifiesAgain({Write("a.ply", "a")}, digest, stamp)) << "another file with the same bytes";
  EXPECT_EQ(notes_->workers(), std::set<std::string>{"verifier"});
}

TEST_F(NotedVerificationTest, NothingIsNotedOfABatchWithAWrongFile) {
  v1::WrittenFile file = Write("a.ply", "a");
  file.set_digest(FileDigest("b"));
  all_.UseNotes(notes_, 1);
  Add(all_, {0, 0}, {file, Write("c.ply", "c")});
  EXPECT_NE(Verify(all_), "");
  EXPECT_TRUE(notes_->workers().empty());
}

}  // namespace
}  // namespace tilemend
