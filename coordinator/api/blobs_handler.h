// Calls of workers on blobs: inputs of tasks that they read, outputs that they write.
#ifndef TILEMEND_COORDINATOR_API_BLOBS_HANDLER_H_
#define TILEMEND_COORDINATOR_API_BLOBS_HANDLER_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "coordinator/api/long_calls.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/store/blob_folder.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

// Thread-safe.
class BlobsHandler {
 public:
  // `cluster` must outlive this.
  explicit BlobsHandler(Cluster& cluster) : cluster_(cluster) {}

  // `stop` makes a call that stands still, here and below, end: `send` and `next` then give false.
  absl::Status ReadBlob(
      const v1::ReadBlobRequest& request, const std::function<bool(std::string_view)>& send,
      const std::function<void()>& stop = [] {});
  // `next` gives the messages of the stream and false at its end.
  absl::StatusOr<v1::WriteBlobResponse> WriteBlob(
      const std::function<bool(v1::WriteBlobRequest&)>& next, const std::function<void()>& stop = [] {});

  // Ends streams that stand still or whose job is over, and forgets attempts that are over. With the lock held.
  void Tick(absl::Time now);

 private:
  struct Sent {
    TaskKey task;
    std::string worker;
    int64_t bytes = 0;
  };
  absl::StatusOr<std::shared_ptr<BlobFolder>> FindBlobs(const std::string& job);                // takes the lock
  absl::Status CountSent(const v1::TaskRef& attempt, const std::string& worker, size_t bytes);  // takes the lock
  void ForgetSent();                                                                            // with the lock held
  void StopIdleStreams(absl::Time now);                                                         // likewise

  Cluster& cluster_;
  std::map<uint64_t, Sent> sent_;  // in blobs of attempts, by their tokens
  LongCalls streams_{250};         // threads at most
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_BLOBS_HANDLER_H_
