#include "worker/papers/front/advancing_front.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <unordered_set>
#include <utility>

#include "common/mesh/edge_key.h"
#include "common/mesh/triangle_shape.h"
#include "worker/papers/front/front_loops.h"
#include "worker/papers/front/front_sight.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kJoined = 75 * kDegree, kOneVertex = 135 * kDegree;
// A corner that allows no new vertex is cut off if it is sharper than this.
constexpr double kCutOff = 150 * kDegree;
// Vertices of the front within this many edges of where a new one should go may take its place.
constexpr double kReach = 1.6;

// A corner that waits is looked at again when the front has changed within this many edges of it.
constexpr double kSight = 8;

// What a new triangle must keep to, one after the other as the front gets stuck.
enum class Care { kFull, kNearFront, kNone };

class Front {
 public:
  Front(const FrontRim& rim, const FrontRule& rule, const FrontLimits& limits)
      : rim_(rim),
        rule_(rule),
        limits_(limits),
        loops_(rim.loops),
        areas_(rim.areas),
        neighbours_(rim.neighbours),
        sizes_(rim.sizes) {
    for (const Vector3d& area : rim.areas) {
      carried_.push_back(area.norm() > 0 ? Vector3d(area.normalized()) : Vector3d::UnitZ());
    }
    patch_.points = rim.points;
  }

  FrontPatch Run() {
    for (int32_t node = 0; node < loops_.size(); ++node) Queue(node);
    while (!loops_.Alive().empty()) {
      if (queue_.empty() && !TakeLessCare()) return {};
      if (sight_.looked_at() > limits_.most_looks) return {FrontEnd::kTooMuchWork, {}, {}};
      const int32_t node = queue_.begin()->second;
      queue_.erase(queue_.begin());
      of_node_[node].queued = -1;
      if (!loops_[node].alive) continue;
      if (!Advance(node)) {
        Wait(node);
        continue;
      }
      if (RunsAway() || (limits_.is_cancelled && limits_.is_cancelled())) return {};
      QueueWaitingNear(node);
      care_ = Care::kFull;
    }
    patch_.end = FrontEnd::kClosed;
    return std::move(patch_);
  }

 private:
  int64_t NewPoints() const { return std::ssize(patch_.points) - std::ssize(rim_.points); }

  bool RunsAway() const {
    return NewPoints() > limits_.most_new_points || std::ssize(loops_.Alive()) > limits_.longest_front;
  }

  bool TakeLessCare() {
    if (care_ == Care::kNone || waiting_.empty()) return false;
    care_ = care_ == Care::kFull ? Care::kNearFront : Care::kNone;
    widest_wait_ = 0;
    for (const int32_t node : std::exchange(waiting_, {})) Queue(node);
    return true;
  }

  void Wait(int32_t node) {
    waiting_.insert(node);
    widest_wait_ = std::max(widest_wait_, kSight * CornerAt(node).Length());
  }

  // What a corner allows depends on the front near it alone.
  void QueueWaitingNear(int32_t changed) {
    if (waiting_.empty()) {
      widest_wait_ = 0;
      return;
    }
    const Point3 place = At(changed);
    const double own_reach = kSight * CornerAt(changed).Length();
    for (const int32_t node : sight_.NodesNear(place, std::max(own_reach, widest_wait_))) {
      if (!waiting_.contains(node)) continue;
      const double reach = std::max(own_reach, kSight * CornerAt(node).Length());
      if ((At(node) - place).norm() <= reach) Queue(node);
    }
  }

  // A corner that may have changed. Its edge ahead is seen from now on.
  void Queue(int32_t node) {
    of_node_.resize(loops_.size());
    OfNode& own = of_node_[node];
    waiting_.erase(node);
    if (own.queued >= 0) queue_.erase({own.queued, node});
    own.queued = -1;
    if (!loops_[node].alive) return;
    if (own.followed != loops_[node].after) sight_.Follow(node, sizes_[loops_[node].vertex]);
    own.followed = loops_[node].after;
    own.queued = CornerAt(node).angle_rad;
    queue_.insert({own.queued, node});
  }

  void QueueAround(int32_t node) {
    for (const int32_t n : {loops_[node].before, node, loops_[node].after}) Queue(n);
  }

  const Point3& At(int32_t node) const { return patch_.points[loops_[node].vertex]; }

