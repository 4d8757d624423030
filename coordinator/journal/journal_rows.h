// Rows of the journal's tables, each with a sum that tells damage.
#ifndef TILEMEND_COORDINATOR_JOURNAL_JOURNAL_ROWS_H_
#define TILEMEND_COORDINATOR_JOURNAL_JOURNAL_ROWS_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "coordinator/journal/journal.h"

namespace tilemend {

using NameBytes = std::array<char, 16>;

// The first half of the SHA-256 of the parts; no two lists of parts give the same bytes.
std::string SumOf(const std::vector<std::string_view>& parts);

// Of a task, as rows name it.
std::string NameOf(const TaskName& task);

// The workers of a result, as rows have them: those that were lost with its task, or who gave it.
std::string WorkersOf(const ResultRecord& result);
// The reverse. `result` has its state.
void SetWorkers(std::string_view workers, ResultRecord& result);

// A row of `result`.
struct ResultRow {
  int64_t number = 0, job = 0;
  std::string name;
  int64_t state = 0;
  std::string output;
  int64_t inside = 0;               // whether the output's bytes are in `content`
  std::string error, lost_workers;  // the latter as WorkersOf

  std::string Sum() const;
};

// Of a row of `job`, of one of `aside`.
std::string SumOfJob(const JobRecord& job);
std::string SumOfAside(const SetAsideRecord& aside);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_JOURNAL_ROWS_H_
