#include "coordinator/report/changed_options.h"

#include <variant>

#include "common/options/job_options.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json ChangedOptions(const Json& report) {
  Json defaults = Json::object(), changed = Json::object();
  for (const ReportedOption& option : ReportedOptions(WithDefaults(v1::JobSpec()), kOfJobs)) {
    std::visit([&](const auto& value) { defaults[option.name] = value; }, option.value);
  }
  const Json& options = Member(report, "options");
  if (!options.is_object()) return changed;
  for (const auto& [name, value] : options.items()) {
    if (Member(defaults, name.c_str()) != value) changed[name] = value;
  }
  return changed;
}

}  // namespace tilemend
