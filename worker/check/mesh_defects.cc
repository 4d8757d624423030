#include "worker/check/mesh_defects.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "common/mesh/box_tree.h"
#include "common/mesh/disjoint_sets.h"
#include "common/mesh/position_index.h"
#include "common/mesh/triangle_shape.h"
#include "common/mesh/vertex_lists.h"
#include "worker/check/corner_cones.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

constexpr size_t kMostPlaces = 10;
constexpr double kDegree = std::numbers::pi / 180;

struct Side {
  int32_t lo, hi;  // welded vertices
  int32_t triangle;
  bool forward;  // from lo to hi
};

class DefectFinder {
 public:
  DefectFinder(const TriMesh& mesh, const CheckLimits& limits) : limits_(limits) {
    for (int kind = 0; kind < kDefectKinds; ++kind) found_[static_cast<Defect>(kind)];
    PositionIndex index;
    std::vector<int32_t> number;
    for (const Point3& p : mesh.points) number.push_back(index.Insert(p));
    points_ = index.positions();
    std::set<std::array<int32_t, 3>> seen;
    for (const Triangle& t : mesh.triangles) {
      const Triangle welded = {number[t[0]], number[t[1]], number[t[2]]};
      std::array<int32_t, 3> key = {welded[0], welded[1], welded[2]};
      std::sort(key.begin(), key.end());
      if (TwiceVectorArea(points_, welded).squaredNorm() <= 0) {
        Add(Defect::kFlatTriangle, points_[welded[0]]);
      } else if (!seen.insert(key).second) {
        Add(Defect::kDuplicateTriangle, points_[welded[0]]);
      } else {
        triangles_.push_back(welded);
      }
    }
  }

  std::map<Defect, DefectFinding> Run() {
    LookAtEdges();
    LookAtVertices();
    LookAtComponents();
    LookForCrossings();
    return std::move(found_);
  }

 private:
  void Add(Defect defect, const Point3& place) {
    DefectFinding& finding = found_[defect];
    ++finding.count;
    if (finding.places.size() < kMostPlaces) finding.places.push_back(place);
  }

  Point3 MiddleOf(int32_t t) const {
    return (points_[triangles_[t][0]] + points_[triangles_[t][1]] + points_[triangles_[t][2]]) / 3;
  }

