#include "coordinator/plan/overlap/wall_feet.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/mesh/rounding.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

constexpr double kWallWidth = 0.02;  // metres from the object to the foot
constexpr double kMostOfWay = 0.25;  // of the way to the next vertex: the foot is not farther

class FootLayer {
 public:
  explicit FootLayer(Plan& plan) : plan_(plan) {}

  std::vector<RimSegment> WithFeet(const std::vector<RimSegment>& region) {
    std::vector<RimSegment> result;
    for (const RimSegment& s : region) {
      const bool down = s.seam && IsWall(s.from) && IsOnOutline(s.to);
      const bool up = s.seam && IsWall(s.to) && IsOnOutline(s.from);
      if ((!down && !up) || !HasRoom(s)) {
        result.push_back(s);
        continue;
      }
      const int32_t foot = down ? FootBetween(s.from, s.to) : FootBetween(s.to, s.from);
      result.push_back({s.from, foot, true});
      result.push_back({foot, s.to, true});
    }
    return result;
  }

 private:
  bool IsWall(int32_t v) const {
    const PlanVertex& vertex = plan_.vertices[v];
    return vertex.on_object && (vertex.index >= 0 || vertex.on_neighbour);
  }
  bool IsOnOutline(int32_t v) const {
    return plan_.vertices[v].index < 0 && plan_.vertices[v].follows >= 0 && !IsWall(v);
  }

  // For a foot between the ends. Where one is a hair beside the other or above it there is none; nor is there on the
  // edge of an area, which needs not run along an axis.
  bool HasRoom(const RimSegment& s) const {
    const Point2 way = (plan_.vertices[s.to].position - plan_.vertices[s.from].position).head<2>().cwiseAbs();
    return kMostOfWay * way.maxCoeff() >= plan_.lattice_step && way.minCoeff() <= kMeetTolerance;
  }

  int32_t FootBetween(int32_t wall, int32_t next) {
    const Point3 from = plan_.vertices[wall].position;
    PlanVertex foot = plan_.vertices[next];
    const Point3 way = foot.position - from;
    const int along = std::abs(way.x()) > std::abs(way.y()) ? 0 : 1;  // the outline runs along an axis
    const double length = std::abs(way[along]), share = std::min(kWallWidth / length, kMostOfWay);
    foot.position[along] = RoundedToLattice(from[along] + share * way[along], plan_.lattice_step);
    foot.lines = along == 0 ? 2 : 1;
    if (plan_.vertices[wall].follows >= 0) {
      foot.follows = plan_.vertices[wall].follows;
      foot.on_neighbour = foot.on_neighbour && plan_.vertices[wall].index < 0;  // else it stands on the ground
    }
    plan_.vertices.push_back(foot);
    return static_cast<int32_t>(plan_.vertices.size() - 1);
  }

  Plan& plan_;
};

// Where a neighbour's surface passes high above the fill, or below it, a wall stands on the outline, up to it.
void RaiseToNeighbours(Plan& plan) {
  for (PlanVertex& v : plan.vertices) {
    if (v.on_neighbour) v.on_object = plan.vertices[v.follows].on_object;
  }
}

}  // namespace

void LayWallFeet(Plan& plan) {
  RaiseToNeighbours(plan);
  FootLayer feet(plan);
  for (PlannedHole& hole : plan.holes) {
    for (std::vector<RimSegment>& region : hole.own_regions) region = feet.WithFeet(region);
  }
}

}  // namespace tilemend
