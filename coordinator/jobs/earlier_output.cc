#include "coordinator/jobs/earlier_output.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/records/output_names.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/report/report_key.h"

namespace tilemend {

namespace {

constexpr size_t kMostNamed = 10;  // holes in a warning

// Numbers of holes mean the same holes only in an output with the same key.
std::set<int32_t> DecidedBefore(const JobSpec& spec, const std::string& key) {
  if (spec.decisions().empty()) return {};
  const auto report = ReadFile(absl::StrCat(spec.out(), "/", kReportFiles[0]));
  return report.ok() && KeyInReport(*report) == key ? DecidedHolesIn(*report) : std::set<int32_t>();
}

}  // namespace

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
  job.decided_before = DecidedBefore(job.spec, job.key);
  AddFileDigest("decisions", water.decisions_digest, job.identity);
  return job;
}

std::string UndoneDecisions(const JobOnOutput& job, const std::map<int32_t, int32_t>& decisions) {
  std::vector<int32_t> undone;
  for (const int32_t hole : job.decided_before) {
    if (!decisions.contains(hole)) undone.push_back(hole);
  }
  if (undone.empty()) return "";
  const size_t all = undone.size();
  undone.resize(std::min(all, kMostNamed));
  return absl::StrCat(job.spec.decisions(), ": the decisions of the last run on ", all, all == 1 ? " hole" : " holes",
                      " are undone, as the file has none on ", all == 1 ? "it: hole " : "them: holes ",
                      absl::StrJoin(undone, ", "), all > undone.size() ? " and others" : "");
}

}  // namespace tilemend
