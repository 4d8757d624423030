#include "coordinator/report/page_holes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "absl/strings/str_cat.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/left_open.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

std::string KindNameOf(const Json& hole) {
  const std::string type = Text(Member(hole, "type")), single = Text(Member(hole, "single"));
  return absl::StrCat(Text(Member(hole, "kind")), type.empty() ? "" : " ", type, single.empty() ? "" : ", ", single);
}

Json PageHole(const Json& hole) {
  const Json& area = Member(hole, "area_m2");
  return {{"id", Member(hole, "id")},
          {"cell", Member(hole, "cell")},
          {"centre", Member(hole, "centre")},
          {"kind", KindNameOf(hole)},
          {"area", area.is_null() ? Json() : Json(std::abs(Number(area)))},
          {"rim", Member(hole, "perimeter_m")},
          {"filled", !IsLeftOpen(hole)},
          {"counts", CountsAsLeft(hole)},
          {"method", Text(Member(hole, "method"))},
          {"level", Member(hole, "level_m")},
          {"sigma", Member(Member(hole, "water"), "sigma_m")},
          {"doubt", Member(hole, "doubt_m3")},
          {"crossings", Member(hole, "crossings")},
          {"cluster", Member(hole, "cluster")},
          {"decision", Text(Member(hole, "decision"))},
          {"reason", HoleReasonOf(hole)}};
}

}  // namespace

const Json& HoleRowsOf(const Json& report) {
  static const Json kNone = Json::array();
  const Json& rows = Member(report, "per_hole");
  return rows.is_array() ? rows : kNone;
}

bool IsLeftOpen(const Json& hole) { return Member(hole, "outcome") != "filled"; }

std::string HoleReasonOf(const Json& hole) {
  const std::string reason = Text(Member(hole, "reason"));
  return reason.empty() ? Text(Member(Member(hole, "water"), "reason")) : reason;
}

Json PageHoles(const Json& report, size_t most) {
  std::vector<const Json*> holes;
  for (const Json& hole : HoleRowsOf(report)) holes.push_back(&hole);
  std::stable_sort(holes.begin(), holes.end(), [](const Json* a, const Json* b) {
    if (IsLeftOpen(*a) != IsLeftOpen(*b)) return IsLeftOpen(*a);
    const double doubt_a = Number(Member(*a, "doubt_m3")), doubt_b = Number(Member(*b, "doubt_m3"));
    if (doubt_a != doubt_b) return doubt_a > doubt_b;
    return std::abs(Number(Member(*a, "area_m2"))) > std::abs(Number(Member(*b, "area_m2")));
  });
  holes.resize(std::min(holes.size(), most));
  Json rows = Json::array();
  for (const Json* hole : holes) rows.push_back(PageHole(*hole));
  return rows;
}

}  // namespace tilemend
