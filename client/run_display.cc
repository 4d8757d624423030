#include "client/run_display.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/time/clock.h"
#include "client/hole_columns.h"
#include "client/holes_table.h"
#include "client/left_table.h"
#include "client/output.h"
#include "client/progress_display.h"
#include "client/water_table.h"
#include "common/util/stage_words.h"
#include "common/util/standard_streams.h"
#include "common/util/text.h"
#include "coordinator/jobs/job_metrics.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/left_open.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

std::string Counts(const char* name, int64_t done, int64_t all) {
  return all == 0 ? "" : absl::StrCat(", ", done, " of ", all, " ", name);
}

// "81 of 84 holes filled, 6551.8 m2", of the cells that were chosen.
std::string FilledText(const Json& report) {
  size_t holes = 0, filled = 0;
  double area = 0;
  for (const Json& hole : Member(report, "per_hole")) {
    if (!IsInChosenCell(hole)) continue;
    ++holes;
    if (Text(Member(hole, "outcome")) != "filled") continue;
    ++filled;
    area += Number(Member(hole, "area_m2"));
  }
  return absl::StrCat(filled, " of ", Counted(holes, "hole"), " filled, ", HoleColumns(report).Area(area), " m2",
                      UncountedText(report), "\n");
}

// "61 of 64 tiles kept as they were", where some were.
std::string KeptText(const Json& report) {
  const Json &tasks = Member(report, "tasks"), &all = Member(tasks, "tiles"), &kept = Member(tasks, "tiles_kept");
  if (Number(kept) == 0) return "";
  return absl::StrCat(Text(kept), " of ", Text(all), " tiles kept as they were\n");
}

std::string WarningLines(const Json& report) {
  std::string text;
  for (const Json& warning : Member(report, "warnings")) {
    absl::StrAppend(&text, "warning: ", Printable(Text(warning)), "\n");
  }
  return text;
}

}  // namespace

std::string StageText(const v1::Job& job) {
  const v1::Progress& p = job.progress();
  std::string name = StageWordsOf(p.phase());
  if (p.phase().starts_with("fill")) return name + Counts("holes", p.holes_filled(), p.holes());
  if (p.phase().starts_with("assemble")) return name + Counts("cells", p.cells_done(), p.cells());
  return name;
}

std::string EndWithoutReport(const v1::Job& job) {
  if (job.state() == v1::FAILED) return "";
  std::string text;
  for (const std::string& warning : job.warnings()) absl::StrAppend(&text, "warning: ", Printable(warning), "\n");
  return absl::StrCat(text, job.state() == v1::CANCELLED ? "cancelled" : Printable(job.message()), "\n");
}

std::string ResultText(const Json& report, size_t columns) {
  return absl::StrCat(FilledText(report), KeptText(report), WarningLines(report),
                      WaterText(report, "filled flat as water", columns), ReviewText(report, columns),
                      LookAtText(report, columns), LeftText(report, "left open", columns));
}

RunDisplay::RunDisplay() : is_terminal_(::isatty(STDERR_FILENO) == 1), begin_(absl::Now()) {}

RunDisplay::~RunDisplay() { EndStage(); }

void RunDisplay::EndStage() {
  if (stage_.empty()) return;
  EraseBar();
  std::fprintf(stderr, "%s, %.1f s\n", stage_.c_str(), absl::ToDoubleSeconds(absl::Now() - begin_));
}

void RunDisplay::Show(const v1::Job& job) {
  const v1::Progress& p = job.progress();
  if (p.phase().empty() || p.phase() == kResumePhase) return;
  if (std::string stage = StageWordsOf(p.phase()); stage != stage_) {
    EndStage();
    stage_ = std::move(stage);
    begin_ = absl::Now();
    if (!is_terminal_) std::fprintf(stderr, "%s\n", stage_.c_str());
  }
  if (!is_terminal_) return;
  share_ = std::max(share_, ShareDone(p.phase(), p.cells(), p.cells_done(), p.tasks(), p.tasks_done()));
  EraseBar();
  std::fputs(BarLine(share_, StageText(job), ColumnsOfTerminal(STDERR_FILENO)).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace tilemend
