#include "coordinator/plan/water/hole_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/weighted_median.h"
#include "coordinator/plan/water/hole_groups.h"
#include "coordinator/plan/water/line_intervals.h"

namespace tilemend {
namespace {

constexpr double kLineSpacing = 0.25;  // metres
constexpr double kNeck = 0.75;         // metres: half of the widest gap between objects that parts a hole
constexpr double kFewerWalls = 0.5;    // of the walls down to the ground
constexpr double kLeastArea = 1;       // m2, as a square of the ground raster
constexpr double kMostLines = 1 << 20;
constexpr size_t kMostRuns = size_t{1} << 22;

// Of a line across the region, what lies in one part.
struct Run {
  double from, to;
  int32_t part;
};

// The segments that a line meets, while it moves upwards.
class SweptSegments {
 public:
  // `reach`: above and below a segment, as far as it is met
  SweptSegments(std::vector<PlaneSegment> segments, double reach) : segments_(std::move(segments)), reach_(reach) {
    for (auto& [low, high] : segments_) {
      if (low.y() > high.y()) std::swap(low, high);
    }
    std::ranges::sort(segments_, {}, [](const PlaneSegment& s) { return s.first.y(); });
  }

  // Those that the line at y meets, the lower end first; y rises from call to call.
  const std::vector<PlaneSegment>& At(double y) {
    for (; next_ < segments_.size() && segments_[next_].first.y() - reach_ <= y; ++next_) {
      met_.push_back(segments_[next_]);
    }
    std::erase_if(met_, [&](const PlaneSegment& s) { return s.second.y() + reach_ <= y; });
    return met_;
  }

 private:
  std::vector<PlaneSegment> segments_;
  double reach_;
  size_t next_ = 0;
  std::vector<PlaneSegment> met_ = {};
};

// The x where a segment, which is not level, has this y. Beyond its ends that of the nearer end.
double AlongAt(const PlaneSegment& s, double y) {
  const double share = std::clamp((y - s.first.y()) / (s.second.y() - s.first.y()), 0.0, 1.0);
  return s.first.x() + share * (s.second.x() - s.first.x());
}

// What of the line lies in the region. A wall without width, seen from above, parts it.
std::vector<double> InsideAt(double y, SweptSegments& region) {
  std::vector<double> ends;
  for (const PlaneSegment& s : region.At(y)) {
    if (s.first.y() <= y && y < s.second.y()) ends.push_back(AlongAt(s, y));
  }
  std::ranges::sort(ends);
  return ends;
}

// What of the line lies in squares around points of objects.
std::vector<double> TakenAt(double y, SweptSegments& objects) {
  std::vector<std::pair<double, double>> taken;
  for (const PlaneSegment& s : objects.At(y)) {
    const bool is_level = s.first.y() == s.second.y();
    const double a = is_level ? s.first.x() : AlongAt(s, y - kNeck);
    const double b = is_level ? s.second.x() : AlongAt(s, y + kNeck);
    taken.emplace_back(std::min(a, b) - kNeck, std::max(a, b) + kNeck);
  }
  return UnionOf(std::move(taken));
}

// The parts that are left of a region, seen from above, when the squares around its objects are taken from it.
class Parts {
 public:
  Parts(const std::vector<PlaneSegment>& region, const std::vector<PlaneSegment>& objects) {
    double top = -std::numeric_limits<double>::infinity();
    for (const auto& [p, q] : region) {
      bottom_ = std::min({bottom_, p.y(), q.y()});
      top = std::max({top, p.y(), q.y()});
    }
    bottom_ = std::floor(bottom_ / kLineSpacing) * kLineSpacing;
    if (region.empty() || !(top - bottom_ <= kMostLines * kLineSpacing)) return;
    FindRuns(static_cast<size_t>(std::ceil((top - bottom_) / kLineSpacing)), {region, 0}, {objects, kNeck});
    JoinRuns();
  }

