#include "coordinator/journal/group_commit.h"

#include <unistd.h>

#include <cstdio>
#include <string>
#include <utility>

#include "common/util/exit_codes.h"

namespace tilemend {
namespace {

constexpr std::chrono::milliseconds kIdle(500);  // without a put, before there is time for what can wait

}  // namespace

void EndForJournal(const absl::Status& status) {
  std::fprintf(stderr,
               "tilemend-coordinator: the journal cannot be written: %s; ending. Nobody was told of what is not in it. "
               "Start the coordinator again when the cause is mended: its jobs go on.\n",
               std::string(status.message()).c_str());
  std::fflush(stderr);
  ::_exit(kExitRetryable);
}

GroupCommit::GroupCommit(std::function<void(std::vector<JournalPut>)> commit, std::function<bool()> tidy)
    : commit_(std::move(commit)), tidy_(std::move(tidy)), writer_([this] { Write(); }) {}

GroupCommit::~GroupCommit() {
  {
    std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
    queued_.notify_all();
  }
  writer_.join();
}

void GroupCommit::Put(JournalPut put) {
  std::lock_guard<std::mutex> lock(mutex_);
  queue_.push_back(std::move(put));
  ++put_;
  queued_.notify_one();
}

void GroupCommit::Await() {
  std::unique_lock<std::mutex> lock(mutex_);
  committed_.wait(lock, [this, wanted = put_] { return durable_ >= wanted; });
}

void GroupCommit::Write() {
  const auto is_news = [this] { return ending_ || !queue_.empty(); };
  std::unique_lock<std::mutex> lock(mutex_);
  bool is_tidy = false;
  std::chrono::milliseconds pause = kIdle;
  while (true) {
    if (is_tidy) {
      queued_.wait(lock, is_news);
    } else if (!queued_.wait_for(lock, pause, is_news)) {
      lock.unlock();
      is_tidy = !tidy_();
      lock.lock();
      pause = std::chrono::milliseconds(0);
      continue;
    }
    if (queue_.empty()) return;
    std::vector<JournalPut> puts = std::exchange(queue_, {});
    const uint64_t until = put_;
    lock.unlock();
    commit_(std::move(puts));
    lock.lock();
    durable_ = until;
    is_tidy = false;
    pause = kIdle;
    committed_.notify_all();
  }
}

}  // namespace tilemend
