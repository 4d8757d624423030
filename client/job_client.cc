#include "client/job_client.h"

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/rpc/grpc_status.h"
#include "common/rpc/trace.h"
#include "common/util/status_macros.h"
#include "tilemend/v1/jobs.grpc.pb.h"

namespace tilemend {
namespace {

constexpr absl::Duration kPause = absl::Milliseconds(200);
constexpr absl::Duration kLongestPause = absl::Seconds(2);
constexpr absl::Duration kReconnectPatience = absl::Minutes(10);
constexpr absl::Duration kConnectedAfter =
    absl::Seconds(30);  // of a call without an answer: a job may be silent for hours
constexpr std::chrono::seconds kCallTimeout(30);

absl::Status Unreachable(const absl::Status& status, const std::string& hint) {
  return absl::UnavailableError(absl::StrCat(
      "cannot reach the coordinator; is it running, and are --coordinator, --tls-ca, --tls-cert and --tls-key "
      "right?",
      hint.empty() ? "" : " ", hint, " (", std::string(status.message()), ")"));
}

absl::Status Stopped() { return absl::CancelledError("the watch was stopped"); }

}  // namespace

class JobClient::Impl {
 public:
  Impl(const std::shared_ptr<grpc::Channel>& channel, Patience given)
      : stub(v1::Jobs::NewStub(channel)), workers(v1::Workers::NewStub(channel)), patience(std::move(given)) {}

  void TellOfWait(const absl::Status& status) {
    if (patience.on_wait && !told.exchange(true)) patience.on_wait(status);
  }

  // Repeats a call that is safe to repeat while the coordinator cannot be reached.
  template <typename Stub, typename Request, typename Response>
  absl::StatusOr<Response> Call(Stub& to, grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                                const Request& request, absl::Duration limit) {
    const absl::Time give_up = absl::Now() + limit;
    while (true) {
      grpc::ClientContext context;
      context.set_deadline(std::chrono::system_clock::now() + kCallTimeout);
      context.AddMetadata("traceparent", TraceParent(trace));
      Response response;
      const absl::Status status = FromServerStatus((to.*method)(&context, request, &response));
      if (status.ok()) {
        reached = true;
        return response;
      }
      if (!absl::IsUnavailable(status)) return status;
      if (absl::Now() + kPause > give_up) return Unreachable(status, patience.hint);
      if (stopped) return Stopped();
      TellOfWait(status);
      absl::SleepFor(kPause);
    }
  }

  const std::unique_ptr<v1::Jobs::Stub> stub;
  const std::unique_ptr<v1::Workers::Stub> workers;
  const std::string trace = NewTrace();
  const Patience patience;
  std::atomic<bool> reached{false};  // by a call
  std::atomic<bool> stopped{false};
  std::atomic<bool> told{false};  // of a wait
};

JobClient::JobClient(const std::shared_ptr<grpc::Channel>& channel, Patience patience)
    : impl_(std::make_unique<Impl>(channel, std::move(patience))) {}

JobClient::~JobClient() = default;

absl::StatusOr<v1::Job> JobClient::Create(const v1::CreateJobRequest& request) {
  return impl_->Call(*impl_->stub, &v1::Jobs::Stub::CreateJob, request,
                     request.request_id().empty() ? absl::ZeroDuration() : impl_->patience.of_calls);
}

absl::StatusOr<v1::Job> JobClient::Get(const std::string& name) {
  v1::GetJobRequest request;
  request.set_name(name);
  return impl_->Call(*impl_->stub, &v1::Jobs::Stub::GetJob, request, impl_->patience.of_calls);
}

absl::StatusOr<v1::ListJobsResponse> JobClient::List(const v1::ListJobsRequest& request) {
  return impl_->Call(*impl_->stub, &v1::Jobs::Stub::ListJobs, request, impl_->patience.of_calls);
}

absl::StatusOr<v1::ListWorkersResponse> JobClient::ListWorkers(const v1::ListWorkersRequest& request) {
  return impl_->Call(*impl_->workers, &v1::Workers::Stub::ListWorkers, request, impl_->patience.of_calls);
}

absl::StatusOr<v1::Job> JobClient::Cancel(const std::string& name) {
  v1::CancelJobRequest request;
  request.set_name(name);
  return impl_->Call(*impl_->stub, &v1::Jobs::Stub::CancelJob, request, impl_->patience.of_calls);
}

absl::StatusOr<v1::Job> JobClient::Pause(const std::string& name) {
  v1::PauseJobRequest request;
  request.set_name(name);
  return impl_->Call(*impl_->stub, &v1::Jobs::Stub::PauseJob, request, impl_->patience.of_calls);
}

absl::StatusOr<v1::Job> JobClient::Resume(const std::string& name) {
  v1::ResumeJobRequest request;
  request.set_name(name);
  return impl_->Call(*impl_->stub, &v1::Jobs::Stub::ResumeJob, request, impl_->patience.of_calls);
}

absl::StatusOr<v1::Job> JobClient::Prioritize(const std::string& name, int32_t priority) {
  v1::PrioritizeJobRequest request;
  request.set_name(name);
  request.set_priority(priority);
  return impl_->Call(*impl_->stub, &v1::Jobs::Stub::PrioritizeJob, request, impl_->patience.of_calls);
}

absl::StatusOr<v1::Job> JobClient::Retry(const v1::RetryJobRequest& request) {
  return impl_->Call(*impl_->stub, &v1::Jobs::Stub::RetryJob, request,
                     request.request_id().empty() ? absl::ZeroDuration() : impl_->patience.of_calls);
}

absl::Status JobClient::WatchOnce(v1::WatchJobRequest& request, const std::function<void(const v1::Job&)>& show,
                                  v1::Job& last) {
  grpc::ClientContext context;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    if (impl_->stopped) return Stopped();
    watch_context_ = &context;
  }
  const auto reader = impl_->stub->WatchJob(&context, request);
  v1::Job job;
  while (reader->Read(&job)) {
    request.set_cursor(job.cursor());
    show(job);
    last = job;
  }
  const absl::Status status = FromServerStatus(reader->Finish());
  std::lock_guard<std::mutex> lock(mutex_);
  watch_context_ = nullptr;
  return impl_->stopped ? Stopped() : status;
}

