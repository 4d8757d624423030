#include "coordinator/jobs/earlier_output.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "common/records/output_names.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/report/report_key.h"

namespace tilemend {

std::string OutputKey(const std::string& scene_key) { return Sha256Hex(scene_key); }

absl::StatusOr<bool> MayReplace(const JobSpec& spec, const std::string& key) {
  if (spec.overwrite() || spec.decisions().empty()) return spec.overwrite();
  const auto report = ReadFile(absl::StrCat(spec.out(), "/", kReportFiles[0]));
  if (!report.ok()) return false;
  if (KeyInReport(*report) == key) return true;
  return WithErrorInfo(
      absl::AlreadyExistsError(absl::StrCat(
          Printable(spec.out()),
          ": the output there is of another scene or other options, so decisions do not apply to it; give those that "
          "its report.json names, choose another --out, or give --overwrite to do all of it again")),
      {"OUTPUT_EXISTS", {}});
}

void WarnOfUndoneDecisions(const JobSpec& spec, WaterChoice& water) {
  if (spec.decisions().empty()) return;
  const auto is_decision = [](const WaterArea& area) { return area.decision != ReviewDecision::kNone; };
  const auto given = static_cast<size_t>(std::ranges::count_if(water.options.areas, is_decision));
  const auto report = ReadFile(absl::StrCat(spec.out(), "/", kReportFiles[0]));
  const size_t decided = report.ok() ? DecidedHolesIn(*report) : 0;
  if (decided <= given) return;
  const std::string holes = absl::StrCat(decided, decided == 1 ? " hole" : " holes");
  water.warnings.push_back(
      given == 0
          ? absl::StrCat(spec.decisions(), ": the decisions of the last run on ", holes, " are undone")
          : absl::StrCat(spec.decisions(), ": it has ", given, given == 1 ? " decision" : " decisions",
                         ", and the last run had some on ", holes, "; those that are not in the file are undone"));
}

absl::StatusOr<JobOnOutput> OnOutput(const JobSpec& spec, const WaterChoice& water, const std::string& area_digest,
                                     const Scene& scene) {
  JobOnOutput job{spec, IdentityOf(spec), "", false};
  AddFileDigest("water", water.digest, job.identity);
  AddFileDigest("clear", water.clear_digest, job.identity);
  AddFileDigest("area", area_digest, job.identity);
  TILEMEND_ASSIGN_OR_RETURN(const OutputCells cells, CellsWithOutput(spec, job.identity, scene));
  job.adds = cells.adds;
  job.spec.set_cells(cells.cells);
  job.identity["cells"] = cells.cells;
  job.key = OutputKey(JobKey(job.identity));
  AddFileDigest("decisions", water.decisions_digest, job.identity);
  return job;
}

}  // namespace tilemend
