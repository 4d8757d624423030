#include "client/saved_acceptance.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "client/acceptance_text.h"
#include "common/records/output_names.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/utc.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/shallow_json.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kShownPlaces = 20;  // of one fault on the page

std::string PathIn(const std::string& out) { return absl::StrCat(out, "/", kAcceptanceFile); }

Json FaultsOf(const Json& findings) {
  Json faults = Json::array();
  for (const auto& [name, finding] : findings.items()) {
    const Json &is_fault = Member(finding, "fault"), &count = Member(finding, "count");
    if (is_fault != true || !count.is_number_integer() || count == 0) continue;
    Json places = Json::array();
    for (const Json& place : Member(finding, "places")) {
      if (places.size() < kShownPlaces) places.push_back(place);
    }
    faults.push_back({{"what", Member(finding, "text")}, {"count", count}, {"places", std::move(places)}});
  }
  return faults;
}

}  // namespace

absl::Status SaveAcceptance(const std::string& out, const Acceptance& acceptance, absl::Time date) {
  Json json = {{"date", UtcText(date)}};
  json.update(AcceptanceJson(acceptance));
  return WriteFileAtomically(PathIn(out), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

absl::StatusOr<Json> SavedAcceptance(const std::string& out) {
  const auto text = ReadFile(PathIn(out));
  if (absl::IsNotFound(text.status())) return Json();
  TILEMEND_RETURN_IF_ERROR(text.status());
  const Json json = ParseShallow(*text);
  if (!Member(json, "accepted").is_boolean() || !Member(json, "findings").is_object()) {
    return absl::InvalidArgumentError(
        absl::StrCat(PathIn(out), ": not what `tilemend check` writes; `tilemend check SCENE OUT --page` replaces it"));
  }
  return Json{{"accepted", json["accepted"]},
              {"verdict", Member(json, "verdict")},
              {"date", Member(json, "date")},
              {"faults", FaultsOf(json["findings"])}};
}

}  // namespace tilemend
