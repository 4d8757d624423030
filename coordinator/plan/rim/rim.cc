#include "coordinator/plan/rim/rim.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <unordered_map>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/edge_loops.h"
#include "common/mesh/position_index.h"
#include "common/mesh/vertex_lists.h"

namespace tilemend {
namespace {

// Boundary vertices and edges of all tiles, in order of the cells. Every pair of edges that run between the same points
// is dropped: in opposite directions, two tiles meet there. Points and edges are tidied up as soon as no tile to come
// reaches them: what is held is the rim so far, and the boundaries of the tiles about the cell.
class RimCollector {
 public:
  RimCollector(RimPoints keep, Rim& rim) : keep_(keep), rim_(rim) {
    rim_.points.reserve(kLeast);
    rim_.edges.reserve(kLeast);
  }

  void Take(CellId cell, const SurveyRecord& record) {
    std::vector<int32_t>& number = rim_.point_of[cell];
    number.reserve(record.vertices.size());
    for (const BoundaryVertex& v : record.vertices) {
      const auto place = static_cast<size_t>(index_.Insert(v.position));
      if (place == point_at_.size()) {
        point_at_.push_back(static_cast<int32_t>(rim_.points.size()));
        rim_.points.push_back({cell, v.index, v.position, v.normal, v.centroid_height, 0});
      } else {
        rim_.points[point_at_[place]].normal += v.normal;
      }
      number.push_back(point_at_[place]);
    }
    for (const BoundaryEdge& e : record.edges) {
      rim_.edges.push_back({number[e.from], number[e.to], cell, e.piece == kAreaPiece});
    }
    open_.push_back(cell);
  }

  // Tells that all tiles to come lie at x >= `west`.
  void Advance(double west) {
    if (rim_.points.size() + rim_.edges.size() > tidy_at_) TidyUp(west);
  }

  void Finish() {
    TidyUp(std::numeric_limits<double>::infinity());
    rim_.points.shrink_to_fit();
    rim_.edges.shrink_to_fit();
  }

 private:
  static constexpr size_t kLeast = 1 << 16;  // points and edges: fewer are not worth the while

  void TidyUp(double west) {
    const auto passed = [&](int32_t p) { return rim_.points[p].position.x() < west; };
    DropMatched(passed);
    const std::vector<int32_t> number = DropPoints(passed);
    Renumber(number, passed);
    tidy_at_ = 2 * (rim_.points.size() + rim_.edges.size()) + kLeast;
  }

  template <typename Passed>
  void DropMatched(const Passed& passed) {
    const auto first = rim_.edges.begin() + static_cast<ptrdiff_t>(settled_edges_);
    const VertexLists upper_ends(rim_.points.size(), [&](const auto& use) {
      for (auto e = first; e != rim_.edges.end(); ++e) use(std::min(e->from, e->to), std::max(e->from, e->to));
    });
    const auto is_matched = [&](const RimEdge& e) {
      if (!passed(e.from) && !passed(e.to)) return false;
      return std::ranges::count(upper_ends.Of(std::min(e.from, e.to)), std::max(e.from, e.to)) != 1;
    };
    rim_.edges.erase(std::remove_if(first, rim_.edges.end(), is_matched), rim_.edges.end());
  }

  // Drops points without edges. Returns the new number of each, -1 for those that are gone.
  template <typename Passed>
  std::vector<int32_t> DropPoints(const Passed& passed) {
    std::vector<bool> used(rim_.points.size(), keep_ == RimPoints::kAll);
    for (const RimEdge& e : rim_.edges) used[e.from] = used[e.to] = true;
    std::vector<int32_t> number(rim_.points.size(), -1);
    size_t kept = 0;
    for (size_t p = 0; p < number.size(); ++p) {
      if (!used[p] && passed(static_cast<int32_t>(p))) continue;
      number[p] = static_cast<int32_t>(kept);
      if (kept != p) rim_.points[kept] = rim_.points[p];
      ++kept;
    }
    rim_.points.resize(kept);
    return number;
  }

  template <typename Passed>
  void Renumber(const std::vector<int32_t>& number, const Passed& passed) {
    for (RimEdge& e : rim_.edges) e.from = number[e.from], e.to = number[e.to];
    const auto is_done = [&](const RimEdge& e) { return passed(e.from) && passed(e.to); };
    const auto first = rim_.edges.begin() + static_cast<ptrdiff_t>(settled_edges_);
    settled_edges_ = std::find_if_not(first, rim_.edges.end(), is_done) - rim_.edges.begin();
    for (const CellId cell : open_) {
      for (int32_t& p : rim_.point_of.at(cell)) p = p < 0 ? p : number[p];
    }
    int32_t settled = 0;  // the first so many points keep their numbers
    while (settled < std::ssize(rim_.points) && passed(settled)) ++settled;
    std::erase_if(open_, [&](CellId cell) {
      std::vector<int32_t>& points = rim_.point_of.at(cell);
      const int32_t last = points.empty() ? -1 : *std::ranges::max_element(points);
      if (last < 0) rim_.point_of.erase(cell);
      return last < settled;
    });
    index_ = PositionIndex();
    point_at_.clear();
    for (size_t p = 0; p < rim_.points.size(); ++p) {
      if (passed(static_cast<int32_t>(p))) continue;
      index_.Insert(rim_.points[p].position);
      point_at_.push_back(static_cast<int32_t>(p));
    }
  }

