// The tilemend command as a process, with the toy in place of the geometry: what it prints, where, and its exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/time/clock.h"
#include "common/util/build_id.h"
#include "common/util/files.h"
#include "tests/support/process.h"
#include "tests/support/test_cluster.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class CommandTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!kHasGrpc) GTEST_SKIP() << "needs gRPC";
  }
  Ended Run(const std::vector<std::string>& words) {
    return Process(folder_.path().string(), TOY_CLIENT, words).Wait();
  }

  // Makes a scene of one tile; returns the file's bytes.
  std::string MakeScene(const std::vector<std::string>& vertices, const std::vector<std::string>& faces) {
    std::string tile =
        absl::StrCat("ply\nformat ascii 1.0\nelement vertex ", vertices.size(),
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face ", faces.size(),
                     "\nproperty list uchar int vertex_indices\nend_header\n", absl::StrJoin(vertices, "\n"), "\n");
    for (const std::string& face : faces) absl::StrAppend(&tile, "3 ", face, "\n");
    std::filesystem::create_directory(folder_ / "scene");
    EXPECT_TRUE(WriteFileAtomically(folder_ / "scene/tile.ply", tile).ok());
    EXPECT_TRUE(WriteFileAtomically(folder_ / "scene/scene.json",
                                    R"({"origin": [0, 0, 0], "cell_size": 10, "cols": 1, "rows": 1,
                                        "tiles": [{"col": 0, "row": 0, "path": "tile.ply"}]})")
                    .ok());
    return tile;
  }

  TempFolder folder_;
};

