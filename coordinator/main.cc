// tilemend-coordinator: takes jobs, plans them and gives their tasks to workers.
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <semaphore>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
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
#include "common/util/failpoint.h"
#include "common/util/flags.h"
#include "common/util/heap.h"
#include "common/util/job_log_tail.h"
#include "common/util/log.h"
#include "common/util/manual.h"
#include "common/util/roots.h"
#include "common/util/settings.h"
#include "common/util/signals.h"
#include "common/util/standard_streams.h"
#include "common/util/status_macros.h"
#include "common/util/version.h"
#include "common/util/without_exceptions.h"
#include "coordinator/api/access.h"
#include "coordinator/api/coordinator.h"
#include "coordinator/api/gate.h"
#include "coordinator/api/grpc_services.h"
#include "coordinator/jobs/scene_pipeline.h"
#include "coordinator/journal/postgres_journal.h"
#include "coordinator/journal/sqlite_journal.h"
#include "coordinator/journal/work_lock.h"
#include "coordinator/web/web_server.h"

namespace tilemend {
namespace {

constexpr char kProgram[] = "tilemend-coordinator";

std::vector<FlagSpec> CoordinatorFlags() {
  std::vector<FlagSpec> flags = {
      {"listen", "HOST:PORT", "address for clients and workers", "127.0.0.1:7070"},
      {"web", "HOST:PORT",
       "serve a page with jobs, maps and workers, and the API as JSON, on http://HOST:PORT (https with --tls-cert)",
       ""},
      {"log", "text|json|auto", "lines of the log on stderr; auto: text on a terminal, else JSON", "auto"},
      {"tokens", "FILE", "who may call by token: lines NAME ROLE[,ROLE] SHA256 [EXPIRES]", ""},
      {"audit", "FILE", "append who did what, as lines of JSON (default: in the log)", ""},
      {"root", "DIR[:DIR]", "jobs may name files below these folders alone (default: anywhere)", ""},
      {"work", "DIR", "folder for jobs and intermediate files; needed", ""},
      {"journal", "URI", "PostgreSQL in place of a file in --work, for coordinators that stand by (postgresql://...)",
       ""},
      {"stand-by", "SECONDS", "take over from a coordinator that is silent for so long, 3 to 3600", "10"},
      {"lease", "SECONDS", "a worker that is silent for longer is lost, 3 to 86400", "30"},
      {"longest-task", "HOURS", "an attempt that takes longer is given up, 0.01 to 1000", "6"},
      {"max-jobs", "N", "jobs at once, 1 to 10000", "64"},
      {"keep-jobs", "DAYS", "a job that is over is forgotten after so long, 0.01 to 10000", "30"},
      {"check-tiles", "size|digest|content",
       "what of tiles workers are held to: the sizes of files, their digests, which other workers verify, or every "
       "byte of what they must be",
       "digest"},
      {"verify", "PERCENT", "share of the files whose digests other workers verify, 0.01 to 100", "100"},
      {"recompute", "PERCENT", "share of the tasks that other workers compute again, 0 to 100", "2"},
      DescribeFlag(),
      {"version", "", "show the release", ""},
      {"help", "", "show this", "", 'h'},
  };
  const std::vector<FlagSpec> security = ServerSecurityFlags();
  flags.insert(flags.begin() + 1, security.begin(), security.end());
  const std::vector<FlagSpec> status = StatusFlags();
  flags.insert(flags.end() - 3, status.begin(), status.end());
  return AllAsSettings(std::move(flags));
}

// What of tiles workers are held to.
struct TileRules {
  TileCheck check = TileCheck::kSize;  // by the coordinator
  VerifiedShares verified = {};        // by other workers
};

absl::StatusOr<TileRules> TileRulesFromFlags(const Flags& flags) {
  const std::string name = flags.Text("check-tiles");
  if (name == "size") return TileRules{};
  if (name != "digest" && name != "content") {
    return absl::InvalidArgumentError(absl::StrCat("--check-tiles '", name, "': expected size, digest or content"));
  }
  TILEMEND_ASSIGN_OR_RETURN(const double files, flags.Number("verify", 0.01, 100));
  TILEMEND_ASSIGN_OR_RETURN(const double results, flags.Number("recompute", 0, 100));
  return TileRules{name == "content" ? TileCheck::kContent : TileCheck::kSize, {files / 100, results / 100}};
}

absl::StatusOr<CoordinatorOptions> OptionsFromFlags(const Flags& flags) {
  CoordinatorOptions options;
  if (!flags.arguments().empty()) {
    return absl::InvalidArgumentError(absl::StrCat("unexpected argument '", flags.arguments().front(), "'"));
  }
  options.work_folder = flags.Text("work");
  if (options.work_folder.empty()) return absl::InvalidArgumentError("--work DIR is needed");
  TILEMEND_ASSIGN_OR_RETURN(const double lease, flags.Number("lease", 3, 86400));
  options.lease = absl::Seconds(lease);
  TILEMEND_ASSIGN_OR_RETURN(const double longest, flags.Number("longest-task", 0.01, 1000));
  options.state.longest_attempt = absl::Hours(longest);
  TILEMEND_ASSIGN_OR_RETURN(const int64_t max_jobs, flags.Integer("max-jobs", 1, 10000));
  options.max_running_jobs = static_cast<size_t>(max_jobs);
  TILEMEND_ASSIGN_OR_RETURN(const double keep_jobs, flags.Number("keep-jobs", 0.01, 10000));
  options.keep_jobs = absl::Hours(24 * keep_jobs);
  TILEMEND_RETURN_IF_ERROR(TileRulesFromFlags(flags).status());
  options.attempts_of = AttemptsOfScene;
  options.build = BuildId();
  TILEMEND_RETURN_IF_ERROR(CheckAddress(flags.Text("listen")));
  TILEMEND_RETURN_IF_ERROR(CheckServerSecurity(SecurityFromFlags(flags), flags.Text("listen")));
  TILEMEND_RETURN_IF_ERROR(CheckStatusFlags(flags));
  if (flags.IsGiven("web")) {
    TILEMEND_RETURN_IF_ERROR(CheckAddress(flags.Text("web")));
    TILEMEND_RETURN_IF_ERROR(CheckServerSecurity(SecurityFromFlags(flags), flags.Text("web")));
  }
  return options;
}

int Fail(const absl::Status& status, int code) {
  std::fprintf(stderr, "tilemend-coordinator: %s\n", std::string(status.message()).c_str());
  return code;
}

// Jobs keep to the folders of --root, the program itself to these and its work folder.
absl::Status KeepToRoots(const Flags& flags, CoordinatorOptions& options) {
  std::vector<std::string> folders = RootsInFlag(flags.Text("root"));
  if (folders.empty()) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(options.roots, Roots::Open(folders));
  std::error_code error;
  options.work_folder = std::filesystem::absolute(options.work_folder, error).string();
  std::filesystem::create_directories(options.work_folder, error);
  folders.push_back(options.work_folder);
  TILEMEND_ASSIGN_OR_RETURN(auto all, Roots::Open(folders));
  KeepFilesTo(std::move(all));
  return absl::OkStatus();
}

double SizeOf(const std::string& path) {
  std::error_code error;
  const uintmax_t bytes = std::filesystem::file_size(path, error);
  return error ? 0 : static_cast<double>(bytes);
}

// Where lines go, and the last ones on jobs for the page.
struct Logs {
  StreamLog stream;
  JobLogTail tail{stream};
};

absl::StatusOr<std::unique_ptr<Logs>> LogFromFlags(const Flags& flags) {
  TILEMEND_ASSIGN_OR_RETURN(const LogFormat format, LogFormatNamed(flags.Text("log"), stderr));
  return std::unique_ptr<Logs>(new Logs{{stderr, format, {{"program", kProgram}, {"release", Version()}}}});
}

struct Audit {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file;
  std::unique_ptr<StreamLog> log;
};

// Null without a path. `log` is told when the file does not take lines any more.
absl::StatusOr<std::unique_ptr<Audit>> OpenAudit(const std::string& path, Log& log) {
  if (path.empty()) return nullptr;
  std::FILE* const file = std::fopen(path.c_str(), "ae");
  if (file == nullptr) {
    return absl::PermissionDeniedError(absl::StrCat(path, ": cannot append to it: ", std::strerror(errno)));
  }
  std::setvbuf(file, nullptr, _IONBF, 0);  // so that nothing of a line that a full disk refuses is tried again
  auto audit = std::make_unique<Audit>(Audit{{file, std::fclose}, nullptr});
  audit->log = std::make_unique<StreamLog>(file, LogFormat::kJson, LogFields{{"program", kProgram}});
  audit->log->OnLoss([path, &log] {
    log.Error("audit lines are lost", {{"file", path}, {"hint", "is the disk full?"}});
  });
  return audit;
}

// Whether callers need a name.
bool IsClosed(const Flags& flags) { return !flags.Text("tokens").empty() || !flags.Text("tls-ca").empty(); }

// Whoever asks for certificates or gives a file of tokens wants to know who calls. Without `audit` the log has its
// lines.
absl::StatusOr<std::shared_ptr<Gate>> GateFromFlags(const Flags& flags, MetricsRegistry& metrics, const Audit* audit,
                                                    Log& log) {
  Log& lines = audit == nullptr ? log : *audit->log;
  if (!IsClosed(flags)) return std::make_shared<Gate>(Access::Open(), metrics, lines);
  TILEMEND_ASSIGN_OR_RETURN(Access access, Access::Closed(flags.Text("tokens"), log));
  return std::make_shared<Gate>(std::move(access), metrics, lines);
}

// Null without --metrics.
absl::StatusOr<std::unique_ptr<StatusServer>> ServeMetrics(const Flags& flags, const CredentialFiles& credentials,
                                                           const std::string& work_folder, PrometheusRegistry& metrics,
                                                           ProcessMetrics& process, Log& log) {
  if (!flags.IsGiven("metrics")) return nullptr;
  Gauge* const journal_bytes =
      metrics.AddGauge("tilemend_coordinator_journal_bytes", "Size of the journal's files.", {});
  const StatusPages pages = {[&, journal_bytes, journal = work_folder + "/journal.sqlite"] {
    process.Update();
    journal_bytes->Set(SizeOf(journal) + SizeOf(journal + "-wal"));
    return metrics.Text();
  }};
  TILEMEND_ASSIGN_OR_RETURN(
      auto server, StatusServer::Start(flags.Text("metrics"), pages, StatusSecurityFromFlags(flags, credentials)));
  log.Info("metrics served", {{"address", WithPort(flags.Text("metrics"), server->port())}});
  return server;
}

// Null without --web.
absl::StatusOr<std::unique_ptr<WebServer>> ServePage(const Flags& flags, const TlsFiles& tls, Coordinator& coordinator,
                                                     const std::shared_ptr<Gate>& gate, const std::string& listen,
                                                     JobLogTail& log) {
  if (!flags.IsGiven("web")) return nullptr;
  TILEMEND_ASSIGN_OR_RETURN(
      auto server, WebServer::Start(flags.Text("web"), coordinator,
                                    {{tls.certificate, tls.key, tls.authority}, gate, IsClosed(flags), &log, listen}));
  log.Info("page served", {{"address", WithPort(flags.Text("web"), server->port())}});
  return server;
}

// In PostgreSQL the journal itself says who may write; then the work folder is shared.
struct OpenJournal {
  std::unique_ptr<WorkLock> lock;
  std::shared_ptr<Journal> journal;
};

absl::StatusOr<OpenJournal> JournalFromFlags(const Flags& flags, const std::string& work_folder,
                                             std::function<bool()> ends, Log& log) {
  OpenJournal opened;
  if (flags.Text("journal").empty()) {
    TILEMEND_ASSIGN_OR_RETURN(WorkLock lock, WorkLock::Take(work_folder));
    opened.lock = std::make_unique<WorkLock>(std::move(lock));
    TILEMEND_ASSIGN_OR_RETURN(opened.journal, OpenSqliteJournal(work_folder + "/journal.sqlite"));
    return opened;
  }
  StandBy stand_by;
  TILEMEND_ASSIGN_OR_RETURN(const double silence, flags.Number("stand-by", 3, 3600));
  stand_by.silence = absl::Seconds(silence);
  stand_by.waits = [&log] { log.Info("standing by: another coordinator is at work"); };
  stand_by.ends = std::move(ends);
  TILEMEND_ASSIGN_OR_RETURN(opened.journal, OpenPostgresJournal(flags.Text("journal"), stand_by));
  log.Info("at work", {{"epoch", static_cast<int64_t>(opened.journal->epoch())}});
  return opened;
}

// Sets the check of their results as well.
absl::StatusOr<PipelineFactory> PipelinesFromFlags(const Flags& flags, CoordinatorOptions& options) {
  TILEMEND_ASSIGN_OR_RETURN(const TileRules tiles, TileRulesFromFlags(flags));
  const auto surveys = std::make_shared<DecodedSurveys>();
  options.check_result = SceneResultCheck(tiles.check, surveys);
  return ScenePipelineFactory(options.work_folder, tiles.verified, surveys);
}

std::string TextOf(const Demand& demand) { return absl::StrCat(demand.jobs, " jobs, ", demand.tasks, " tasks"); }

absl::Status Serve(const Flags& flags, CoordinatorOptions options) {
  std::binary_semaphore stop(0);
  std::atomic<bool> is_asked_to_end{false};
  SignalWatcher signals;  // before any other thread
  signals.Start([&](int count) {
    is_asked_to_end.store(true);
    if (count == 1) stop.release();
  });
  PrometheusRegistry metrics;
  ProcessMetrics process(metrics, kProgram, Version());
  TILEMEND_ASSIGN_OR_RETURN(const auto logs, LogFromFlags(flags));
  JobLogTail& log = logs->tail;
  log.Info("starting", {{"build", options.build}});
  options.log = &log;
  TILEMEND_ASSIGN_OR_RETURN(const auto credentials,
                            CredentialKeeper::Start(CredentialFilesFromFlags(flags), log, metrics));
  TILEMEND_ASSIGN_OR_RETURN(const auto status,
                            ServeMetrics(flags, credentials->kept(), options.work_folder, metrics, process, log));
  TILEMEND_RETURN_IF_ERROR(KeepToRoots(flags, options));
  const auto opened = JournalFromFlags(
      flags, options.work_folder, [&] { return is_asked_to_end.load(); }, log);
  if (!opened.ok()) return absl::IsCancelled(opened.status()) ? absl::OkStatus() : opened.status();
  options.journal = opened->journal;
  TILEMEND_ASSIGN_OR_RETURN(PipelineFactory pipelines, PipelinesFromFlags(flags, options));
  TILEMEND_ASSIGN_OR_RETURN(const auto coordinator,
                            Coordinator::Create(std::move(options), std::move(pipelines), metrics));
  TILEMEND_ASSIGN_OR_RETURN(const auto audit, OpenAudit(flags.Text("audit"), log));
  TILEMEND_ASSIGN_OR_RETURN(const auto gate, GateFromFlags(flags, metrics, audit.get(), log));
  TILEMEND_ASSIGN_OR_RETURN(
      const auto server, CoordinatorServer::Start(flags.Text("listen"), *coordinator, {credentials->kept().tls, gate}));
  const std::string listen = WithPort(flags.Text("listen"), server->rpc().port());
  TILEMEND_ASSIGN_OR_RETURN(const auto page,
                            ServePage(flags, credentials->kept().tls, *coordinator, gate, listen, log));
  log.Info("listening", {{"address", listen}});
  const ServiceNotifier notifier([&coordinator] { return TextOf(coordinator->calls().cluster.DemandNow()); });
  stop.acquire();
  signals.Stop();  // before `stop` goes
  log.Info("ending");
  return absl::OkStatus();
}

int PrintDescription(const std::string& form) {
  const auto text = Describe({kProgram,
                              "takes jobs, plans them and gives their tasks to workers",
                              "--work DIR [FLAGS]",
                              "",
                              {},
                              CoordinatorFlags()},
                             form);
  if (!text.ok()) return Fail(text.status(), kExitUsage);
  std::fputs(text->c_str(), stdout);
  return kExitDone;
}

// Answers what is asked about the program itself, if anything is. Settings have no part in it.
std::optional<int> Answer(const Flags& flags) {
  if (flags.Switch("help")) {
    std::printf("Usage: tilemend-coordinator --work DIR [FLAGS]\n\n%s",
                FlagsHelp(CoordinatorFlags(), ColumnsOfHelp(STDOUT_FILENO)).c_str());
    return kExitDone;
  }
  if (flags.IsGiven("describe")) return PrintDescription(flags.Text("describe"));
  if (flags.Switch("version")) {
    std::printf("tilemend-coordinator %s, build %s\n", Version(), BuildId().c_str());
    return kExitDone;
  }
  return std::nullopt;
}

int Main(const std::vector<std::string>& words) {
  PrepareProcess();
  if (const auto asked = Flags::Parse(CoordinatorFlags(), words, {}); asked.ok()) {
    if (const std::optional<int> code = Answer(*asked)) return *code;
  }
  const auto settings = ReadSettings(CoordinatorFlags(), "", std::getenv);
  if (!settings.ok()) return Fail(settings.status(), kExitUsage);
  const auto flags = Flags::Parse(CoordinatorFlags(), words, *settings);
  if (!flags.ok()) return Fail(flags.status(), kExitUsage);
  auto options = OptionsFromFlags(*flags);
  if (!options.ok()) return Fail(options.status(), kExitUsage);
  const char* failpoint = std::getenv("TILEMEND_FAILPOINT");
  const absl::Status armed = ArmFailPoint(failpoint == nullptr ? "" : failpoint);
  if (!armed.ok()) return Fail(armed, kExitUsage);
  if (const absl::Status store = UseS3(); !store.ok()) return Fail(store, kExitUsage);
  ShareHeap();
  const absl::Status status = WithoutExceptions([&] { return Serve(*flags, *std::move(options)); });
  return status.ok() ? static_cast<int>(kExitDone) : Fail(status, ExitCodeOf(status));
}

}  // namespace
}  // namespace tilemend

int main(int argc, char** argv) { return tilemend::Main(std::vector<std::string>(argv + 1, argv + argc)); }
