// The calls of clients, each behind the gate. The caller is admitted or refused, counted, and written to the log where
// it matters. Both gRPC and the JSON mirror are adapters over it, so they have the same permissions.
#ifndef TILEMEND_COORDINATOR_API_GUARDED_CALLS_H_
#define TILEMEND_COORDINATOR_API_GUARDED_CALLS_H_

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/clock.h"
#include "coordinator/api/coordinator.h"
#include "coordinator/api/gate.h"

namespace tilemend {

// Who is at the other end, as far as that is shown.
struct Peer {
  Claims claims;
  std::string address;
  std::string trace = {};  // of the call, "" without one
};

// Does around a call what every call needs. Thread-safe.
class Entrance {
 public:
  explicit Entrance(std::shared_ptr<Gate> gate) : gate_(std::move(gate)) {}

  // `call` takes the caller and gives an absl::Status. Errors of Gate::Admit.
  template <class Call>
  absl::Status Run(const Peer& peer, std::string_view rpc, Call call) const {
    const absl::Time start = absl::Now();
    const auto caller = Begin(peer, rpc);
    absl::Status status = caller.ok() ? call(*caller) : caller.status();
    End(rpc, status, start);
    return status;
  }

  // The two halves of Run, for a call that no thread waits for. Also of a call that was refused.
  absl::StatusOr<Caller> Begin(const Peer& peer, std::string_view rpc) const {
    return gate_->Admit(rpc, peer.claims, peer.address);
  }
  void End(std::string_view rpc, const absl::Status& status, absl::Time start) const {
    gate_->Ended(rpc, status, absl::Now() - start);
  }

  // Whether a call that was admitted still may go on: tokens expire and are taken back. Errors of Gate::Admit.
  absl::Status MayGoOn(const Peer& peer, std::string_view rpc) const {
    return gate_->Admit(rpc, peer.claims, peer.address).status();
  }

  // As Run, of a `call` that gives a value.
  template <typename T, class Call>
  absl::StatusOr<T> Ask(const Peer& peer, std::string_view rpc, Call call) const {
    absl::StatusOr<T> result = absl::InternalError("no answer");
    const absl::Status status = Run(peer, rpc, [&](const Caller& caller) {
      result = call(caller);
      return result.status();
    });
    return status.ok() ? std::move(result) : absl::StatusOr<T>(status);
  }

  // Of a call that changes a job: `call` gives the job's message. The `name` is the job's as far as it is known before,
  // and `how` what else the call asks for.
  absl::StatusOr<v1::Job> Change(const Peer& peer, std::string_view rpc, const std::string& name, LogFields how,
                                 const std::function<absl::StatusOr<v1::Job>(const Caller&)>& call) const;

 private:
  const std::shared_ptr<Gate> gate_;
};

// Thread-safe. Errors of the handlers and of Gate::Admit; kPermissionDenied (ROLE_NEEDED) for a change of another's job
// without the role admin.
class GuardedCalls {
 public:
  // Both must outlive this.
  GuardedCalls(CallHandlers& calls, const Entrance& entrance) : calls_(calls), entrance_(entrance) {}

  // The caller, if it may watch.
  absl::StatusOr<Caller> Identify(const Peer& peer) const;
  absl::StatusOr<v1::Job> CreateJob(const Peer& peer, const v1::CreateJobRequest& request) const;
  absl::StatusOr<v1::Job> GetJob(const Peer& peer, const v1::GetJobRequest& request) const;
  // The job as it is, as a watch's first state.
  absl::StatusOr<v1::Job> WatchedJob(const Peer& peer, const v1::WatchJobRequest& request) const;
  // Calls `wake` when the job has changed since `request.cursor`, or `peer` may not watch any more, as
  // tilemend::AwaitJob.
  std::shared_ptr<void> AwaitJob(const Peer& peer, const v1::WatchJobRequest& request,
                                 std::function<void()> wake) const;
  absl::StatusOr<v1::ListJobsResponse> ListJobs(const Peer& peer, const v1::ListJobsRequest& request) const;
  absl::StatusOr<v1::Job> CancelJob(const Peer& peer, const v1::CancelJobRequest& request) const;
  absl::StatusOr<v1::Job> RetryJob(const Peer& peer, const v1::RetryJobRequest& request) const;
  absl::StatusOr<v1::Job> PauseJob(const Peer& peer, const v1::PauseJobRequest& request) const;
  absl::StatusOr<v1::Job> ResumeJob(const Peer& peer, const v1::ResumeJobRequest& request) const;
  absl::StatusOr<v1::Job> PrioritizeJob(const Peer& peer, const v1::PrioritizeJobRequest& request) const;
  absl::StatusOr<v1::ListWorkersResponse> ListWorkers(const Peer& peer, const v1::ListWorkersRequest& request) const;
  // The map of a job, for whoever may see the job.
  absl::StatusOr<JobCells> GetCells(const Peer& peer, const std::string& name) const;

 private:
  template <typename Request>
  absl::StatusOr<v1::Job> Steer(const Peer& peer, std::string_view rpc, const LogFields& how, const Request& request,
                                absl::StatusOr<v1::Job> (JobsHandler::*steer)(const Request&)) const;
  absl::Status CheckOwner(const Caller& caller, const std::string& name) const;

  CallHandlers& calls_;
  const Entrance& entrance_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_GUARDED_CALLS_H_
