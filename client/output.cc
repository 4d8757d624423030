#include "client/output.h"

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <tuple>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/strip.h"
#include "absl/time/clock.h"
#include "client/fitted_table.h"
#include "common/records/filler.h"
#include "common/records/surface.h"
#include "common/rpc/status_proto.h"
#include "common/util/error_info.h"
#include "common/util/stage_words.h"
#include "common/util/text.h"
#include "common/util/utc.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

std::string StateName(v1::JobState state) { return absl::AsciiStrToLower(v1::JobState_Name(state)); }

std::string TimeText(const google::protobuf::Timestamp& time) { return UtcText(absl::FromUnixSeconds(time.seconds())); }

// Since then, in a column: "0 s" takes less room.
std::string AgeText(const google::protobuf::Timestamp& time) {
  const absl::Duration age = absl::Now() - TimeOf(time);
  return age < absl::Milliseconds(500) ? "0 s" : DurationText(age);
}

// As people say it: a job that is paused, or for which there is no worker, does not run.
std::string StateText(const v1::Job& job) {
  if (job.state() != v1::RUNNING) return StateName(job.state());
  return job.paused() ? "paused" : job.waiting().empty() ? "running" : "waiting";
}

// Likewise: a worker that gets tasks and holds none is idle.
std::string StateText(const v1::WorkerInfo& worker) {
  if (worker.state() == v1::WORKING && worker.tasks() == 0) return "idle";
  return absl::StrReplaceAll(absl::AsciiStrToLower(v1::WorkerState_Name(worker.state())), {{"_", " "}});
}

// "2/2, 1 waiting": tasks that it is at, of those that it takes at once, and those that it holds beside them.
std::string TasksText(const v1::WorkerInfo& worker) {
  const int32_t waiting = std::max(0, worker.tasks() - worker.threads());
  return absl::StrCat(Share(worker.tasks() - waiting, worker.threads()),
                      waiting > 0 ? absl::StrCat(", ", waiting, " waiting") : "");
}

struct Column {
  size_t width = 0;
  bool has_numbers = false, has_texts = false;

  bool right() const { return has_numbers && !has_texts; }
  void Take(const std::string& cell) {
    width = std::max(width, ColumnsOf(cell));
    double number = 0;
    const auto digits = absl::StripPrefix(cell, "< ");  // as AreaText has them
    if (!cell.empty() && cell != "-") (absl::SimpleAtod(digits, &number) ? has_numbers : has_texts) = true;
  }
};

constexpr size_t kMostOfError = 6000;  // what is longer is a path of a hundred thousand letters

// Bytes of a path need not be UTF-8.
std::string Dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

absl::Time TimeOf(const google::protobuf::Timestamp& time) {
  return absl::FromUnixSeconds(time.seconds()) + absl::Nanoseconds(time.nanos());
}

std::string DurationText(absl::Duration duration) {
  constexpr absl::Duration kHalf = absl::Milliseconds(500);
  if (duration < kHalf) return "less than 1 s";
  const int64_t seconds = absl::ToInt64Seconds(duration + kHalf);
  if (seconds < 60) return absl::StrCat(seconds, " s");
  if (seconds < 3600) return absl::StrFormat("%d min %02d s", seconds / 60, seconds % 60);
  if (seconds < 48 * 3600) return absl::StrFormat("%d h %02d min", seconds / 3600, seconds / 60 % 60);
  return absl::StrFormat("%d d %02d h", seconds / 86400, seconds / 3600 % 24);
}

std::string Share(int64_t part, int64_t whole) { return whole == 0 ? "-" : absl::StrCat(part, "/", whole); }

