#include "coordinator/plan/water/hole_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

constexpr double kLineSpacing = 0.25;   // metres
constexpr double kMostLines = 1 << 20;  // memory; a hole of 262 km has no parts
constexpr double kNeck = 0.75;          // metres: half of the widest gap between objects that shuts a part off
constexpr double kFewerWalls = 0.5;     // of the walls down to the ground

struct Interval {
  double from, to;
};

// Of a line across the region, what lies in one part.
struct Run {
  Interval along;
  int32_t part;
};

// The union of the intervals, ascending.
std::vector<Interval> Joined(std::vector<Interval> intervals) {
  std::ranges::sort(intervals, {}, &Interval::from);
  std::vector<Interval> joined;
  for (const Interval& i : intervals) {
    if (!joined.empty() && i.from <= joined.back().to) {
      joined.back().to = std::max(joined.back().to, i.to);
    } else {
      joined.push_back(i);
    }
  }
  return joined;
}

// `whole` without `taken`, both ascending and disjoint.
std::vector<Interval> Without(const std::vector<Interval>& whole, const std::vector<Interval>& taken) {
  std::vector<Interval> left;
  auto next = taken.begin();
  for (Interval i : whole) {
    while (next != taken.end() && next->to <= i.from) ++next;
    for (auto t = next; t != taken.end() && t->from < i.to; ++t) {
      if (t->from > i.from) left.push_back({i.from, t->from});
      i.from = std::max(i.from, t->to);
    }
    if (i.from < i.to) left.push_back(i);
  }
  return left;
}

// The parts that are left of a region, seen from above, when the squares around its objects are taken from it: the
// sides of these are twice kNeck.
class Parts {
 public:
  Parts(const std::vector<PlaneSegment>& region, const std::vector<PlaneSegment>& objects) {
    double top = -std::numeric_limits<double>::infinity();
    for (const auto& [p, q] : region) {
      bottom_ = std::min({bottom_, p.y(), q.y()});
      top = std::max({top, p.y(), q.y()});
    }
    bottom_ = std::floor(bottom_ / kLineSpacing) * kLineSpacing;
    if (!(top - bottom_ <= kMostLines * kLineSpacing)) return;
    lines_.resize(static_cast<size_t>(std::ceil((top - bottom_) / kLineSpacing)) + 1);
    FindRuns(region, objects);
    JoinRuns();
  }

  // The part nearest to a point, at most two necks away; -1: none.
  int32_t Nearest(const Point2& p) const {
    double nearest = 2 * kNeck;
    int32_t part = -1;
    for (size_t l = FirstLine(p.y() - nearest); l < lines_.size() && HeightOf(l) <= p.y() + 2 * kNeck; ++l) {
      for (const Run& run : lines_[l]) {
        const double beside = std::max({run.along.from - p.x(), p.x() - run.along.to, 0.0});
        const double distance = std::hypot(beside, HeightOf(l) - p.y());
        if (distance < nearest) {
          nearest = distance;
          part = run.part;
        }
      }
    }
    return part;
  }

 private:
  double HeightOf(size_t line) const { return bottom_ + (static_cast<double>(line) + 0.5) * kLineSpacing; }
  size_t FirstLine(double y) const {
    return static_cast<size_t>(std::max(0.0, std::ceil((y - bottom_) / kLineSpacing - 0.5)));
  }

  void FindRuns(const std::vector<PlaneSegment>& region, const std::vector<PlaneSegment>& objects) {
    std::vector<std::vector<double>> ends(lines_.size());
    for (const auto& [p, q] : region) {
      const Point2 &low = p.y() < q.y() ? p : q, &high = p.y() < q.y() ? q : p;
      for (size_t l = FirstLine(low.y()); l < lines_.size() && HeightOf(l) < high.y(); ++l) {
        const double share = (HeightOf(l) - low.y()) / (high.y() - low.y());
        ends[l].push_back(low.x() + share * (high.x() - low.x()));
      }
    }
    std::vector<std::vector<Interval>> taken(lines_.size());
    for (const auto& [p, q] : objects) {
      const Point2 &low = p.y() < q.y() ? p : q, &high = p.y() < q.y() ? q : p;
      for (size_t l = FirstLine(low.y() - kNeck); l < lines_.size() && HeightOf(l) <= high.y() + kNeck; ++l) {
        const auto at = [&](double y) {
          const double rise = high.y() - low.y();
          return low.x() + (rise > 0 ? std::clamp((y - low.y()) / rise, 0.0, 1.0) : 0.0) * (high.x() - low.x());
        };
        const double a = at(HeightOf(l) - kNeck);
        const double b = high.y() > low.y() ? at(HeightOf(l) + kNeck) : high.x();
        taken[l].push_back({std::min(a, b) - kNeck, std::max(a, b) + kNeck});
      }
    }
    int32_t runs = 0;
    for (size_t l = 0; l < lines_.size(); ++l) {
      std::ranges::sort(ends[l]);
      std::vector<Interval> inside;
      for (size_t i = 0; i + 1 < ends[l].size(); i += 2) inside.push_back({ends[l][i], ends[l][i + 1]});
      for (const Interval& i : Without(inside, Joined(std::move(taken[l])))) lines_[l].push_back({i, runs++});
    }
    part_of_.resize(runs);
    std::iota(part_of_.begin(), part_of_.end(), 0);
  }

