// A coordinator that does what a test says, as a worker sees it.
#ifndef TILEMEND_TESTS_WORKER_SERVICE_FAKE_LINK_H_
#define TILEMEND_TESTS_WORKER_SERVICE_FAKE_LINK_H_

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "worker/service/work_link.h"

namespace tilemend {

// Calls of Sync wait until they are answered or interrupted. Shared by the links of one worker and the test.
class FakeCoordinator {
 public:
  using Condition = std::function<bool(const v1::SyncRequest&)>;

  // Waits for a call whose request meets `condition`, answers it and returns the request. Calls before it that do not
  // are left waiting: the worker interrupts them when it has something to tell.
  v1::SyncRequest Answer(absl::StatusOr<v1::SyncResponse> response, const Condition& condition = {}) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return waiting_ && !answer_ && (!condition || condition(*waiting_)); });
    answer_ = std::move(response);
    changed_.notify_all();
    return *waiting_;
  }

  void PutBlob(const std::string& digest, const std::string& bytes) {
    std::lock_guard<std::mutex> lock(mutex_);
    blobs_[digest] = bytes;
  }
  std::string Blob(const std::string& digest) {
    std::lock_guard<std::mutex> lock(mutex_);
    return blobs_[digest];
  }
  // The next `times`; 0: all.
  void FailWrites(absl::Status status, int times = 0) {
    std::lock_guard<std::mutex> lock(mutex_);
    write_status_ = std::move(status);
    failing_writes_ = times;
  }

  std::unique_ptr<WorkLink> NewLink() { return std::make_unique<Link>(*this); }

 private:
  class Call : public SyncCall {
   public:
    explicit Call(FakeCoordinator& owner) : owner_(owner) {}
    absl::StatusOr<v1::SyncResponse> Run(const v1::SyncRequest& request) override {
      std::unique_lock<std::mutex> lock(owner_.mutex_);
      owner_.waiting_ = request;
      owner_.answer_.reset();
      owner_.changed_.notify_all();
      owner_.changed_.wait(lock, [this] { return interrupted_ || owner_.answer_; });
      owner_.waiting_.reset();
      if (!owner_.answer_) return absl::CancelledError("interrupted");
      return *std::exchange(owner_.answer_, std::nullopt);
    }
    void Interrupt() override {
      std::lock_guard<std::mutex> lock(owner_.mutex_);
      interrupted_ = true;
      owner_.changed_.notify_all();
    }

   private:
    FakeCoordinator& owner_;
    bool interrupted_ = false;
  };

  class Link : public WorkLink {
   public:
    explicit Link(FakeCoordinator& owner) : owner_(owner) {}
    std::unique_ptr<SyncCall> NewSync() override { return std::make_unique<Call>(owner_); }
    absl::StatusOr<std::string> ReadBlob(const std::string& /*job*/, const std::string& digest) override {
      std::lock_guard<std::mutex> lock(owner_.mutex_);
      const auto blob = owner_.blobs_.find(digest);
      if (blob == owner_.blobs_.end()) return absl::NotFoundError("no such blob");
      return blob->second;
    }
    absl::Status WriteBlob(const v1::TaskRef& /*attempt*/, const std::string& /*worker*/, const std::string& digest,
                           const std::string& bytes) override {
      std::lock_guard<std::mutex> lock(owner_.mutex_);
      if (owner_.write_status_.ok()) owner_.blobs_[digest] = bytes;
      const absl::Status status = owner_.write_status_;
      if (owner_.failing_writes_ > 0 && --owner_.failing_writes_ == 0) owner_.write_status_ = absl::OkStatus();
      return status;
    }

   private:
    FakeCoordinator& owner_;
  };

  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<v1::SyncRequest> waiting_;
  std::optional<absl::StatusOr<v1::SyncResponse>> answer_;
  std::map<std::string, std::string> blobs_;
  absl::Status write_status_;
  int failing_writes_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_WORKER_SERVICE_FAKE_LINK_H_
