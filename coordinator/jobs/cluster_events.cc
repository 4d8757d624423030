#include "coordinator/jobs/cluster_events.h"

#include <cmath>

namespace tilemend {
namespace {

constexpr absl::Duration kBetweenRefusals = absl::Seconds(10);

double SecondsOf(const Job& job) { return absl::ToDoubleSeconds(job.ended - job.created); }

// Milliseconds are enough for people.
double Rounded(double seconds) { return std::round(seconds * 1000) / 1000; }

}  // namespace

ClusterEvents::ClusterEvents(MetricsRegistry& registry, JobMetrics& jobs, Log& log) : log_(log), jobs_(jobs) {
  const std::string prefix = "tilemend_coordinator_";
  workers_came_ = registry.AddCounter(prefix + "workers_came_total", "Workers that called for the first time.", {});
  workers_lost_ = registry.AddCounter(prefix + "workers_lost_total", "Workers that fell silent.", {});
}

void ClusterEvents::JobCreated(const Job& job, const JobSpec& spec, const JobOrigin& origin) {
  log_.Info("job created", {{"job", job.id},
                            {"trace", origin.trace},
                            {"owner", origin.owner},
                            {"scene", spec.scene()},
                            {"out", spec.out()},
                            {"request_id", job.request_id}});
}

void ClusterEvents::JobRestored(const Job& job, const JobOrigin& origin) {
  log_.Info("job goes on", {{"job", job.id}, {"trace", origin.trace}, {"owner", origin.owner}});
}

void ClusterEvents::JobStarted(const Job& job, const JobOrigin& origin) {
  const double seconds = absl::ToDoubleSeconds(job.started - job.created);
  jobs_.Started(job);
  log_.Info("job started", {{"job", job.id}, {"trace", origin.trace}, {"queue_seconds", Rounded(seconds)}});
}

void ClusterEvents::JobEnded(const Job& job, const JobOutcome& outcome, const absl::Status& error,
                             const JobOrigin& origin) {
  jobs_.Ended(job, error);
  log_.Write(job.state == JobState::kFailed ? LogLevel::kError : LogLevel::kInfo, "job ended",
             {{"job", job.id},
              {"trace", origin.trace},
              {"owner", origin.owner},
              {"state", JobStateName(job.state)},
              {"seconds", Rounded(SecondsOf(job))},
              {"cells", job.progress.cells},
              {"holes", job.progress.holes},
              {"holes_filled", job.progress.holes_filled},
              {"triangles", job.progress.triangles},
              {"tasks", job.counts.added},
              {"retried", job.counts.given_again()},
              {"quarantined", job.counts.quarantined},
              {"message", outcome.message},
              {"error", std::string(error.message())}});
}

void ClusterEvents::AttemptFailed(const Task& task, const std::string& job, const std::string& worker,
                                  const JobOrigin& origin, const absl::Status& error) {
  log_.Warn("attempt failed", {{"job", job},
                               {"trace", origin.trace},
                               {"task", task.id},
                               {"cell", ToString(task.cell)},
                               {"stage", StageName(task.stage)},
                               {"attempt", task.attempts},
                               {"worker", worker},
                               {"code", absl::StatusCodeToString(error.code())},
                               {"error", std::string(error.message())}});
}

void ClusterEvents::AttemptLost(const StruckTask& task, const JobOrigin& origin) {
  log_.Warn("attempt lost", {{"job", task.key.job},
                             {"trace", origin.trace},
                             {"task", task.key.task},
                             {"cell", ToString(task.cell)},
                             {"stage", StageName(task.stage)},
                             {"worker", task.lost_workers.empty() ? "" : task.lost_workers.back()}});
}

void ClusterEvents::WorkerCame(const WorkerRecord& worker, const std::string& release, const std::string& identity) {
  workers_came_->Increment();
  log_.Info("worker came",
            {{"worker", worker.id}, {"threads", worker.threads}, {"worker_release", release}, {"identity", identity}});
}

void ClusterEvents::WorkerRefused(const std::string& worker, const std::string& release, const absl::Status& reason,
                                  absl::Time now) {
  if (now - last_refusal_ < kBetweenRefusals) return;
  last_refusal_ = now;
  log_.Warn("worker refused",
            {{"worker", worker}, {"worker_release", release}, {"reason", std::string(reason.message())}});
}

void ClusterEvents::WorkerLeft(const std::string& worker) { log_.Info("worker left", {{"worker", worker}}); }

void ClusterEvents::WorkerLost(const WorkerRecord& worker, absl::Time now) {
  workers_lost_->Increment();
  log_.Warn("worker lost", {{"worker", worker.id},
                            {"silent_seconds", Rounded(absl::ToDoubleSeconds(now - worker.last_seen))},
                            {"tasks", static_cast<int64_t>(worker.held.size())}});
}

void ClusterEvents::WorkerSuspected(const std::string& worker, const std::string& reason) {
  log_.Warn("worker suspected", {{"worker", worker}, {"reason", reason}});
}

void ClusterEvents::WorkerCleared(const std::string& worker) { log_.Info("worker cleared", {{"worker", worker}}); }

void ClusterEvents::WorkerSetAside(const std::string& worker, const std::string& reason) {
  log_.Error("worker set aside", {{"worker", worker}, {"reason", reason}});
}

void ClusterEvents::WorkerBlind(const std::string& worker, const std::string& job, const std::string& reason) {
  log_.Warn("worker does not see the job's folders", {{"worker", worker}, {"job", job}, {"reason", reason}});
}

}  // namespace tilemend
