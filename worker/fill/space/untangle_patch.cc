#include "worker/fill/space/untangle_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/position_index.h"
#include "common/mesh/triangle_shape.h"
#include "worker/fill/space/free_outline.h"
#include "worker/fill/space/live_crossings.h"
#include "worker/fill/space/patch_changes.h"
#include "worker/fill/space/patch_crossings.h"
#include "worker/fill/space/patch_edit.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {
namespace {

constexpr int kMaxPasses = 12;
constexpr double kMinGain = 0.01;  // of the weight: a pass that gains less is the last
constexpr double kMinLess = 1e-9;  // metres: sums in another order differ by less
// Of the edges at a point: how far it goes.
constexpr double kSteps[] = {0.5, 0.25, 0.1, 0.04, 0.015};
// Of the same: how far surface that faces up may rise or fall.
constexpr double kMaxRise = 0.25;
// A bound on the work: changes tried in a patch, some 1,000 for a triangle.
constexpr int kMaxTries = 50'000;
constexpr int kTriesPerQuestion = 100;  // whether it is cancelled

// Shakes of a cluster, changes drawn for one until one may be made, and passes after it.
constexpr int kShakes = 16;
constexpr int kDraws = 20;
constexpr int kShakePasses = 4;
// As kSteps, in those passes: more shakes with fewer steps solve more in the same time.
constexpr double kShakeSteps[] = {0.25, 0.04};
constexpr double kMaxWorse = 1;  // weight: by how much a shake may raise it

// The 26 directions, and none.
Eigen::Vector3d WayOf(int i) {
  const Eigen::Vector3d way = Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1).cast<double>();
  return way.isZero() ? way : Eigen::Vector3d(way.normalized());
}

// The first triangle that crosses and is not among `left`, and all that hang together with it.
std::set<int32_t> NextCluster(const std::vector<PatchCrossing>& crossings, const std::set<int32_t>& left,
                              const PatchEdit& edit) {
  std::set<int32_t> cluster, corners;
  const auto add = [&](int32_t t) {
    if (t < 0 || left.contains(t) || !cluster.insert(t).second) return;
    corners.insert(edit.Corners(t).begin(), edit.Corners(t).end());
  };
  const auto belongs = [&](int32_t t) {
    return t >= 0 && (cluster.contains(t) ||
                      std::ranges::any_of(edit.Corners(t), [&](int32_t v) { return corners.contains(v); }));
  };
  for (size_t before = 0; before == 0 || before != cluster.size();) {
    before = cluster.size();
    for (const auto& [pair, points] : crossings) {
      if (!cluster.empty() && !belongs(pair.a) && !belongs(pair.b)) continue;
      add(pair.a);
      add(pair.b);
    }
    if (cluster.empty()) break;
  }
  return cluster;
}

class Untangler {
 public:
  Untangler(const LocalHole& hole, std::span<const SpaceTriangle> surface, std::span<const SpaceTriangle> earlier,
            const std::function<bool()>& is_cancelled, LocalPatch& patch)
      : hole_(hole),
        is_cancelled_(is_cancelled),
        patch_(patch),
        edit_(hole, patch),
        outline_(hole),
        crossings_(surface, earlier, edit_.AllPlaced()) {
    double edges = 0;
    for (const SpaceTriangle& t : edit_.AllPlaced()) {
      for (int k = 0; k < 3; ++k) {
        reach_.extend(t[k]);
        edges += (t[(k + 1) % 3] - t[k]).norm() / 3;
      }
    }
    const double edge = edges / std::max(1, edit_.count());
    reach_.min().array() -= edge;
    reach_.max().array() += edge;
    for (const Point3& p : hole.positions) taken_.Insert(p);
    for (const Point3& p : patch.new_points) taken_.Insert(p);
    for (const std::span<const SpaceTriangle> part : {surface, earlier}) {
      for (const SpaceTriangle& t : part) std::ranges::for_each(t, [&](const Point3& p) { taken_.Insert(p); });
    }
  }