Json JobJson(const v1::Job& job) {
  const v1::Progress& p = job.progress();
  Json json = {{"name", job.name()},
               {"state", StateName(job.state())},
               {"scene", job.spec().scene()},
               {"out", job.spec().out()},
               {"created", TimeText(job.create_time())}};
  if (job.has_end_time()) json["ended"] = TimeText(job.end_time());
  json["progress"] = {{"phase", p.phase()},
                      {"cells", p.cells()},
                      {"cells_done", p.cells_done()},
                      {"holes", p.holes()},
                      {"holes_filled", p.holes_filled()},
                      {"tasks", p.tasks()},
                      {"tasks_done", p.tasks_done()},
                      {"tasks_running", p.tasks_running()},
                      {"tasks_retried", p.tasks_retried()},
                      {"tasks_quarantined", p.tasks_quarantined()},
                      {"tasks_taken_over", p.tasks_taken_over()}};
  if (job.has_error()) {
    const absl::Status error = StatusFromProto(job.error());
    json["error"] = {{"code", absl::StatusCodeToString(error.code())},
                     {"message", job.error().message()},
                     {"reason", ErrorReason(error)}};
  }
  if (job.has_start_time()) json["started"] = TimeText(job.start_time());
  if (!job.owner().empty()) json["owner"] = job.owner();
  if (!job.trace().empty()) json["trace"] = job.trace();
  if (!job.waiting().empty()) json["waiting"] = job.waiting();
  if (job.slot() > 0) json["slot"] = job.slot();
  json["priority"] = job.priority();
  json["paused"] = job.paused();
  for (const std::string& warning : job.warnings()) json["warnings"].push_back(warning);
  if (!job.message().empty()) json["message"] = job.message();
  if (!job.report().empty()) json["report"] = job.report();
  return json;
}

std::string MoreText(size_t count, const std::string& where) {
  return count > kMostListedRows ? absl::StrCat("and ", count - kMostListedRows, " more; ", where, "\n") : "";
}

std::string LevelText(const Json& level) {
  if (!level.is_array() || level.size() != 2) return Decimals(level, 3);
  return absl::StrCat(Decimals(level[0], 3), " to ", Decimals(level[1], 3));
}

std::string Table(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows) {
  std::vector<Column> columns;
  for (const std::string& heading : headings) columns.push_back({heading.size()});
  for (const auto& row : rows) {
    for (size_t i = 0; i < row.size() && i < columns.size(); ++i) columns[i].Take(Printable(row[i]));
  }
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    std::string line;
    for (size_t i = 0; i < row.size() && i < columns.size(); ++i) {
      const std::string cell = Printable(row[i]);
      const std::string padding(columns[i].width - ColumnsOf(cell), ' ');
      absl::StrAppend(&line, columns[i].right() ? padding : "", cell, columns[i].right() ? "" : padding, "  ");
    }
    absl::StrAppend(&text, std::string(absl::StripTrailingAsciiWhitespace(line)), "\n");
  };
  add(headings);
  for (const auto& row : rows) add(row);
  return text;
}

std::string Counted(size_t count, const std::string& noun) { return Counted(count, noun, noun + "s"); }

std::string Counted(size_t count, const std::string& one, const std::string& many) {
  return absl::StrCat(count, " ", count == 1 ? one : many);
}

namespace {

// The surface, and the filler of closed holes where one is named.
std::string SurfaceText(const v1::JobSpec& spec) {
  const bool is_named = !spec.filler().empty() && spec.filler() != FillerName(Filler::kAuto);
  return absl::StrCat(spec.surface().empty() ? SurfaceName(kDefaultSurface) : spec.surface(),
                      is_named ? absl::StrCat(", closed holes by ", spec.filler()) : "");
}

}  // namespace

