#include "tests/support/direct_link.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "common/rpc/limits.h"
#include "common/util/status_macros.h"
#include "tests/support/waiting_sync.h"

namespace tilemend {
namespace {

// One call, shared by the side that waits (and may go away) and the side that serves it.
struct Exchange {
  std::mutex mutex;
  std::condition_variable changed;
  bool interrupted = false;
  std::optional<absl::StatusOr<v1::SyncResponse>> response;
};

// The threads that serve calls, joined with the link: as a server goes on with a call whose client is gone.
class Servers {
 public:
  ~Servers() {
    for (std::thread& thread : threads_) thread.join();
  }
  void Add(std::thread thread) {
    std::lock_guard<std::mutex> lock(mutex_);
    threads_.push_back(std::move(thread));
  }

 private:
  std::mutex mutex_;
  std::vector<std::thread> threads_;
};

class DirectSyncCall : public SyncCall {
 public:
  DirectSyncCall(Coordinator& coordinator, Servers& servers) : coordinator_(coordinator), servers_(servers) {}

  absl::StatusOr<v1::SyncResponse> Run(const v1::SyncRequest& request) override {
    servers_.Add(std::thread([&coordinator = coordinator_, exchange = exchange_, request] {
      const auto alive = [&exchange] {
        std::lock_guard<std::mutex> lock(exchange->mutex);
        return !exchange->interrupted;
      };
      auto response = SyncAndWait(coordinator.calls().work, request, alive);
      std::lock_guard<std::mutex> lock(exchange->mutex);
      exchange->response = std::move(response);
      exchange->changed.notify_all();
    }));
    std::unique_lock<std::mutex> lock(exchange_->mutex);
    exchange_->changed.wait(lock, [this] { return exchange_->interrupted || exchange_->response.has_value(); });
    if (exchange_->interrupted) return absl::CancelledError("interrupted");
    return *std::move(exchange_->response);
  }

  void Interrupt() override {
    std::lock_guard<std::mutex> lock(exchange_->mutex);
    exchange_->interrupted = true;
    exchange_->changed.notify_all();
  }

 private:
  Coordinator& coordinator_;
  Servers& servers_;
  const std::shared_ptr<Exchange> exchange_ = std::make_shared<Exchange>();
};

class DirectLink : public WorkLink {
 public:
  explicit DirectLink(Coordinator& coordinator) : coordinator_(coordinator) {}

  std::unique_ptr<SyncCall> NewSync() override { return std::make_unique<DirectSyncCall>(coordinator_, servers_); }

  absl::StatusOr<std::string> ReadBlob(const std::string& job, const std::string& digest) override {
    v1::ReadBlobRequest request;
    request.set_job(job);
    request.set_digest(digest);
    std::string bytes;
    TILEMEND_RETURN_IF_ERROR(coordinator_.calls().blobs.ReadBlob(request, [&bytes](std::string_view chunk) {
      bytes.append(chunk);
      return true;
    }));
    return bytes;
  }

  absl::Status WriteBlob(const v1::TaskRef& attempt, const std::string& worker, const std::string& digest,
                         const std::string& bytes) override {
    size_t position = 0;
    bool first = true;
    const auto next = [&](v1::WriteBlobRequest& message) {
      if (!first && position >= bytes.size()) return false;
      first = false;
      *message.mutable_attempt() = attempt;
      message.set_worker(worker);
      message.set_digest(digest);
      message.set_data(bytes.substr(position, kMaxChunkBytes));
      position += kMaxChunkBytes;
      return true;
    };
    return coordinator_.calls().blobs.WriteBlob(next).status();
  }

 private:
  Coordinator& coordinator_;
  Servers servers_;
};

}  // namespace

std::unique_ptr<WorkLink> NewDirectLink(Coordinator& coordinator) { return std::make_unique<DirectLink>(coordinator); }

}  // namespace tilemend
