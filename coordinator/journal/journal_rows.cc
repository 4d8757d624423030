#include "coordinator/journal/journal_rows.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "common/store/digest.h"

namespace tilemend {

std::string SumOf(const std::vector<std::string_view>& parts) {
  std::string bytes;
  bytes.reserve(512);
  for (const std::string_view part : parts) {
    absl::StrAppend(&bytes, part.size(), ":");
    bytes += part;
  }
  return {Sha256Of(bytes).data(), sizeof(NameBytes)};
}

std::string NameOf(const TaskName& task) {
  return SumOf({absl::StrCat(static_cast<int>(task.stage), " ", task.cell.col, " ", task.cell.row), task.input});
}

std::string WorkersOf(const ResultRecord& result) {
  return result.state == TaskState::kCommitted ? result.worker : absl::StrJoin(result.lost_workers, "\n");
}

void SetWorkers(std::string_view workers, ResultRecord& result) {
  if (workers.empty()) return;
  if (result.state == TaskState::kCommitted) {
    result.worker = workers;
  } else {
    result.lost_workers = absl::StrSplit(std::string(workers), '\n');
  }
}

std::string ResultRow::Sum() const {
  return SumOf({absl::StrCat(number, " ", job, " ", state, " ", inside), name, output, error, lost_workers});
}

std::string SumOfJob(const JobRecord& job) {
  return SumOf({absl::StrCat(job.number, " ", job.over, " ", job.released), job.request_id, job.body});
}

std::string SumOfAside(const SetAsideRecord& aside) { return SumOf({aside.worker, aside.reason}); }

}  // namespace tilemend
