// Blobs over CoordinatorImpl.
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/limits.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/api/coordinator_impl.h"

namespace tilemend {
namespace {

// A stream that has moved nothing for so long holds a thread for nothing.
constexpr absl::Duration kIdleStream = absl::Seconds(60);

}  // namespace

absl::StatusOr<std::shared_ptr<BlobFolder>> CoordinatorImpl::FindBlobs(const std::string& job) {
  Lock lock(mutex_);
  TILEMEND_ASSIGN_OR_RETURN(const Job* found, JobNamed(absl::StrCat("jobs/", job)));
  if (!IsOver(found->state)) return entries_.at(job).blobs;
  const std::string state(JobStateName(found->state));
  return WithErrorInfo(absl::FailedPreconditionError(absl::StrCat("jobs/", job, ": the job is over (", state, ")")),
                       {"JOB_OVER", {{"job", job}, {"state", state}}});
}

absl::Status CoordinatorImpl::ReadBlob(const v1::ReadBlobRequest& request,
                                       const std::function<bool(std::string_view)>& send,
                                       const std::function<void()>& stop) {
  TILEMEND_ASSIGN_OR_RETURN(const auto call, streams_.Enter(request.job(), options_.clock(), stop));
  TILEMEND_ASSIGN_OR_RETURN(const auto blobs, FindBlobs(request.job()));
  return blobs->ReadChunks(request.digest(), [&](std::string_view chunk) {
    metrics_.BlobSent(static_cast<int64_t>(chunk.size()));
    call->Touch(options_.clock());
    return send(chunk);
  });
}

// Only who holds a task may write, and no more than its output can have: else strangers could fill the disk.
absl::Status CoordinatorImpl::CountSent(const v1::TaskRef& attempt, const std::string& worker, size_t bytes) {
  Lock lock(mutex_);
  const TaskKey key{attempt.job(), attempt.task()};
  const Task* task = state_.FindTask(key);
  if (task == nullptr || FindLease(*task, worker, attempt.attempt_token()) == nullptr) {
    return WithErrorInfo(absl::FailedPreconditionError("the worker does not hold the task that the blob is of"),
                         {"LATE_RESULT", {{"job", key.job}, {"task", absl::StrCat(key.task)}}});
  }
  Sent& sent = sent_.try_emplace(attempt.attempt_token(), Sent{key, worker}).first->second;
  sent.bytes += static_cast<int64_t>(bytes);
  if (sent.bytes <= options_.most_sent) return absl::OkStatus();
  return WithErrorInfo(
      absl::ResourceExhaustedError(absl::StrCat("an attempt may send ", options_.most_sent, " bytes at most")),
      {"BLOB_TOO_LARGE", {{"limit", absl::StrCat(options_.most_sent)}}});
}

void CoordinatorImpl::ForgetSent() {
  std::erase_if(sent_, [this](const auto& entry) {
    const auto& [token, sent] = entry;
    const Task* task = state_.FindTask(sent.task);
    return task == nullptr || FindLease(*task, sent.worker, token) == nullptr;
  });
}

absl::StatusOr<v1::WriteBlobResponse> CoordinatorImpl::WriteBlob(const std::function<bool(v1::WriteBlobRequest&)>& next,
                                                                 const std::function<void()>& stop) {
  TILEMEND_ASSIGN_OR_RETURN(const auto call, streams_.Enter("", options_.clock(), stop));
  v1::WriteBlobRequest message;
  if (!next(message)) return absl::InvalidArgumentError("a blob needs a first message with its attempt and its digest");
  const v1::TaskRef attempt = message.attempt();
  const std::string worker = message.worker();
  const std::string digest = message.digest();
  if (!IsDigest(digest)) return absl::InvalidArgumentError("a digest has 64 lower-case hexadecimal digits");
  TILEMEND_ASSIGN_OR_RETURN(const auto blobs, FindBlobs(attempt.job()));
  call->Name(attempt.job());
  TILEMEND_ASSIGN_OR_RETURN(const auto writer, blobs->NewWriter(OutputSync()));
  do {
    if (message.data().size() > kMaxChunkBytes) {
      return absl::InvalidArgumentError(absl::StrCat("a chunk may have ", kMaxChunkBytes, " bytes at most"));
    }
    TILEMEND_RETURN_IF_ERROR(CountSent(attempt, worker, message.data().size()));
    metrics_.BlobReceived(static_cast<int64_t>(message.data().size()));
    TILEMEND_RETURN_IF_ERROR(writer->Append(message.data()));
    call->Touch(options_.clock());
  } while (next(message));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, writer->Commit(digest));
  v1::WriteBlobResponse response;
  response.set_size(size);
  return response;
}

void CoordinatorImpl::StopIdleStreams(absl::Time now) {
  streams_.Stop(now - kIdleStream, [this](const std::string& id) {
    const Job* job = id.empty() ? nullptr : state_.FindJob(id);
    return job != nullptr && IsOver(job->state);
  });
}

std::map<std::string, std::shared_ptr<BlobFolder>> CoordinatorImpl::BlobsOf(const v1::SyncResponse& response) {
  std::map<std::string, std::shared_ptr<BlobFolder>> blobs;
  for (const v1::Task& task : response.start()) blobs[task.ref().job()] = entries_.at(task.ref().job()).blobs;
  return blobs;
}

void CoordinatorImpl::InlineInputs(const std::map<std::string, std::shared_ptr<BlobFolder>>& blobs,
                                   v1::SyncResponse& response) {
  size_t left = kMaxInlineBytesPerSync;
  for (v1::Task& task : *response.mutable_start()) {
    const auto& folder = blobs.at(task.ref().job());
    if (folder == nullptr) continue;
    v1::BlobRef& input = *task.mutable_input();
    const auto size = folder->Size(input.digest());
    input.set_size(size.value_or(-1));  // no size: not inside, so that nobody takes it for empty
    if (!size.ok()) continue;           // the job has just ended, and the worker is told so next time; or it was lost
    if (static_cast<size_t>(*size) > std::min(left, kInlineBlobBytes)) continue;
    auto content = folder->Read(input.digest());
    if (!content.ok()) continue;
    left -= content->size();
    metrics_.BlobSent(*size);
    input.set_content(*std::move(content));
  }
}

}  // namespace tilemend