  Vector3d NormalAt(int32_t node) const {
    const Vector3d& around = areas_[loops_[node].vertex];
    const Vector3d missing = TwiceVectorArea(At(loops_[node].before), At(node), At(loops_[node].after));
    const Vector3d whole = missing.dot(around) > 0 ? Vector3d(around + missing) : around;
    if (whole.norm() > 0) return whole.normalized();
    return missing.norm() > 0 ? Vector3d(missing.normalized()) : Vector3d::UnitZ();
  }

  FrontCorner CornerAt(int32_t node) const {
    const int32_t v = loops_[node].vertex;
    FrontCorner corner;
    corner.at = At(node);
    corner.before = At(loops_[node].before);
    corner.after = At(loops_[node].after);
    corner.normal = NormalAt(node);
    corner.angle_rad = FrontAngle(corner.at, corner.before, corner.after, corner.normal);
    corner.neighbours = neighbours_[v];
    corner.carried = carried_[v];
    corner.size = limits_.by_corners ? 0 : sizes_[v];
    return corner;
  }

  bool Advance(int32_t node) {
    const FrontCorner corner = CornerAt(node);
    if (corner.angle_rad <= kJoined && CutOff(node, corner)) return true;
    if (care_ == Care::kNone) return CutOff(node, corner) || AttachNearest(node, corner);
    std::vector<Point3> places;
    if (corner.angle_rad <= kOneVertex) {
      places = {rule_(corner, 1.0 / 2)};
    } else {
      places = {rule_(corner, 2.0 / 3), rule_(corner, 1.0 / 3)};
    }
    if (Divide(node, corner, places)) return true;
    return AttachNear(node, corner, places) || (corner.angle_rad < kCutOff && CutOff(node, corner));
  }

  // A triangle that joins the neighbours of a corner.
  bool CutOff(int32_t node, const FrontCorner& corner) {
    const int32_t a = loops_[node].before, b = loops_[node].after;
    if (loops_[b].after != a && !IsFree(loops_[a].vertex, loops_[b].vertex)) return false;
    const Triangle t = {loops_[a].vertex, loops_[node].vertex, loops_[b].vertex};
    if (!Fits({corner.before, corner.at, corner.after}, t, corner)) return false;
    Add(t);
    loops_.CutOff(node);
    Queue(node);
    QueueAround(a);
    QueueAround(b);
    return true;
  }

  // Triangles between the corner and new vertices.
  bool Divide(int32_t node, const FrontCorner& corner, const std::vector<Point3>& places) {
    const double near = care_ == Care::kFull ? limits_.merge * corner.Length() : 0;
    for (const Point3& p : places) {
      if (near > 0 && sight_.IsNear(p, node, near)) return false;
    }
    const int32_t a = loops_.VertexBefore(node), v = loops_[node].vertex, b = loops_.VertexAfter(node);
    for (size_t i = 0; i < places.size(); ++i) {
      const Point3& last = i == 0 ? corner.before : places[i - 1];
      if (!Fits({last, corner.at, places[i]}, {i == 0 ? a : -1, v, -1}, corner)) return false;
    }
    if (!Fits({places.back(), corner.at, corner.after}, {-1, v, b}, corner)) return false;
    std::vector<int32_t> inserted;
    for (const Point3& p : places) {
      const auto vertex = static_cast<int32_t>(patch_.points.size());
      patch_.points.push_back(p);
      areas_.emplace_back(Vector3d::Zero());
      neighbours_.emplace_back();
      sizes_.push_back((sizes_[a] + sizes_[v] + sizes_[b]) / 3);
      carried_.emplace_back((carried_[a] + carried_[v] + carried_[b]).normalized());
      Add({loops_.VertexBefore(node), v, vertex});
      inserted.push_back(loops_.Insert(node, vertex));
    }
    Add({loops_.VertexBefore(node), v, b});
    loops_.CutOff(node);
    Queue(node);
    for (const int32_t n : inserted) QueueAround(n);
    return true;
  }

  // A triangle between one of the corner's edges and the vertex of the front nearest to where a new one should go.
  bool AttachNear(int32_t node, const FrontCorner& corner, const std::vector<Point3>& places) {
    const double reach = kReach * corner.Length();
    std::map<int32_t, double> distances;
    for (const Point3& p : places) {
      for (const int32_t n : sight_.NodesNear(p, reach)) {
        const double distance = (At(n) - p).norm();
        double& least = distances.try_emplace(n, distance).first->second;
        least = std::min(least, distance);
      }
    }
    std::vector<std::pair<double, int32_t>> near;
    for (const auto& [n, distance] : distances) {
      if (distance < reach && NormalAt(n).dot(corner.normal) > 0) near.emplace_back(distance, n);
    }
    std::sort(near.begin(), near.end());
    return std::any_of(near.begin(), near.end(), [&](const auto& n) { return AttachEither(node, corner, n.second); });
  }

