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

// The rim of a group of holes, and how steep the way down is from each of its vertices.
struct GroupSteps {
  std::vector<int32_t> holes;
  std::vector<int32_t> rim;
  std::vector<double> steps;
};

// The original vertices on the rims of the holes; ascending.
std::vector<int32_t> RimVerticesOf(const Plan& plan, const std::vector<int32_t>& holes) {
  std::set<int32_t> vertices;
  for (const int32_t h : holes) {
    ForRimSegments(plan.holes[h], [&](const RimSegment& s) {
      for (const int32_t v : {s.from, s.to}) {
        if (plan.vertices[v].index >= 0) vertices.insert(v);
      }
    });
  }
  return {vertices.begin(), vertices.end()};
}

GroupSteps StepsOf(const PlanInput& input, const std::vector<int32_t>& holes, const ObjectRule& rule,
                   const Plan& plan) {
  GroupSteps group{holes, RimVerticesOf(plan, holes), {}};
  Eigen::AlignedBox2d box;
  std::vector<Point3> rim;
  for (const int32_t v : group.rim) {
    rim.push_back(plan.vertices[v].position);
    box.extend(Point2(rim.back().head<2>()));
  }
  if (rim.empty() || box.diagonal().norm() < kLeastExtent * rule.radius) return {};
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

}  // namespace

void MarkObjects(const PlanInput& input, Plan& plan) {
  const ObjectRule rule;
  std::vector<GroupSteps> groups;
  std::vector<double> all;
  for (const std::vector<int32_t>& holes : GroupHoles(plan)) {
    groups.push_back(StepsOf(input, holes, rule, plan));
    all.insert(all.end(), groups.back().steps.begin(), groups.back().steps.end());
  }
  if (!AreWalls(all, rule)) return;
  for (const GroupSteps& group : groups) {
    const auto on_object = [&](double step) { return step > rule.slope; };
    if (std::all_of(group.steps.begin(), group.steps.end(), on_object)) continue;
    for (size_t i = 0; i < group.rim.size(); ++i) {
      if (on_object(group.steps[i])) plan.vertices[group.rim[i]].on_object = true;
    }
    MarkRaised(group.holes, plan);
    const ptrdiff_t count =
        std::count_if(group.rim.begin(), group.rim.end(), [&](int32_t v) { return plan.vertices[v].on_object; });
    if (kFewObjects * count <= std::ssize(group.steps)) continue;
    for (const int32_t h : group.holes) plan.holes[h].among_objects = true;
  }
  LowerSizesAtObjects(plan);
}

}  // namespace tilemend
