// A job that changes an earlier output, and begins again since a worker lied: its own wrong tile was in its way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <tuple>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/rpc/receipt_payloads.h"
#include "common/util/files.h"
#include "tests/integration/worker_lies.h"
#include "tests/support/postgres_server.h"
#include "tests/support/untrusted_workers.h"

namespace tilemend {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

// Writes something else than it reports to the first tile that is new or changed. Tells that when it may go on.
class LiarOnce {
 public:
  StageRunner Runner() {
    return [this, run = SceneStageRunner()](Stage stage, const std::string& input, const CancelToken& cancel) {
      while (stage == Stage::kVerify && !cancel.cancelled()) absl::SleepFor(absl::Milliseconds(1));
      auto result = run(stage, input, cancel);
      if (stage == Stage::kAssemble && result.ok() && !has_lied_ && Spoil(input, *result)) {
        has_lied_ = true;
        while (!may_go_on_ && !cancel.cancelled()) absl::SleepFor(absl::Milliseconds(1));
      }
      return result;
    };
  }
  bool has_lied() const { return has_lied_; }
  void GoOn() { may_go_on_ = true; }

 private:
  static bool Spoil(const std::string& asked, std::string& told) {
    v1::AssembleInput input;
    Tile tile;
    if (!input.ParseFromString(asked) || !tile.ParseFromString(told) || tile.unchanged()) return false;
    const auto there = ReadFile(input.output_root() + "/" + tile.files(0).path());
    const std::string path = WrittenPath(input, tile);
    std::string bytes = ReadFile(path).value();
    if (there.ok() && *there == bytes) return false;
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    if (!WriteFileAtomically(path, bytes).ok()) return false;
    *tile.mutable_files(0)->mutable_receipt() = ToProto(ReceiptOf(path).value());
    told = tile.SerializeAsString();
    return true;
  }

