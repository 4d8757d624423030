#include "coordinator/plan/water/mark_objects.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "coordinator/plan/water/hole_groups.h"
#include "coordinator/plan/water/raised_levels.h"
#include "coordinator/plan/water/shore_line.h"
#include "coordinator/plan/water/shore_objects.h"
#include "coordinator/plan/water/terraces.h"

namespace tilemend {
namespace {

constexpr double kLeastExtent = 2;  // radii of the opening: a smaller hole has no opposite shore to tell an object by
constexpr ptrdiff_t kFewObjects = 10;  // one rim vertex in so many
constexpr double kLeastShareOfSize = 0.4;

std::set<CellId> CellsAround(const Plan& plan, const std::vector<int32_t>& holes) {
  std::set<CellId> cells;
  for (const int32_t h : holes) {
    const CellId c = plan.holes[h].cell;
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) cells.insert({c.col + dc, c.row + dr});
    }
  }
  return cells;
}

std::vector<Point3> BandPointsIn(const PlanInput& input, const std::set<CellId>& cells,
                                 const Eigen::AlignedBox2d& box) {
  std::vector<Point3> points;
  for (const CellId cell : cells) {
    const auto it = input.cells.find(cell);
    if (it == input.cells.end() || it->second == nullptr) continue;
    const auto record = it->second.WithBand();
    for (const Point3& p : record->band.points) {
      if (box.contains(Point2(p.head<2>()))) points.push_back(p);
    }
  }
  return points;
}

// The rim of a group of holes, and how steep the way down is from each of its vertices; of a small one nothing.
struct GroupSteps {
  std::vector<int32_t> holes;
  std::vector<int32_t> rim;
  std::vector<double> steps;
};

GroupSteps StepsOf(const PlanInput& input, const std::vector<int32_t>& holes, const ObjectRule& rule,
                   const Plan& plan) {
  GroupSteps group{holes, RimVerticesOf(plan, holes), {}};
  Eigen::AlignedBox2d box;
  std::vector<Point3> rim;
  for (const int32_t v : group.rim) {
    rim.push_back(plan.vertices[v].position);
    box.extend(Point2(rim.back().head<2>()));
  }
  if (rim.empty() || box.diagonal().norm() < kLeastExtent * rule.radius) return group;
  box.min().array() -= rule.radius;
  box.max().array() += rule.radius;
  group.steps = StepsDown(rim, BandPointsIn(input, CellsAround(plan, holes), box), rule);
  return group;
}

// Where the shore of holes in their cells ends: at the edge of the area, as what goes on in the next cell shares its
// vertex.
std::vector<int32_t> EndsOfShore(const Plan& plan, const std::vector<int32_t>& holes, const ShoreLine& shore) {
  std::map<int32_t, int> edges;
  for (const int32_t h : holes) {
    for (const RimSegment& s : plan.holes[h].segments) {
      if (s.seam) continue;
      ++edges[s.from];
      ++edges[s.to];
    }
  }
  std::vector<int32_t> ends;
  for (int32_t i = 0; i < std::ssize(shore.vertices); ++i) {
    const auto it = edges.find(shore.vertices[i]);
    if (it != edges.end() && it->second == 1) ends.push_back(i);
  }
  return ends;
}

// Marks what walls lift off the ground of a group's rim, and its terraces.
void MarkRaised(const std::vector<int32_t>& holes, Plan& plan) {
  ShoreLine shore = WholeShoreLineOf(plan, holes);
  const auto mark = [&](const std::vector<bool>& raised) {
    for (size_t i = 0; i < raised.size(); ++i) {
      if (!raised[i]) continue;
      shore.kinds[i] = ShorePoint::kOther;
      plan.vertices[shore.vertices[i]].on_object = true;
    }
  };
  mark(OnRaisedLevels(shore.points, shore.kinds, shore.edges, EndsOfShore(plan, holes, shore)));
  mark(OnTerraces(shore.points, shore.kinds, shore.edges));
}

