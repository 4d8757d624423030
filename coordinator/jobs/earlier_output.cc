#include "coordinator/jobs/earlier_output.h"

#include <nlohmann/json.hpp>

#include "absl/strings/str_cat.h"
#include "common/records/output_names.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

// The member `key` of a report; "" if it has none. Lists of holes are dropped as they are read.
std::string KeyIn(const std::string& report) {
  using Json = nlohmann::json;
  const auto keep = [](int depth, Json::parse_event_t event, const Json&) {
    return depth != 1 || (event != Json::parse_event_t::object_start && event != Json::parse_event_t::array_start);
  };
  const Json json = Json::parse(report, keep, false);
  const auto key = json.is_object() ? json.find("key") : json.end();
  return json.is_object() && key != json.end() && key->is_string() ? key->get<std::string>() : "";
}

}  // namespace

std::string OutputKey(const std::string& scene_key) { return Sha256Hex(scene_key); }

absl::StatusOr<bool> MayReplace(const JobSpec& spec, const std::string& key) {
  if (spec.overwrite() || spec.decisions().empty()) return spec.overwrite();
  const auto report = ReadFile(absl::StrCat(spec.out(), "/", kReportFiles[0]));
  if (!report.ok()) return false;
  if (KeyIn(*report) == key) return true;
  return WithErrorInfo(
      absl::AlreadyExistsError(absl::StrCat(
          Printable(spec.out()),
          ": the output there is of another scene or other options, so decisions do not apply to it; give the scene and "
          "the options that its report.json names, choose another --out, or give --overwrite to do all of it again")),
      {"OUTPUT_EXISTS", {}});
}

}  // namespace tilemend
