// tilemend-worker: runs tasks of a coordinator. The first SIGTERM or SIGINT lets it finish and report what it has, the
// second makes it give that back.
#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/metrics/prometheus_registry.h"
#include "common/rpc/endpoint.h"
#include "common/util/exit_codes.h"
#include "common/util/flags.h"
#include "common/util/signals.h"
#include "common/util/status_macros.h"
#include "common/util/version.h"
#include "worker/service/scene_stages.h"
#include "worker/service/worker.h"

namespace tilemend {
namespace {

std::vector<FlagSpec> WorkerFlags() {
  return {
      {"coordinator", "HOST:PORT", "address of the coordinator", "127.0.0.1:7070"},
      {"threads", "N", "tasks at once, 1 to 1024 (default: the number of cores)", ""},
      {"metrics", "HOST:PORT", "serve Prometheus metrics on http://HOST:PORT/metrics", ""},
      {"version", "", "show the release", ""},
      {"help", "", "show this", "", 'h'},
  };
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
  TILEMEND_RETURN_IF_ERROR(CheckAddress(flags.Text("coordinator")));
  if (flags.IsGiven("metrics")) TILEMEND_RETURN_IF_ERROR(CheckAddress(flags.Text("metrics")));
  options.id = NewWorkerId();
  options.tell = [](const std::string& reason) {
    std::fprintf(stderr, "tilemend-worker: %s\n", reason.empty() ? "gets tasks again" : reason.c_str());
  };
  return options;
}

int Fail(const absl::Status& status, int code) {
  std::fprintf(stderr, "tilemend-worker: %s\n", std::string(status.message()).c_str());
  return code;
}

absl::Status Work(const Flags& flags, const WorkerOptions& options) {
  SignalWatcher signals;  // before any other thread
  PrometheusRegistry metrics;
  if (flags.IsGiven("metrics")) {
    const std::string address = flags.Text("metrics");
    TILEMEND_RETURN_IF_ERROR(metrics.Expose(address));
    std::fprintf(stderr, "tilemend-worker: metrics on http://%s:%d/metrics\n",
                 address.substr(0, address.rfind(':')).c_str(), metrics.port());
  }
  Worker worker(options, NewGrpcWorkLink(Connect(flags.Text("coordinator"))), SceneStageRunner(), metrics);
  std::fprintf(stderr, "tilemend-worker: %s with %d threads for %s\n", options.id.c_str(), options.threads,
               flags.Text("coordinator").c_str());
  signals.Start([&worker](int count) {
    std::fprintf(stderr, "tilemend-worker: %s\n", count == 1 ? "finishing what it has" : "giving back what it has");
    if (count == 1) {
      worker.Drain();
    } else {
      worker.Stop();
    }
  });
  const absl::Status status = worker.Join();
  signals.Stop();  // before the worker goes
  return status;
}

int Main(const std::vector<std::string>& words) {
  PrepareProcess();
  const auto flags = Flags::Parse(WorkerFlags(), words);
  if (!flags.ok()) return Fail(flags.status(), kExitUsage);
  if (flags->Switch("help")) {
    std::printf("Usage: tilemend-worker [FLAGS]\n\n%s", FlagsHelp(WorkerFlags()).c_str());
    return kExitDone;
  }
  if (flags->Switch("version")) {
    std::printf("tilemend-worker %s\n", Version());
    return kExitDone;
  }
  const auto options = OptionsFromFlags(*flags);
  if (!options.ok()) return Fail(options.status(), kExitUsage);
  const absl::Status status = Work(*flags, *options);
  return status.ok() ? static_cast<int>(kExitDone) : Fail(status, ExitCodeOf(status));
}

}  // namespace
}  // namespace tilemend

int main(int argc, char** argv) { return tilemend::Main(std::vector<std::string>(argv + 1, argv + argc)); }
