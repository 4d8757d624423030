// tilemend-worker: runs tasks of a coordinator. The first SIGTERM or SIGINT lets it finish and report what it has, the
// second makes it give that back.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/metrics/process_metrics.h"
#include "common/metrics/prometheus_registry.h"
#include "common/metrics/status_server.h"
#include "common/rpc/credential_keeper.h"
#include "common/rpc/credentials.h"
#include "common/rpc/endpoint.h"
#include "common/rpc/status_flags.h"
#include "common/s3/s3_store.h"
#include "common/service/service_notifier.h"
#include "common/util/build_id.h"
#include "common/util/exit_codes.h"
#include "common/util/flags.h"
#include "common/util/heap.h"
#include "common/util/log.h"
#include "common/util/manual.h"
#include "common/util/roots.h"
#include "common/util/settings.h"
#include "common/util/signals.h"
#include "common/util/standard_streams.h"
#include "common/util/status_macros.h"
#include "common/util/version.h"
#include "common/util/without_exceptions.h"
#include "worker/service/scene_stages.h"
#include "worker/service/task_memory.h"
#include "worker/service/worker.h"
#include "worker/service/worker_id.h"

namespace tilemend {
namespace {

constexpr char kProgram[] = "tilemend-worker";

std::vector<FlagSpec> WorkerFlags() {
  std::vector<FlagSpec> flags = {
      {"coordinator", "HOST:PORT", "address of the coordinator", "127.0.0.1:7070"},
      {"threads", "N", "tasks at once, 1 to 1024 (default: the number of cores)", ""},
      {"task-memory", "MB",
       "memory that tasks take at once, 64 to 1e6; one alone may take more (default: 3/4 of what there is)", ""},
      {"root", "DIR[:DIR]", "read and write files below these folders alone (default: anywhere)", ""},
      {"health", "HOST:PORT", "answer the standard gRPC health check there", ""},
      {"log", "text|json|auto", "lines of the log on stderr; auto: text on a terminal, else JSON", "auto"},
      DescribeFlag(),
      {"version", "", "show the release", ""},
      {"help", "", "show this", "", 'h'},
  };
  const std::vector<FlagSpec> security = ChannelSecurityFlags();
  flags.insert(flags.begin() + 1, security.begin(), security.end());
  const std::vector<FlagSpec> status = StatusFlags();
  flags.insert(flags.end() - 3, status.begin(), status.end());
  return AllAsSettings(std::move(flags));
}

// Bytes.
absl::StatusOr<int64_t> TaskMemoryFromFlags(const Flags& flags) {
  if (!flags.IsGiven("task-memory")) return static_cast<int64_t>(MemoryLimitBytes() * 3 / 4);
  TILEMEND_ASSIGN_OR_RETURN(const int64_t megabytes,
                            flags.Integer("task-memory", kLeastTaskMegabytes, kMostTaskMegabytes));
  return megabytes * kMegabyte;
}

absl::StatusOr<WorkerOptions> OptionsFromFlags(const Flags& flags) {
  WorkerOptions options;
  if (!flags.arguments().empty()) {
    return absl::InvalidArgumentError(absl::StrCat("unexpected argument '", flags.arguments().front(), "'"));
  }
  options.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  if (flags.IsGiven("threads")) {
    TILEMEND_ASSIGN_OR_RETURN(const int64_t threads, flags.Integer("threads", 1, 1024));
    options.threads = static_cast<int>(threads);
  }
  options.prefetch = options.threads + 2;
  TILEMEND_RETURN_IF_ERROR(CheckAddress(flags.Text("coordinator")));
  const Security security = SecurityFromFlags(flags);
  TILEMEND_RETURN_IF_ERROR(CheckChannelSecurity(security, flags.Text("coordinator")));
  TILEMEND_RETURN_IF_ERROR(CheckStatusFlags(flags));
  if (flags.IsGiven("health")) {
    TILEMEND_RETURN_IF_ERROR(CheckAddress(flags.Text("health")));
    TILEMEND_RETURN_IF_ERROR(CheckServerSecurity(security, flags.Text("health")));
  }
  options.id = NewWorkerId();
  options.build = BuildId();
  return options;
}

int Fail(const absl::Status& status, int code) {
  std::fprintf(stderr, "tilemend-worker: %s\n", std::string(status.message()).c_str());
  return code;
}

absl::Status KeepToRoots(const Flags& flags) {
  const std::vector<std::string> folders = RootsInFlag(flags.Text("root"));
  if (folders.empty()) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(auto roots, Roots::Open(folders));
  KeepFilesTo(std::move(roots));
  return absl::OkStatus();
}

// Null without --metrics.
absl::StatusOr<std::unique_ptr<StatusServer>> ServeMetrics(const Flags& flags, const CredentialFiles& credentials,
                                                           PrometheusRegistry& metrics, ProcessMetrics& process,
                                                           Worker& worker, Log& log) {
  if (!flags.IsGiven("metrics")) return nullptr;
  const StatusPages pages = {[&] {
                               process.Update();
                               return metrics.Text();
                             },
                             [&worker] { return worker.WhyNotReady(); }};
  TILEMEND_ASSIGN_OR_RETURN(
      auto server, StatusServer::Start(flags.Text("metrics"), pages, StatusSecurityFromFlags(flags, credentials)));
  log.Info("metrics served", {{"address", WithPort(flags.Text("metrics"), server->port())}});
  return server;
}

absl::Status Work(const Flags& flags, WorkerOptions options, int64_t task_memory) {
  SignalWatcher signals;  // before any other thread
  TILEMEND_RETURN_IF_ERROR(KeepToRoots(flags));
  PrometheusRegistry metrics;
  ProcessMetrics process(metrics, kProgram, Version());
  TILEMEND_ASSIGN_OR_RETURN(const LogFormat format, LogFormatNamed(flags.Text("log"), stderr));
  StreamLog log(stderr, format, {{"program", kProgram}, {"release", Version()}, {"worker", options.id}});
  options.log = &log;
  KeepHeap(options.threads);
  log.Info("starting",
           {{"coordinator", flags.Text("coordinator")}, {"threads", options.threads}, {"build", options.build}});
  TILEMEND_ASSIGN_OR_RETURN(const auto credentials,
                            CredentialKeeper::Start(CredentialFilesFromFlags(flags), log, metrics));
  const CredentialFiles& kept = credentials->kept();
  Worker worker(options, NewGrpcWorkLink(Connect(flags.Text("coordinator"), {kept.tls, kept.token})),
                SceneStageRunner(task_memory), metrics);
  std::unique_ptr<RpcServer> health;
  if (flags.IsGiven("health")) {
    TILEMEND_ASSIGN_OR_RETURN(health, RpcServer::Start(flags.Text("health"), {}, kept.tls));
    log.Info("health served", {{"address", WithPort(flags.Text("health"), health->port())}});
  }
  TILEMEND_ASSIGN_OR_RETURN(const auto status, ServeMetrics(flags, kept, metrics, process, worker, log));
  const ServiceNotifier notifier([&worker] {
    const std::string reason = worker.WhyNotReady();
    return reason.empty() ? "connected" : reason;
  });
  signals.Start([&](int count) {
    log.Info(count == 1 ? "finishing what it has" : "giving back what it has");
    if (count == 1) {
      worker.Drain();
    } else {
      worker.Stop();
    }
  });
  absl::Status end = worker.Join();
  signals.Stop();  // before the worker goes
  return end;
}

int PrintDescription(const std::string& form) {
  const auto text = Describe({kProgram, "runs tasks of a coordinator", "[FLAGS]", "", {}, WorkerFlags()}, form);
  if (!text.ok()) return Fail(text.status(), kExitUsage);
  std::fputs(text->c_str(), stdout);
  return kExitDone;
}

// Answers what is asked about the program itself, if anything is. Settings have no part in it.
std::optional<int> Answer(const Flags& flags) {
  if (flags.Switch("help")) {
    std::printf("Usage: tilemend-worker [FLAGS]\n\n%s", FlagsHelp(WorkerFlags(), ColumnsOfHelp(STDOUT_FILENO)).c_str());
    return kExitDone;
  }
  if (flags.IsGiven("describe")) return PrintDescription(flags.Text("describe"));
  if (flags.Switch("version")) {
    std::printf("tilemend-worker %s, build %s\n", Version(), BuildId().c_str());
    return kExitDone;
  }
  return std::nullopt;
}

int Main(const std::vector<std::string>& words) {
  PrepareProcess();
  if (const auto asked = Flags::Parse(WorkerFlags(), words, {}); asked.ok()) {
    if (const std::optional<int> code = Answer(*asked)) return *code;
  }
  const auto settings = ReadSettings(WorkerFlags(), "", std::getenv);
  if (!settings.ok()) return Fail(settings.status(), kExitUsage);
  const auto flags = Flags::Parse(WorkerFlags(), words, *settings);
  if (!flags.ok()) return Fail(flags.status(), kExitUsage);
  const auto options = OptionsFromFlags(*flags);
  if (!options.ok()) return Fail(options.status(), kExitUsage);
  const auto task_memory = TaskMemoryFromFlags(*flags);
  if (!task_memory.ok()) return Fail(task_memory.status(), kExitUsage);
  if (const absl::Status store = UseS3(); !store.ok()) return Fail(store, kExitUsage);
  const absl::Status status = WithoutExceptions([&] { return Work(*flags, *options, *task_memory); });
  return status.ok() ? static_cast<int>(kExitDone) : Fail(status, ExitCodeOf(status));
}

}  // namespace
}  // namespace tilemend

int main(int argc, char** argv) { return tilemend::Main(std::vector<std::string>(argv + 1, argv + argc)); }