absl::StatusOr<v1::Job> JobClient::Watch(const std::string& name, const std::function<void(const v1::Job&)>& show) {
  v1::WatchJobRequest request;
  request.set_name(name);
  v1::Job last;
  const absl::Duration reconnect_patience =
      impl_->patience.of_calls > absl::ZeroDuration() ? kReconnectPatience : absl::ZeroDuration();
  absl::Time give_up = absl::Now() + (impl_->reached ? reconnect_patience : impl_->patience.of_calls);
  absl::Duration pause = kPause;
  while (true) {
    const uint64_t cursor = request.cursor();
    const absl::Time begun = absl::Now();
    const absl::Status status = WatchOnce(request, show, last);
    if (IsOver(last.state())) return last;
    const bool was_connected = request.cursor() != cursor || absl::Now() - begun > kConnectedAfter || status.ok();
    if (was_connected) {
      give_up = absl::Now() + reconnect_patience;
      pause = kPause;
    }
    if (status.ok()) {  // it had to make room for another watch
      absl::SleepFor(pause);
      continue;
    }
    const bool is_shed = absl::IsResourceExhausted(status);
    if (!absl::IsUnavailable(status) && !is_shed) return status;
    if (absl::Now() + pause > give_up) {
      if (last.name().empty()) return Unreachable(status, impl_->patience.hint);
      return absl::UnavailableError(absl::StrCat(name, ": lost the coordinator: ", std::string(status.message())));
    }
    if (last.name().empty() && absl::IsUnavailable(status)) impl_->TellOfWait(status);
    absl::SleepFor(pause);
    pause = std::min(2 * pause, kLongestPause);
  }
}

void JobClient::StopWatch() {
  std::lock_guard<std::mutex> lock(mutex_);
  impl_->stopped = true;
  if (watch_context_ != nullptr) watch_context_->TryCancel();
}

absl::StatusOr<std::string> FindJobName(JobClient& client, const std::string& argument) {
  constexpr size_t kWholeId = 12;
  const std::string name = JobName(argument);
  if (name == JobName(""))
    return absl::InvalidArgumentError(absl::StrCat("'", argument, "': expected the id of a job"));
  if (name.size() >= JobName("").size() + kWholeId) return name;
  std::vector<std::string> found;
  v1::ListJobsRequest request;
  do {
    TILEMEND_ASSIGN_OR_RETURN(const v1::ListJobsResponse page, client.List(request));
    for (const v1::Job& job : page.jobs()) {
      if (job.name() == name) return name;
      if (absl::StartsWith(job.name(), name)) found.push_back(job.name());
    }
    request.set_page_token(page.next_page_token());
  } while (!request.page_token().empty());
  if (found.size() < 2) return found.empty() ? name : found.front();
  return absl::InvalidArgumentError(absl::StrCat("'", argument, "': several jobs begin so: ", found[0], ", ", found[1],
                                                 found.size() > 2 ? ", ..." : ""));
}

std::string JobName(const std::string& argument) {
  return absl::StartsWith(argument, "jobs/") ? argument : absl::StrCat("jobs/", argument);
}

bool IsOver(v1::JobState state) { return state != v1::RUNNING && state != v1::JOB_STATE_UNSPECIFIED; }

}  // namespace tilemend
