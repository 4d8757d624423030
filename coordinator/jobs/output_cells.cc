#include "coordinator/jobs/output_cells.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "common/grid/cell_choice.h"
#include "common/grid/scene_place.h"
#include "common/options/job_options.h"
#include "common/records/output_names.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/report/report_key.h"

namespace tilemend {
namespace {

constexpr char kFileSuffix[] = " file";

// Files count by their content alone.
bool CountsByContent(const std::string& option) {
  return option == "clear" || option == "area" || option == "decisions";
}

JobIdentity IdentityOf(const std::string& scene, const std::vector<ReportedOption>& options) {
  JobIdentity identity = {{"scene", scene.empty() ? "" : ScenePlaceOf(scene)}};
  for (const ReportedOption& option : options) {
    if (CountsByContent(option.name)) continue;
    const auto* number = std::get_if<double>(&option.value);
    const auto* text = std::get_if<std::string>(&option.value);
    identity[option.name] = number != nullptr ? absl::StrFormat("%.17g", *number)
                            : text != nullptr ? *text
                                              : absl::StrCat(std::get<bool>(option.value));
  }
  return identity;
}

JobIdentity IdentityOfReport(const std::string& report) {
  const std::optional<ReportedJob> job = JobInReport(report);
  if (!job) return {};
  JobIdentity identity = IdentityOf(job->scene, job->options);
  for (const auto& [option, digest] : job->files) AddFileDigest(option, digest, identity);
  return identity;
}

struct FoundOutput {
  bool is_complete = false;
  JobIdentity identity;
};

// Whether a file may be there all the same. Other errors show when the output is claimed.
bool MayBeThere(const std::string& folder, const absl::Status& status) {
  return absl::IsUnavailable(status) || IsStoreError(folder, status);
}

// None if there is no output. Errors if a mount or a store fails.
absl::StatusOr<std::optional<FoundOutput>> FindOutput(const std::string& folder) {
  // A marker without a key is of a job that has not written yet.
  const auto key = ReadFile(absl::StrCat(folder, "/", kJobMarker));
  if (MayBeThere(folder, key.status())) return key.status();
  if (key.ok() && !key->empty()) return FoundOutput{false, IdentityOfKey(*key)};
  const auto text = ReadFile(absl::StrCat(folder, "/", kReportFiles[0]));
  if (MayBeThere(folder, text.status())) return text.status();
  if (!text.ok()) return std::nullopt;
  return FoundOutput{true, IdentityOfReport(*text)};
}

absl::Status RefusedOutput(const JobSpec& spec, const std::string& what, const std::string& instead = "") {
  return WithErrorInfo(
      absl::AlreadyExistsError(absl::StrCat(Printable(spec.out()), ": exists already", what, "; choose another --out, ",
                                            instead.empty() ? "or " : "",
                                            "give --overwrite to replace the files that the job writes", instead)),
      {"OUTPUT_EXISTS", {}});
}

absl::Status IsComplete(const JobSpec& spec) {
  return RefusedOutput(spec, ", and is complete",
                       ", or --decisions FILE to do only the holes again that a reviewer decided on");
}

// The names of entries that differ but for the cells, of those that both have if `of_both`.
std::vector<std::string> DifferingFlags(const JobIdentity& a, const JobIdentity& b, bool of_both) {
  std::set<std::string> names;
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const auto& [name, value] : *one) {
      const auto found = other->find(name);
      const bool differs = found == other->end() ? !of_both : found->second != value;
      if (differs && name != "cells") names.insert(name);
    }
  }
  std::vector<std::string> flags;
  for (const std::string& name : names) flags.push_back(name == "scene" ? "the scene" : absl::StrCat("--", name));
  return flags;
}

absl::Status OfAnotherJob(const JobSpec& spec, const FoundOutput& found, const std::vector<std::string>& differences) {
  return RefusedOutput(spec, absl::StrCat(found.is_complete ? ", an output" : ", an unfinished output",
                                          " of a job that differs in ", absl::StrJoin(differences, ", ")));
}

std::string CellsIn(const JobIdentity& identity) {
  const auto cells = identity.find("cells");
  return cells == identity.end() ? "" : cells->second;
}

}  // namespace

JobIdentity IdentityOf(const JobSpec& spec) { return IdentityOf(spec.scene(), ReportedOptions(spec, kOfJobs)); }

