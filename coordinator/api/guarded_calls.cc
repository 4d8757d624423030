#include "coordinator/api/guarded_calls.h"

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/api/job_wait.h"

namespace tilemend {
namespace {

constexpr char kWatchJob[] = "tilemend.v1.Jobs/WatchJob";

JobOrigin OriginOf(const Peer& peer, const Caller& caller) { return {caller.name, peer.trace}; }

}  // namespace

absl::StatusOr<v1::Job> Entrance::Change(const Peer& peer, std::string_view rpc, const std::string& name, LogFields how,
                                         const std::function<absl::StatusOr<v1::Job>(const Caller&)>& call) const {
  return Ask<v1::Job>(peer, rpc, [&](const Caller& caller) {
    absl::StatusOr<v1::Job> job = call(caller);
    how.emplace(how.begin(), "what", job.ok() ? job->name() : name);
    gate_->Audit(rpc, caller, peer.address, how, job.status());
    return job;
  });
}

absl::StatusOr<Caller> GuardedCalls::Identify(const Peer& peer) const {
  return entrance_.Ask<Caller>(peer, "tilemend.v1.Jobs/ListJobs",
                               [](const Caller& caller) { return absl::StatusOr<Caller>(caller); });
}

absl::StatusOr<v1::Job> GuardedCalls::CreateJob(const Peer& peer, const v1::CreateJobRequest& request) const {
  const v1::JobSpec& spec = request.spec();
  LogFields how = {{"scene", spec.scene()}, {"out", spec.out()}, {"overwrite", spec.overwrite() ? "true" : ""}};
  return entrance_.Change(peer, "tilemend.v1.Jobs/CreateJob", "", std::move(how),
                          [&](const Caller& caller) { return calls_.jobs.CreateJob(request, OriginOf(peer, caller)); });
}

absl::StatusOr<v1::Job> GuardedCalls::GetJob(const Peer& peer, const v1::GetJobRequest& request) const {
  return entrance_.Ask<v1::Job>(peer, "tilemend.v1.Jobs/GetJob",
                                [&](const Caller&) { return calls_.jobs.GetJob(request); });
}

absl::StatusOr<v1::Job> GuardedCalls::WatchedJob(const Peer& peer, const v1::WatchJobRequest& request) const {
  v1::GetJobRequest get;
  get.set_name(request.name());
  return entrance_.Ask<v1::Job>(peer, kWatchJob, [&](const Caller&) { return calls_.jobs.GetJob(get); });
}

std::shared_ptr<void> GuardedCalls::AwaitJob(const Peer& peer, const v1::WatchJobRequest& request,
                                             std::function<void()> wake) const {
  return tilemend::AwaitJob(
      calls_.watch, request, [this, peer] { return entrance_.MayGoOn(peer, kWatchJob); }, std::move(wake));
}

absl::StatusOr<v1::ListJobsResponse> GuardedCalls::ListJobs(const Peer& peer,
                                                            const v1::ListJobsRequest& request) const {
  return entrance_.Ask<v1::ListJobsResponse>(peer, "tilemend.v1.Jobs/ListJobs",
                                             [&](const Caller&) { return calls_.jobs.ListJobs(request); });
}

absl::StatusOr<v1::Job> GuardedCalls::CancelJob(const Peer& peer, const v1::CancelJobRequest& request) const {
  return Steer(peer, "tilemend.v1.Jobs/CancelJob", {}, request, &JobsHandler::CancelJob);
}

absl::StatusOr<v1::Job> GuardedCalls::RetryJob(const Peer& peer, const v1::RetryJobRequest& request) const {
  return entrance_.Change(peer, "tilemend.v1.Jobs/RetryJob", request.name(),
                          {{"overwrite", request.overwrite() ? "true" : ""}},
                          [&](const Caller& caller) -> absl::StatusOr<v1::Job> {
                            TILEMEND_RETURN_IF_ERROR(CheckOwner(caller, request.name()));
                            return calls_.jobs.RetryJob(request, OriginOf(peer, caller));
                          });
}

absl::StatusOr<v1::Job> GuardedCalls::PauseJob(const Peer& peer, const v1::PauseJobRequest& request) const {
  return Steer(peer, "tilemend.v1.Jobs/PauseJob", {}, request, &JobsHandler::PauseJob);
}

absl::StatusOr<v1::Job> GuardedCalls::ResumeJob(const Peer& peer, const v1::ResumeJobRequest& request) const {
  return Steer(peer, "tilemend.v1.Jobs/ResumeJob", {}, request, &JobsHandler::ResumeJob);
}

absl::StatusOr<v1::Job> GuardedCalls::PrioritizeJob(const Peer& peer, const v1::PrioritizeJobRequest& request) const {
  return Steer(peer, "tilemend.v1.Jobs/PrioritizeJob", {{"priority", request.priority()}}, request,
               &JobsHandler::PrioritizeJob);
}

absl::StatusOr<v1::ListWorkersResponse> GuardedCalls::ListWorkers(const Peer& peer,
                                                                  const v1::ListWorkersRequest& request) const {
  return entrance_.Ask<v1::ListWorkersResponse>(peer, "tilemend.v1.Workers/ListWorkers",
                                                [&](const Caller&) { return calls_.cluster.ListWorkers(request); });
}

absl::StatusOr<JobCells> GuardedCalls::GetCells(const Peer& peer, const std::string& name) const {
  return entrance_.Ask<JobCells>(peer, "tilemend.v1.Jobs/GetJob",
                                 [&](const Caller&) { return calls_.jobs.GetCells(name); });
}

template <typename Request>
absl::StatusOr<v1::Job> GuardedCalls::Steer(const Peer& peer, std::string_view rpc, const LogFields& how,
                                            const Request& request,
                                            absl::StatusOr<v1::Job> (JobsHandler::*steer)(const Request&)) const {
  return entrance_.Change(peer, rpc, request.name(), how, [&](const Caller& caller) -> absl::StatusOr<v1::Job> {
    TILEMEND_RETURN_IF_ERROR(CheckOwner(caller, request.name()));
    return std::invoke(steer, calls_.jobs, request);
  });
}

// Another's job is the administrators'.
absl::Status GuardedCalls::CheckOwner(const Caller& caller, const std::string& name) const {
  if (caller.May(Role::kAdmin)) return absl::OkStatus();
  v1::GetJobRequest request;
  request.set_name(name);
  TILEMEND_ASSIGN_OR_RETURN(const v1::Job job, calls_.jobs.GetJob(request));
  if (job.owner() == caller.name) return absl::OkStatus();
  return WithErrorInfo(absl::PermissionDeniedError(absl::StrCat(name, ": is another's; it needs the role admin")),
                       {"ROLE_NEEDED", {{"role", "admin"}, {"job", name}}});
}

}  // namespace tilemend