  const RimPoints keep_;
  Rim& rim_;
  PositionIndex index_;            // of the points that a tile to come may have
  std::vector<int32_t> point_at_;  // by number in the index
  std::vector<CellId> open_;       // with points whose numbers may change
  size_t settled_edges_ = 0;       // no edge to come matches one of the first so many
  size_t tidy_at_ = kLeast;
};

void CollectEdges(const PlanInput& input, RimPoints keep, Rim& rim) {
  std::vector<double> west;  // of the tiles from each one on
  for (const auto& [cell, record] : input.cells) {
    if (record != nullptr && record->vertex_count > 0) west.push_back(record->lo.x());
  }
  std::reverse(west.begin(), west.end());
  std::partial_sum(west.begin(), west.end(), west.begin(), [](double a, double b) { return std::min(a, b); });
  RimCollector collector(keep, rim);
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr) continue;
    if (record->vertex_count > 0 && keep == RimPoints::kOfEdges) {
      collector.Advance(west.back());
      west.pop_back();
    }
    collector.Take(cell, *record.Outline());
  }
  collector.Finish();
}

// The angle of `d` around axis `normal`, in (-pi, pi], from a direction fixed by the normal.
class AngleAround {
 public:
  explicit AngleAround(Eigen::Vector3d normal) {
    if (normal.norm() == 0) normal = Eigen::Vector3d::UnitZ();
    normal.normalize();
    const Eigen::Vector3d helper = std::abs(normal.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    u_ = (helper - normal * helper.dot(normal)).normalized();
    v_ = normal.cross(u_);
  }
  double operator()(const Eigen::Vector3d& d) const { return std::atan2(d.dot(v_), d.dot(u_)); }

 private:
  Eigen::Vector3d u_, v_;
};

// The triangles at a point between a boundary edge that leaves it and one that arrives.
struct Fan {
  int32_t arriving = 0, leaving = 0;
  double begin = 0, width = 0;  // angles; turning counter-clockwise one crosses the surface
  double middle() const { return begin + width / 2; }
};

// An angle as a turn of at least `least` and less than a full one more.
double AsTurn(double angle, double least) {
  const double full = 2 * std::numbers::pi;
  return angle - full * std::floor((angle - least) / full);
}

// Links each fan to the next around the point. False if some fan is not known, or they lie over each other: parts of
// surface that meet in no common plane.
bool LinkFans(const Rim& rim, int32_t point, std::span<const int32_t> arriving, std::span<const int32_t> after,
              std::vector<int32_t>& next) {
  const AngleAround angle(rim.points[point].normal);
  const Point3& middle = rim.points[point].position;
  std::vector<Fan> fans;
  for (const int32_t a : arriving) {
    if (after.empty() || after[a] < 0) return false;
    Fan fan{a, after[a]};
    fan.begin = angle(rim.points[rim.edges[fan.leaving].to].position - middle);
    fan.width = AsTurn(angle(rim.points[rim.edges[a].from].position - middle) - fan.begin, 0);
    fans.push_back(fan);
  }
  std::ranges::sort(fans, {}, [](const Fan& f) { return std::pair(AsTurn(f.middle(), 0), f.arriving); });
  double turned = 0;
  for (size_t i = 0; i < fans.size(); ++i) {
    const Fan &fan = fans[i], &other = fans[(i + 1) % fans.size()];
    const double overlap = std::min(fan.width, other.width) / 2;
    turned += fan.width + AsTurn(other.begin - fan.begin - fan.width, -overlap);
  }
  if (turned > 3 * std::numbers::pi) return false;
  for (size_t i = 0; i < fans.size(); ++i) next[fans[i].arriving] = fans[(i + 1) % fans.size()].leaving;
  return true;
}

// For the edges that arrive at and leave one point: which leaves after which arrives. Turning counter-clockwise from
// the way back along an arriving edge one crosses the hole; the first leaving edge met bounds the same hole.
void LinkAt(const Rim& rim, int32_t point, std::span<const int32_t> arriving, std::span<const int32_t> leaving,
            std::span<const int32_t> after, std::vector<int32_t>& next) {
  if (arriving.size() == 1 && leaving.size() == 1) {
    next[arriving[0]] = leaving[0];
    return;
  }
  if (arriving.size() == leaving.size() && LinkFans(rim, point, arriving, after, next)) return;
  const AngleAround angle(rim.points[point].normal);
  std::vector<bool> taken(leaving.size(), false);
  for (const int32_t a : arriving) {
    const double back = angle(rim.points[rim.edges[a].from].position - rim.points[point].position);
    double best = 10;
    size_t choice = leaving.size();
    for (size_t k = 0; k < leaving.size(); ++k) {
      if (taken[k]) continue;
      double turn = angle(rim.points[rim.edges[leaving[k]].to].position - rim.points[point].position) - back;
      if (turn <= 0) turn += 2 * std::numbers::pi;
      if (turn < best) {
        best = turn;
        choice = k;
      }
    }
    if (choice == leaving.size()) continue;
    taken[choice] = true;
    next[a] = leaving[choice];
  }
}

std::vector<int32_t> LinkAtPoints(const Rim& rim, std::span<const int32_t> after, std::vector<uint8_t>& touching) {
  const auto edges_at = [&rim](int32_t RimEdge::*end) {
    return VertexLists(rim.points.size(), [&rim, end](const auto& use) {
      for (size_t e = 0; e < rim.edges.size(); ++e) use(rim.edges[e].*end, static_cast<int32_t>(e));
    });
  };
  const VertexLists arriving = edges_at(&RimEdge::to), leaving = edges_at(&RimEdge::from);
  std::vector<int32_t> next(rim.edges.size(), -1);
  for (int32_t p = 0; p < std::ssize(rim.points); ++p) {
    const std::span<const int32_t> there = arriving.Of(p);
    if (there.empty()) continue;
    LinkAt(rim, p, there, leaving.Of(p), after, next);
    touching[p] = there.size() > 1;
  }
  return next;
}

void TraceLoops(const std::vector<int32_t>& next, Rim& rim) {
  for (EdgeWalk& walk : FollowEdges(next)) {
    if (walk.closed) {
      rim.loops.push_back(std::move(walk.edges));
    } else {
      rim.unlinked.insert(rim.unlinked.end(), walk.edges.begin(), walk.edges.end());
    }
  }
}

// Counts the groups of two or more loops that share a point.
int32_t CountTouchingGroups(const Rim& rim, const std::vector<uint8_t>& touching) {
  DisjointSets groups(static_cast<int32_t>(rim.loops.size()));
  std::unordered_map<int32_t, int32_t> loop_at;
  for (size_t l = 0; l < rim.loops.size(); ++l) {
    for (const int32_t e : rim.loops[l]) {
      const int32_t p = rim.edges[e].from;
      if (!touching[p]) continue;
      const auto [it, fresh] = loop_at.try_emplace(p, static_cast<int32_t>(l));
      if (!fresh) groups.Join(static_cast<int32_t>(l), it->second);
    }
  }
  std::vector<int32_t> members(rim.loops.size(), 0);
  for (const int32_t group : groups.Groups()) ++members[group];
  return static_cast<int32_t>(std::count_if(members.begin(), members.end(), [](int32_t n) { return n > 1; }));
}

// How many times its length seen from above an edge reaches at most: those of walls reach no farther than others.
constexpr double kSteepestReach = 1.5;

void StoreSizes(Rim& rim) {
  std::vector<int32_t> count(rim.points.size(), 0);
  for (const RimEdge& e : rim.edges) {
    const double length = LengthOf(rim, e);
    const double from_above = (rim.points[e.to].position - rim.points[e.from].position).head<2>().norm();
    for (const int32_t p : {e.from, e.to}) {
      rim.points[p].size += length;
      rim.points[p].reach += from_above;
      ++count[p];
    }
  }
  for (size_t p = 0; p < rim.points.size(); ++p) {
    RimPoint& point = rim.points[p];
    if (count[p] == 0) continue;
    point.size /= count[p];
    point.reach = std::min(point.size, kSteepestReach * point.reach / count[p]);
  }
}

}  // namespace

double LengthOf(const Rim& rim, const RimEdge& e) {
  const RimPoint &from = rim.points[e.from], &to = rim.points[e.to];
  const Point3 way = to.position - from.position;
  return e.area_edge && (from.index < 0 || to.index < 0) ? way.head<2>().norm() : way.norm();
}

Rim BuildRim(const PlanInput& input, RimPoints keep) {
  Rim rim;
  CollectEdges(input, keep, rim);
  StoreSizes(rim);
  LinkLoops(rim);
  return rim;
}

void LinkLoops(Rim& rim, std::span<const int32_t> after) {
  rim.loops.clear();
  rim.unlinked.clear();
  std::vector<uint8_t> touching(rim.points.size(), 0);
  const std::vector<int32_t> next = LinkAtPoints(rim, after, touching);
  TraceLoops(next, rim);
  rim.continuous = CountTouchingGroups(rim, touching);
}

std::vector<RimSegment> Reversed(const Rim& rim, std::span<const int32_t> edges) {
  std::vector<RimSegment> segments;
  for (const int32_t e : edges) segments.push_back({rim.edges[e].to, rim.edges[e].from, rim.edges[e].area_edge});
  std::reverse(segments.begin(), segments.end());
  return segments;
}

}  // namespace tilemend
