// The water that an area of the user tells of.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_GIVEN_WATER_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_GIVEN_WATER_H_

#include <cstddef>
#include <vector>

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/level_evidence.h"

namespace tilemend {

// A hole or cluster under an area.
struct GivenPart {
  size_t number = 0;
  double area = 0;  // m2
  std::vector<PlaneSegment> outline;
  std::vector<RimChain> rim;  // not empty
};

struct GivenWater {
  std::vector<size_t> parts;  // numbers, in the order of the parts
  WaterBody body;             // without its holes; the level is not rounded
  LevelEvidence evidence;     // of its rim
};

// The bodies of water in the parts that an area decides on:
//   with a centreline  a river (FitRiver) of the parts that it runs through
//   several            a river that falls through them, if JoinBasins finds one
//   others             each a lake at the area's level, or that of its rim; or a river, if FindFall finds one
// An area of kind kLake has no river; one of kind kRiver says that its water falls.
// A part belongs to the river there, or to the largest lake, if CanBeOneLevel.
// Precondition: area.water. Cost: EvidenceOf's for each part, and those of the rivers.
std::vector<GivenWater> WaterOfArea(const WaterArea& area, std::vector<GivenPart> parts, double min_river);

// Figures of the rim for the report.
void DescribeRim(const LevelEvidence& evidence, double sigma, WaterBody& body);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_GIVEN_WATER_H_