  void Run() {
    LocalPatch before = patch_;
    ForEachCluster([&](const std::set<int32_t>& cluster) { return Untangle(cluster); });
    steps_ = kShakeSteps;
    ForEachCluster([&](const std::set<int32_t>& cluster) { return Shake(cluster); });
    edit_.Finish();
    if (!outline_.TellLeft(patch_)) patch_ = std::move(before);
  }

 private:
  bool IsAtEnd() const { return tries_ > kMaxTries || is_ended_ || (is_cancelled_ && is_cancelled_()); }

  // Calls use(cluster), which returns those that cross afterwards instead of the cluster, for all that hang together.
  template <typename Use>
  void ForEachCluster(const Use& use) {
    std::set<int32_t> left;  // triangles that cross in the end
    for (;;) {
      const std::set<int32_t> cluster = NextCluster(crossings_.Avoidable(), left, edit_);
      if (cluster.empty() || IsAtEnd()) break;
      made_.clear();
      const std::set<int32_t> rest = use(cluster);
      left.insert(rest.begin(), rest.end());
    }
  }

  std::set<int32_t> CrossedBut(const std::set<int32_t>& others) const {
    std::set<int32_t> crossed;
    for (const PatchCrossing& c : crossings_.Avoidable()) crossed.insert({c.pair.a, c.pair.b});
    std::erase_if(crossed, [&](int32_t t) { return t < 0 || others.contains(t); });
    return crossed;
  }

  std::set<int32_t> Untangle(const std::set<int32_t>& cluster) {
    const std::set<int32_t> now = Descend(cluster, CrossedBut(cluster), kMaxPasses);
    if (now.size() <= cluster.size()) return now;
    UndoTo(0);
    return cluster;
  }

  // Returns those that cross after passes of improvements, but for `others`.
  std::set<int32_t> Descend(std::set<int32_t> now, const std::set<int32_t>& others, int passes) {
    for (int pass = 0; pass < passes && !now.empty(); ++pass) {
      const double before = crossings_.weight();
      for (const int32_t t : now) {
        if (!edit_.IsGone(t) && !IsAtEnd()) Improve(t);
      }
      now = CrossedBut(others);
      if (crossings_.weight() > (1 - kMinGain) * before) break;
    }
    return now;
  }

  // Leaves a local minimum (iterated local search, Lourenço 2003): makes a change drawn by chance, and improves from
  // there. Keeps that if fewer cross, or as many along shorter curves.
  std::set<int32_t> Shake(const std::set<int32_t>& cluster) {
    const std::set<int32_t> others = CrossedBut(cluster);
    std::set<int32_t> now = cluster;
    for (int shake = 0; shake < kShakes && !now.empty() && !IsAtEnd(); ++shake) {
      const size_t made = made_.size();
      const double before = crossings_.weight();
      if (!ChangeByChance(now)) continue;
      std::set<int32_t> then = Descend(CrossedBut(others), others, kShakePasses);
      if (then.size() < now.size() || (then.size() == now.size() && crossings_.weight() < before - kMinLess)) {
        now = std::move(then);
      } else {
        UndoTo(made);
      }
    }
    return now;
  }

  size_t DrawBelow(size_t end) { return random_() % end; }

  // At one of some triangles or beside them. Returns false if none that was drawn may be made.
  bool ChangeByChance(const std::set<int32_t>& triangles) {
    std::set<int32_t> found;
    for (const int32_t t : triangles) {
      for (const int32_t v : edit_.Corners(t)) {
        for (const int32_t beside : edit_.TrianglesAt(v)) found.insert(beside);
      }
    }
    const std::vector<int32_t> around(found.begin(), found.end());
    for (int draw = 0; draw < kDraws; ++draw) {
      const int32_t t = around[DrawBelow(around.size())];
      const SpaceTriangle& p = edit_.Placed(t);
      const auto changes = ChangesAt(t, (p[0] + p[1] + p[2]) / 3, NextPoint(), hole_, edit_, outline_);
      if (changes.empty()) continue;
      best_.reset();
      least_ = crossings_.weight() + kMaxWorse;
      const auto& [change, places] = changes[DrawBelow(changes.size())];
      if (places.empty()) {
        Try(change);
      } else {
        const auto& [place, size] = places[DrawBelow(places.size())];
        const double step = kSteps[DrawBelow(std::size(kSteps))];
        TryAt(place + step * size * WayOf(static_cast<int>(DrawBelow(27))), IsWaterAt(place), change);
      }
      if (!best_) continue;
      Make(*best_);
      return true;
    }
    return false;
  }