// Edges that run up an object are long in space alone: triangles of that length beside them would carry its wall far
// out.
void LowerSizesAtObjects(Plan& plan) {
  std::map<int32_t, std::pair<double, int>> lengths;  // seen from above: sum and count
  for (const PlannedHole& hole : plan.holes) {
    ForRimSegments(hole, [&](const RimSegment& s) {
      if (s.seam) return;
      const Point3 way = plan.vertices[s.to].position - plan.vertices[s.from].position;
      for (const int32_t v : {s.from, s.to}) {
        if (!plan.vertices[v].on_object) continue;
        lengths[v].first += way.head<2>().norm();
        ++lengths[v].second;
      }
    });
  }
  for (const auto& [v, length] : lengths) {
    double& size = plan.vertices[v].size;
    size = std::clamp(length.first / length.second, kLeastShareOfSize * size, size);
  }
}

bool IsUnknown(const KnownObjects& known, int32_t v) { return known.on_object.empty() || !known.on_object[v]; }

void TakeKnown(const KnownObjects& known, Plan& plan) {
  for (size_t v = 0; v < known.on_object.size(); ++v) {
    if (known.on_object[v]) plan.vertices[v].on_object = *known.on_object[v];
  }
}

// Takes what is known of the shore of a group, if all of it is. Where nothing of the rim is known to be ground, that of
// the whole shore is what the surface has to go by.
void TakeKnownShore(const KnownShore& shore, const KnownObjects& known, const std::vector<int32_t>& rim,
                    const std::vector<int32_t>& holes, Plan& plan) {
  const auto is_ground = [&](int32_t v) { return known.on_object[v] == false; };
  const auto is_known = [&](int32_t h) { return known.shore_of[h] >= 0; };
  bool among = plan.holes[holes.front()].among_objects;
  if (std::ranges::all_of(holes, is_known)) among = shore.among_objects;
  if (std::ranges::none_of(rim, is_ground) && !shore.ground.empty()) among = true;
  for (const int32_t h : holes) plan.holes[h].among_objects = among;
}

// Marks of the rim of a group what nothing is known of.
void MarkGroup(const GroupSteps& group, const ObjectRule& rule, const KnownObjects& known, Plan& plan) {
  const auto on_object = [&](double step) { return step > rule.slope; };
  if (std::all_of(group.steps.begin(), group.steps.end(), on_object)) return;
  if (std::ranges::none_of(group.rim, [&](int32_t v) { return IsUnknown(known, v); })) return;
  for (size_t i = 0; i < group.rim.size(); ++i) {
    if (on_object(group.steps[i]) && IsUnknown(known, group.rim[i])) plan.vertices[group.rim[i]].on_object = true;
  }
  MarkRaised(group.holes, plan);
  TakeKnown(known, plan);
  const ptrdiff_t count =
      std::count_if(group.rim.begin(), group.rim.end(), [&](int32_t v) { return plan.vertices[v].on_object; });
  if (kFewObjects * count <= std::ssize(group.steps)) return;
  for (const int32_t h : group.holes) plan.holes[h].among_objects = true;
}

}  // namespace

void MarkObjects(const PlanInput& input, const KnownObjects& known, Plan& plan) {
  const ObjectRule rule;
  std::vector<GroupSteps> groups;
  std::vector<double> all;
  for (const std::vector<int32_t>& holes : GroupHoles(plan)) {
    groups.push_back(StepsOf(input, holes, rule, plan));
    all.insert(all.end(), groups.back().steps.begin(), groups.back().steps.end());
  }
  TakeKnown(known, plan);
  const bool are_walls = known.any || AreWalls(all, rule);
  for (const GroupSteps& group : groups) {
    if (are_walls) MarkGroup(group, rule, known, plan);
    const KnownShore* shore = known.ShoreOf(group.holes);
    if (shore != nullptr) TakeKnownShore(*shore, known, group.rim, group.holes, plan);
  }
  LowerSizesAtObjects(plan);
}

}  // namespace tilemend
