#include "coordinator/jobs/coordinator_metrics.h"

#include <string>

namespace tilemend {

CoordinatorMetrics::CoordinatorMetrics(MetricsRegistry& registry) {
  const std::string prefix = "tilemend_coordinator_";
  for (size_t i = 0; i < stages_.size(); ++i) {
    const std::string_view name = i < kAllStages.size() ? StageName(kAllStages[i]) : "unknown";
    const MetricsRegistry::Labels labels = {{"stage", std::string(name)}};
    PerStage& stage = stages_[i];
    stage.started = registry.AddCounter(prefix + "tasks_started_total", "Attempts given to workers.", labels);
    stage.finished = registry.AddCounter(prefix + "tasks_finished_total", "Tasks whose result was committed.", labels);
    stage.failed = registry.AddCounter(prefix + "tasks_failed_total", "Tasks that ended with an error.", labels);
    stage.quarantined = registry.AddCounter(prefix + "tasks_quarantined_total",
                                            "Tasks given up because too many workers were lost with them.", labels);
    stage.retried =
        registry.AddCounter(prefix + "tasks_retried_total", "Attempts lost to a machine's failure.", labels);
    stage.refused_late = registry.AddCounter(prefix + "tasks_refused_late_total",
                                             "Results refused because their attempt had been given up.", labels);
    stage.refused = registry.AddCounter(prefix + "results_refused_total", "Results that were wrong.", labels);
    stage.seconds = registry.AddHistogram(prefix + "task_seconds", "From the lease to the result that ended the task.",
                                          labels, Histogram::ScaledBounds(0.001, 2, 20));
  }
  for (size_t i = 0; i < jobs_.size(); ++i) {
    const std::string state(JobStateName(static_cast<JobState>(i)));
    jobs_[i] = registry.AddGauge(prefix + "jobs", "Jobs by state.", {{"state", state}});
  }
  workers_ = registry.AddGauge(prefix + "workers_connected", "Workers that call.", {});
  workers_set_aside_ =
      registry.AddGauge(prefix + "workers_set_aside", "Workers that get no task, as a result of theirs was wrong.", {});
  workers_blind_ = registry.AddGauge(prefix + "workers_blind",
                                     "Workers that do not see the folders of a job, counted for each job.", {});
  task_slots_ = registry.AddGauge(prefix + "task_slots", "Tasks that the workers take at once.", {});
  tasks_pending_ = registry.AddGauge(prefix + "tasks_pending", "Tasks that wait for a worker.", {});
  tasks_running_ = registry.AddGauge(prefix + "tasks_running", "Tasks that workers hold.", {});
  blob_bytes_sent_ = registry.AddCounter(prefix + "blob_sent_bytes_total", "Bytes of blobs sent to workers.", {});
  blob_bytes_received_ = registry.AddCounter(prefix + "blob_received_bytes_total", "Bytes of blobs from workers.", {});
}

CoordinatorMetrics::PerStage& CoordinatorMetrics::Of(Stage stage) { return stages_[StageIndex(stage)]; }

void CoordinatorMetrics::Settled(const SettledTask& task, absl::Time now) {
  PerStage& stage = Of(task.stage);
  Counter* counter = task.state == TaskState::kCommitted ? stage.finished
                     : task.state == TaskState::kFailed  ? stage.failed
                                                         : stage.quarantined;
  counter->Increment();
  stage.seconds->Observe(absl::ToDoubleSeconds(now - task.leased_at));
}

void CoordinatorMetrics::Show(const CoordinatorState& state) {
  std::array<int64_t, 5> jobs{};
  int64_t pending = 0;
  int64_t running = 0;
  for (const auto& [id, job] : state.jobs()) {
    ++jobs[static_cast<size_t>(job.state)];
    pending += job.counts.pending;
    running += job.counts.leased;
  }
  for (size_t i = 0; i < jobs.size(); ++i) jobs_[i]->Set(static_cast<double>(jobs[i]));
  workers_->Set(static_cast<double>(state.workers().size()));
  int64_t slots = 0;
  for (const auto& [id, worker] : state.workers()) slots += worker.draining ? 0 : worker.threads;
  task_slots_->Set(static_cast<double>(slots));
  tasks_pending_->Set(static_cast<double>(pending));
  tasks_running_->Set(static_cast<double>(running));
}

void CoordinatorMetrics::ShowTrust(const WorkerTrust::Counts& counts) {
  workers_set_aside_->Set(static_cast<double>(counts.set_aside));
  workers_blind_->Set(static_cast<double>(counts.blind));
}

}  // namespace tilemend