  // The last changes of a cluster, but for the first `made`.
  void UndoTo(size_t made) {
    for (; made_.size() > made; made_.pop_back()) {
      const auto& [first, out] = made_.back();
      crossings_.Undo(out, first);
      edit_.TakeOutFrom(first);
      edit_.DropFrom(first);
      for (const int32_t t : out) edit_.PutBack(t);
    }
  }

  // Makes the change at a triangle after which least crosses, if that is less than now.
  void Improve(int32_t t) {
    best_.reset();
    least_ = crossings_.weight();
    std::vector<Point3> points;  // of the curves on the triangle
    for (const PatchCrossing& c : crossings_.Avoidable()) {
      if (c.pair.a == t || c.pair.b == t) points.insert(points.end(), c.points.begin(), c.points.end());
    }
    const SpaceTriangle& p = edit_.Placed(t);
    if (points.empty()) points.assign(p.begin(), p.end());
    const Point3 middle =
        std::accumulate(points.begin(), points.end(), Point3(Point3::Zero())) / static_cast<double>(points.size());
    for (const auto& [change, places] : ChangesAt(t, middle, NextPoint(), hole_, edit_, outline_)) {
      for (const auto& [place, size] : places) TryPlaces(change, place, size);
      if (places.empty()) Try(change);
    }
    if (best_) Make(*best_);
  }

  int32_t NextPoint() const { return hole_.size() + static_cast<int32_t>(patch_.new_points.size()); }

  bool IsWaterAt(const Point3& place) const { return hole_.WaterLevelAt(place.head<2>()) == hole_.Storable(place).z(); }

  // With its new point at a place, or at the water's level there.
  void TryAt(const Point3& place, bool is_water, PatchChange change) {
    change.point = hole_.Storable(place);
    if (is_water) change.point->z() = *hole_.WaterLevelAt(place.head<2>());
    if (taken_.Find(*change.point) < 0) Try(change);
  }

  // At a place and around it; at the water's level if the place is there.
  void TryPlaces(const PatchChange& change, const Point3& place, double size) {
    const bool is_water = IsWaterAt(place);
    TryAt(place, is_water, change);
    for (const double step : steps_) {
      for (int i = 0; i < 27; ++i) {
        if (!WayOf(i).isZero()) TryAt(place + step * size * WayOf(i), is_water, change);
      }
    }
  }

  void Try(const PatchChange& change) {
    if (is_ended_) return;
    std::vector<SpaceTriangle> in;
    for (const Triangle& t : change.in) {
      if (IsOfSurface(hole_, t)) return;
      SpaceTriangle& placed = in.emplace_back();
      for (int k = 0; k < 3; ++k) placed[k] = t[k] == NextPoint() ? *change.point : edit_.At(t[k]);
      if (!HasArea(placed)) return;
    }
    if (!IsWithinReach(change) || !StaysAtOutline(change) || !KeepsWater(change, in) || !KeepsSurface(change, in))
      return;
    if (++tries_ % kTriesPerQuestion == 0) is_ended_ = IsAtEnd();
    const double weight = crossings_.WeightWith(change.out, in);
    if (weight > least_ - kMinLess || !KeepsManifold(change)) return;
    least_ = weight;
    best_ = change;
  }

  bool IsWater(const SpaceTriangle& t) const {
    return std::ranges::all_of(t, [&](const Point3& p) { return hole_.WaterLevelAt(p.head<2>()) == p.z(); });
  }

  // Of the patch as it came in, and an edge around it.
  bool IsWithinReach(const PatchChange& change) const { return !change.point || reach_.contains(*change.point); }

