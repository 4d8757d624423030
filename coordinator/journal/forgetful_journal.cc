#include "coordinator/journal/journal.h"

namespace tilemend {
namespace {

class ForgetfulJournal : public Journal {
 public:
  uint32_t epoch() const override { return 1; }
  std::vector<JobRecord> TakeJobs() override { return {}; }
  void PutJob(JobRecord) override {}
  void PutResult(int64_t, TaskName, ResultRecord) override {}
  void DropJob(int64_t) override {}
  void DropResults(int64_t, const std::string&) override {}
  std::vector<SetAsideRecord> TakeSetAside() override { return {}; }
  void PutSetAside(SetAsideRecord) override {}
  void Await() override {}
  absl::StatusOr<std::optional<ResultRecord>> Find(int64_t, const TaskName&) override { return std::nullopt; }
  absl::StatusOr<std::vector<std::string>> Outputs(int64_t) override { return std::vector<std::string>(); }
  bool is_durable() const override { return false; }
};

}  // namespace

std::unique_ptr<Journal> NewForgetfulJournal() { return std::make_unique<ForgetfulJournal>(); }

}  // namespace tilemend
