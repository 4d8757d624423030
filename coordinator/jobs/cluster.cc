#include "coordinator/jobs/cluster.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/strip.h"
#include "common/util/error_info.h"

namespace tilemend {

Cluster::Cluster(CoordinatorOptions start, MetricsRegistry& registry)
    : options(std::move(start)),
      journal(options.journal),
      metrics(registry),
      job_metrics(registry),
      events(registry, job_metrics, *options.log),
      state(options.state) {}

absl::StatusOr<const Job*> Cluster::JobNamed(const std::string& name) const {
  absl::string_view id = name;
  if (!absl::ConsumePrefix(&id, "jobs/") || id.empty() || id.find('/') != absl::string_view::npos) {
    return WithErrorInfo(absl::InvalidArgumentError(absl::StrCat("'", name, "': expected jobs/ID")),
                         {"INVALID_NAME", {{"name", name}}});
  }
  const Job* job = state.FindJob(std::string(id));
  if (job != nullptr) return job;
  return WithErrorInfo(absl::NotFoundError(absl::StrCat(name, ": no such job; `tilemend list` shows all")),
                       {"JOB_NOT_FOUND", {{"job", std::string(id)}}});
}

MayWork Cluster::MayWorkNow() const {
  return [this](const std::string& worker, const std::string& job) { return trust.MayWorkOn(worker, job); };
}

std::set<std::string> WorkersBeingChecked(const Cluster& cluster) {
  std::set<std::string> workers;
  for (const auto& [worker, caller] : cluster.callers) {
    if (caller.calls > 0) workers.insert(worker);
  }
  return workers;
}

void Cluster::ShowMetrics() {
  metrics.Show(state);
  job_metrics.Show(state, options.clock());
}

void Cluster::Changed() {
  work_changed.notify_all();
  job_changed.notify_all();
}

void Cluster::StopWaiting() {
  const ClusterLock lock(mutex);
  stopping = true;
  stop_changed.notify_all();
  Changed();
  job_changed.Wake();
}

Sync OutputSync(const Cluster& cluster) { return cluster.journal->is_durable() ? Sync::kYes : Sync::kNo; }

std::string BlobsPathOf(const Cluster& cluster, const std::string& job) {
  return absl::StrCat(cluster.options.work_folder, "/jobs/", job);
}

}  // namespace tilemend
