#include "coordinator/state/given_results.h"

#include <algorithm>

namespace tilemend {

void GivenResults::Put(int64_t task, const std::string& worker) {
  const auto place = static_cast<size_t>(task) - 1;
  given_by_.resize(std::max(given_by_.size(), place + 1));
  given_by_[place] = numbers_.try_emplace(worker, static_cast<int32_t>(numbers_.size()) + 1).first->second;
}

std::vector<int64_t> GivenResults::Revoke(const std::string& worker) {
  std::vector<int64_t> tasks;
  const auto number = numbers_.find(worker);
  if (number == numbers_.end()) return tasks;
  for (size_t place = 0; place < given_by_.size(); ++place) {
    if (given_by_[place] != number->second) continue;
    given_by_[place] = 0;
    tasks.push_back(static_cast<int64_t>(place) + 1);
  }
  return tasks;
}

}  // namespace tilemend
