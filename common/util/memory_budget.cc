#include "common/util/memory_budget.h"

namespace tilemend {

MemoryBudget::Share::Share(MemoryBudget& budget, int64_t bytes) : budget_(budget), bytes_(bytes) {
  std::unique_lock lock(budget_.mutex_);
  const uint64_t turn = budget_.came_++;
  budget_.changed_.wait(lock, [&] {
    return budget_.admitted_ == turn && (budget_.taken_ == 0 || bytes_ <= budget_.bytes_ - budget_.taken_);
  });
  ++budget_.admitted_;
  budget_.taken_ += bytes_;
  budget_.changed_.notify_all();
}

MemoryBudget::Share::~Share() {
  const std::lock_guard lock(budget_.mutex_);
  budget_.taken_ -= bytes_;
  budget_.changed_.notify_all();
}

}  // namespace tilemend
