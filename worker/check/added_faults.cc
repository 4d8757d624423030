#include "worker/check/added_faults.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "common/mesh/box_tree.h"
#include "common/mesh/edge_key.h"
#include "common/mesh/position_index.h"
#include "common/mesh/triangle_shape.h"
#include "worker/check/corner_cones.h"
#include "worker/check/crossing_curves.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

// One triangle at an edge.
struct EdgeSide {
  uint64_t edge;  // EdgeKey of the lower and the higher welded vertex
  bool is_after, is_added, is_inner, is_forward;
  int32_t triangle;  // of the tile before or after

  bool operator<(const EdgeSide& other) const { return edge < other.edge; }
};

bool IsLower(const Point3& a, const Point3& b) {
  return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
}

class AddedFaultFinder {
 public:
  AddedFaultFinder(const TriMesh& before, const TriMesh& after, const std::vector<bool>& added) {
    Weld(before, {}, false);
    originals_ = index_.size();
    Weld(after, added, true);
    points_ = index_.positions();
  }

  AddedFindings Run() {
    LookAtEdges();
    LookForCrossings();
    std::sort(found_.open.begin(), found_.open.end(), [](const OpenEdge& a, const OpenEdge& b) {
      return a.from != b.from ? IsLower(a.from, b.from) : IsLower(a.to, b.to);
    });
    return std::move(found_);
  }