TEST_F(CommandTest, RunWritesTheReportAndSaysSo) {
  const Ended ended = Run({"run", "toy://4x3", "--out", folder_ / "out", "--workers", "2"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("total 5205483\n"));  // what the job says
  EXPECT_THAT(ended.out, HasSubstr("/out/report.html (open it in a browser)"));
  EXPECT_THAT(ended.err, Not(HasSubstr("\r")));  // no bar: not a terminal
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/report.json"));
}

TEST_F(CommandTest, JsonIsAllThatStdoutHas) {
  const Ended ended = Run({"run", "toy://4x3", "--out", folder_ / "out", "-o", "json"});
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << ended.out;
  EXPECT_EQ(json["state"], "done");
  EXPECT_EQ(json["progress"]["tasks"], 36);
}

TEST_F(CommandTest, ExitCodes) {
  const std::string out = folder_ / "out";
  EXPECT_EQ(Run({}).code, 2);
  EXPECT_EQ(Run({"run", "toy://2x2"}).code, 2);
  EXPECT_EQ(Run({"run", "--out", out}).code, 2);
  EXPECT_EQ(Run({"run", "toy://2x2", "--out", out, "--surface", "flat"}).code, 2);
  EXPECT_EQ(Run({"run", "toy://2x2", "--out", out, "--filler", "putty"}).code, 2);
  EXPECT_EQ(Run({"fill", "mesh.off", "--out", out, "--filler", "putty"}).code, 2);
  EXPECT_EQ(Run({"fill", "mesh.off", "--out", out, "--svm-rings", "2"}).code, 2);
  EXPECT_EQ(Run({"fill", "mesh.off", "--out", out, "--filler", "svm-laplacian", "--svm-rings", "0"}).code, 2);
  EXPECT_EQ(Run({"run", "toy://2x2", "--out", out, "--workers", "0"}).code, 2);
  EXPECT_EQ(Run({"run", "no-such-scene", "--out", out}).code, 3);
  EXPECT_EQ(Run({"report", out}).code, 3);
  EXPECT_EQ(Run({"run", "toy://0x2", "--out", out}).code, 4);
  EXPECT_EQ(Run({"list", "--coordinator", "127.0.0.1:1"}).code, 5);
  EXPECT_EQ(Run({"run", "toy://2x2?plan_error=1", "--out", out}).code, 6);
  EXPECT_EQ(Run({"run", "toy://2x2?fail=1,1", "--out", out}).code, 100);
}

TEST_F(CommandTest, SaysOfOptionsThatExcludeEachOtherWhichToLeaveOut) {
  const std::string out = folder_ / "out.off";
  const auto refusal = [&](std::vector<std::string> flags) {
    std::vector<std::string> args = {"fill", "mesh.off", "--out", out};
    args.insert(args.end(), flags.begin(), flags.end());
    const Ended ended = Run(args);
    EXPECT_EQ(ended.code, 2);
    return ended.err;
  };
  EXPECT_THAT(refusal({"--surface", "wang", "--filler", "svm-laplacian"}), HasSubstr("leave one of the two out"));
  EXPECT_THAT(refusal({"--water", "auto", "--water-colour", "300,0,0"}),
              HasSubstr("expected R,G,B, each 0 to 255, or #rrggbb"));
  EXPECT_THAT(refusal({"--front-bend", "1"}), HasSubstr("leave it out, or choose advancing-front-normal"));
  EXPECT_THAT(refusal({"--filler", "minimum-area", "--tension", "1"}), HasSubstr("leave it out, or choose auto"));
  EXPECT_THAT(refusal({"--fairing-steps", "3"}), HasSubstr("leave it out, or choose one of them"));
  const Ended ended = Run({"run", "toy://2x2", "--out", out, "--seam-smoothing", "0.4"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("--seam-smoothing: only the surface wang has this option"));
}

TEST_F(CommandTest, AggregateLeavesTheSceneAndFilesBesideItsOutputAsTheyAre) {
  const std::string tile = MakeScene({"1 1 0", "9 1 0", "1 9 0"}, {"0 1 2"});
  std::filesystem::create_symlink(folder_ / "scene/tile.ply", folder_ / "link.ply");
  for (const char* out : {"scene/tile.ply", "scene/new.ply", "link.ply"}) {
    EXPECT_EQ(Run({"aggregate", folder_ / "scene", "--out", folder_ / out, "--overwrite"}).code, 4) << out;
  }
  EXPECT_EQ(ReadFile(folder_ / "scene/tile.ply").value(), tile);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "scene/new.ply"));
  std::filesystem::create_directory(folder_ / "out");
  const Ended ended = Run({"aggregate", folder_ / "scene", "--out", folder_ / "out/all.ply"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/all.ply"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {}), 1) << "the output alone";
}

TEST_F(CommandTest, AggregateEndsWith100WhereBoundaryEdgesFormNoLoop) {
  MakeScene({"1 1 0", "9 1 0", "1 9 0", "1 5 3", "9 9 0"}, {"0 1 2", "0 1 3", "0 1 4"});  // three at one edge
  const Ended ended = Run({"aggregate", folder_ / "scene", "--out", folder_ / "all.ply"});
  EXPECT_EQ(ended.code, 100) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("form no loop"));
}

TEST_F(CommandTest, UnknownWordsGetASuggestion) {
  Ended ended = Run({"submitt"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("did you mean submit?"));
  ended = Run({"run", "x", "--overwrit"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("did you mean --overwrite?"));
  EXPECT_THAT(ended.out, IsEmpty());
}

TEST_F(CommandTest, HelpAndVersionAreData) {
  EXPECT_THAT(Run({"--version"}).out, HasSubstr("tilemend "));
  EXPECT_THAT(Run({"help"}).out, HasSubstr("submit"));
  EXPECT_THAT(Run({"help", "run"}).out, HasSubstr("--workers"));
  EXPECT_EQ(Run({"run", "--help"}).code, 0);
  EXPECT_EQ(Run({"run", "--version"}).out, Run({"--version"}).out);
}

TEST_F(CommandTest, AJobThatNeverBeganPrintsItsErrorOnce) {
  const Ended ended = Run({"run", "no-such-scene", "--out", folder_ / "out"});
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_THAT(ended.err, HasSubstr("no-such-scene: no such scene"));
  const Ended json = Run({"run", "no-such-scene", "--out", folder_ / "out", "-o", "json"});
  EXPECT_TRUE(nlohmann::json::parse(json.out, nullptr, false).is_object()) << json.out;
}

TEST_F(CommandTest, WrongPathsAreCalledWhatTheyAre) {
  Ended ended = Run({"inspect", folder_ / "a.stl"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("a.stl: no such file or folder"));
  ended = Run({"fill", folder_.path().string(), "--out", folder_ / "x.ply"});
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, HasSubstr("is a folder; `tilemend run`"));
}

TEST_F(CommandTest, FillAndRunTellTheSameOfTheirFlags) {
  for (const char* command : {"run", "fill"}) {
    const std::string help = Run({"help", command}).out;
    EXPECT_THAT(help, HasSubstr("1 to 10"));
    EXPECT_THAT(help, HasSubstr("1 to 1e6"));
    EXPECT_THAT(help, HasSubstr("auto: from the rim"));
  }
}

TEST_F(CommandTest, CtrlCCancelsARunAndLeavesNothing) {
  Process process(folder_.path().string(), TOY_CLIENT,
                  {"run", "toy://20x20?sleep_ms=10000", "--out", folder_ / "out", "--work", folder_ / "work"});
  process.AwaitLine("look at the tiles");
  process.Signal(SIGINT);
  const Ended ended = process.Wait();
  EXPECT_EQ(ended.code, 7) << ended.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "work"));
}

// An output that takes a minute: the edges of its hole are short, and stay so inside.
TEST_F(CommandTest, CtrlCEndsAFillAndLeavesNothing) {
  std::string ring = "OFF\n8000 8000 0\n";
  for (int i = 0; i < 4000; ++i) {
    const double angle = i * (2 * 3.14159265358979 / 4000);
    absl::StrAppend(&ring, std::cos(angle), " ", std::sin(angle), " 0\n", 1.1 * std::cos(angle), " ",
                    1.1 * std::sin(angle), " 0\n");
  }
  for (int i = 0; i < 4000; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % 4000);
    absl::StrAppend(&ring, "3 ", a, " ", a + 1, " ", b, "\n3 ", b, " ", a + 1, " ", b + 1, "\n");
  }
  ASSERT_TRUE(WriteFileAtomically(folder_ / "ring.off", ring).ok());
  Process process(folder_.path().string(), TOY_CLIENT,
                  {"fill", folder_ / "ring.off", "--out", folder_ / "new/filled.off", "--uniform"});
  ASSERT_TRUE(Await([&] { return std::filesystem::exists(folder_ / "new/.filled.off.tilemend-lock"); }));
  process.Signal(SIGINT);
  const Ended ended = process.Wait();
  EXPECT_EQ(ended.code, 7) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("cancelled; nothing was written"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "new"));
}

