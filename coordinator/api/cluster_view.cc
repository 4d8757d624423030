// What CoordinatorImpl tells of its jobs and workers.
#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/rpc/limits.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/api/coordinator_impl.h"
#include "coordinator/jobs/job_proto.h"

namespace tilemend {
namespace {

// Then a page ends: one job more, with its longest paths, error and warnings, fits into a message.
constexpr size_t kMostPageBytes = size_t{2} << 20;

constexpr int32_t kDefaultPageSize = 50;
constexpr int32_t kMaxPageSize = 1000;

absl::Status InvalidPage(const std::string& what) {
  return WithErrorInfo(absl::InvalidArgumentError(what), {"INVALID_PAGE", {}});
}

int32_t PageSize(int32_t wanted) { return wanted == 0 ? kDefaultPageSize : std::min(wanted, kMaxPageSize); }

}  // namespace

v1::Job CoordinatorImpl::Describe(const Job& job) const {
  const JobEntry& entry = entries_.at(job.id);
  v1::Job message = JobToProto(job, entry.spec, entry.outcome, entry.error, entry.origin);
  message.set_waiting(WhyWaiting(job));
  message.set_slot(events_.SlotOf(job.id));
  return message;
}

std::string CoordinatorImpl::WhyWaiting(const Job& job) const {
  if (IsOver(job.state)) return "";
  if (job.paused) return "it is paused; `tilemend resume` lets it go on";
  if (job.counts.leased > 0 || job.counts.pending == 0) return "";
  int64_t able = 0, barred = 0;
  for (const auto& [id, worker] : state_.workers()) {
    able += !worker.draining && trust_.MayWorkOn(id, job.id) ? 1 : 0;
    barred += worker.draining || trust_.IsBarred(id, job.id) ? 1 : 0;
  }
  const auto connected = static_cast<int64_t>(state_.workers().size());
  if (connected == 0) return "no worker is connected";
  if (able == 0 && barred < connected) return "workers look at its folders";
  if (able > 0) return absl::StrCat("the workers that may work on it are busy or rest (", able, ")");
  return absl::StrCat("none of the connected workers (", connected, ") may work on it; `tilemend workers` says why");
}

void CoordinatorImpl::ShowMetrics() {
  metrics_.Show(state_);
  events_.Show(state_, options_.clock());
}

absl::StatusOr<v1::ListJobsResponse> CoordinatorImpl::ListJobs(const v1::ListJobsRequest& request) {
  if (request.page_size() < 0) return InvalidPage("page_size: below 0");
  int64_t below = std::numeric_limits<int64_t>::max();  // the token is the number of the last job that was looked at
  if (!request.page_token().empty() &&
      (!absl::SimpleAtoi(request.page_token(), &below) || below <= 0 || absl::StrCat(below) != request.page_token())) {
    return InvalidPage(absl::StrCat("page_token: '", request.page_token(), "' was not given out here"));
  }
  const std::set<int> states(request.states().begin(), request.states().end());
  return Answer([&] {
    const auto& numbers = state_.job_numbers();
    v1::ListJobsResponse response;
    auto it = numbers.lower_bound(below);
    size_t bytes = 0;
    while (it != numbers.begin() && response.jobs_size() < PageSize(request.page_size()) && bytes < kMostPageBytes) {
      --it;
      v1::Job job = Describe(*state_.FindJob(it->second));
      if (!states.empty() && !states.contains(job.state())) continue;
      bytes += job.ByteSizeLong();
      *response.add_jobs() = std::move(job);
    }
    if (it != numbers.begin()) response.set_next_page_token(absl::StrCat(it->first));
    return response;
  });
}

v1::WorkerInfo CoordinatorImpl::Describe(const WorkerRecord& worker) const {
  v1::WorkerInfo info;
  info.set_id(worker.id);
  info.set_threads(worker.threads);
  info.set_tasks(static_cast<int32_t>(worker.held.size()));
  SetTime(worker.last_seen, *info.mutable_last_seen());
  if (const auto caller = callers_.find(worker.id); caller != callers_.end()) {
    info.set_release(caller->second.release);
    info.set_identity(caller->second.identity);
    SetTime(caller->second.first_seen, *info.mutable_first_seen());
  }
  info.set_message(trust_.WhySetAside(worker.id));
  info.set_state(!info.message().empty() ? v1::SET_ASIDE : worker.draining ? v1::DRAINING : v1::WORKING);
  if (const std::vector<std::string> jobs = trust_.BlindTo(worker.id); info.message().empty() && !jobs.empty()) {
    info.set_message(absl::StrCat("does not see the folders of jobs/", absl::StrJoin(jobs, ", jobs/")));
  }
  return info;
}

absl::StatusOr<v1::ListWorkersResponse> CoordinatorImpl::ListWorkers(const v1::ListWorkersRequest& request) {
  if (request.page_size() < 0) return InvalidPage("page_size: below 0");
  Lock lock(mutex_);
  v1::ListWorkersResponse response;
  // The token is the last worker that was shown.
  auto it = state_.workers().upper_bound(request.page_token());
  for (; it != state_.workers().end() && response.workers_size() < PageSize(request.page_size()); ++it) {
    *response.add_workers() = Describe(it->second);
  }
  if (it != state_.workers().end()) response.set_next_page_token(std::prev(it)->first);
  return response;
}

Demand CoordinatorImpl::DemandNow() {
  return Answer([&] { return DemandOf(state_); });
}

absl::Status CoordinatorImpl::WatchDemand(const std::function<bool(bool)>& send, const std::function<bool()>& alive) {
  TILEMEND_ASSIGN_OR_RETURN(const auto call, watches_.Enter("", options_.clock(), [] {}));
  std::optional<bool> told;
  Lock lock(mutex_);
  while (!stopping_) {
    const bool active = DemandOf(state_).jobs > 0;
    if (told != active) {
      lock.unlock();
      if (!send(active)) return absl::CancelledError("the watcher went away");
      told = active;
      lock.lock();
      continue;
    }
    job_changed_.wait_for(lock, absl::ToChronoMilliseconds(kMaxPoll));
    if (!alive()) return absl::CancelledError("the watcher went away");
  }
  return absl::UnavailableError("the coordinator is shutting down");
}

}  // namespace tilemend
