// Commands that talk to a coordinator.
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <random>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_split.h"
#include "client/commands.h"
#include "client/job_client.h"
#include "client/job_end.h"
#include "client/job_flags.h"
#include "client/output.h"
#include "client/progress_display.h"
#include "common/rpc/credentials.h"
#include "common/rpc/endpoint.h"
#include "common/util/error_info.h"
#include "common/util/signals.h"
#include "common/util/standard_streams.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr absl::Duration kPatience = absl::Milliseconds(1500);
constexpr absl::Duration kWatchPatience = absl::Minutes(10);    // the coordinator may start again meanwhile
constexpr absl::Duration kRestartPatience = absl::Seconds(15);  // of a script, that has named its request

std::string NewRequestId() {
  std::random_device random;
  return absl::StrFormat("%08x%08x%08x%08x", random(), random(), random(), random());
}

// What every command here begins with.
struct Session {
  OutputFormat format = OutputFormat::kTable;
  std::unique_ptr<JobClient> client;
  std::unique_ptr<SignalWatcher> signals;  // only if it is going to watch; it calls the client, so it goes first
};

// What may be wrong with a token if the coordinator cannot be reached; "" without one.
std::string TokenHint(const Security& security) {
  if (security.token_file.empty()) return "";
  if (security.tls.empty()) return "--token-file is given without --tls-ca: a coordinator with TLS needs that.";
  if (!security.tls.certificate.empty()) return "";
  return "--token-file is given without --tls-cert and --tls-key: a coordinator with --tls-ca needs them, too.";
}

absl::Duration PatienceOf(const Args& args, bool waits_for_start) {
  if (waits_for_start) return kWatchPatience;
  return args.IsGiven("request-id") ? kRestartPatience : kPatience;
}

absl::StatusOr<Session> OpenSession(const Args& args, bool watches, bool waits_for_start = false) {
  Session session;
  if (watches) session.signals = std::make_unique<SignalWatcher>();  // before gRPC has threads
  TILEMEND_ASSIGN_OR_RETURN(session.format, FormatFromFlags(args));
  const std::string address = args.Text("coordinator");
  TILEMEND_RETURN_IF_ERROR(CheckAddress(address));
  const Security security = SecurityFromFlags(args);
  TILEMEND_RETURN_IF_ERROR(CheckChannelSecurity(security, address));
  JobClient::Patience patience{PatienceOf(args, waits_for_start)};
  patience.hint = TokenHint(security);
  if (waits_for_start) {
    patience.on_wait = [address](const absl::Status& why) {
      std::fprintf(stderr, "tilemend: waits for the coordinator at %s (%s)\n", Printable(address).c_str(),
                   Printable(std::string(why.message())).c_str());
    };
  }
  session.client = std::make_unique<JobClient>(Connect(address, security), std::move(patience));
  return session;
}

int PrintJob(const absl::StatusOr<v1::Job>& job, OutputFormat format) {
  if (!job.ok()) return PrintError(job.status());
  std::fputs(JobText(*job, format).c_str(), stdout);
  if (format == OutputFormat::kTable) {
    std::fputs(ClusterEndText(*job, ColumnsOfTerminal(STDOUT_FILENO)).c_str(), stdout);
  }
  return kExitDone;
}

// Until the job is over; Ctrl-C ends the watching, not the job.
int WatchToEnd(Session& session, const std::string& name) {
  absl::StatusOr<v1::Job> job;
  {
    ProgressDisplay display;
    job = session.client->Watch(name, [&display](const v1::Job& now) { display.Show(now); });
    session.signals->Stop();
  }
  if (absl::IsCancelled(job.status())) {
    std::fprintf(stderr, "tilemend: %s goes on; `tilemend cancel %s` cancels it\n", name.c_str(), name.c_str());
    return kExitCancelled;
  }
  const int printed = PrintJob(job, session.format);
  return job.ok() ? ExitCodeOf(*job) : printed;
}

// From now on Ctrl-C ends what the session waits for.
void StopOnSignal(Session& session) {
  session.signals->Start([client = session.client.get()](int) { client->StopWatch(); });
}

// Prints a job that was just made, or waits for its end.
int AfterStart(Session& session, const Args& args, absl::StatusOr<v1::Job> job) {
  const std::string reason = ErrorReason(job.status());
  if (reason == "SCENE_NOT_FOUND" || reason == "FILE_NOT_FOUND") {
    job = absl::NotFoundError(absl::StrCat(std::string(job.status().message()), " where the coordinator runs"));
  }
  if (job.ok() && args.Switch("wait")) {
    StopOnSignal(session);
    return WatchToEnd(session, job->name());
  }
  const int printed = PrintJob(job, session.format);
  if (job.ok() && session.format == OutputFormat::kTable) {
    const std::string address = args.IsGiven("coordinator") ? " --coordinator " + args.Text("coordinator") : "";
    std::printf("\nfollow it: tilemend watch %s%s\n", job->name().c_str(), Printable(address).c_str());
  }
  return printed;
}

std::string RequestIdFromFlags(const Args& args) {
  return args.IsGiven("request-id") ? args.Text("request-id") : NewRequestId();
}

absl::StatusOr<int32_t> PriorityNamed(const std::string& text) {
  constexpr int32_t kMost = 100;  // as a coordinator takes it
  int32_t priority = 0;
  if (absl::SimpleAtoi(text, &priority) && -kMost <= priority && priority <= kMost) return priority;
  return absl::InvalidArgumentError(absl::StrCat("priority '", text, "': expected a whole number from -100 to 100"));
}

