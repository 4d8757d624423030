#include "coordinator/jobs/describe_job.h"

#include <cstdint>
#include <string>

#include "absl/strings/str_cat.h"
#include "coordinator/jobs/job_proto.h"

namespace tilemend {
namespace {

// Why none of the job's tasks runs, for people; "" if one does.
std::string WhyWaiting(const Cluster& cluster, const Job& job) {
  if (IsOver(job.state)) return "";
  if (job.paused) return "it is paused; `tilemend resume` lets it go on";
  if (job.counts.leased > 0 || job.counts.pending == 0) return "";
  int64_t able = 0, barred = 0;
  for (const auto& [id, worker] : cluster.state.workers()) {
    able += !worker.draining && cluster.trust.MayWorkOn(id, job.id) ? 1 : 0;
    barred += worker.draining || cluster.trust.IsBarred(id, job.id) ? 1 : 0;
  }
  const auto connected = static_cast<int64_t>(cluster.state.workers().size());
  if (connected == 0) return "no worker is connected";
  if (able == 0 && barred < connected) return "workers look at its folders";
  if (able > 0) return absl::StrCat("the workers that may work on it are busy or rest (", able, ")");
  return absl::StrCat("none of the connected workers (", connected, ") may work on it; `tilemend workers` says why");
}

}  // namespace

v1::Job DescribeJob(const Cluster& cluster, const Job& job) {
  const JobEntry& entry = cluster.jobs.at(job.id);
  v1::Job message = JobToProto(job, entry.spec, entry.outcome, entry.error, entry.origin);
  message.set_waiting(WhyWaiting(cluster, job));
  message.set_slot(cluster.job_metrics.SlotOf(job.id));
  return message;
}

}  // namespace tilemend
