// A share of things that nobody can predict.
#ifndef TILEMEND_COORDINATOR_JOBS_RANDOM_SHARE_H_
#define TILEMEND_COORDINATOR_JOBS_RANDOM_SHARE_H_

#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"

namespace tilemend {

// Chooses by name, the same each time. Another object chooses others, unless it has the same key.
class RandomShare {
 public:
  // `share` from 0 (none) to 1 (all).
  explicit RandomShare(double share) : share_(share) {}
  // Chooses as every other object with this key. `key` is secret.
  void UseKey(uint64_t key) { key_ = key; }

  bool is_none() const { return share_ <= 0; }
  bool Has(std::string_view name) const {
    if (share_ <= 0 || share_ >= 1) return share_ >= 1;
    const std::string digest = FileDigest(absl::StrCat(key_, " ", std::string(name)));
    return static_cast<double>(std::stoul(digest.substr(0, 8), nullptr, 16)) < share_ * 0x1p32;
  }
  // A number that no other object has given.
  uint64_t NextNumber() { return ++last_number_; }
  static uint64_t NewKey() {
    std::random_device random;
    return static_cast<uint64_t>(random()) << 32 | random();
  }

 private:
  const double share_;
  uint64_t key_ = NewKey();
  uint64_t last_number_ = NewKey();
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_RANDOM_SHARE_H_