  std::atomic<bool> has_lied_{false}, may_go_on_{false};
};

enum class JournalKind { kSqlite, kPostgres };

// Whether the coordinator starts again between the lie and its discovery, and where its journal is.
class OwnWrongTilesTest : public UntrustedWorkerTest,
                          public ::testing::WithParamInterface<std::tuple<bool, JournalKind>> {
 protected:
  OwnWrongTilesTest() : UntrustedWorkerTest(WithoutReading()) {}
  static void TearDownTestSuite() { server_.reset(); }
  void SetUp() override {
    if (is_with_postgres() && server_ == nullptr) GTEST_SKIP() << "PostgreSQL is not installed";
  }
  static bool restarts() { return std::get<0>(GetParam()); }
  static bool is_with_postgres() { return std::get<1>(GetParam()) == JournalKind::kPostgres; }
  static ClusterOptions WithoutReading() {
    // An empty one for each test.
    if (is_with_postgres() && !PostgresServer::Programs().empty()) server_ = std::make_unique<PostgresServer>();
    ClusterOptions options = Options();
    options.check_result = SceneResultCheck(TileCheck::kSize);
    options.durable = true;
    if (is_with_postgres() && server_ != nullptr) options.postgres = server_->where();
    return options;
  }
  v1::JobSpec SpecOf(const std::string& out, const std::string& cells) const {
    v1::JobSpec spec;
    spec.set_scene(scene_);
    spec.set_out(out);
    spec.set_cells(cells);
    return spec;
  }
  std::string Submit(const v1::JobSpec& spec) {
    v1::CreateJobRequest request;
    *request.mutable_spec() = spec;
    const auto job = cluster_.coordinator().calls().jobs.CreateJob(request);
    EXPECT_TRUE(job.ok()) << job.status();
    return job.ok() ? job->name() : "";
  }
  v1::Job Run(const v1::JobSpec& spec) {
    const std::string worker = absl::StrCat("honest", ++runs_);
    cluster_.AddWorker(worker, 2, SceneStageRunner());
    v1::Job job = cluster_.WaitFor(Submit(spec));
    cluster_.KillWorker(worker);
    return job;
  }
  v1::Job RunWithLiar(const v1::JobSpec& spec) {
    LiarOnce liar;
    cluster_.AddWorker("liar", 1, liar.Runner());
    const std::string name = Submit(spec);
    const auto is_running = [&] { return cluster_.Get(name).state() == v1::RUNNING; };
    while (is_running() && !liar.has_lied()) absl::SleepFor(absl::Milliseconds(1));
    if (!restarts()) cluster_.AddWorker("good", 2, SceneStageRunner());
    liar.GoOn();
    if (restarts()) {
      while (is_running() && cluster_.Get(name).progress().phase() != "verify") absl::SleepFor(absl::Milliseconds(1));
      cluster_.Restart();
      cluster_.AddWorker("good", 2, SceneStageRunner());
    }
    return cluster_.WaitFor(name);
  }
  void ExpectCaught(const v1::Job& job) {
    EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
    EXPECT_THAT(job.warnings(), Contains(HasSubstr("worker liar wrote something else than it reported to")));
  }

 private:
  static std::unique_ptr<PostgresServer> server_;
  int runs_ = 0;
};

std::unique_ptr<PostgresServer> OwnWrongTilesTest::server_;

TEST_P(OwnWrongTilesTest, OfCellsThatAreAddedAreReplaced) {
  const auto undisturbed = Undisturbed();
  const std::string out = cluster_.folder() / "added";
  ASSERT_EQ(Run(SpecOf(out, "0,0-1,2")).state(), v1::DONE);
  ExpectCaught(RunWithLiar(SpecOf(out, "2,0-3,2")));
  EXPECT_TRUE(TilesBelow(out) == undisturbed) << "other bytes";
}

TEST_P(OwnWrongTilesTest, OfDecisionsAreReplaced) {
  const std::string decisions = cluster_.folder() / "decisions.geojson";
  const char* const kOpen = R"({"type": "Feature", "properties": {"decision": "open"}, "geometry": {"type": "Polygon",
      "coordinates": [[[64, 4], [76, 4], [76, 16], [64, 16], [64, 4]]]}})";
  ASSERT_TRUE(WriteFileAtomically(decisions, kOpen).ok());
  v1::JobSpec honest = SpecOf(cluster_.folder() / "honest", ""), lied = SpecOf(cluster_.folder() / "lied", "");
  for (v1::JobSpec* spec : {&honest, &lied}) {
    ASSERT_EQ(Run(*spec).state(), v1::DONE);
    spec->set_decisions(decisions);
  }
  const auto before = TilesBelow(honest.out());
  Run(honest);
  ASSERT_FALSE(TilesBelow(honest.out()) == before) << "the decision has changed nothing";
  const v1::Job job = RunWithLiar(lied);
  EXPECT_THAT(job.warnings(), Contains(HasSubstr("worker liar wrote something else than it reported to")));
  EXPECT_TRUE(TilesBelow(lied.out()) == TilesBelow(honest.out())) << job.error().message();
}

// A file of somebody else stays, also where the job began again.
TEST_P(OwnWrongTilesTest, OfOthersStay) {
  const std::string out = cluster_.folder() / "added";
  const std::string mine = out + "/tiles/Tile_+003_+002.ply";
  ASSERT_EQ(Run(SpecOf(out, "0,0-1,2")).state(), v1::DONE);
  ASSERT_TRUE(WriteFileAtomically(mine, "mine").ok());
  const v1::Job job = RunWithLiar(SpecOf(out, "2,0-3,2"));
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_THAT(job.error().message(), HasSubstr(mine + ": is there from an earlier job"));
  EXPECT_EQ(ReadFile(mine).value(), "mine");
}

INSTANTIATE_TEST_SUITE_P(Restarts, OwnWrongTilesTest,
                         ::testing::Combine(::testing::Bool(),
                                            ::testing::Values(JournalKind::kSqlite, JournalKind::kPostgres)));

}  // namespace
}  // namespace tilemend
