#include "common/mesh/position_index.h"

#include <bit>

namespace tilemend {

PositionIndex::PositionIndex() : slots_(64, -1), filter_(16, 0) {}

uint64_t PositionIndex::Hash(const Point3& p) {
  uint64_t h = 0;
  for (int k = 0; k < 3; ++k) {
    h = (h ^ std::bit_cast<uint64_t>(p[k] + 0.0)) * 0x9e3779b97f4a7c15ULL;  // + 0.0 turns -0.0 into 0.0
    h ^= h >> 29;
  }
  return h * 0xbf58476d1ce4e5b9ULL;
}

int32_t PositionIndex::Insert(const Point3& p) {
  if (positions_.size() * 2 >= slots_.size()) Grow();
  const uint64_t hash = Hash(p);
  const size_t mask = slots_.size() - 1;
  for (size_t i = hash & mask;; i = (i + 1) & mask) {
    if (slots_[i] < 0) {
      slots_[i] = size();
      positions_.push_back(p);
      const uint64_t bit = (hash >> 32) % (filter_.size() * 64);
      filter_[bit / 64] |= uint64_t{1} << (bit % 64);
      return slots_[i];
    }
    if (positions_[slots_[i]] == p) return slots_[i];
  }
}

int32_t PositionIndex::Find(const Point3& p) const {
  const uint64_t hash = Hash(p);
  const uint64_t bit = (hash >> 32) % (filter_.size() * 64);
  if ((filter_[bit / 64] >> (bit % 64) & 1) == 0) return -1;
  const size_t mask = slots_.size() - 1;
  for (size_t i = hash & mask; slots_[i] >= 0; i = (i + 1) & mask) {
    if (positions_[slots_[i]] == p) return slots_[i];
  }
  return -1;
}

void PositionIndex::Grow() {
  slots_.assign(slots_.size() * 2, -1);
  filter_.assign(slots_.size() / 8, 0);  // eight bits a slot
  const size_t mask = slots_.size() - 1;
  for (int32_t n = 0; n < size(); ++n) {
    const uint64_t hash = Hash(positions_[n]);
    size_t i = hash & mask;
    while (slots_[i] >= 0) i = (i + 1) & mask;
    slots_[i] = n;
    const uint64_t bit = (hash >> 32) % (filter_.size() * 64);
    filter_[bit / 64] |= uint64_t{1} << (bit % 64);
  }
}

}  // namespace tilemend
