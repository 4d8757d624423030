#include "coordinator/jobs/job_metrics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"

namespace tilemend {
namespace {

// From 1 s to 6 days; from 0.1 s to 14 h.
std::vector<double> JobBounds() { return Histogram::ScaledBounds(1, 2, 20); }
std::vector<double> QueueBounds() { return Histogram::ScaledBounds(0.1, 2, 20); }

}  // namespace

double ShareDone(const Job& job) {
  if (job.state == JobState::kDone || job.state == JobState::kPartial) return 1;
  const Progress& p = job.progress;
  return ShareDone(p.phase, p.cells, p.cells_done, job.counts.added, job.counts.settled());
}

double ShareDone(std::string_view phase, int64_t cells, int64_t cells_done, int64_t tasks, int64_t tasks_done) {
  if (cells == 0) return 0;
  const int64_t out = tasks - tasks_done;
  const bool are_held_back = out > kMostTasksOut / 2;
  int64_t to_come = cells;
  if (phase == "survey" || phase == "plan")
    to_come = 2 * cells + (are_held_back ? std::max<int64_t>(0, cells - tasks) : 0);
  if (phase == "assemble") to_come = are_held_back ? std::max<int64_t>(0, cells - cells_done - out) : 0;
  if (phase == kVerifyPhase) to_come = 0;
  return std::min(1.0, static_cast<double>(tasks_done) / static_cast<double>(std::max<int64_t>(1, tasks + to_come)));
}

JobMetrics::JobMetrics(MetricsRegistry& registry) {
  const std::string prefix = "tilemend_coordinator_";
  for (size_t i = 0; i < kSlots; ++i) {
    const MetricsRegistry::Labels labels = {{"slot", absl::StrCat(i + 1)}};
    slots_[i].share = registry.AddGauge(prefix + "running_job_done_ratio",
                                        "Share of a running job that is done; NaN where no job runs.", labels);
    slots_[i].age =
        registry.AddGauge(prefix + "running_job_age_seconds", "Since a running job was made; NaN likewise.", labels);
    slots_[i].tasks_running = registry.AddGauge(prefix + "running_job_tasks_running",
                                                "Tasks of a running job that workers hold; NaN likewise.", labels);
    for (Gauge* const gauge : {slots_[i].share, slots_[i].age, slots_[i].tasks_running}) gauge->Set(std::nan(""));
  }
  for (size_t i = 0; i < ended_.size(); ++i) {
    const auto state = static_cast<JobState>(i);
    ended_[i] = Counter::Null();
    seconds_[i] = Histogram::Null();
    if (!IsOver(state)) continue;
    const MetricsRegistry::Labels labels = {{"state", std::string(JobStateName(state))}};
    ended_[i] =
        registry.AddCounter(prefix + "jobs_ended_total", "Jobs that ended so, those of the journal too.", labels);
    seconds_[i] = registry.AddHistogram(prefix + "job_seconds", "From a job's making to its end.", labels, JobBounds());
  }
  queue_seconds_ = registry.AddHistogram(prefix + "job_queue_seconds",
                                         "From a job's making until a worker had its first task.", {}, QueueBounds());
  holes_filled_ = registry.AddCounter(prefix + "holes_filled_total", "Holes that were filled.", {});
  triangles_ = registry.AddCounter(prefix + "triangles_total", "New triangles, of holes that were filled.", {});
  cells_done_ = registry.AddCounter(prefix + "cells_done_total", "Cells that were done.", {});
  output_mismatches_ = registry.AddCounter(prefix + "output_mismatches_total",
                                           "Jobs that failed since their output was not there as it was written.", {});
}

void JobMetrics::Started(const Job& job) { queue_seconds_->Observe(absl::ToDoubleSeconds(job.started - job.created)); }

void JobMetrics::Ended(const Job& job, const absl::Status& error) {
  if (ErrorReason(error) == "OUTPUT_CHANGED") output_mismatches_->Increment();
  CountProgress(job);
  CountEnd(job);
  counted_.erase(job.id);
}

void JobMetrics::CountEnd(const Job& job) {
  if (!IsOver(job.state)) return;
  ended_[static_cast<size_t>(job.state)]->Increment();
  seconds_[static_cast<size_t>(job.state)]->Observe(absl::ToDoubleSeconds(job.ended - job.created));
}

// Progress may start anew when a coordinator does: only what is more than ever counts.
void JobMetrics::CountProgress(const Job& job) {
  Progress& counted = counted_[job.id];
  const int64_t holes = std::max<int64_t>(0, job.progress.holes_filled - counted.holes_filled);
  const int64_t cells = std::max<int64_t>(0, job.progress.cells_done - counted.cells_done);
  const int64_t triangles = std::max<int64_t>(0, job.progress.triangles - counted.triangles);
  holes_filled_->Increment(static_cast<double>(holes));
  triangles_->Increment(static_cast<double>(triangles));
  cells_done_->Increment(static_cast<double>(cells));
  counted.holes_filled += holes;
  counted.cells_done += cells;
  counted.triangles += triangles;
}

void JobMetrics::Show(const CoordinatorState& state, absl::Time now) {
  for (Slot& slot : slots_) {
    const Job* job = slot.job.empty() ? nullptr : state.FindJob(slot.job);
    if (job == nullptr || IsOver(job->state)) slot.job.clear();
  }
  for (const auto& [number, id] : state.running()) {
    CountProgress(*state.FindJob(id));
    if (SlotOf(id) > 0) continue;
    const auto free = std::find_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.job.empty(); });
    if (free != slots_.end()) free->job = id;
  }
  for (const Slot& slot : slots_) {
    const Job* job = slot.job.empty() ? nullptr : state.FindJob(slot.job);
    slot.share->Set(job == nullptr ? std::nan("") : ShareDone(*job));
    slot.age->Set(job == nullptr ? std::nan("") : absl::ToDoubleSeconds(now - job->created));
    slot.tasks_running->Set(job == nullptr ? std::nan("") : static_cast<double>(job->counts.leased));
  }
}

int32_t JobMetrics::SlotOf(const std::string& job) const {
  const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return slot.job == job; });
  return found == slots_.end() ? 0 : static_cast<int32_t>(found - slots_.begin()) + 1;
}

}  // namespace tilemend
