#include "coordinator/plan/water/given_water.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "coordinator/plan/water/basins.h"
#include "coordinator/plan/water/given_line.h"
#include "coordinator/plan/water/river_profile.h"

namespace tilemend {
namespace {

using Parts = std::vector<GivenPart>;

LevelEvidence EvidenceOfPart(const GivenPart& part) { return EvidenceOf(part.rim, {}); }

// The rims of several parts.
std::vector<RimChain> RimOf(const Parts& parts) {
  std::vector<RimChain> rim;
  for (const GivenPart& part : parts) rim.insert(rim.end(), part.rim.begin(), part.rim.end());
  return rim;
}

// Takes the river along the given line out of the parts.
std::vector<GivenWater> TakeRiver(const std::vector<Point2>& line, Parts& parts) {
  const auto beside = std::stable_partition(parts.begin(), parts.end(),
                                            [&](const GivenPart& part) { return RunsThrough(line, part.outline); });
  Parts on(std::make_move_iterator(parts.begin()), std::make_move_iterator(beside));
  parts.erase(parts.begin(), beside);
  GivenWater river;
  RiverProfile profile;
  if (!on.empty()) profile = FitRiver(line, RimOf(on));
  if (profile.water.stations.empty()) {
    parts.insert(parts.end(), std::make_move_iterator(on.begin()), std::make_move_iterator(on.end()));
    return {};
  }
  const LevelEvidence evidence = EvidenceOf(AboveRiver(profile.water, RimOf(on)), {});
  std::erase_if(parts, [&](GivenPart& part) {
    const LevelEvidence own = EvidenceOf(AboveRiver(profile.water, part.rim), {});
    if (!CanBeOneLevel(own.level, own, evidence)) return false;
    on.push_back(std::move(part));
    return true;
  });
  for (const GivenPart& part : on) river.parts.push_back(part.number);
  river.evidence = EvidenceOf(RimOf(on), {});
  DescribeRim(river.evidence, evidence.sigma(), river.body);
  river.body.river = std::move(profile.water);
  river.body.removed_rises = std::move(profile.removed);
  return {std::move(river)};
}

Basin BasinOf(const WaterArea& area, size_t number, const GivenPart& part, double min_river) {
  const bool is_river = area.kind == WaterKind::kRiver;  // then it is one, however narrow
  return MakeBasin(number, part.outline, part.rim, part.area, is_river ? 0 : min_river, is_river);
}

// Takes the rivers that fall through several of the parts, as on under bridges, out of them.
std::vector<GivenWater> TakeJointRivers(const WaterArea& area, double min_river, Parts& parts) {
  std::vector<Basin> basins;
  for (size_t p = 0; p < parts.size(); ++p) basins.push_back(BasinOf(area, p, parts[p], min_river));
  std::vector<GivenWater> rivers;
  std::vector<bool> is_taken(parts.size(), false);
  for (const Basin& basin : JoinBasins(std::move(basins), area.kind == WaterKind::kRiver ? 0 : min_river)) {
    if (!basin.river || basin.members.size() < 2) continue;
    GivenWater& river = rivers.emplace_back();
    for (const size_t p : basin.members) {
      is_taken[p] = true;
      river.parts.push_back(parts[p].number);
    }
    river.evidence = basin.evidence;
    DescribeRim(basin.evidence, basin.river->evidence.sigma(), river.body);
    river.body.river = basin.river->water;
  }
  Parts rest;
  for (size_t p = 0; p < parts.size(); ++p) {
    if (!is_taken[p]) rest.push_back(std::move(parts[p]));
  }
  parts = std::move(rest);
  return rivers;
}

GivenWater LakeOf(const WaterArea& area, const GivenPart& part, double min_river) {
  const Basin basin = BasinOf(area, part.number, part, min_river);
  GivenWater water{{part.number}, {}, basin.evidence};
  water.body.level = area.level.value_or(basin.evidence.level);
  water.body.shore_level = basin.evidence.level;
  DescribeRim(basin.evidence, basin.evidence.sigma(), water.body);
  if (area.level_sigma) water.body.sigma = *area.level_sigma;
  water.body.level_is_given = area.level && !area.level_sigma;
  if (!area.level && area.kind != WaterKind::kLake && basin.river) {
    water.body.river = basin.river->water;
    water.body.sigma = basin.river->evidence.sigma();
  }
  return water;
}

}  // namespace

void DescribeRim(const LevelEvidence& evidence, double sigma, WaterBody& body) {
  body.sigma = sigma;
  body.lowest = evidence.lowest;
  body.highest = evidence.highest;
}

std::vector<GivenWater> WaterOfArea(const WaterArea& area, std::vector<GivenPart> parts, double min_river) {
  std::vector<GivenWater> all;
  if (!area.level && area.kind != WaterKind::kLake && area.centreline.size() > 1)
    all = TakeRiver(area.centreline, parts);
  if (!area.level && area.kind != WaterKind::kLake && parts.size() > 1) {
    for (GivenWater& river : TakeJointRivers(area, min_river, parts)) all.push_back(std::move(river));
  }
  std::ranges::stable_sort(parts, [](const GivenPart& a, const GivenPart& b) { return a.area > b.area; });
  const size_t first = all.size();
  LevelEvidence largest;
  for (const GivenPart& part : parts) {
    GivenWater water = LakeOf(area, part, min_river);
    const LevelEvidence own = EvidenceOfPart(part);
    if (all.size() == first) {
      largest = own;
    } else if (GivenWater& lake = all[first]; lake.body.river.stations.empty() && water.body.river.stations.empty() &&
                                              CanBeOneLevel(own.level - largest.level, own, largest)) {
      lake.parts.push_back(part.number);
      lake.body.lowest = std::min(lake.body.lowest, own.lowest);
      lake.body.highest = std::max(lake.body.highest, own.highest);
      continue;
    }
    all.push_back(std::move(water));
  }
  for (GivenWater& water : all) water.body.forced = !area.is_as_found;
  return all;
}

}  // namespace tilemend
