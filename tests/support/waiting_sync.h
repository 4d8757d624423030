// A call of a worker that its caller waits for.
#ifndef TILEMEND_TESTS_SUPPORT_WAITING_SYNC_H_
#define TILEMEND_TESTS_SUPPORT_WAITING_SYNC_H_

#include <functional>
#include <future>
#include <memory>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "coordinator/api/work_handler.h"

namespace tilemend {

inline absl::StatusOr<v1::SyncResponse> SyncAndWait(
    WorkHandler& work, const v1::SyncRequest& request, const std::function<bool()>& alive = [] { return true; },
    const std::string& identity = "") {
  const auto answer = std::make_shared<std::promise<absl::StatusOr<v1::SyncResponse>>>();
  work.Sync(std::make_shared<WorkerSync>(
      WorkerSync{request, identity, alive,
                 [answer](absl::StatusOr<v1::SyncResponse> told) { answer->set_value(std::move(told)); }}));
  return answer->get_future().get();
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_WAITING_SYNC_H_