TEST_F(CommandTest, WhatIsPrintedOfAReportIsPrintable) {
  ASSERT_TRUE(WriteFileAtomically(folder_ / "out/report.json",
                                  R"({"version": "0.1.0", "cells": 4, "warnings": ["a\u001b[31mb"], "scene": "\u001bc",
                                      "borders": {"\u001b[2J": 3}})")
                  .ok());
  EXPECT_THAT(Run({"report", folder_ / "out"}).out, Not(HasSubstr("\033")));
}

TEST_F(CommandTest, WhatCannotBePrintedIsAnError) {
  ASSERT_TRUE(WriteFileAtomically(folder_ / "out/report.json", R"({"version": "0.1.0", "cells": 4})").ok());
  const auto run_in_shell = [&](const std::string& words, const char* redirection) {
    return Process(folder_.path().string(), "/bin/sh", {"-c", absl::StrCat(TOY_CLIENT, " ", words, redirection)})
        .Wait();
  };
  const std::string report = absl::StrCat("report ", folder_ / "out");
  for (const std::string& words : {report, std::string("--version"), std::string("--help"), std::string("help run")}) {
    const Ended full = run_in_shell(words, " > /dev/full");
    EXPECT_EQ(full.code, 5) << words;
    EXPECT_THAT(full.err, HasSubstr("standard output: cannot write")) << words;
  }
  EXPECT_NE(run_in_shell("--describe bash", " > /dev/full").code, 0);
  EXPECT_EQ(run_in_shell(report, " >&-").code, 0);
}

