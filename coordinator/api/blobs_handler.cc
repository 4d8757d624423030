#include "coordinator/api/blobs_handler.h"

#include "absl/strings/str_cat.h"
#include "common/rpc/limits.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/api/task_ref.h"

namespace tilemend {
namespace {

// A stream that has moved nothing for so long holds a thread for nothing.
constexpr absl::Duration kIdleStream = absl::Seconds(60);

}  // namespace

void BlobsHandler::Tick(absl::Time now) {
  ForgetSent();
  StopIdleStreams(now);
}

absl::Status BlobsHandler::ReadBlob(const v1::ReadBlobRequest& request,
                                    const std::function<bool(std::string_view)>& send,
                                    const std::function<void()>& stop) {
  TILEMEND_ASSIGN_OR_RETURN(const auto call, streams_.Enter(request.job(), cluster_.options.clock(), stop));
  TILEMEND_ASSIGN_OR_RETURN(const auto blobs, FindBlobs(request.job()));
  return blobs->ReadChunks(request.digest(), [&](std::string_view chunk) {
    cluster_.metrics.BlobSent(static_cast<int64_t>(chunk.size()));
    call->Touch(cluster_.options.clock());
    return send(chunk);
  });
}

absl::StatusOr<v1::WriteBlobResponse> BlobsHandler::WriteBlob(const std::function<bool(v1::WriteBlobRequest&)>& next,
                                                              const std::function<void()>& stop) {
  TILEMEND_ASSIGN_OR_RETURN(const auto call, streams_.Enter("", cluster_.options.clock(), stop));
  v1::WriteBlobRequest message;
  if (!next(message)) return absl::InvalidArgumentError("a blob needs a first message with its attempt and its digest");
  const v1::TaskRef attempt = message.attempt();
  const std::string worker = message.worker();
  const std::string digest = message.digest();
  if (!IsDigest(digest)) return absl::InvalidArgumentError("a digest has 64 lower-case hexadecimal digits");
  TILEMEND_ASSIGN_OR_RETURN(const auto blobs, FindBlobs(attempt.job()));
  call->Name(attempt.job());
  TILEMEND_ASSIGN_OR_RETURN(const auto writer, blobs->NewWriter(OutputSync(cluster_)));
  do {
    if (message.data().size() > kMaxChunkBytes) {
      return absl::InvalidArgumentError(absl::StrCat("a chunk may have ", kMaxChunkBytes, " bytes at most"));
    }
    TILEMEND_RETURN_IF_ERROR(CountSent(attempt, worker, message.data().size()));
    cluster_.metrics.BlobReceived(static_cast<int64_t>(message.data().size()));
    TILEMEND_RETURN_IF_ERROR(writer->Append(message.data()));
    call->Touch(cluster_.options.clock());
  } while (next(message));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, writer->Commit(digest));
  v1::WriteBlobResponse response;
  response.set_size(size);
  return response;
}

absl::StatusOr<std::shared_ptr<BlobFolder>> BlobsHandler::FindBlobs(const std::string& job) {
  ClusterLock lock(cluster_.mutex);
  TILEMEND_ASSIGN_OR_RETURN(const Job* found, cluster_.JobNamed(absl::StrCat("jobs/", job)));
  if (!IsOver(found->state)) return cluster_.jobs.at(job).blobs;
  const std::string state(JobStateName(found->state));
  return WithErrorInfo(absl::FailedPreconditionError(absl::StrCat("jobs/", job, ": the job is over (", state, ")")),
                       {"JOB_OVER", {{"job", job}, {"state", state}}});
}

// Only who holds a task may write, and no more than its output can have: else strangers could fill the disk.
absl::Status BlobsHandler::CountSent(const v1::TaskRef& attempt, const std::string& worker, size_t bytes) {
  ClusterLock lock(cluster_.mutex);
  const TaskKey key{attempt.job(), attempt.task()};
  const Task* task = cluster_.state.FindTask(key);
  if (task == nullptr || FindLease(*task, worker, attempt.attempt_token()) == nullptr) {
    return WithErrorInfo(absl::FailedPreconditionError("the worker does not hold the task that the blob is of"),
                         {"LATE_RESULT", {{"job", key.job}, {"task", absl::StrCat(key.task)}}});
  }
  Sent& sent = sent_.try_emplace(attempt.attempt_token(), Sent{key, worker}).first->second;
  sent.bytes += static_cast<int64_t>(bytes);
  if (sent.bytes <= cluster_.options.most_sent) return absl::OkStatus();
  return WithErrorInfo(
      absl::ResourceExhaustedError(absl::StrCat("an attempt may send ", cluster_.options.most_sent, " bytes at most")),
      {"BLOB_TOO_LARGE", {{"limit", absl::StrCat(cluster_.options.most_sent)}}});
}

void BlobsHandler::ForgetSent() {
  std::erase_if(sent_, [this](const auto& entry) {
    const auto& [token, sent] = entry;
    const Task* task = cluster_.state.FindTask(sent.task);
    return task == nullptr || FindLease(*task, sent.worker, token) == nullptr;
  });
}

void BlobsHandler::StopIdleStreams(absl::Time now) {
  streams_.Stop(now - kIdleStream, [this](const std::string& id) {
    const Job* job = id.empty() ? nullptr : cluster_.state.FindJob(id);
    return job != nullptr && IsOver(job->state);
  });
}

}  // namespace tilemend
