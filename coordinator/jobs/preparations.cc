#include "coordinator/jobs/preparations.h"

#include <chrono>
#include <thread>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks(50);

// 0 where there is no count, or none that can be read.
int CountIn(const std::string& path) {
  const auto text = ReadFile(path);
  int count = 0;
  return text.ok() && absl::SimpleAtoi(*text, &count) ? count : 0;
}

}  // namespace

Preparations::Attempt::~Attempt() {
  // A file that stays counts one too many, for a job that is resumed after that.
  if (!path_.empty()) RemoveFile(path_).IgnoreError();
}

absl::StatusOr<Preparations::Attempt> Preparations::Begin(const std::string& job, const std::stop_token& stop) {
  std::string path = absl::StrCat(folder_, "/", job);
  const int before = CountIn(path);
  if (before >= kMaxPreparations) {
    TILEMEND_RETURN_IF_ERROR(RemoveFile(path));
    return absl::AbortedError(absl::StrCat(
        "the coordinator ended ", before, " times while it read the scene and the polygons of this job; ",
        "the job may need more memory than the machine has. Look at the coordinator's log, then submit it again"));
  }
  std::unique_lock<std::mutex> alone(alone_, std::defer_lock);
  while (before > 0 && !alone.try_lock()) {
    if (stop.stop_requested()) return absl::CancelledError("stopped before the job was prepared");
    std::this_thread::sleep_for(kBetweenLooks);
  }
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(path, absl::StrCat(before + 1)));
  return Attempt(std::move(path), std::move(alone));
}

}  // namespace tilemend
