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
  // Gives up on a coordinator that cannot be reached for `patience` (kUnavailable); a watch waits ten minutes, in which
  // the coordinator may start again, where it has been under way or a call has succeeded, unless `patience` is 0.
  JobClient(const std::shared_ptr<grpc::Channel>& channel, absl::Duration patience);
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
  // From another thread.
  void StopWatch();

 private:
  class Impl;
  absl::Status WatchOnce(v1::WatchJobRequest& request, const std::function<void(const v1::Job&)>& show, v1::Job& last);

  const std::unique_ptr<Impl> impl_;
  const absl::Duration patience_;
  std::mutex mutex_;
  bool stopped_ = false;
  grpc::ClientContext* watch_context_ = nullptr;
};

// The name of the job that `argument` means: a name, an id or the beginning of an id that no other job has.
// kInvalidArgument if several have it, or if it is empty. Else the name as it was given, for the coordinator to refuse.
absl::StatusOr<std::string> FindJobName(JobClient& client, const std::string& argument);

// "jobs/X" for "X" and "jobs/X".
std::string JobName(const std::string& argument);

bool IsOver(v1::JobState state);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_JOB_CLIENT_H_
