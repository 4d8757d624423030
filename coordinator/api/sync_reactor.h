// A worker's call over gRPC, by its callback API: no thread waits for it.
#ifndef TILEMEND_COORDINATOR_API_SYNC_REACTOR_H_
#define TILEMEND_COORDINATOR_API_SYNC_REACTOR_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "common/rpc/answer_limit.h"
#include "common/rpc/grpc_status.h"
#include "coordinator/api/guarded_calls.h"
#include "coordinator/api/work_handler.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

// Deletes itself when gRPC is done with the call.
class SyncReactor : public grpc::ServerUnaryReactor {
 public:
  // All must outlive the call.
  SyncReactor(const Entrance& entrance, WorkHandler& work, const grpc::CallbackServerContext& context,
              v1::SyncResponse& response)
      : entrance_(entrance), work_(work), context_(context), response_(response) {}

  // Takes what is in `request`, which may have 1 MB: gRPC keeps it until the call has ended, and reads it no more.
  void Begin(const Peer& peer, v1::SyncRequest& request) {
    worker_ = request.worker();
    const auto caller = entrance_.Begin(peer, kRpc);
    if (!caller.ok()) return Answer(caller.status());
    const auto alive = [gone = gone_] { return !*gone; };
    const auto answer = [this](absl::StatusOr<v1::SyncResponse> response) { Answer(std::move(response)); };
    sync_ = std::make_shared<WorkerSync>(WorkerSync{std::move(request), caller->name, alive, answer});
    work_.Sync(sync_);
  }

 private:
  static constexpr char kRpc[] = "tilemend.v1.Work/Sync";

  void Answer(absl::StatusOr<v1::SyncResponse> response) {
    entrance_.End(kRpc, response.status(), begin_);
    answering_.emplace(context_);
    Finish(Reply(std::move(response), &response_));
  }

  void OnCancel() override {
    *gone_ = true;
    work_.Gone(worker_);
  }
  void OnDone() override { delete this; }

  const Entrance& entrance_;
  WorkHandler& work_;
  const grpc::CallbackServerContext& context_;
  v1::SyncResponse& response_;
  const absl::Time begin_ = absl::Now();
  std::string worker_;
  std::shared_ptr<WorkerSync> sync_;  // counts as a call until gRPC is done with it
  const std::shared_ptr<std::atomic<bool>> gone_ = std::make_shared<std::atomic<bool>>(false);
  std::optional<Answering> answering_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_SYNC_REACTOR_H_
