#include "worker/service/task_blobs.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "common/rpc/input_parts.h"
#include "common/rpc/limits.h"
#include "common/store/digest.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Ground rasters of three rows of 80 cells of 250 m.
constexpr size_t kMostPartBytes = size_t{32} << 20;

// To send or fetch a blob while the connection stands: with the pauses between them 2.6 seconds in all.
constexpr int kMostTries = 6;

}  // namespace

TaskBlobs::TaskBlobs(const WorkerOptions& options, WorkLink& link, WorkerState& state,
                     const CoordinatorContact& contact)
    : options_(options), link_(link), state_(state), contact_(contact), parts_(kMostPartBytes) {}

absl::StatusOr<std::string> TaskBlobs::Input(const HeldTask& held) {
  const v1::Task& task = held.task;
  std::string input = task.input().content();
  if (task.input().size() != static_cast<int64_t>(input.size())) {
    TILEMEND_ASSIGN_OR_RETURN(input, Fetch(held, task.input().digest()));
  }
  for (const std::string& part : PartsOf(static_cast<Stage>(task.stage()), input)) {
    TILEMEND_ASSIGN_OR_RETURN(const auto bytes, Part(held, part));
    input += *bytes;
  }
  return input;
}

absl::StatusOr<std::shared_ptr<const std::string>> TaskBlobs::Part(const HeldTask& held, const std::string& digest) {
  if (auto known = parts_.Find(digest)) return known;
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, Fetch(held, digest));
  auto part = std::make_shared<const std::string>(std::move(bytes));
  parts_.Put(digest, part, part->size());
  return part;
}

absl::StatusOr<std::string> TaskBlobs::Fetch(const HeldTask& held, const std::string& digest) {
  auto read = link_.ReadBlob(held.task.ref().job(), digest);
  for (int tried = 0; !read.ok() && MayTryAgain(held, read.status(), tried); ++tried) {
    read = link_.ReadBlob(held.task.ref().job(), digest);
  }
  // What the coordinator has lost is no fault of the task.
  if (absl::IsNotFound(read.status())) return absl::UnavailableError(read.status().message());
  return read;
}

bool TaskBlobs::MayTryAgain(const HeldTask& held, const absl::Status& status, int tried) {
  if (!absl::IsUnavailable(status) && !absl::IsDeadlineExceeded(status)) return false;
  const absl::Duration pause = std::min(options_.first_backoff * (1 << std::min(tried, 10)), options_.max_backoff);
  // While it is not connected it does not count: a result is kept through any loss of connection.
  return state_.WaitFor(held, pause) && (tried < kMostTries || !contact_.is_connected());
}

absl::StatusOr<v1::BlobRef> TaskBlobs::Store(const HeldTask& held, std::string output) {
  v1::BlobRef blob;
  blob.set_size(static_cast<int64_t>(output.size()));
  if (output.size() <= kInlineBlobBytes) {
    blob.set_content(std::move(output));
    return blob;
  }
  blob.set_digest(Sha256Hex(output));
  const auto write = [&] { return link_.WriteBlob(held.task.ref(), options_.id, blob.digest(), output); };
  absl::Status written = write();
  for (int tried = 0; !written.ok() && MayTryAgain(held, written, tried); ++tried) written = write();
  TILEMEND_RETURN_IF_ERROR(written);
  return blob;
}

}  // namespace tilemend