// What changes one job and needs no more than its name.
int ChangeJob(const Args& args, absl::StatusOr<v1::Job> (JobClient::*change)(const std::string&)) {
  auto session = OpenSession(args, false);
  if (!session.ok()) return PrintUsageError(session.status());
  const auto name = FindJobName(*session->client, args.arguments().front());
  if (!name.ok()) return PrintError(name.status());
  return PrintJob((session->client.get()->*change)(*name), session->format);
}

}  // namespace

int SubmitCommand(const Args& args) {
  auto session = OpenSession(args, args.Switch("wait"));
  if (!session.ok()) return PrintUsageError(session.status());
  const auto spec = JobFromFlags(args);
  if (!spec.ok()) return PrintUsageError(spec.status());
  v1::CreateJobRequest request;
  *request.mutable_spec() = *spec;
  request.set_request_id(RequestIdFromFlags(args));
  const auto priority = PriorityNamed(args.Text("priority"));
  if (!priority.ok()) return PrintUsageError(priority.status());
  request.set_priority(*priority);
  return AfterStart(*session, args, session->client->Create(request));
}

// A job that was cancelled a moment ago keeps its folder until its workers have left it.
absl::StatusOr<v1::Job> RetryOnceLeft(JobClient& client, const v1::RetryJobRequest& request) {
  const absl::Time end = absl::Now() + absl::Seconds(10);
  while (true) {
    absl::StatusOr<v1::Job> job = client.Retry(request);
    const std::optional<ErrorInfo> error = GetErrorInfo(job.status());
    const bool leaving = error && error->reason == "OUTPUT_IN_USE" && error->metadata.contains("job") &&
                         absl::StrCat("jobs/", error->metadata.at("job")) == request.name();
    if (!leaving || absl::Now() > end) return job;
    absl::SleepFor(absl::Milliseconds(100));
  }
}

int RetryCommand(const Args& args) {
  auto session = OpenSession(args, args.Switch("wait"));
  if (!session.ok()) return PrintUsageError(session.status());
  const auto name = FindJobName(*session->client, args.arguments().front());
  if (!name.ok()) return PrintError(name.status());
  v1::RetryJobRequest request;
  request.set_name(*name);
  request.set_request_id(RequestIdFromFlags(args));
  request.set_overwrite(args.Switch("overwrite"));
  return AfterStart(*session, args, RetryOnceLeft(*session->client, request));
}

int GetCommand(const Args& args) {
  auto session = OpenSession(args, false);
  if (!session.ok()) return PrintUsageError(session.status());
  const auto name = FindJobName(*session->client, args.arguments().front());
  if (!name.ok()) return PrintError(name.status());
  return PrintJob(session->client->Get(*name), session->format);
}

int CancelCommand(const Args& args) { return ChangeJob(args, &JobClient::Cancel); }
int PauseCommand(const Args& args) { return ChangeJob(args, &JobClient::Pause); }
int ResumeCommand(const Args& args) { return ChangeJob(args, &JobClient::Resume); }

int PrioritizeCommand(const Args& args) {
  auto session = OpenSession(args, false);
  if (!session.ok()) return PrintUsageError(session.status());
  const auto priority = PriorityNamed(args.arguments().back());
  if (!priority.ok()) return PrintUsageError(priority.status());
  const auto name = FindJobName(*session->client, args.arguments().front());
  if (!name.ok()) return PrintError(name.status());
  return PrintJob(session->client->Prioritize(*name, *priority), session->format);
}

int WatchCommand(const Args& args) {
  auto session = OpenSession(args, true, true);
  if (!session.ok()) return PrintUsageError(session.status());
  StopOnSignal(*session);
  const auto name = FindJobName(*session->client, args.arguments().front());
  return name.ok() ? WatchToEnd(*session, *name) : PrintError(name.status());
}

int WorkersCommand(const Args& args) {
  auto session = OpenSession(args, false);
  if (!session.ok()) return PrintUsageError(session.status());
  v1::ListWorkersRequest request;
  std::vector<v1::WorkerInfo> workers;
  do {
    const auto page = session->client->ListWorkers(request);
    if (!page.ok()) return PrintError(page.status());
    workers.insert(workers.end(), page->workers().begin(), page->workers().end());
    request.set_page_token(page->next_page_token());
  } while (!request.page_token().empty());
  std::fputs(WorkersText(workers, session->format, ColumnsOfTerminal(STDOUT_FILENO)).c_str(), stdout);
  return kExitDone;
}

int ListCommand(const Args& args) {
  auto session = OpenSession(args, false);
  if (!session.ok()) return PrintUsageError(session.status());
  v1::ListJobsRequest request;
  for (const absl::string_view name : absl::StrSplit(args.Text("state"), ',', absl::SkipEmpty())) {
    v1::JobState state{};
    if (!v1::JobState_Parse(absl::AsciiStrToUpper(name), &state) || state == v1::JOB_STATE_UNSPECIFIED) {
      return PrintUsageError(absl::InvalidArgumentError(
          absl::StrCat("--state '", name, "': expected running, done, partial, failed or cancelled")));
    }
    request.add_states(state);
  }
  std::vector<v1::Job> jobs;
  do {
    const auto page = session->client->List(request);
    if (!page.ok()) return PrintError(page.status());
    jobs.insert(jobs.end(), page->jobs().begin(), page->jobs().end());
    request.set_page_token(page->next_page_token());
  } while (!request.page_token().empty());
  std::fputs(JobsText(jobs, session->format, ColumnsOfTerminal(STDOUT_FILENO)).c_str(), stdout);
  return kExitDone;
}

}  // namespace tilemend