std::string JobText(const v1::Job& job, OutputFormat format) {
  if (format == OutputFormat::kJson) return Dump(JobJson(job));
  const v1::Progress& p = job.progress();
  const bool is_dry = job.spec().dry_run();  // nothing is filled
  std::vector<std::vector<std::string>> rows = {{"state", StateText(job)}, {"scene", job.spec().scene()}};
  if (!job.spec().out().empty()) rows.push_back({"out", job.spec().out()});
  rows.push_back({"surface", SurfaceText(job.spec())});
  if (!p.phase().empty()) rows.push_back({"phase", StageWordsOf(p.phase())});
  for (const auto& [name, part, whole] : {std::tuple("cells", p.cells_done(), p.cells()),
                                          {"holes", p.holes_filled(), p.holes()},
                                          {"tasks", p.tasks_done(), p.tasks()}}) {
    const bool is_whole = is_dry && std::string_view(name) != "tasks";
    if (whole > 0) rows.push_back({name, is_whole ? absl::StrCat(whole) : Share(part, whole)});
  }
  if (job.priority() != 0) rows.push_back({"priority", absl::StrCat(job.priority())});
  if (!job.waiting().empty()) rows.push_back({"waiting", job.waiting()});
  const absl::Time created = TimeOf(job.create_time());
  const absl::Time end = job.has_end_time() ? TimeOf(job.end_time()) : absl::Now();
  rows.push_back({"elapsed", DurationText(end - created)});
  if (!job.owner().empty()) rows.push_back({"owner", job.owner()});
  if (p.tasks_retried() > 0) rows.push_back({"retried", absl::StrCat(p.tasks_retried())});
  if (p.tasks_quarantined() > 0) rows.push_back({"quarantined", absl::StrCat(p.tasks_quarantined())});
  for (const std::string& warning : job.warnings()) rows.push_back({"warning", warning});
  if (!job.message().empty()) rows.push_back({"message", job.message()});
  if (job.has_error()) rows.push_back({"error", job.error().message()});
  if (!job.report().empty()) rows.push_back({"report", job.report()});
  if (!job.name().empty()) return Table({"job", job.name()}, rows);
  const std::vector<std::string> first = rows.front();
  rows.erase(rows.begin());
  return Table(first, rows);
}

std::string JobsText(const std::vector<v1::Job>& jobs, OutputFormat format, size_t columns) {
  if (format == OutputFormat::kJson) {
    Json json = Json::array();
    for (const v1::Job& job : jobs) json.push_back(JobJson(job));
    return Dump(json);
  }
  std::vector<std::vector<std::string>> rows;
  for (const v1::Job& job : jobs) {
    rows.push_back({job.name(), StateText(job), Share(job.progress().cells_done(), job.progress().cells()),
                    Share(job.progress().tasks_done(), job.progress().tasks()), AgeText(job.create_time()),
                    job.spec().out()});
  }
  return FittedTable({{"JOB"}, {"STATE"}, {"CELLS", 3}, {"TASKS", 2}, {"AGE", 1}, {"OUT", 0, true}}, std::move(rows),
                     columns);
}

std::string WorkersText(const std::vector<v1::WorkerInfo>& workers, OutputFormat format, size_t columns) {
  std::vector<std::vector<std::string>> rows;
  Json json = Json::array();
  for (const v1::WorkerInfo& w : workers) {
    const std::string state = StateText(w);
    rows.push_back({w.id(), state, TasksText(w), AgeText(w.first_seen()), AgeText(w.last_seen()), w.release(),
                    w.identity(), w.message()});
    json.push_back({{"id", w.id()},
                    {"state", state},
                    {"tasks", w.tasks()},
                    {"threads", w.threads()},
                    {"first_seen", TimeText(w.first_seen())},
                    {"last_seen", TimeText(w.last_seen())},
                    {"release", w.release()},
                    {"identity", w.identity()},
                    {"message", w.message()}});
  }
  if (format == OutputFormat::kJson) return Dump(json);
  return FittedTable({{"WORKER", 0, true},
                      {"STATE"},
                      {"TASKS"},
                      {"AGE", 1},
                      {"SEEN", 2},
                      {"RELEASE", 4},
                      {"IDENTITY", 3},
                      {"MESSAGE", 0, true}},
                     std::move(rows), columns);
}

ExitCode ExitCodeOf(const v1::Job& job) {
  switch (job.state()) {
    case v1::PARTIAL:
      return kExitSomeLeft;
    case v1::FAILED:
      return job.has_error() ? ExitCodeOf(StatusFromProto(job.error())) : kExitFailed;
    case v1::CANCELLED:
      return kExitCancelled;
    default:
      return kExitDone;
  }
}

ExitCode PrintError(const absl::Status& status) {
  std::fprintf(stderr, "tilemend: %s\n", Printable(Shortened(std::string(status.message()), kMostOfError)).c_str());
  return ExitCodeOf(status);
}

void PrintWarnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    std::fprintf(stderr, "tilemend: warning: %s\n", Printable(warning).c_str());
  }
}

}  // namespace tilemend
