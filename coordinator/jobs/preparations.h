// How often coordinators ended while they prepared a job: while they read its scene and its polygons.
#ifndef TILEMEND_COORDINATOR_JOBS_PREPARATIONS_H_
#define TILEMEND_COORDINATOR_JOBS_PREPARATIONS_H_

#include <mutex>
#include <stop_token>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// After so many coordinators have ended while they prepared a job, it fails. A job that takes more memory than the
// machine has would end every coordinator that resumes it, within seconds, and with it all other jobs. One may have
// been killed by chance, two are a coincidence.
inline constexpr int kMaxPreparations = 3;

// Keeps the counts in files of a folder, one for each job that is being prepared. Jobs that were there when a
// coordinator ended are prepared one after another, so that the next end counts for one of them. Thread-safe.
class Preparations {
 public:
  explicit Preparations(std::string folder) : folder_(std::move(folder)) {}

  // One preparation, while this lives. It ended well if this is destroyed.
  class Attempt {
   public:
    Attempt(std::string path, std::unique_lock<std::mutex> alone) : path_(std::move(path)), alone_(std::move(alone)) {}
    Attempt(Attempt&&) = default;
    Attempt& operator=(Attempt&&) = delete;
    ~Attempt();

   private:
    std::string path_;                    // empty: moved from
    std::unique_lock<std::mutex> alone_;  // of a job that was there when a coordinator ended
  };

  // Counts one more, durably. Returns kAborted after kMaxPreparations that did not end well; the count begins anew
  // then. Returns kCancelled if a stop is requested while other jobs are prepared. Errors of WriteFileAtomically.
  absl::StatusOr<Attempt> Begin(const std::string& job, const std::stop_token& stop);

 private:
  const std::string folder_;
  std::mutex alone_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_PREPARATIONS_H_
