// Parts of inputs that were fetched, for the tasks that come next.
#ifndef TILEMEND_WORKER_SERVICE_PART_CACHE_H_
#define TILEMEND_WORKER_SERVICE_PART_CACHE_H_

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "absl/status/statusor.h"

namespace tilemend {

// Forgets first what was asked for longest ago. Thread-safe.
class PartCache {
 public:
  using Bytes = std::shared_ptr<const std::string>;

  explicit PartCache(size_t most_bytes) : most_bytes_(most_bytes) {}

  // The bytes of this digest; from `read`, with its errors, if they are not here.
  absl::StatusOr<Bytes> Get(const std::string& digest, const std::function<absl::StatusOr<std::string>()>& read);

 private:
  struct Part {
    std::string digest;
    Bytes bytes;
  };

  const size_t most_bytes_;
  std::mutex mutex_;
  std::list<Part> parts_;  // the latest first
  std::map<std::string, std::list<Part>::iterator> by_digest_;
  size_t bytes_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_PART_CACHE_H_
