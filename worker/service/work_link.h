// The coordinator as a worker sees it.
#ifndef TILEMEND_WORKER_SERVICE_WORK_LINK_H_
#define TILEMEND_WORKER_SERVICE_WORK_LINK_H_

#include <memory>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "tilemend/v1/work.pb.h"

namespace grpc {
class Channel;
}

namespace tilemend {

// One call of Sync that can be interrupted from another thread, even before it has begun.
class SyncCall {
 public:
  virtual ~SyncCall() = default;
  // Once. kCancelled after Interrupt.
  virtual absl::StatusOr<v1::SyncResponse> Run(const v1::SyncRequest& request) = 0;
  virtual void Interrupt() = 0;
};

// Thread-safe. kUnavailable and kDeadlineExceeded mean that the coordinator could not be reached.
class WorkLink {
 public:
  virtual ~WorkLink() = default;
  virtual std::unique_ptr<SyncCall> NewSync() = 0;
  // The whole blob, checked against its digest: kUnavailable if it came damaged.
  virtual absl::StatusOr<std::string> ReadBlob(const std::string& job, const std::string& digest) = 0;
  // The output of an attempt that this worker holds.
  virtual absl::Status WriteBlob(const v1::TaskRef& attempt, const std::string& worker, const std::string& digest,
                                 const std::string& bytes) = 0;
};

// How long to wait before the next call, where the coordinator answered that it has no room for this one. None for any
// other status.
std::optional<absl::Duration> RetryAfter(const absl::Status& status);

std::unique_ptr<WorkLink> NewGrpcWorkLink(const std::shared_ptr<grpc::Channel>& channel);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_WORK_LINK_H_
