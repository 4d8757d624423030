// Each watch and each worker held a thread of the coordinator, so that a few thousand of them could not be.
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/rpc/limits.h"
#include "tests/support/test_cluster.h"
#include "tilemend/v1/work.grpc.pb.h"

namespace tilemend {
namespace {

constexpr int kWatches = 2000, kWorkers = 1000;
constexpr int kChannels = 8;                           // a connection has 512 calls at once
constexpr int kMostThreads = 32, kMostNewThreads = 8;  // gRPC itself has more on many cores
constexpr int64_t kMostBytesOfCall = 1 << 20;          // on both sides

int Threads() { return static_cast<int>(std::distance(std::filesystem::directory_iterator("/proc/self/task"), {})); }

int64_t ResidentBytes() {
  int64_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

template <class Condition>
void Await(Condition condition) {
  while (!condition()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

class ClientWatch : public grpc::ClientReadReactor<v1::Job> {
 public:
  ClientWatch(v1::Jobs::Stub& stub, const std::string& name) {
    request_.set_name(name);
    stub.async()->WatchJob(&context_, &request_, this);
    StartRead(&job_);
    StartCall();
  }
  void OnReadDone(bool is_read) override {
    if (!is_read) return;
    last = job_.state();
    ++states;
    StartRead(&job_);
  }
  void OnDone(const grpc::Status& status) override {
    is_ok = status.ok();
    is_over = true;
  }

  std::atomic<int> states{0};
  std::atomic<v1::JobState> last{v1::JOB_STATE_UNSPECIFIED};
  std::atomic<bool> is_ok{false}, is_over{false};

 private:
  grpc::ClientContext context_;
  v1::WatchJobRequest request_;
  v1::Job job_;
};

// A worker that never begins what it gets.
class IdleWorker {
 public:
  IdleWorker(v1::Work::Stub& stub, int number, const std::atomic<bool>& ends) : stub_(stub), ends_(ends) {
    request_.set_protocol(kProtocolVersion);
    request_.set_worker(absl::StrCat("w", number));
    request_.set_threads(1);
    request_.set_wait_ms(1000);
  }
  void Call() {
    request_.set_sequence(request_.sequence() + 1);
    context_ = std::make_unique<grpc::ClientContext>();
    stub_.async()->Sync(context_.get(), &request_, &response_, [this](const grpc::Status& status) {
      if (!status.ok()) ++errors;
      ++answers;
      ends_ ? is_over.store(true) : Call();
    });
  }

  std::atomic<int> answers{0}, errors{0};
  std::atomic<bool> is_over{false};

 private:
  v1::Work::Stub& stub_;
  const std::atomic<bool>& ends_;
  std::unique_ptr<grpc::ClientContext> context_;
  v1::SyncRequest request_;
  v1::SyncResponse response_;
};

class ThreadOfEachCallTest : public ::testing::Test {
 protected:
  ThreadOfEachCallTest() {
    for (int i = 0; i < kChannels; ++i) {
      grpc::ChannelArguments own;
      own.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
      const auto channel = grpc::CreateCustomChannel(absl::StrCat("127.0.0.1:", cluster_.rpc().port()),
                                                     grpc::InsecureChannelCredentials(), own);
      jobs_.push_back(v1::Jobs::NewStub(channel));
      work_.push_back(v1::Work::NewStub(channel));
    }
    request_.set_name(cluster_.Submit("toy://1x1").name());
  }
  void StartCalls() {
    for (int i = 0; i < kWatches; ++i) watches_.emplace_back(*jobs_[i % kChannels], request_.name());
    for (int i = 0; i < kWorkers; ++i) workers_.emplace_back(*work_[i % kChannels], i, ends_).Call();
    Await([&] { return std::all_of(watches_.begin(), watches_.end(), [](auto& watch) { return watch.states > 0; }); });
    Await([&] { return std::all_of(workers_.begin(), workers_.end(), [](auto& one) { return one.answers > 1; }); });
  }
  // As `submit --wait` does it.
  double SecondsOfANewcomer() {
    const auto start = std::chrono::steady_clock::now();
    v1::Job job;
    grpc::ClientContext context;
    const grpc::Status status = jobs_[0]->GetJob(&context, request_, &job);
    EXPECT_TRUE(status.ok()) << status.error_message();
    ClientWatch& watch = watches_.emplace_back(*jobs_[1], request_.name());
    Await([&] { return watch.states > 0; });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  double SecondsOfACancellation() {
    const auto start = std::chrono::steady_clock::now();
    v1::CancelJobRequest cancel;
    cancel.set_name(request_.name());
    EXPECT_TRUE(cluster_.coordinator().calls().jobs.CancelJob(cancel).ok());
    Await([&] {
      return std::all_of(watches_.begin(), watches_.end(), [](auto& watch) { return watch.is_over.load(); });
    });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  void EndWorkers() {
    ends_ = true;
    Await([&] { return std::all_of(workers_.begin(), workers_.end(), [](auto& one) { return one.is_over.load(); }); });
  }

  static ClusterOptions Listening() {
    ClusterOptions options;
    options.listen = "127.0.0.1:0";
    return options;
  }
  std::deque<ClientWatch> watches_;
  std::deque<IdleWorker> workers_;
  std::atomic<bool> ends_{false};
  TestCluster cluster_{Listening()};
  std::vector<std::unique_ptr<v1::Jobs::Stub>> jobs_;
  std::vector<std::unique_ptr<v1::Work::Stub>> work_;
  v1::GetJobRequest request_;
};

TEST_F(ThreadOfEachCallTest, IsNotThereAnyMore) {
  const int64_t before = ResidentBytes();
  const int threads_before = Threads();
  StartCalls();
  const int threads = Threads();
  const int64_t bytes = (ResidentBytes() - before) / (kWatches + kWorkers);
  const double newcomer = SecondsOfANewcomer(), cancellation = SecondsOfACancellation();
  EndWorkers();
  std::cout << kWatches << " watches and " << kWorkers << " workers: " << threads << " threads (before "
            << threads_before << "), " << bytes << " bytes a call on both sides; a newcomer is told after " << newcomer
            << " s, an end to all after " << cancellation << " s\n";
  EXPECT_LE(threads, std::max(kMostThreads, threads_before + kMostNewThreads));
  EXPECT_LE(bytes, kMostBytesOfCall);
  for (const ClientWatch& watch : watches_) {
    EXPECT_TRUE(watch.is_ok);
    EXPECT_EQ(watch.last, v1::CANCELLED);
  }
  for (const IdleWorker& worker : workers_) EXPECT_EQ(worker.errors, 0);
}

}  // namespace
}  // namespace tilemend