void AddFileDigest(const std::string& option, const std::string& digest, JobIdentity& identity) {
  if (!digest.empty()) identity[absl::StrCat(option, kFileSuffix)] = digest;
}

std::map<std::string, std::string> FileDigestsOf(const JobIdentity& identity) {
  std::map<std::string, std::string> digests;
  for (const auto& [name, value] : identity) {
    if (name.ends_with(kFileSuffix)) digests[name.substr(0, name.rfind(kFileSuffix))] = value;
  }
  return digests;
}

std::string JobKey(const JobIdentity& identity) {
  std::string key;
  for (const auto& [name, value] : identity) absl::StrAppend(&key, name, "=", value, "\n");
  return key;
}

JobIdentity IdentityOfKey(const std::string& key) {
  JobIdentity identity;
  for (const std::string& line : std::vector<std::string>(absl::StrSplit(key, '\n'))) {
    const size_t equals = line.find('=');
    if (equals != std::string::npos) identity[line.substr(0, equals)] = line.substr(equals + 1);
  }
  return identity;
}

namespace {

// Whether an output with the cells `before` has those of the job.
absl::StatusOr<bool> HasCells(const std::string& before, const std::string& cells, const Scene& scene) {
  TILEMEND_ASSIGN_OR_RETURN(const std::set<CellId> there, ChooseCells(before, scene));
  TILEMEND_ASSIGN_OR_RETURN(const std::set<CellId> wanted, ChooseCells(cells, scene));
  const bool whole = there.empty() || there.size() == scene.tiles.size();
  return whole || (!wanted.empty() && std::ranges::includes(there, wanted));
}

// The cells of a job that does some cells of a complete output again, or decides on them: all of the output's, so that
// its report keeps the others. What did not change is not computed again.
absl::StatusOr<std::string> CellsDoneAgain(const JobSpec& spec, JobIdentity identity, const FoundOutput& found,
                                           const Scene& scene) {
  JobIdentity before = found.identity;
  if (!spec.decisions().empty()) before.erase(absl::StrCat("decisions", kFileSuffix));
  const bool is_same = found.is_complete && !before.empty() && DifferingFlags(identity, before, false).empty();
  if (spec.cells().empty() || !is_same) return spec.cells();
  const std::string cells = CellsIn(before);
  TILEMEND_ASSIGN_OR_RETURN(const bool has_all, HasCells(cells, spec.cells(), scene));
  return has_all ? cells : spec.cells();
}

}  // namespace

absl::StatusOr<OutputCells> CellsWithOutput(const JobSpec& spec, const JobIdentity& identity, const Scene& scene) {
  OutputCells result{false, spec.cells()};
  if (spec.dry_run()) return result;
  TILEMEND_ASSIGN_OR_RETURN(const std::optional<FoundOutput> found, FindOutput(spec.out()));
  if (!found) return result;
  if (spec.overwrite() || !spec.decisions().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(result.cells, CellsDoneAgain(spec, identity, *found, scene));
    return result;
  }
  if (found->identity.empty()) return RefusedOutput(spec, "");
  if (const auto differences = DifferingFlags(identity, found->identity, false); !differences.empty()) {
    return OfAnotherJob(spec, *found, differences);
  }
  const std::string before = CellsIn(found->identity);
  if (!found->is_complete && before == spec.cells()) return result;  // the same job goes on
  result.adds = true;
  TILEMEND_ASSIGN_OR_RETURN(const bool has_all, HasCells(before, spec.cells(), scene));
  if (has_all && found->is_complete) return IsComplete(spec);
  result.cells = has_all ? before : spec.cells().empty() ? "" : absl::StrCat(before, " ", spec.cells());
  return result;
}

absl::Status CheckOutputTakes(const JobSpec& spec) {
  if (spec.overwrite() || spec.dry_run() || !spec.decisions().empty()) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const std::optional<FoundOutput> found, FindOutput(spec.out()));
  if (!found || KindOf(absl::StrCat(spec.out(), "/", kJobMarker)) != PathKind::kNothing) return absl::OkStatus();
  if (const auto differences = DifferingFlags(IdentityOf(spec), found->identity, true); !differences.empty()) {
    return OfAnotherJob(spec, *found, differences);
  }
  const std::string before = CellsIn(found->identity);
  return before.empty() || before == spec.cells() ? IsComplete(spec) : absl::OkStatus();
}

}  // namespace tilemend