TEST_F(CommandTest, ReportShowsTheReportOfAnOutput) {
  ASSERT_TRUE(WriteFileAtomically(folder_ / "out/report.json",
                                  R"({"version": "0.1.0", "cells": 4, "warnings": ["mind the gap"]})")
                  .ok());
  const Ended ended = Run({"report", folder_ / "out"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("\n1 warning\n  mind the gap\n"));
  ASSERT_TRUE(WriteFileAtomically(folder_ / "out/report.json", "[").ok());
  EXPECT_EQ(Run({"report", folder_ / "out"}).code, 4);
}

TEST_F(CommandTest, ReportMakesThePageOfReportJsonAlone) {
  for (const char* name : {"out/report.json", "out/old.json"}) {
    ASSERT_TRUE(WriteFileAtomically(folder_ / name, R"({"version": "0.1.0", "cells": 4})").ok());
  }
  EXPECT_EQ(Run({"report", folder_ / "out/old.json"}).code, 0);
  const Ended ended = Run({"report", folder_ / "out/old.json", "--html"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("old.json; give the folder, or leave --html out"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/report.html"));
}

TEST_F(CommandTest, ReportSaysWhereThePageIsAndPrintsNoText) {
  const std::string text = R"({"version": "0.1.0", "cells": 4, "warnings": ["mind the gap"]})";
  ASSERT_TRUE(WriteFileAtomically(folder_ / "out/report.json", text).ok());
  const Ended ended = Run({"report", folder_ / "out", "--html"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(ended.err, absl::StrCat("tilemend: wrote ", folder_ / "out/report.html", "\n"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/report.html"));
  EXPECT_EQ(Run({"report", folder_ / "out", "--html", "-o", "json"}).out, text);
}

// A cluster of processes: the programs as they are installed, but for the geometry.
class ClusterCommandTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    if (IsSkipped()) return;
    ClusterOptions options;
    options.build = BuildId();
    options.listen = "127.0.0.1:0";
    cluster_ = std::make_unique<TestCluster>(options);
    address_ = absl::StrCat("127.0.0.1:", cluster_->rpc().port());
  }
  Ended RunWith(std::vector<std::string> words) {
    words.emplace_back("--coordinator");
    words.push_back(address_);
    return Run(words);
  }

  std::unique_ptr<TestCluster> cluster_;
  std::string address_;
};

TEST_F(ClusterCommandTest, SubmitWaitGetListWatch) {
  Process worker(folder_.path().string(), TOY_WORKER, {"--coordinator", address_, "--threads", "2"});
  const Ended submitted = RunWith({"submit", "toy://4x3", "--out", folder_ / "out", "--wait", "-o", "json"});
  EXPECT_EQ(submitted.code, 0) << submitted.err;
  const std::string name = nlohmann::json::parse(submitted.out)["name"];
  EXPECT_THAT(RunWith({"get", name}).out, HasSubstr("done"));
  EXPECT_THAT(RunWith({"get", name.substr(5)}).out, HasSubstr("done"));
  EXPECT_THAT(RunWith({"list"}).out, HasSubstr(name));
  EXPECT_EQ(RunWith({"watch", name}).code, 0);
  EXPECT_EQ(RunWith({"get", "none"}).code, 3);
  EXPECT_EQ(RunWith({"get", "jobs/"}).code, 4);  // the beginning of every name
  EXPECT_EQ(RunWith({"cancel", name}).code, 6);
  const Ended again = RunWith({"retry", name, "--wait", "--overwrite"});
  EXPECT_EQ(again.code, 0) << again.err;
  worker.Signal(SIGTERM);
  EXPECT_EQ(worker.Wait().code, 0);
}

TEST_F(ClusterCommandTest, ARepeatedRequestIdGivesTheSameJob) {
  const std::vector<std::string> words = {"submit",       "toy://2x2", "--out", folder_ / "out",
                                          "--request-id", "r",         "-o",    "json"};
  const auto first = nlohmann::json::parse(RunWith(words).out);
  EXPECT_EQ(nlohmann::json::parse(RunWith(words).out)["name"], first["name"]);
}

TEST_F(ClusterCommandTest, ARequestThatHasANameWaitsForACoordinatorThatStartsAgain) {
  cluster_.reset();
  Process submit(folder_.path().string(), TOY_CLIENT,
                 {"submit", "toy://2x2", "--out", folder_ / "out", "--request-id", "r", "--coordinator", address_});
  absl::SleepFor(absl::Seconds(3));  // without a name it has given up by now
  ClusterOptions options;
  options.listen = address_;
  cluster_ = std::make_unique<TestCluster>(options);
  const Ended submitted = submit.Wait();
  EXPECT_EQ(submitted.code, 0) << submitted.err;
}

TEST_F(ClusterCommandTest, AJobThatIsNotWaitedForNamesTheNextCommand) {
  const Ended submitted = RunWith({"submit", "toy://2x2", "--out", folder_ / "out"});
  EXPECT_EQ(submitted.code, 0) << submitted.err;
  EXPECT_THAT(submitted.out, HasSubstr("follow it: tilemend watch jobs/"));
  EXPECT_THAT(submitted.out, HasSubstr(" --coordinator " + address_ + "\n"));
}

TEST_F(ClusterCommandTest, JobsArePausedResumedAndPrioritized) {
  const auto job = nlohmann::json::parse(
      RunWith({"submit", "toy://2x2", "--out", folder_ / "out", "--priority", "-4", "-o", "json"}).out);
  EXPECT_EQ(job["priority"], -4);
  EXPECT_THAT(RunWith({"pause", job["name"]}).out, HasSubstr("it is paused"));
  EXPECT_THAT(RunWith({"list"}).out, HasSubstr("  paused  "));
  EXPECT_TRUE(cluster_->Get(job["name"]).paused());
  EXPECT_EQ(RunWith({"resume", job["name"]}).code, 0);
  EXPECT_FALSE(cluster_->Get(job["name"]).paused());
  EXPECT_EQ(nlohmann::json::parse(RunWith({"prioritize", job["name"], "9", "-o", "json"}).out)["priority"], 9);
  EXPECT_EQ(RunWith({"prioritize", job["name"], "101"}).code, 2);
  EXPECT_EQ(RunWith({"submit", "toy://2x2", "--out", folder_ / "high", "--priority", "-101"}).code, 2);
  EXPECT_EQ(RunWith({"prioritize", job["name"], "high"}).code, 2);
}

TEST_F(ClusterCommandTest, CancelledWatchEndsWithSeven) {
  const auto job = nlohmann::json::parse(RunWith({"submit", "toy://2x2", "--out", folder_ / "out", "-o", "json"}).out);
  Process watch(folder_.path().string(), TOY_CLIENT, {"watch", job["name"], "--coordinator", address_});
  watch.AwaitLine("look at the tiles");
  EXPECT_EQ(RunWith({"cancel", job["name"]}).code, 0);
  EXPECT_EQ(watch.Wait().code, 7);
}

TEST_F(ClusterCommandTest, WatchingAJobThatIsOverNamesNoStep) {
  const auto job = nlohmann::json::parse(RunWith({"submit", "toy://2x2", "--out", folder_ / "out", "-o", "json"}).out);
  const std::string name = job["name"];
  EXPECT_EQ(RunWith({"cancel", name}).code, 0);
  const Ended ended = RunWith({"watch", name});
  EXPECT_EQ(ended.code, 7);
  EXPECT_THAT(ended.err, Not(HasSubstr(name + ": ")));
}

TEST_F(ClusterCommandTest, CtrlCEndsTheWatchingNotTheJob) {
  const auto job = nlohmann::json::parse(RunWith({"submit", "toy://2x2", "--out", folder_ / "out", "-o", "json"}).out);
  Process watch(folder_.path().string(), TOY_CLIENT, {"watch", job["name"], "--coordinator", address_});
  watch.AwaitLine("look at the tiles");
  watch.Signal(SIGINT);
  const Ended ended = watch.Wait();
  EXPECT_EQ(ended.code, 7);
  EXPECT_THAT(ended.err, HasSubstr("goes on"));
  EXPECT_EQ(cluster_->Get(job["name"]).state(), v1::RUNNING);
}

TEST_F(ClusterCommandTest, AWorkerOfAnotherBuildEndsAndSaysSo) {
  ClusterOptions options;
  options.listen = "127.0.0.1:0";
  options.build = "another";
  TestCluster other(options);
  const Ended ended =
      Process(folder_.path().string(), TOY_WORKER, {"--coordinator", absl::StrCat("127.0.0.1:", other.rpc().port())})
          .Wait();
  EXPECT_EQ(ended.code, 6);
  EXPECT_THAT(ended.err, HasSubstr(absl::StrCat("is of build ", BuildId())));
  EXPECT_THAT(ended.err, HasSubstr("this coordinator of another"));
  EXPECT_THAT(ended.err, HasSubstr("use programs of the same build"));
}

TEST_F(CommandTest, TheCoordinatorServesUntilItIsTold) {
  Process coordinator(
      folder_.path().string(), TOY_COORDINATOR,
      {"--listen", "127.0.0.1:0", "--work", folder_ / "work", "--metrics", "127.0.0.1:0", "--log", "text"});
  coordinator.AwaitLine("listening address=127.0.0.1:");
  coordinator.Signal(SIGTERM);
  EXPECT_EQ(coordinator.Wait().code, 0);
  EXPECT_EQ(Process(folder_.path().string(), TOY_COORDINATOR, {"--listen", "nowhere", "--work", folder_ / "work"})
                .Wait()
                .code,
            2);
  EXPECT_EQ(Process(folder_.path().string(), TOY_COORDINATOR, {}).Wait().code, 2);
  EXPECT_EQ(Process(folder_.path().string(), TOY_WORKER, {"--threads", "0"}).Wait().code, 2);
}

}  // namespace
}  // namespace tilemend
