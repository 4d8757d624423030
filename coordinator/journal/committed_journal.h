// What journals have in common that put through a GroupCommit.
#ifndef TILEMEND_COORDINATOR_JOURNAL_COMMITTED_JOURNAL_H_
#define TILEMEND_COORDINATOR_JOURNAL_COMMITTED_JOURNAL_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "coordinator/journal/group_commit.h"
#include "coordinator/journal/journal.h"

namespace tilemend {

class CommittedJournal : public Journal {
 public:
  uint32_t epoch() const override { return epoch_; }
  std::vector<JobRecord> TakeJobs() override { return std::exchange(jobs_, {}); }
  void PutJob(JobRecord job) override { Writer().Put(std::move(job)); }
  void PutResult(int64_t job, TaskName task, ResultRecord result) override {
    Writer().Put(NewResult{job, std::move(task), std::move(result)});
  }
  void DropJob(int64_t job) override { Writer().Put(OldJob{job}); }
  std::vector<SetAsideRecord> TakeSetAside() override { return std::exchange(set_aside_, {}); }
  void PutSetAside(SetAsideRecord record) override { Writer().Put(std::move(record)); }
  void DropResults(int64_t job, const std::string& worker) override { Writer().Put(FalseResults{job, worker}); }
  void Await() override { Writer().Await(); }
  bool is_durable() const override { return true; }

 protected:
  // Of what is read when it is opened.
  uint32_t epoch_ = 0;
  std::vector<JobRecord> jobs_;
  std::vector<SetAsideRecord> set_aside_;

 private:
  // The last member of whoever has it, so that its thread ends before what it writes with.
  virtual GroupCommit& Writer() = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOURNAL_COMMITTED_JOURNAL_H_
