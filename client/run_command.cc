// `tilemend run`: a coordinator and a worker inside this process, over the same calls as on a cluster.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "absl/strings/str_cat.h"
#include "client/acceptance.h"
#include "client/acceptance_text.h"
#include "client/commands.h"
#include "client/job_client.h"
#include "client/job_end.h"
#include "client/job_flags.h"
#include "client/output.h"
#include "client/progress_display.h"
#include "client/report_page.h"
#include "client/report_text.h"
#include "client/run_display.h"
#include "client/saved_acceptance.h"
#include "client/unfinished.h"
#include "client/work_folder.h"
#include "common/rpc/status_proto.h"
#include "common/util/error_info.h"
#include "common/util/exit_codes.h"
#include "common/util/folders.h"
#include "common/util/heap.h"
#include "common/util/signals.h"
#include "common/util/standard_streams.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/api/coordinator.h"
#include "coordinator/api/grpc_services.h"
#include "coordinator/jobs/scene_pipeline.h"
#include "worker/service/scene_stages.h"
#include "worker/service/task_memory.h"
#include "worker/service/worker.h"

namespace tilemend {
namespace {

// A job that was refused.
v1::Job NotBegun(const v1::JobSpec& spec, const absl::Status& error) {
  v1::Job job;
  job.set_state(v1::FAILED);
  *job.mutable_spec() = spec;
  *job.mutable_error() = StatusToProto(error);
  return job;
}

// As a job of this process is shown. The only worker is the process itself, for which nothing waits, and no other
// command can name the job.
v1::Job Shown(v1::Job job) {
  job.clear_waiting();
  job.clear_name();
  return job;
}

// What tasks may take of the machine.
struct Means {
  int threads = 1;
  int64_t memory_bytes = 0;
};

absl::StatusOr<Means> MeansFromFlags(const Args& args) {
  Means means{static_cast<int>(std::max(1U, std::thread::hardware_concurrency())), 0};
  if (args.IsGiven("workers")) {
    TILEMEND_ASSIGN_OR_RETURN(const int64_t workers, args.Integer("workers", 1, 1024));
    means.threads = static_cast<int>(workers);
  }
  TILEMEND_ASSIGN_OR_RETURN(const int64_t megabytes,
                            args.Integer("task-memory", kLeastTaskMegabytes, kMostTaskMegabytes));
  means.memory_bytes = megabytes * kMegabyte;
  return means;
}

absl::StatusOr<std::unique_ptr<Coordinator>> EmbeddedCoordinator(const std::string& work_folder) {
  CoordinatorOptions options;
  options.work_folder = work_folder;
  // Workers of this process cannot be lost without it; a machine that slept must not look like one that died.
  options.lease = absl::Hours(24);
  // The only worker is this process: what it gets wrong once it gets wrong again.
  const auto surveys = std::make_shared<DecodedSurveys>();
  options.check_result = SceneResultCheck(TileCheck::kSize, surveys);
  options.attempts_of = AttemptsOfScene;
  options.state.max_refusals = 1;
  return Coordinator::Create(options, ScenePipelineFactory(work_folder, {}, surveys), *MetricsRegistry::Null());
}

using ShowJob = std::function<void(const v1::Job&)>;

// Runs the job to its end. The first signal cancels it.
absl::StatusOr<v1::Job> RunEmbedded(const v1::JobSpec& spec, const Means& means, const std::string& work_folder,
                                    SignalWatcher& signals, const ShowJob& show) {
  TILEMEND_ASSIGN_OR_RETURN(const auto coordinator, EmbeddedCoordinator(work_folder));
  TILEMEND_ASSIGN_OR_RETURN(const auto server, CoordinatorServer::Start("", *coordinator));
  JobClient client(server->rpc().InProcessChannel(), absl::ZeroDuration());
  v1::CreateJobRequest request;
  *request.mutable_spec() = spec;
  const auto job = client.Create(request);
  if (!job.ok()) return NotBegun(spec, job.status());
  WorkerOptions worker_options;
  worker_options.id = "embedded";
  worker_options.threads = means.threads;
  worker_options.prefetch = 2 * means.threads;  // the only worker
  // Out of reach in the same process: it has no thread for the calls.
  worker_options.patience = absl::Seconds(10);
  v1::CancelJobRequest cancel;
  cancel.set_name(job->name());
  // Not by a call, for which there may be no thread. Refused if the job has just ended; then there is nothing to
  // cancel.
  const auto cancel_job = [&coordinator, cancel] {
    coordinator->calls().jobs.CancelJob(cancel).status().IgnoreError();
  };
  worker_options.on_end = cancel_job;
  Worker worker(worker_options, NewGrpcWorkLink(server->rpc().InProcessChannel()), SceneStageRunner(means.memory_bytes),
                *MetricsRegistry::Null());
  signals.Start([&cancel_job](int) { cancel_job(); });
  auto end = client.Watch(job->name(), [&show](const v1::Job& now) { show(Shown(now)); });
  signals.Stop();  // before the coordinator goes
  worker.Stop();
  TILEMEND_RETURN_IF_ERROR(worker.Join());
  return end;
}

// The same, shown as `is_plain` says.
absl::StatusOr<v1::Job> RunAndShow(const v1::JobSpec& spec, const Means& means, const std::string& work_folder,
                                   SignalWatcher& signals, bool is_plain) {
  if (is_plain) {
    RunDisplay display;
    return RunEmbedded(spec, means, work_folder, signals, [&display](const v1::Job& job) { display.Show(job); });
  }
  ProgressDisplay display;
  return RunEmbedded(spec, means, work_folder, signals, [&display](const v1::Job& job) { display.Show(job); });
}

// Whether the job ended before its output was complete, and left some.
bool LeftUnfinished(const v1::Job& job) {
  const absl::Status status = StatusFromProto(job.error());
  // The output of another job is not its business.
  const bool wrote = job.state() == v1::CANCELLED || (job.state() == v1::FAILED && !absl::IsAlreadyExists(status) &&
                                                      ErrorReason(status) != "OUTPUT_IN_USE");
  return wrote && IsUnfinished(job.spec().out());
}

// Whether the job found a complete output without the page, as if the program that made it was killed just then.
bool LacksPage(const v1::Job& job) {
  if (ErrorReason(StatusFromProto(job.error())) != "OUTPUT_EXISTS") return false;
  return KindOf(job.spec().out() + "/report.json") == PathKind::kFile &&
         KindOf(job.spec().out() + "/report.html") == PathKind::kNothing;
}

std::string PageLine(const std::string& page) {
  return absl::StrCat("page: ", Printable(page), " (open it in a browser)\n");
}

// The path of the page, which it writes beside a new report; "" without one. Without it the output is complete.
std::string WritePage(const v1::Job& job) {
  if (job.report().empty()) return "";
  const absl::Status written = WriteReportPage(std::filesystem::path(job.report()).parent_path().string());
  if (written.ok()) return absl::StrCat(job.spec().out(), "/report.html");
  PrintWarnings({absl::StrCat("no report.html: ", std::string(written.message()))});
  return "";
}

// The job, and what its report says.
void PrintJob(const v1::Job& job, OutputFormat format, const std::string& page) {
  std::fputs(JobText(format == OutputFormat::kTable ? Shown(job) : job, format).c_str(), stdout);
  if (format == OutputFormat::kJson || job.report().empty()) return;
  const auto report = ReportOf(job);
  if (!report.ok()) {
    PrintError(report.status());
    return;
  }
  std::fputs(SummaryText(*report, ColumnsOfTerminal(STDOUT_FILENO)).c_str(), stdout);
  if (!page.empty()) std::fputs(("\n" + PageLine(page)).c_str(), stdout);
}

// `--check` compares tiles that were written.
absl::Status CheckCanFollow(const v1::JobSpec& spec) {
  v1::Job done;
  done.set_state(v1::DONE);
  *done.mutable_spec() = spec;
  if (CanBeChecked(done)) return absl::OkStatus();
  return absl::InvalidArgumentError("run: --check needs an output, and --dry-run writes none");
}

// Compares the output with the scene, and keeps the verdict for the page.
absl::StatusOr<Acceptance> Accept(const std::string& scene, const std::string& out) {
  StepDisplay display;
  TILEMEND_ASSIGN_OR_RETURN(Acceptance acceptance, CheckAcceptance(scene, out, display.Watcher()));
  TILEMEND_RETURN_IF_ERROR(SaveAcceptance(out, acceptance, absl::Now()));
  return acceptance;
}

// The result, without a word on jobs and tasks: on a terminal short, else whole.
void PrintResult(const v1::Job& job, const std::string& page) {
  if (job.report().empty()) {
    std::fputs(EndWithoutReport(job).c_str(), stdout);
    return;
  }
  const auto report = ReportOf(job);
  if (!report.ok()) {
    PrintError(report.status());
    return;
  }
  const size_t columns = ColumnsOfTerminal(STDOUT_FILENO);
  const bool is_short = ::isatty(STDOUT_FILENO) == 1;
  const std::string text = is_short ? ResultText(*report, columns)
                                    : absl::StrCat(Printable(job.message()), "\n", SummaryText(*report, columns));
  std::fputs(text.c_str(), stdout);
  const std::string where = page.empty() ? absl::StrCat("report: ", Printable(job.report()), "\n") : PageLine(page);
  std::fputs(absl::StrCat("\n", where).c_str(), stdout);
}

// What became of a job that failed or was cancelled.
void PrintFailure(const v1::Job& job) {
  if (job.state() == v1::FAILED) PrintError(StatusFromProto(job.error()));
  if (!LeftUnfinished(job)) return;
  const char* const first = ExitCodeOf(job) == kExitInvalidInput ? "once that is mended, " : "";
  std::fprintf(stderr, "tilemend: %s is not complete; %sthe same command completes it\n",
               Printable(job.spec().out()).c_str(), first);
}

// How a finished job can be checked, or what the check says. `acceptance`: of --check. The exit code.
int PrintAcceptance(const v1::Job& job, const std::string& scene,
                    const std::optional<absl::StatusOr<Acceptance>>& acceptance, OutputFormat format) {
  const bool is_table = format == OutputFormat::kTable;
  if (!acceptance) {
    if (is_table && CanBeChecked(job)) std::fputs(CheckLine(scene, job.spec().out()).c_str(), stdout);
    return kExitDone;
  }
  if (!acceptance->ok()) return PrintError(acceptance->status());
  PrintWarnings((*acceptance)->warnings);
  const bool is_accepted = (*acceptance)->IsAccepted();
  const std::string text = is_accepted ? absl::StrCat(VerdictOf(**acceptance), "\n") : AcceptanceText(**acceptance);
  if (is_table) std::fputs(absl::StrCat("\n", text).c_str(), stdout);
  return is_accepted ? kExitDone : kExitSomeLeft;
}

// Runs the job in a work folder that goes away again.
absl::StatusOr<v1::Job> RunLocally(const Args& args, const v1::JobSpec& spec, const Means& means, bool is_plain) {
  SignalWatcher signals;  // before any other thread; until the work folder is gone
  TILEMEND_ASSIGN_OR_RETURN(const WorkFolder work_folder, WorkFolder::Make(args.Text("work")));
  KeepHeap(means.threads);
  return RunAndShow(spec, means, work_folder.path(), signals, is_plain);
}

}  // namespace

int RunCommand(const Args& args) {
  const auto format = FormatFromFlags(args);
  if (!format.ok()) return PrintUsageError(format.status());
  const auto spec = JobFromFlags(args);
  if (!spec.ok()) return PrintUsageError(spec.status());
  const auto means = MeansFromFlags(args);
  if (!means.ok()) return PrintUsageError(means.status());
  const absl::Status can_check = args.Switch("check") ? CheckCanFollow(*spec) : absl::OkStatus();
  if (!can_check.ok()) return PrintUsageError(can_check);
  const std::string& scene = args.arguments().front();
  const bool is_plain = *format == OutputFormat::kTable && !args.Switch("verbose");
  const auto job = RunLocally(args, *spec, *means, is_plain);
  if (!job.ok()) return PrintError(job.status());
  PrintFailure(*job);
  std::optional<absl::StatusOr<Acceptance>> acceptance;
  if (args.Switch("check") && CanBeChecked(*job)) acceptance = Accept(scene, spec->out());
  const std::string page = WritePage(*job);
  if (LacksPage(*job)) {
    const std::string out = Printable(spec->out());
    std::fprintf(stderr, "tilemend: %s has no report.html; `tilemend report %s --html` writes it\n", out.c_str(),
                 out.c_str());
  }
  // A job that failed before its first phase has nothing more to tell.
  const bool only_error = job->state() == v1::FAILED && job->progress().phase().empty();
  if (is_plain) {
    PrintResult(*job, page);
  } else if (!only_error || *format == OutputFormat::kJson) {
    PrintJob(*job, *format, page);
  }
  const int accepted = PrintAcceptance(*job, scene, acceptance, *format);
  return ExitCodeOf(*job) == kExitDone ? accepted : ExitCodeOf(*job);
}

}  // namespace tilemend