 private:
  void Weld(const TriMesh& mesh, const std::vector<bool>& added, bool is_after) {
    std::vector<int32_t> number;
    number.reserve(mesh.points.size());
    for (const Point3& p : mesh.points) number.push_back(index_.Insert(p));
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& corners = mesh.triangles[t];
      const bool is_added = is_after && added[t];
      const auto is_original = [&](int32_t v) { return number[v] < originals_; };
      const bool is_inner = is_added && std::none_of(corners.begin(), corners.end(), is_original);
      if (is_after) found_.inner.push_back(is_inner);
      if (TwiceVectorArea(mesh.points, corners).squaredNorm() <= 0) {
        if (is_added) {
          found_.faults[AddedFault::kFlatTriangle].push_back({mesh.points[corners[0]], static_cast<int32_t>(t)});
        }
        continue;
      }
      const Triangle welded = {number[corners[0]], number[corners[1]], number[corners[2]]};
      for (int k = 0; k < 3; ++k) {
        const int32_t a = welded[k], b = welded[(k + 1) % 3];
        sides_.push_back(
            {EdgeKey(std::min(a, b), std::max(a, b)), is_after, is_added, is_inner, a < b, static_cast<int32_t>(t)});
      }
      if (!is_after) continue;
      triangles_.push_back(welded);
      number_.push_back(static_cast<int32_t>(t));
      is_added_.push_back(is_added);
    }
  }

  void LookAtEdges() {
    std::sort(sides_.begin(), sides_.end());
    for (size_t i = 0, next = 0; i < sides_.size(); i = next) {
      while (next < sides_.size() && sides_[next].edge == sides_[i].edge) ++next;
      LookAtEdge(i, next);
    }
    sides_ = {};
  }

  void LookAtEdge(size_t first, size_t last) {
    const auto count = [&](auto is_counted) {
      return static_cast<int32_t>(std::count_if(sides_.begin() + static_cast<ptrdiff_t>(first),
                                                sides_.begin() + static_cast<ptrdiff_t>(last), is_counted));
    };
    const int32_t before = count([](const EdgeSide& s) { return !s.is_after; });
    const int32_t after = count([](const EdgeSide& s) { return s.is_after; });
    const int32_t added = count([](const EdgeSide& s) { return s.is_added; });
    const int32_t inner = count([](const EdgeSide& s) { return s.is_inner; });
    const int32_t forward = count([](const EdgeSide& s) { return s.is_after && s.is_forward; });
    const uint64_t edge = sides_[first].edge;
    const auto a = static_cast<int32_t>(edge >> 32), b = static_cast<int32_t>(edge & 0xffffffffU);
    const Point3 middle = (points_[a] + points_[b]) / 2;
    const int32_t triangle = AddedTriangleAt(first, last);
    if (after > 2 && before <= 2) found_.faults[AddedFault::kNonManifoldEdge].push_back({middle, triangle});
    if (after == 2 && added > 0 && forward != 1) found_.faults[AddedFault::kTurnedEdge].push_back({middle, triangle});
    if (before != 1 && after != 1) return;
    const bool swap = IsLower(points_[b], points_[a]);
    OpenEdge open{points_[swap ? b : a], points_[swap ? a : b], before, after, added > 0, inner > 0};
    open.forward = swap ? after - forward : forward;
    open.triangle = triangle;
    found_.open.push_back(std::move(open));
  }

  // The lowest; -1: none.
  int32_t AddedTriangleAt(size_t first, size_t last) const {
    int32_t lowest = -1;
    for (size_t i = first; i < last; ++i) {
      const EdgeSide& side = sides_[i];
      if (side.is_added && (lowest < 0 || side.triangle < lowest)) lowest = side.triangle;
    }
    return lowest;
  }

  SpaceTriangle InSpace(int32_t t) const {
    return {points_[triangles_[t][0]], points_[triangles_[t][1]], points_[triangles_[t][2]]};
  }

  void LookForCrossings() {
    const std::vector<CrossingPair> pairs = CrossingPairs();
    if (pairs.empty()) return;
    const std::vector<bool> of_input = ContinueCrossings(points_, triangles_, is_added_, pairs);
    std::map<int32_t, AddedFault> worst;              // of each added triangle that crosses
    std::map<int32_t, std::vector<int32_t>> crossed;  // the fills' triangles that it crosses
    for (size_t i = 0; i < pairs.size(); ++i) {
      const auto [a, b] = pairs[i];
      const AddedFault fault = of_input[i]                    ? AddedFault::kCrossedRim
                               : is_added_[a] && is_added_[b] ? AddedFault::kCrossedFill
                                                              : AddedFault::kCrossedSurface;
      for (const int32_t t : {a, b}) {
        if (!is_added_[t]) continue;
        AddedFault& known = worst.try_emplace(t, fault).first->second;
        known = std::min(known, fault);
        if (fault == AddedFault::kCrossedFill) crossed[t].push_back(number_[t == a ? b : a]);
      }
    }
    for (const auto& [t, fault] : worst) {
      const SpaceTriangle placed = InSpace(t);
      std::vector<int32_t>& others = crossed[t];
      std::ranges::sort(others);
      found_.faults[fault].push_back({(placed[0] + placed[1] + placed[2]) / 3, number_[t], std::move(others)});
    }
  }

  // Of which one or both were added, sorted.
  std::vector<CrossingPair> CrossingPairs() const {
    std::vector<CrossingPair> pairs;
    if (std::ranges::find(is_added_, true) == is_added_.end()) return pairs;
    std::vector<Eigen::AlignedBox3d> boxes;
    for (int32_t t = 0; t < std::ssize(triangles_); ++t) boxes.push_back(BoxOf(InSpace(t)));
    const CornerCones cones(points_, triangles_);
    const BoxTree tree(boxes);
    for (int32_t a = 0; a < std::ssize(triangles_); ++a) {
      if (!is_added_[a]) continue;
      tree.AnyMeeting(boxes[a], [&](int32_t b) {
        if (a == b || (is_added_[b] && b < a)) return false;
        if (!cones.AreApart(a, b) && TrianglesCross(InSpace(a), InSpace(b))) {
          pairs.push_back({std::min(a, b), std::max(a, b)});
        }
        return false;
      });
    }
    std::ranges::sort(pairs);
    return pairs;
  }

  PositionIndex index_;
  int32_t originals_ = 0;            // vertices of the tile before: the first of index_
  std::vector<Point3> points_;       // welded
  std::vector<Triangle> triangles_;  // of the tile after, with area
  std::vector<bool> is_added_;       // of triangles_
  std::vector<int32_t> number_;      // in the tile after, of triangles_
  std::vector<EdgeSide> sides_;
  AddedFindings found_;
};

}  // namespace

AddedFindings FindAddedFaults(const TriMesh& before, const TriMesh& after, const std::vector<bool>& added) {
  return AddedFaultFinder(before, after, added).Run();
}

}  // namespace tilemend