  // The part nearest to a point, at most two necks away; -1: none. O(log n) for each line in between.
  int32_t Nearest(const Point2& p) const {
    constexpr double kFar = 2 * kNeck;
    double nearest = kFar;
    int32_t part = -1;
    const double first = std::ceil((p.y() - kFar - bottom_) / kLineSpacing - 0.5);
    for (auto l = static_cast<size_t>(std::max(0.0, first)); l < Lines() && HeightOf(l) <= p.y() + kFar; ++l) {
      const auto line = LineOf(l);
      for (auto run = std::ranges::lower_bound(line, p.x() - kFar, {}, &Run::to);
           run != line.end() && run->from < p.x() + kFar; ++run) {
        if (run->part < 0) continue;
        const double beside = std::max({run->from - p.x(), p.x() - run->to, 0.0});
        const double distance = std::hypot(beside, HeightOf(l) - p.y());
        if (distance >= nearest) continue;
        nearest = distance;
        part = run->part;
      }
    }
    return part;
  }

 private:
  size_t Lines() const { return first_.empty() ? 0 : first_.size() - 1; }
  double HeightOf(size_t line) const { return bottom_ + (static_cast<double>(line) + 0.5) * kLineSpacing; }
  std::span<const Run> LineOf(size_t line) const {
    return std::span(runs_).subspan(first_[line], first_[line + 1] - first_[line]);
  }

  void FindRuns(size_t lines, SweptSegments region, SweptSegments objects) {
    first_ = {0};
    for (size_t l = 0; l < lines; ++l) {
      const double y = HeightOf(l);
      const std::vector<double> left = Without(InsideAt(y, region), TakenAt(y, objects));
      for (size_t i = 0; i + 1 < left.size(); i += 2) {
        runs_.push_back({left[i], left[i + 1], static_cast<int32_t>(runs_.size())});
      }
      first_.push_back(runs_.size());
      if (runs_.size() <= kMostRuns) continue;
      runs_.clear();
      first_.clear();
      return;
    }
  }

  // Those of lines beside each other that face each other are of one part; small ones are of none.
  void JoinRuns() {
    DisjointSets sets(static_cast<int32_t>(runs_.size()));
    for (size_t l = 1; l < Lines(); ++l) {
      const auto lower = LineOf(l - 1);
      auto below = lower.begin();
      for (const Run& run : LineOf(l)) {
        while (below != lower.end() && below->to <= run.from) ++below;
        for (auto b = below; b != lower.end() && b->from < run.to; ++b) sets.Join(run.part, b->part);
      }
    }
    std::map<int32_t, double> areas;
    for (Run& run : runs_) {
      run.part = sets.LowestOf(run.part);
      areas[run.part] += (run.to - run.from) * kLineSpacing;
    }
    for (Run& run : runs_) {
      if (areas[run.part] <= kLeastArea) run.part = -1;
    }
  }

  double bottom_ = std::numeric_limits<double>::infinity();
  std::vector<Run> runs_ = {};      // line by line, upwards
  std::vector<size_t> first_ = {};  // of each line in runs_, and their number
};

// An end of an edge of the rim, at an original vertex; seen from above.
struct RimEnd {
  int32_t vertex;
  double length;     // half of the edge, metres; 0 if it is steeper than 45 degrees, as it runs up a wall then
  Point2 into_hole;  // across the edge, of length 1
};

// The rim of some holes, seen from above.
struct Outline {
  std::vector<PlaneSegment> region = {};      // what bounds it: rims, and seams to other holes than these
  std::vector<PlaneSegment> on_objects = {};  // original edges, both ends of which are
  std::vector<RimEnd> ends = {};
};

PlaneSegment FromAbove(const Plan& plan, int32_t from, int32_t to) {
  return {plan.vertices[from].position.head<2>(), plan.vertices[to].position.head<2>()};
}

Outline OutlineOf(const Plan& plan, const std::vector<int32_t>& holes) {
  Outline outline;
  std::map<std::pair<int32_t, int32_t>, int> seams;  // how often
  for (const int32_t h : holes) {
    for (const RimSegment& s : plan.holes[h].segments) {
      if (s.seam) {
        ++seams[std::minmax(s.from, s.to)];
      } else {
        outline.region.push_back(FromAbove(plan, s.from, s.to));
      }
    }
  }
  for (const auto& [ends, count] : seams) {
    if (count % 2 == 1) outline.region.push_back(FromAbove(plan, ends.first, ends.second));
  }
  std::set<std::pair<int32_t, int32_t>> seen;  // own regions have edges of the hole once more
  const auto add = [&](const RimSegment& s) {
    if (s.seam || !seen.emplace(s.from, s.to).second) return;
    const PlanVertex& a = plan.vertices[s.from];
    const PlanVertex& b = plan.vertices[s.to];
    if (a.on_object && b.on_object) outline.on_objects.push_back(FromAbove(plan, s.from, s.to));
    const Point3 way = b.position - a.position;
    const double length = way.head<2>().norm();
    const Point2 into_hole = Point2(-way.y(), way.x()).normalized();  // the hole is on the left
    for (const int32_t v : {s.from, s.to}) {
      if (plan.vertices[v].index < 0) continue;
      outline.ends.push_back({v, std::abs(way.z()) <= length ? length / 2 : 0, into_hole});
    }
  };
  for (const int32_t h : holes) ForRimSegments(plan.holes[h], add);
  return outline;
}

// An end of an edge on the rim of a part.
struct RimPoint {
  int32_t vertex;
  double length;  // as RimEnd::length
  double height;
  std::optional<double> ground;  // under it, where that is known
  bool on_object;
};

// Square metres of upright wall between the rim and a level through its objects, and between the rim and the ground.
struct Walls {
  double to_objects = 0, to_ground = 0;
  double level = 0;  // of the objects

