#include "worker/service/part_cache.h"

#include <utility>

#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<PartCache::Bytes> PartCache::Get(const std::string& digest,
                                                const std::function<absl::StatusOr<std::string>()>& read) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto found = by_digest_.find(digest); found != by_digest_.end()) {
      parts_.splice(parts_.begin(), parts_, found->second);
      return parts_.front().bytes;
    }
  }
  TILEMEND_ASSIGN_OR_RETURN(std::string fresh, read());
  const auto bytes = std::make_shared<const std::string>(std::move(fresh));
  const std::lock_guard<std::mutex> lock(mutex_);
  if (by_digest_.contains(digest)) return bytes;  // another thread was quicker
  parts_.push_front({digest, bytes});
  by_digest_[digest] = parts_.begin();
  bytes_ += bytes->size();
  while (bytes_ > most_bytes_) {
    bytes_ -= parts_.back().bytes->size();
    by_digest_.erase(parts_.back().digest);
    parts_.pop_back();
  }
  return bytes;
}

}  // namespace tilemend
