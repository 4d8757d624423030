// The client API of a coordinator, for the commands.
#ifndef TILEMEND_CLIENT_JOB_CLIENT_H_
#define TILEMEND_CLIENT_JOB_CLIENT_H_

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "tilemend/v1/jobs.pb.h"

namespace grpc {
class Channel;
class ClientContext;
}  // namespace grpc

namespace tilemend {

// Thread-safe, except that one Watch goes at a time.
class JobClient {
 public:
  struct Patience {
    absl::Duration of_calls;  // how long a call is repeated while the coordinator cannot be reached
    // As long as that a watch waits for a coordinator that was never reached. One that was is waited for ten minutes,
    // in which it may start again, unless `of_calls` is 0.
    std::function<void(const absl::Status&)> on_wait = nullptr;  // told once, when a call is first repeated
    std::string hint = {};  // what may be wrong if the coordinator cannot be reached
  };

  // Gives up on a coordinator that cannot be reached when its patience is over: kUnavailable.
  JobClient(const std::shared_ptr<grpc::Channel>& channel, Patience patience);
  JobClient(const std::shared_ptr<grpc::Channel>& channel, absl::Duration patience)
      : JobClient(channel, Patience{patience}) {}
  ~JobClient();

  // With a request_id, safe to repeat; it is repeated while the coordinator cannot be reached.
  absl::StatusOr<v1::Job> Create(const v1::CreateJobRequest& request);
  absl::StatusOr<v1::Job> Get(const std::string& name);
  absl::StatusOr<v1::ListJobsResponse> List(const v1::ListJobsRequest& request);
  absl::StatusOr<v1::ListWorkersResponse> ListWorkers(const v1::ListWorkersRequest& request);
  absl::StatusOr<v1::Job> Cancel(const std::string& name);
  absl::StatusOr<v1::Job> Pause(const std::string& name);
  absl::StatusOr<v1::Job> Resume(const std::string& name);
  absl::StatusOr<v1::Job> Prioritize(const std::string& name, int32_t priority);
  absl::StatusOr<v1::Job> Retry(const v1::RetryJobRequest& request);

  // Calls `show` with each state of the job until it is over, and gives the last. Connects again, with the cursor, when
  // the stream is lost. kCancelled after StopWatch.
  absl::StatusOr<v1::Job> Watch(const std::string& name, const std::function<void(const v1::Job&)>& show);
  // From another thread. Calls that are being repeated end with kCancelled as well.
  void StopWatch();

 private:
  class Impl;
  absl::Status WatchOnce(v1::WatchJobRequest& request, const std::function<void(const v1::Job&)>& show, v1::Job& last);

  const std::unique_ptr<Impl> impl_;
  std::mutex mutex_;
  grpc::ClientContext* watch_context_ = nullptr;
};

// The name of the job that `argument` means: a name, an id, or the beginning of an id that no other job has.
// Returns kInvalidArgument if several jobs have it, or if it is empty. A name of no job is returned as it is, for the
// coordinator to refuse.
absl::StatusOr<std::string> FindJobName(JobClient& client, const std::string& argument);

// "jobs/X" for "X" and "jobs/X".
std::string JobName(const std::string& argument);

bool IsOver(v1::JobState state);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_JOB_CLIENT_H_