  bool AttachNearest(int32_t node, const FrontCorner& corner) {
    return AttachNear(node, corner, {corner.before, corner.after});
  }

  // The better shape of the two first.
  bool AttachEither(int32_t node, const FrontCorner& corner, int32_t other) {
    const Point3& q = At(other);
    const int32_t after = loops_[node].after;
    const bool before_first =
        TriangleQuality(corner.before, corner.at, q) >= TriangleQuality(corner.at, corner.after, q);
    return before_first ? Attach(node, corner, other) || Attach(after, corner, other)
                        : Attach(after, corner, other) || Attach(node, corner, other);
  }

  // A triangle of the edge before a node and another node.
  bool Attach(int32_t node, const FrontCorner& corner, int32_t other) {
    const int32_t a = loops_[node].before;
    if (other == node || other == a) return false;
    const int32_t va = loops_[a].vertex, v = loops_[node].vertex, q = loops_[other].vertex;
    if (q == va || q == v || !HasInside(other, (At(a) + At(node)) / 2)) return false;
    if (loops_[node].after != other && !IsFree(v, q)) return false;
    if (loops_[a].before != other && !IsFree(va, q)) return false;
    if (!Fits({At(a), At(node), At(other)}, {va, v, q}, corner)) return false;
    Add({va, v, q});
    const int32_t added = loops_.Join(node, other);
    for (const int32_t n : {a, node, other, added}) QueueAround(n);
    return true;
  }

  // Whether a place lies in the angle of a node that is to be filled.
  bool HasInside(int32_t node, const Point3& p) const {
    const FrontCorner corner = CornerAt(node);
    return FrontAngle(corner.at, p, corner.after, corner.normal) <= corner.angle_rad;
  }

  bool IsFree(int32_t a, int32_t b) const {
    const auto rim = static_cast<int32_t>(rim_.points.size());
    if (a == b || edges_.contains(EdgeKey(std::min(a, b), std::max(a, b)))) return false;
    return a >= rim || b >= rim || rim_.may_join(a, b);
  }

  bool Fits(const SpaceTriangle& t, const Triangle& vertices, const FrontCorner& corner) const {
    return care_ == Care::kNone ? TwiceVectorArea(t).norm() > 0 : sight_.IsClear(t, vertices, corner.normal);
  }

  void Add(const Triangle& t) {
    patch_.triangles.push_back(t);
    const Vector3d area = TwiceVectorArea(patch_.points, t);
    for (int k = 0; k < 3; ++k) {
      areas_[t[k]] += area;
      const int32_t a = t[k], b = t[(k + 1) % 3];
      if (!edges_.insert(EdgeKey(std::min(a, b), std::max(a, b))).second) continue;
      neighbours_[a].push_back(patch_.points[b]);
      neighbours_[b].push_back(patch_.points[a]);
    }
  }

  const FrontRim& rim_;
  const FrontRule& rule_;
  const FrontLimits& limits_;
  FrontPatch patch_;
  FrontLoops loops_;
  FrontSight sight_{loops_, patch_.points};
  std::vector<Vector3d> areas_;
  std::vector<std::vector<Point3>> neighbours_;
  std::vector<double> sizes_;           // of each vertex, as FrontCorner
  std::vector<Vector3d> carried_;       // likewise
  std::unordered_set<uint64_t> edges_;  // of the patch
  struct OfNode {
    double queued = -1;     // its angle in the queue, or -1
    int32_t followed = -1;  // the end of its edge that `sight_` knows of
  };
  std::set<std::pair<double, int32_t>> queue_;
  std::vector<OfNode> of_node_;
  std::set<int32_t> waiting_;
  double widest_wait_ = 0;  // of those that wait: how far off a change may be that lets them go on, metres
  Care care_ = Care::kFull;
};

}  // namespace

FrontPatch AdvanceFront(const FrontRim& rim, const FrontRule& rule, const FrontLimits& limits) {
  return Front(rim, rule, limits).Run();
}

}  // namespace tilemend
