// What was used last, up to so many bytes.
#ifndef TILEMEND_COMMON_UTIL_RECENTLY_USED_H_
#define TILEMEND_COMMON_UTIL_RECENTLY_USED_H_

#include <cstddef>
#include <iterator>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace tilemend {

// Forgets first what was used longest ago. Thread-safe.
template <class Key, class Value>
class RecentlyUsed {
 public:
  using Pointer = std::shared_ptr<const Value>;

  explicit RecentlyUsed(size_t most_bytes) : most_bytes_(most_bytes) {}

  // Null if it is not here.
  Pointer Find(const Key& key) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = by_key_.find(key);
    if (found == by_key_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found->second);
    return entries_.front().value;
  }

  // In place of what is here.
  void Put(const Key& key, Pointer value, size_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto found = by_key_.find(key); found != by_key_.end()) Drop(found->second);
    entries_.push_front({key, std::move(value), bytes});
    by_key_[key] = entries_.begin();
    bytes_ += bytes;
    while (bytes_ > most_bytes_) Drop(std::prev(entries_.end()));
  }

 private:
  struct Entry {
    Key key;
    Pointer value;
    size_t bytes;
  };
  using Entries = std::list<Entry>;

  void Drop(typename Entries::iterator entry) {
    bytes_ -= entry->bytes;
    by_key_.erase(entry->key);
    entries_.erase(entry);
  }

  const size_t most_bytes_;
  std::mutex mutex_;
  Entries entries_;  // the latest first
  std::map<Key, typename Entries::iterator> by_key_;
  size_t bytes_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_RECENTLY_USED_H_
