#include "coordinator/jobs/end_message.h"

#include <algorithm>
#include <iterator>

#include "absl/strings/str_cat.h"
#include "coordinator/report/left_open.h"

namespace tilemend {
namespace {

// Holes of the cells that were chosen.
struct ChosenCount {
  int64_t all = 0;
  int64_t stay_open = 0;  // of them, by the plan
};

ChosenCount CountChosen(const SceneReportInput& report) {
  ChosenCount chosen;
  for (const PlannedHole& hole : report.plan->holes) {
    if (!report.outcome.chosen.empty() && !report.outcome.chosen.contains(hole.cell)) continue;
    ++chosen.all;
    chosen.stay_open += hole.failure.empty() ? 0 : 1;
  }
  return chosen;
}

std::string Counted(int64_t count, const char* noun) { return absl::StrCat(count, " ", noun, count == 1 ? "" : "s"); }

std::string TextOf(const JobSpec& spec, const SceneReportInput& report, const ChosenCount& chosen) {
  if (!spec.dry_run()) {
    const bool is_some_left = chosen.stay_open > 0 || std::ranges::any_of(LeftOf(report), &LeftOpen::is_hole);
    return absl::StrCat(report.outcome.sizes.size(), " of ", Counted(chosen.all, "hole"), " filled",
                        UncountedText(report), is_some_left ? "; the report lists what is left open" : "");
  }
  return absl::StrCat(Counted(std::ssize(report.plan->holes), "hole"),
                      " found, nothing written: ", chosen.all - chosen.stay_open,
                      " to fill (filling may find some that stay open), ", chosen.stay_open,
                      chosen.stay_open == 1 ? " that stays open" : " that stay open");
}

}  // namespace

std::string EndMessage(const JobSpec& spec, const SceneReportInput& report, int64_t without_worker) {
  const ChosenCount chosen = CountChosen(report);
  std::string message = TextOf(spec, report, chosen);
  if (!spec.cells().empty()) {
    const int64_t all = std::ssize(report.plan->holes), cells = std::ssize(report.outcome.chosen);
    absl::StrAppend(&message, "; ", chosen.all, " of ", Counted(all, "hole"), chosen.all == 1 ? " is" : " are",
                    " in the ", cells, " of ", Counted(report.cells, "cell"), " that ", cells == 1 ? "was" : "were",
                    " chosen");
  }
  if (report.taken_over == 0) return message;
  if (report.tiles_kept > 0) {
    absl::StrAppend(&message, "; ", report.tiles_kept, " of ", report.tiles, " tiles kept as they were");
  }
  return absl::StrCat(message, "; ", report.taken_over, " of ", report.tasks, " results taken over, ", without_worker,
                      " of them without a task for a worker");
}

}  // namespace tilemend