  std::vector<Side> SortedSides() const {
    std::vector<Side> sides;
    for (size_t t = 0; t < triangles_.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const int32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        sides.push_back({std::min(a, b), std::max(a, b), static_cast<int32_t>(t), a < b});
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return std::tuple(a.lo, a.hi, a.triangle) < std::tuple(b.lo, b.hi, b.triangle);
    });
    return sides;
  }

  void LookAtEdges() {
    crowded_.assign(points_.size(), false);
    const std::vector<Side> sides = SortedSides();
    for (size_t i = 0, next = 0; i < sides.size(); i = next) {
      const Side& s = sides[i];
      while (next < sides.size() && sides[next].lo == s.lo && sides[next].hi == s.hi) ++next;
      const Point3 middle = (points_[s.lo] + points_[s.hi]) / 2;
      ++edges_;
      length_ += (points_[s.lo] - points_[s.hi]).norm();
      if (next - i > 2) {
        Add(Defect::kNonManifoldEdge, middle);
        crowded_[s.lo] = crowded_[s.hi] = true;
      }
      if (next - i != 2) continue;
      const Vector3d a = TwiceVectorArea(points_, triangles_[s.triangle]).normalized();
      const Vector3d b = TwiceVectorArea(points_, triangles_[sides[i + 1].triangle]).normalized();
      if (s.forward == sides[i + 1].forward) {
        Add(Defect::kTurnedEdge, middle);
      } else if (a.dot(b) < std::cos(limits_.crease_degrees * kDegree)) {
        Add(Defect::kCreasedEdge, middle);
      }
    }
  }

  void LookAtVertices() {
    const VertexLists corners = CornersAt(triangles_, points_.size());
    for (int32_t v = 0; v < std::ssize(points_); ++v) {
      const std::span<const int32_t> around = corners.Of(v);
      if (around.empty()) continue;
      if (!crowded_[v] && CountFans(around) > 1) Add(Defect::kNonManifoldVertex, points_[v]);
      if (IsSpike(v, around)) Add(Defect::kSpike, points_[v]);
    }
  }

  // The other two corners of a triangle at a vertex.
  std::pair<int32_t, int32_t> Others(int32_t corner) const {
    const Triangle& t = triangles_[corner >> 2];
    const int k = corner & 3;
    return {t[(k + 1) % 3], t[(k + 2) % 3]};
  }

  int CountFans(std::span<const int32_t> around) const {
    DisjointSets fans(static_cast<int32_t>(around.size()));
    std::map<int32_t, int32_t> at;  // by neighbour: the first triangle there
    for (size_t i = 0; i < around.size(); ++i) {
      const auto [a, b] = Others(around[i]);
      for (const int32_t other : {a, b}) {
        fans.Join(at.try_emplace(other, static_cast<int32_t>(i)).first->second, static_cast<int32_t>(i));
      }
    }
    const std::vector<int32_t> groups = fans.Groups();
    return *std::max_element(groups.begin(), groups.end()) + 1;
  }

  bool IsSpike(int32_t v, std::span<const int32_t> around) const {
    if (around.size() < 3) return false;
    double angle = 0, to_it = 0, about_it = 0;
    std::map<int32_t, int> ends;
    for (const int32_t corner : around) {
      const auto [a, b] = Others(corner);
      const Vector3d u = points_[a] - points_[v], w = points_[b] - points_[v];
      angle += std::atan2(u.cross(w).norm(), u.dot(w));
      to_it += u.norm() + w.norm();
      about_it += (points_[a] - points_[b]).norm();
      ++ends[a], ++ends[b];
    }
    const bool closed = std::all_of(ends.begin(), ends.end(), [](const auto& end) { return end.second == 2; });
    return closed && angle < limits_.spike_degrees * kDegree && to_it / 2 > limits_.spike_edges * about_it;
  }

  void LookAtComponents() {
    DisjointSets sets(static_cast<int32_t>(points_.size()));
    for (const Triangle& t : triangles_) {
      sets.Join(t[0], t[1]);
      sets.Join(t[0], t[2]);
    }
    std::map<int32_t, Eigen::AlignedBox3d> boxes;
    for (const Triangle& t : triangles_) {
      Eigen::AlignedBox3d& box = boxes[sets.LowestOf(t[0])];
      for (const int32_t v : t) box.extend(points_[v]);
    }
    double widest = 0;
    for (const auto& [piece, box] : boxes) widest = std::max(widest, box.diagonal().norm());
    const double small = limits_.component_edges * length_ / std::max<double>(1, static_cast<double>(edges_));
    for (const auto& [piece, box] : boxes) {
      const double width = box.diagonal().norm();
      if (width < widest && width <= small) Add(Defect::kSmallComponent, Point3(box.center()));
    }
  }

  void LookForCrossings() {
    std::vector<SpaceTriangle> in_space;
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Triangle& t : triangles_) {
      in_space.push_back({points_[t[0]], points_[t[1]], points_[t[2]]});
      Eigen::AlignedBox3d& box = boxes.emplace_back(points_[t[0]]);
      box.extend(points_[t[1]]);
      box.extend(points_[t[2]]);
    }
    const CornerCones cones(points_, triangles_);
    std::vector<bool> crosses(triangles_.size(), false);
    const BoxTree tree(boxes);
    for (int32_t a = 0; a < std::ssize(triangles_); ++a) {
      tree.AnyMeeting(boxes[a], [&](int32_t b) {
        const bool known = b <= a || (crosses[a] && crosses[b]) || cones.AreApart(a, b);
        if (!known && TrianglesCross(in_space[a], in_space[b])) crosses[a] = crosses[b] = true;
        return false;
      });
    }
    for (size_t t = 0; t < crosses.size(); ++t) {
      if (crosses[t]) Add(Defect::kSelfIntersection, MiddleOf(static_cast<int32_t>(t)));
    }
  }

  const CheckLimits& limits_;
  std::vector<Point3> points_;       // welded
  std::vector<Triangle> triangles_;  // with area, each once
  std::vector<bool> crowded_;        // vertices at non-manifold edges
  int64_t edges_ = 0;
  double length_ = 0;  // of all edges
  std::map<Defect, DefectFinding> found_;
};

}  // namespace

std::map<Defect, DefectFinding> FindDefects(const TriMesh& mesh, const CheckLimits& limits) {
  return DefectFinder(mesh, limits).Run();
}

bool HasArea(const MeshView& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const Triangle& t) { return !TwiceVectorArea(mesh.points, t).isZero(0); });
}

}  // namespace tilemend