  int32_t PartOf(int32_t run) {
    while (part_of_[run] != run) run = part_of_[run] = part_of_[part_of_[run]];
    return run;
  }

  // Those of lines beside each other that face each other are of one part.
  void JoinRuns() {
    for (size_t l = 1; l < lines_.size(); ++l) {
      auto below = lines_[l - 1].begin();
      for (const Run& run : lines_[l]) {
        while (below != lines_[l - 1].end() && below->along.to <= run.along.from) ++below;
        for (auto b = below; b != lines_[l - 1].end() && b->along.from < run.along.to; ++b) {
          part_of_[PartOf(run.part)] = PartOf(b->part);
        }
      }
    }
    for (std::vector<Run>& line : lines_) {
      for (Run& run : line) run.part = PartOf(run.part);
    }
  }

  double bottom_ = std::numeric_limits<double>::infinity();
  std::vector<std::vector<Run>> lines_;  // from bottom_ upwards
  std::vector<int32_t> part_of_;         // of runs: union-find
};

// Seen from above, at an original vertex of the rim.
struct OutlineVertex {
  double length = 0;  // metres of rim that is no steeper than 45 degrees: what runs up a wall tells of neither surface
  Point2 into_hole{0, 0};  // across the rim, of any length
};

// The original rim of some holes, seen from above.
struct Outline {
  std::vector<PlaneSegment> on_objects = {};  // both ends are
  std::map<int32_t, OutlineVertex> vertices = {};
};

Outline OutlineOf(const Plan& plan, const std::vector<int32_t>& holes) {
  Outline outline;
  for (const int32_t h : holes) {
    ForRimSegments(plan.holes[h], [&](const RimSegment& s) {
      if (s.seam) return;
      const PlanVertex& a = plan.vertices[s.from];
      const PlanVertex& b = plan.vertices[s.to];
      if (a.on_object && b.on_object) outline.on_objects.emplace_back(a.position.head<2>(), b.position.head<2>());
      const Point3 way = b.position - a.position;
      const double length = way.head<2>().norm();
      for (const int32_t v : {s.from, s.to}) {
        if (plan.vertices[v].index < 0) continue;
        OutlineVertex& vertex = outline.vertices[v];
        if (std::abs(way.z()) <= length) vertex.length += length / 2;
        vertex.into_hole += Point2(-way.y(), way.x());  // the hole is on the left
      }
    });
  }
  return outline;
}

// A vertex on the rim of a part.
struct RimPoint {
  int32_t vertex;
  double length;  // as OutlineVertex::length
  double height;
  std::optional<double> ground;  // under it, where that is known
  bool on_object;
};

// Half of the length lies below it.
double MedianOf(std::vector<std::pair<double, double>> heights_and_lengths) {
  std::ranges::sort(heights_and_lengths);
  double whole = 0;
  for (const auto& [height, length] : heights_and_lengths) whole += length;
  double below = 0;
  for (const auto& [height, length] : heights_and_lengths) {
    below += length;
    if (below >= whole / 2) return height;
  }
  return 0;
}

// Square metres of upright wall between the rim and a level through its objects, and between the rim and the ground.
struct Walls {
  double to_objects = 0, to_ground = 0;
  double level = 0;  // of the objects
};

Walls WallsOf(const std::vector<RimPoint>& rim) {
  std::vector<std::pair<double, double>> objects;
  std::vector<std::pair<double, double>> ground;
  for (const RimPoint& p : rim) {
    if (p.on_object) objects.emplace_back(p.height, p.length);
    if (p.ground) ground.emplace_back(*p.ground, p.length);
  }
  const double level_of_ground = MedianOf(std::move(ground));
  Walls walls{.level = MedianOf(std::move(objects))};
  for (const RimPoint& p : rim) {
    walls.to_objects += p.length * std::abs(p.height - walls.level);
    walls.to_ground += p.length * std::abs(p.height - p.ground.value_or(level_of_ground));
  }
  return walls;
}

}  // namespace

ShutOff VerticesShutOff(const Plan& plan, const std::vector<int32_t>& holes) {
  const Outline outline = OutlineOf(plan, holes);
  if (outline.on_objects.empty()) return {};
  const Parts parts(BoundaryOf(plan, holes), outline.on_objects);
  std::map<int32_t, std::vector<RimPoint>> rims;
  for (const auto& [v, at] : outline.vertices) {
    const PlanVertex& vertex = plan.vertices[v];
    const int32_t part = parts.Nearest(vertex.position.head<2>() + kNeck * at.into_hole.normalized());
    if (part < 0) continue;
    const double height = vertex.position.z();
    const std::optional<double> ground = vertex.on_object ? std::optional<double>(vertex.ground) : height;
    rims[part].push_back({v, at.length, height, ground, vertex.on_object});
  }
  ShutOff shut_off;
  for (const auto& [part, rim] : rims) {
    const Walls walls = WallsOf(rim);
    if (walls.to_objects >= kFewerWalls * walls.to_ground) continue;
    for (const RimPoint& p : rim) {
      const bool is_of_ground = p.ground && std::abs(p.height - *p.ground) < std::abs(p.height - walls.level);
      if (is_of_ground) {
        shut_off.below.emplace_back(p.vertex, static_cast<float>(walls.level));
      } else {
        shut_off.on_object.push_back(p.vertex);
      }
    }
  }
  return shut_off;
}

}  // namespace tilemend