  bool StaysAtOutline(const PatchChange& change) const {
    const bool faces_up = std::ranges::any_of(change.out, [&](int32_t t) { return edit_.FacesUp(t); });
    return !change.point || !change.planned || FreeOutline::MayLie(*change.planned, *change.point, faces_up);
  }

  // Whether where there was water there still is, and nothing else.
  bool KeepsWater(const PatchChange& change, const std::vector<SpaceTriangle>& in) const {
    const auto is_water = [&](int32_t t) { return IsWater(edit_.Placed(t)); };
    if (std::ranges::none_of(change.out, is_water)) return true;
    return std::ranges::all_of(change.out, is_water) &&
           std::ranges::all_of(in, [&](const SpaceTriangle& t) { return IsWater(t); });
  }

  // Whether surface that faces up still does, about where it was. Walls and what lies beside them are free.
  bool KeepsSurface(const PatchChange& change, const std::vector<SpaceTriangle>& in) const {
    double edges = 0;
    for (const int32_t t : change.out) {
      const SpaceTriangle& p = edit_.Placed(t);
      if (!FacesUp(p)) return true;
      for (int k = 0; k < 3; ++k) edges += (p[(k + 1) % 3] - p[k]).norm() / 3;
    }
    const double most = kMaxRise * edges / static_cast<double>(change.out.size());
    const auto is_near = [&](const SpaceTriangle& t, const std::optional<Point3>& p) {
      return !p || std::abs(HeightOver(t, *p).value_or(0)) <= most;
    };
    const std::optional<Point3> gone = change.gone ? std::optional(edit_.At(*change.gone)) : std::nullopt;
    return std::ranges::all_of(change.out, [&](int32_t t) { return is_near(edit_.Placed(t), change.point); }) &&
           std::ranges::all_of(in, [&](const SpaceTriangle& t) { return FacesUp(t) && is_near(t, gone); });
  }

  // A point that merges with another may leave an edge with more than two triangles.
  bool KeepsManifold(const PatchChange& change) {
    if (change.point) return true;
    const int32_t first = edit_.count();
    Put(change);
    bool keeps = true;
    for (int32_t t = first; t < edit_.count(); ++t) keeps = keeps && !edit_.HasOverfullEdge(t);
    edit_.TakeOutFrom(first);
    edit_.DropFrom(first);
    for (const int32_t t : change.out) edit_.PutBack(t);
    return keeps;
  }

  void Put(const PatchChange& change) {
    for (const int32_t t : change.out) edit_.TakeOut(t);
    for (const Triangle& t : change.in) edit_.PutIn(t);
  }

  void Make(const PatchChange& change) {
    const int32_t first = edit_.count();
    if (change.freed) outline_.Add(*change.freed, edit_.At(*change.freed));
    if (change.point) {
      const int32_t v = edit_.AddPoint(*change.point);
      if (change.planned) outline_.Add(v, *change.planned);
      taken_.Insert(*change.point);
    }
    Put(change);
    const std::vector<SpaceTriangle> placed = edit_.AllPlaced();
    crossings_.Change(change.out, std::span(placed).subspan(static_cast<size_t>(first)));
    made_.emplace_back(first, change.out);
  }

  const LocalHole& hole_;
  const std::function<bool()>& is_cancelled_;
  LocalPatch& patch_;
  PatchEdit edit_;
  FreeOutline outline_;
  LiveCrossings crossings_;
  Eigen::AlignedBox3d reach_;  // of new points
  PositionIndex taken_;        // where there is, or was, a vertex
  std::vector<std::pair<int32_t, std::vector<int32_t>>>
      made_;  // changes: the first triangle that came, those that went
  std::optional<PatchChange> best_;
  double least_ = 0;  // its weight
  int tries_ = 0;
  std::span<const double> steps_ = kSteps;
  std::minstd_rand random_;
  bool is_ended_ = false;  // cancelled
};

}  // namespace

void UntanglePatch(const LocalHole& hole, std::span<const SpaceTriangle> surface,
                   std::span<const SpaceTriangle> earlier, const std::function<bool()>& is_cancelled,
                   LocalPatch& patch) {
  Untangler(hole, surface, earlier, is_cancelled, patch).Run();
}

}  // namespace tilemend
