#include "worker/fill/space/patch_changes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "common/mesh/triangle_shape.h"
#include "common/records/moved_outline.h"

namespace tilemend {
namespace {

// An edge is divided no nearer to its ends, as a share of it.
constexpr double kMinShare = 0.1;
// Triangles around a point that is moved: a bound on the work.
constexpr size_t kMostInStar = 64;

bool Has(const Triangle& t, int32_t v) { return std::ranges::find(t, v) != t.end(); }

Triangle With(Triangle t, int32_t old_vertex, int32_t new_vertex) {
  std::ranges::replace(t, old_vertex, new_vertex);
  return t;
}

class ChangeFinder {
 public:
  ChangeFinder(int32_t next, const LocalHole& hole, const PatchEdit& edit, const FreeOutline& outline)
      : next_(next), hole_(hole), edit_(edit), outline_(outline) {}

  std::vector<ChangeNear> Run(int32_t t, const Point3& middle) {
    const Triangle corners = edit_.Corners(t);
    for (const int32_t v : corners) {
      if (v >= hole_.size() || outline_.IsFree(v)) AtPoint(v);
    }
    for (int k = 0; k < 3; ++k) AtEdge(corners[k], corners[(k + 1) % 3], middle);
    LeaveOut(t);
    const SpaceTriangle& p = edit_.Placed(t);
    const double size = std::sqrt(TwiceVectorArea(p).norm());
    PatchChange divide{{t}};
    for (const int32_t v : corners) divide.in.push_back(With(corners, v, next_));
    Add(std::move(divide), {{Point3((p[0] + p[1] + p[2]) / 3), size}, {middle, size}});
    return std::move(changes_);
  }

 private:
  void Add(PatchChange change, std::vector<ChangeNear::Place> places = {}) {
    changes_.push_back({std::move(change), std::move(places)});
  }

  bool IsFreeEdge(int32_t a, int32_t b) const {
    return outline_.IsFreeEdge(a, b) && edit_.TrianglesAtEdge(a, b).size() == 1;
  }

  // It moves, or merges with another one; on the free boundary with the next one along it.
  void AtPoint(int32_t v) {
    const std::vector<int32_t> star = edit_.TrianglesAt(v);
    if (star.size() > kMostInStar) return;
    std::set<int32_t> around;
    PatchChange move{star, {}, v};
    for (const int32_t t : star) {
      around.insert(edit_.Corners(t).begin(), edit_.Corners(t).end());
      move.in.push_back(With(edit_.Corners(t), v, next_));
    }
    around.erase(v);
    double edges = 0;
    for (const int32_t w : around) edges += (edit_.At(w) - edit_.At(v)).norm();
    std::vector<ChangeNear::Place> places = {{edit_.At(v), edges / static_cast<double>(around.size())}};
    std::set<int32_t> along;
    if (outline_.IsFree(v)) {
      std::ranges::copy_if(around, std::inserter(along, along.end()), [&](int32_t w) { return IsFreeEdge(v, w); });
    }
    if (v < hole_.size() ? along.size() != 2 : along.size() == 1) return;
    if (!along.empty()) {
      around = along;
      move.planned = outline_.PlannedPlace(v, edit_.At(v));
      places.push_back({edit_.At(v), 2 * kMaxOutlineAside});
      if (!IsNear(v, *around.begin(), *around.rbegin())) around.clear();
    }
    Add(std::move(move), std::move(places));
    if (hole_.level) return;  // water would rise to what it merges with
    for (const int32_t w : around) Merge(v, w, star);
  }

  void Merge(int32_t v, int32_t w, const std::vector<int32_t>& star) {
    PatchChange merge{star, {}, v};
    for (const int32_t t : star) {
      if (!Has(edit_.Corners(t), w)) merge.in.push_back(With(edit_.Corners(t), v, w));
    }
    Add(std::move(merge));
  }

  // It is divided or flipped; an edge of the free boundary is divided.
  void AtEdge(int32_t a, int32_t b, const Point3& middle) {
    const std::vector<int32_t> sides = edit_.TrianglesAtEdge(a, b);
    const bool is_free = sides.size() == 1 && outline_.IsFreeEdge(a, b);
    if (sides.size() != 2 && !is_free) return;
    PatchChange divide{sides};
    std::vector<int32_t> tips;
    for (const int32_t t : sides) {
      const Triangle& c = edit_.Corners(t);
      for (const int32_t end : {a, b}) divide.in.push_back(With(c, end, next_));
      tips.push_back(*std::ranges::find_if(c, [&](int32_t v) { return v != a && v != b; }));
    }
    const Eigen::Vector3d along = edit_.At(b) - edit_.At(a);
    const double share = std::clamp((middle - edit_.At(a)).dot(along) / along.squaredNorm(), kMinShare, 1 - kMinShare);
    const Point3 place = edit_.At(a) + share * along;
    std::vector<ChangeNear::Place> places = {{place, along.norm() / 2}};
    if (is_free) {
      const Point3 from = outline_.PlannedPlace(a, edit_.At(a)), to = outline_.PlannedPlace(b, edit_.At(b));
      divide.planned = from + share * (to - from);
      places.push_back({place, 2 * kMaxOutlineAside});
    }
    Add(std::move(divide), std::move(places));
    if (is_free || !edit_.MayJoin(tips[0], tips[1])) return;
    Add({sides, {With(edit_.Corners(sides[0]), a, tips[1]), With(edit_.Corners(sides[1]), b, tips[0])}});
  }

  // Whether the free boundary may pass by vertex v from a to b.
  bool IsNear(int32_t v, int32_t a, int32_t b) const {
    const Point3 p = outline_.PlannedPlace(v, edit_.At(v));
    const Eigen::Vector3d along = edit_.At(b) - edit_.At(a);
    const double share = std::clamp((p - edit_.At(a)).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return FreeOutline::MayLie(p, edit_.At(a) + share * along, false);
  }

  // With two edges on the free boundary, or one and a point inside that comes to the boundary instead.
  void LeaveOut(int32_t t) {
    const Triangle c = edit_.Corners(t);
    std::vector<int> free;
    for (int k = 0; k < 3; ++k) {
      if (IsFreeEdge(c[k], c[(k + 1) % 3])) free.push_back(k);
    }
    if (free.empty() || free.size() == 3) return;
    // Opposite the only free edge, or between the two.
    const int k = free.size() == 1 ? (free[0] + 2) % 3 : free[1] - free[0] == 1 ? free[1] : 0;
    const int32_t tip = c[k];
    const bool is_inside = tip >= hole_.size() && !outline_.IsFree(tip);
    if (free.size() == 1 ? !is_inside : !outline_.IsFree(tip)) return;
    if (!IsNear(tip, c[(k + 1) % 3], c[(k + 2) % 3])) return;
    PatchChange without{{t}};
    (free.size() == 1 ? without.freed : without.gone) = tip;
    Add(std::move(without));
  }

  const int32_t next_;
  const LocalHole& hole_;
  const PatchEdit& edit_;
  const FreeOutline& outline_;
  std::vector<ChangeNear> changes_;
};

}  // namespace

std::vector<ChangeNear> ChangesAt(int32_t t, const Point3& middle, int32_t next, const LocalHole& hole,
                                  const PatchEdit& edit, const FreeOutline& outline) {
  return ChangeFinder(next, hole, edit, outline).Run(t, middle);
}

}  // namespace tilemend