  bool AreFewerToObjects() const { return to_objects < kFewerWalls * to_ground; }
};

// `ground_level`: where it is not known below a vertex. All walls are 0 without an object.
Walls WallsOf(const std::vector<RimPoint>& rim, double ground_level) {
  std::vector<std::pair<double, double>> objects;
  for (const RimPoint& p : rim) {
    if (p.on_object) objects.emplace_back(p.height, p.length);
  }
  const std::optional<double> level = WeightedMedian(std::move(objects));
  if (!level) return {};
  Walls walls{.level = *level};
  for (const RimPoint& p : rim) {
    walls.to_objects += p.length * std::abs(p.height - walls.level);
    walls.to_ground += p.length * std::abs(p.height - p.ground.value_or(ground_level));
  }
  return walls;
}

using Rims = std::map<int32_t, std::vector<RimPoint>>;  // by part

Rims RimsOf(const Plan& plan, const Outline& outline, const Parts& parts) {
  Rims rims;
  for (const RimEnd& end : outline.ends) {
    const PlanVertex& vertex = plan.vertices[end.vertex];
    const int32_t part = parts.Nearest(vertex.position.head<2>() + kNeck * end.into_hole);
    if (part < 0) continue;
    const double height = vertex.position.z();
    const std::optional<double> ground = vertex.on_object ? std::optional<double>(vertex.ground) : height;
    rims[part].push_back({end.vertex, end.length, height, ground, vertex.on_object});
  }
  return rims;
}

std::optional<double> GroundLevelOf(const Rims& rims) {
  std::vector<std::pair<double, double>> ground;
  for (const auto& [part, rim] : rims) {
    for (const RimPoint& p : rim) {
      if (p.ground) ground.emplace_back(*p.ground, p.length);
    }
  }
  return WeightedMedian(std::move(ground));
}

}  // namespace

RoofParts FindRoofParts(const Plan& plan, const std::vector<int32_t>& holes) {
  const Outline outline = OutlineOf(plan, holes);
  if (outline.on_objects.empty()) return {};
  const Parts parts(outline.region, outline.on_objects);
  const Rims rims = RimsOf(plan, outline, parts);
  const std::optional<double> ground_level = GroundLevelOf(rims);
  if (!ground_level) return {};
  std::set<int32_t> in_ground;
  std::set<int32_t> joined;
  std::map<int32_t, double> below;
  for (const auto& [part, rim] : rims) {
    const Walls walls = WallsOf(rim, *ground_level);
    for (const RimPoint& p : rim) {
      if (!walls.AreFewerToObjects()) {
        in_ground.insert(p.vertex);
      } else if (p.ground && std::abs(p.height - *p.ground) < std::abs(p.height - walls.level)) {
        below[p.vertex] = walls.level;
      } else {
        joined.insert(p.vertex);
      }
    }
  }
  if (in_ground.empty()) return {};
  RoofParts found{.joined = {joined.begin(), joined.end()}, .below = {}};
  for (const auto& [v, level] : below) {
    if (!in_ground.contains(v) && !joined.contains(v)) found.below.emplace_back(v, static_cast<float>(level));
  }
  return found;
}

}  // namespace tilemend
