#include "coordinator/jobs/earlier_output.h"

#include "absl/strings/str_cat.h"
#include "common/records/output_names.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
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

}  // namespace tilemend
