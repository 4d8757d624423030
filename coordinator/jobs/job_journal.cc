#include "coordinator/jobs/job_journal.h"

#include <cstdint>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/status_proto.h"
#include "common/store/digest.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/describe_job.h"

namespace tilemend {
namespace {

// Contents that wait for the pipeline in memory; beyond that they go to disk.
constexpr size_t kMostKnownBytes = size_t{64} << 20;

absl::Status ErrorOf(const std::string& bytes) {
  v1::Status proto;
  if (!proto.ParseFromString(bytes)) return absl::DataLossError("the journal's text of an error cannot be read");
  return StatusFromProto(proto);
}

// In the journal: a result of one build is never used by another.
TaskName NameOf(const std::string& build, CellId cell, Stage stage, const std::string& input) {
  return {cell, stage, Sha256Hex(absl::StrCat(build, "\n", input))};
}

// A note is a result of a task that nobody asks for.
class JournalNotes : public JobNotes {
 public:
  JournalNotes(std::shared_ptr<Journal> journal, int64_t job, std::string build)
      : journal_(std::move(journal)), job_(job), build_(std::move(build)) {}

  std::optional<std::string> Find(const std::string& name) const override {
    const auto found = journal_->Find(job_, TaskOf(name));
    if (!found.ok() || !*found) return std::nullopt;
    return (*found)->content.value_or("");
  }
  void Put(const std::string& name, const std::string& worker, const std::string& text) override {
    ResultRecord note;
    note.worker = worker;
    if (!text.empty()) {
      note.output = Sha256Hex(text);
      note.content = text;
    }
    journal_->PutResult(job_, TaskOf(name), std::move(note));
  }
  void Await() override { journal_->Await(); }

 private:
  TaskName TaskOf(const std::string& name) const {
    return NameOf(build_, CellId{0, 0}, Stage::kVerify, absl::StrCat("note ", name));
  }

  const std::shared_ptr<Journal> journal_;
  const int64_t job_;
  const std::string build_;
};

}  // namespace

void JobJournal::PutJob(const Job& job, bool released, std::optional<v1::Job> message) const {
  if (!cluster_.journal->is_durable()) return;
  if (!message) message = DescribeJob(cluster_, job);
  const bool over = message->state() != v1::RUNNING;
  cluster_.journal->PutJob({job.number, job.request_id, message->SerializeAsString(), over, released});
}

void JobJournal::PutResult(const SettledTask& task, const std::optional<std::string>& content) const {
  if (!cluster_.journal->is_durable()) return;
  const bool is_inside = content && content->size() <= kMostJournalledBytes;
  ResultRecord result{task.state, task.output, is_inside ? content : std::nullopt, "", {}, task.worker};
  if (task.state != TaskState::kCommitted) result.error = StatusToProto(task.error).SerializeAsString();
  cluster_.journal->PutResult(cluster_.state.FindJob(task.key.job)->number,
                              NameOf(cluster_.options.build, task.cell, task.stage, task.input), std::move(result));
}

void JobJournal::PutLoss(const StruckTask& task) const {
  if (!cluster_.journal->is_durable()) return;
  ResultRecord result;
  result.state = TaskState::kPending;
  result.lost_workers = task.lost_workers;
  cluster_.journal->PutResult(cluster_.state.FindJob(task.key.job)->number,
                              NameOf(cluster_.options.build, task.cell, task.stage, task.input), std::move(result));
}

void JobJournal::DropResults(const Revoked& revoked) const {
  cluster_.journal->DropResults(cluster_.state.FindJob(revoked.job)->number, revoked.worker);
}

bool JobJournal::IsOfSetAside(const ResultRecord& result) const {
  if (result.worker.empty()) return false;
  const ClusterLock lock(cluster_.mutex);
  return cluster_.trust.IsSetAside(result.worker);
}

absl::StatusOr<TaskContents> JobJournal::Recall(const std::string& job, std::vector<TaskSpec>& tasks) const {
  TaskContents contents;
  int64_t number = 0;
  std::shared_ptr<BlobFolder> blobs;
  {
    const ClusterLock lock(cluster_.mutex);
    number = cluster_.state.FindJob(job)->number;
    blobs = cluster_.jobs.at(job).blobs;
  }
  size_t bytes = 0;
  for (TaskSpec& task : tasks) {
    TILEMEND_ASSIGN_OR_RETURN(
        std::optional<ResultRecord> found,
        cluster_.journal->Find(number, NameOf(cluster_.options.build, task.cell, task.stage, task.input)));
    if (!found) continue;
    if (!IsSettled(found->state)) {
      task.lost_workers = std::move(found->lost_workers);
      continue;
    }
    if (IsOfSetAside(*found)) continue;  // it is computed again
    if (found->state == TaskState::kCommitted && !found->content) {
      absl::StatusOr<std::string> blob = blobs->Read(found->output);
      if (!blob.ok()) continue;  // it was lost or damaged: the task is done again
      if (bytes + blob->size() <= kMostKnownBytes) found->content = *std::move(blob);
    }
    task.known = KnownResult{found->state, found->output, absl::OkStatus(), found->worker};
    if (found->state != TaskState::kCommitted) task.known->error = ErrorOf(found->error);
    if (found->content) bytes += found->content->size();
    if (found->content && bytes > kMostKnownBytes && blobs->Put(*found->content).ok()) found->content.reset();
    contents.push_back(std::move(found->content));
  }
  return contents;
}

std::shared_ptr<JobNotes> JobJournal::NotesOf(const std::string& job) const {
  return std::make_shared<JournalNotes>(cluster_.journal, cluster_.state.FindJob(job)->number, cluster_.options.build);
}

}  // namespace tilemend
