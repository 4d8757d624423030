#include "coordinator/report/page_holes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

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
  const Json &area = Member(hole, "area_m2"), &water = Member(hole, "water");
  Json row = {{"id", Member(hole, "id")},
              {"cell", Member(hole, "cell")},
              {"centre", Member(hole, "centre")},
              {"kind", KindNameOf(hole)},
              {"area", area.is_null() ? Json() : Json(std::abs(Number(area)))},
              {"rim", Member(hole, "perimeter_m")},
              {"filled", !IsLeftOpen(hole)},
              {"counts", CountsAsLeft(hole)},
              {"method", Text(Member(hole, "method"))},
              {"level", Member(hole, "level_m")},
              {"sigma", Member(water, "sigma_m")},
              {"doubt", Member(hole, "doubt_m3")},
              {"crossings", Member(hole, "crossings")},
              {"cluster", Member(hole, "cluster")},
              {"decision", Text(Member(hole, "decision"))},
              {"reason", HoleReasonOf(hole)}};
  if (water.is_object()) {
    row["taken_for"] = Text(Member(water, "taken_for"));
    row["rim_level"] = Member(water, "level_m");
  }
  return row;
}

// The first `most`, and the filled holes of the clusters of which any is among them.
std::vector<const Json*> FirstWithTheirClusters(const std::vector<const Json*>& holes, size_t most) {
  std::map<int64_t, std::vector<size_t>> clusters;  // places of filled holes
  for (size_t i = 0; i < holes.size(); ++i) {
    if (!IsLeftOpen(*holes[i]) && ClusterOf(*holes[i]) >= 0) clusters[ClusterOf(*holes[i])].push_back(i);
  }
  std::set<size_t> listed;
  for (size_t i = 0; i < holes.size() && listed.size() < most; ++i) {
    listed.insert(i);
    const auto cluster = IsLeftOpen(*holes[i]) ? clusters.end() : clusters.find(ClusterOf(*holes[i]));
    if (cluster != clusters.end()) listed.insert(cluster->second.begin(), cluster->second.end());
  }
  std::vector<const Json*> first;
  for (const size_t i : listed) first.push_back(holes[i]);
  return first;
}

}  // namespace

const Json& HoleRowsOf(const Json& report) {
  static const Json kNone = Json::array();
  const Json& rows = Member(report, "per_hole");
  return rows.is_array() ? rows : kNone;
}

std::vector<const Json*> ChosenHoles(const Json& report) {
  std::vector<const Json*> holes;
  for (const Json& hole : HoleRowsOf(report)) {
    if (IsInChosenCell(hole)) holes.push_back(&hole);
  }
  return holes;
}

bool IsLeftOpen(const Json& hole) { return Member(hole, "outcome") != "filled"; }

std::string HoleReasonOf(const Json& hole) {
  const std::string reason = Text(Member(hole, "reason"));
  return reason.empty() ? Text(Member(Member(hole, "water"), "reason")) : reason;
}

int64_t ClusterOf(const Json& hole) {
  const Json& cluster = Member(hole, "cluster");
  return cluster.is_number_integer() ? cluster.get<int64_t>() : -1;
}

std::vector<const Json*> ListedHoles(const Json& report, size_t most) {
  std::vector<const Json*> holes = ChosenHoles(report);
  std::stable_sort(holes.begin(), holes.end(), [](const Json* a, const Json* b) {
    if (IsLeftOpen(*a) != IsLeftOpen(*b)) return IsLeftOpen(*a);
    const double doubt_a = Number(Member(*a, "doubt_m3")), doubt_b = Number(Member(*b, "doubt_m3"));
    if (doubt_a != doubt_b) return doubt_a > doubt_b;
    return std::abs(Number(Member(*a, "area_m2"))) > std::abs(Number(Member(*b, "area_m2")));
  });
  return holes.size() > most ? FirstWithTheirClusters(holes, most) : holes;
}

Json PageHoles(const Json& report, size_t most) {
  Json rows = Json::array();
  for (const Json* hole : ListedHoles(report, most)) rows.push_back(PageHole(*hole));
  return rows;
}

}  // namespace tilemend
