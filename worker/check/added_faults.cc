#include "worker/check/added_faults.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "common/mesh/box_tree.h"
#include "common/mesh/position_index.h"
#include "common/mesh/triangle_shape.h"
#include "common/mesh/vertex_lists.h"
#include "worker/check/corner_cones.h"
#include "worker/fill/space/crossing_curves.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

enum class FaceOrigin : uint8_t { kKept, kMissing, kAdded };

// A triangle of the tile before or after, with area.
struct Face {
  Triangle corners;  // welded
  FaceOrigin origin;
  bool is_inner;   // AddedFindings::inner
  int32_t number;  // in the tile after; of a missing one in the tile before

  bool is_before() const { return origin != FaceOrigin::kAdded; }
  bool is_after() const { return origin != FaceOrigin::kMissing; }
};

// One face at an edge.
struct EdgeSide {
  int32_t higher;  // of the edge's two welded vertices
  int32_t face;
  bool is_forward;  // from the lower vertex to the higher one
};

bool IsLower(const Point3& a, const Point3& b) {
  return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
}

class AddedFaultFinder {
 public:
  AddedFaultFinder(const TriMesh& before, const TriMesh& after, const TileChange& change) {
    const std::vector<int32_t> of_before = Weld(before);
    originals_ = index_.size();
    const std::vector<int32_t> of_after = Weld(after);
    points_ = index_.positions();
    for (size_t t = 0; t < after.triangles.size(); ++t) AddFaceAfter(after, t, change.added[t], of_after);
    count_after_ = faces_.size();
    for (const int32_t t : change.missing) {
      if (HasArea(before, t)) faces_.push_back({Welded(before, t, of_before), FaceOrigin::kMissing, false, t});
    }
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
  std::vector<int32_t> Weld(const TriMesh& mesh) {
    std::vector<int32_t> number;
    number.reserve(mesh.points.size());
    for (const Point3& p : mesh.points) number.push_back(index_.Insert(p));
    return number;
  }

  static bool HasArea(const TriMesh& mesh, size_t t) {
    return TwiceVectorArea(mesh.points, mesh.triangles[t]).squaredNorm() > 0;
  }

  static Triangle Welded(const TriMesh& mesh, size_t t, const std::vector<int32_t>& number) {
    const Triangle& corners = mesh.triangles[t];
    return {number[corners[0]], number[corners[1]], number[corners[2]]};
  }

  void AddFaceAfter(const TriMesh& after, size_t t, bool is_added, const std::vector<int32_t>& number) {
    const Triangle welded = Welded(after, t, number);
    const bool is_inner = is_added && std::ranges::none_of(welded, [&](int32_t v) { return v < originals_; });
    found_.inner.push_back(is_inner);
    if (HasArea(after, t)) {
      faces_.push_back({welded, is_added ? FaceOrigin::kAdded : FaceOrigin::kKept, is_inner, static_cast<int32_t>(t)});
    } else if (is_added) {
      found_.faults[AddedFault::kFlatTriangle].push_back({points_[welded[0]], static_cast<int32_t>(t)});
    }
  }

  // Edge by edge, in the order of their vertices. Kept faces count before and after.
  void LookAtEdges() {
    const VertexLists corners(points_.size(), [&](const auto& use) {
      int32_t corner = 0;
      for (const Face& face : faces_) {
        for (int k = 0; k < 3; ++k) use(std::min(face.corners[k], face.corners[(k + 1) % 3]), corner + k);
        corner += 4;
      }
    });
    std::vector<EdgeSide> sides;  // of the edges to higher vertices
    for (int32_t lower = 0; lower < std::ssize(points_); ++lower) {
      sides.clear();
      for (const int32_t corner : corners.Of(lower)) {
        const Triangle& t = faces_[corner / 4].corners;
        const int32_t from = t[corner % 4], to = t[(corner % 4 + 1) % 3];
        sides.push_back({std::max(from, to), corner / 4, from < to});
      }
      std::ranges::sort(sides, {}, &EdgeSide::higher);
      for (size_t i = 0, next = 0; i < sides.size(); i = next) {
        while (next < sides.size() && sides[next].higher == sides[i].higher) ++next;
        const std::span edge = std::span(sides).subspan(i, next - i);
        LookAtEdge(lower, edge.size() > 2 ? WithoutCopies(edge) : edge);
      }
    }
  }

  // Kept triangles that are there twice count once, as they do for the survey.
  std::span<const EdgeSide> WithoutCopies(std::span<const EdgeSide> sides) {
    std::set<Triangle> seen;
    once_.clear();
    for (const EdgeSide& side : sides) {
      Triangle corners = faces_[side.face].corners;
      std::ranges::rotate(corners, std::ranges::min_element(corners));
      if (faces_[side.face].origin != FaceOrigin::kKept || seen.insert(corners).second) once_.push_back(side);
    }
    return once_;
  }

  void LookAtEdge(int32_t lower, std::span<const EdgeSide> sides) {
    const auto count = [&](auto is_counted) {
      return static_cast<int32_t>(
          std::ranges::count_if(sides, [&](const EdgeSide& s) { return is_counted(faces_[s.face], s); }));
    };
    const int32_t before = count([](const Face& f, const EdgeSide&) { return f.is_before(); });
    const int32_t after = count([](const Face& f, const EdgeSide&) { return f.is_after(); });
    if (before == 2 && after == 2 && std::ssize(sides) == 2) return;  // as it was
    const int32_t added = count([](const Face& f, const EdgeSide&) { return f.origin == FaceOrigin::kAdded; });
    const int32_t inner = count([](const Face& f, const EdgeSide&) { return f.is_inner; });
    const int32_t forward = count([](const Face& f, const EdgeSide& s) { return f.is_after() && s.is_forward; });
    const int32_t a = lower, b = sides.front().higher;
    const Point3 middle = (points_[a] + points_[b]) / 2;
    const int32_t triangle = AddedTriangleAt(sides);
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
  int32_t AddedTriangleAt(std::span<const EdgeSide> sides) const {
    int32_t lowest = -1;
    for (const EdgeSide& side : sides) {
      const Face& face = faces_[side.face];
      if (face.origin == FaceOrigin::kAdded && (lowest < 0 || face.number < lowest)) lowest = face.number;
    }
    return lowest;
  }

  SpaceTriangle InSpace(int32_t f) const {
    const Triangle& corners = faces_[f].corners;
    return {points_[corners[0]], points_[corners[1]], points_[corners[2]]};
  }

  std::span<const Face> FacesAfter() const { return std::span(faces_).first(count_after_); }

  bool IsAdded(int32_t f) const { return faces_[f].origin == FaceOrigin::kAdded; }

  void LookForCrossings() {
    const std::span faces = FacesAfter();
    if (std::ranges::none_of(faces, [](const Face& f) { return f.origin == FaceOrigin::kAdded; })) return;
    std::vector<Triangle> triangles;
    std::vector<bool> is_added;
    for (const Face& face : faces) {
      triangles.push_back(face.corners);
      is_added.push_back(face.origin == FaceOrigin::kAdded);
    }
    const std::vector<CrossingPair> pairs = CrossingPairs(triangles);
    if (!pairs.empty()) TellCrossings(pairs, ContinueCrossings(points_, triangles, is_added, pairs));
  }

  // Pairs of which one or both were added, sorted. `triangles` are those of FacesAfter.
  std::vector<CrossingPair> CrossingPairs(std::span<const Triangle> triangles) const {
    std::vector<int32_t> added;
    std::vector<Eigen::AlignedBox3d> boxes;
    Eigen::AlignedBox3d all;
    const auto count = static_cast<int32_t>(triangles.size());
    for (int32_t f = 0; f < count; ++f) {
      if (!IsAdded(f)) continue;
      added.push_back(f);
      all.extend(boxes.emplace_back(BoxOf(InSpace(f))));
    }
    const CornerCones cones(points_, triangles);
    const BoxTree tree(boxes);
    std::vector<CrossingPair> pairs;
    for (int32_t b = 0; b < count; ++b) {
      const Eigen::AlignedBox3d box = BoxOf(InSpace(b));
      if (!box.intersects(all)) continue;
      tree.AnyMeeting(box, [&](int32_t i) {
        const int32_t a = added[i];
        if (a == b || (IsAdded(b) && b < a)) return false;
        if (!cones.AreApart(a, b) && TrianglesCross(InSpace(a), InSpace(b))) {
          pairs.push_back({std::min(a, b), std::max(a, b)});
        }
        return false;
      });
    }
    std::ranges::sort(pairs);
    return pairs;
  }

  void TellCrossings(std::span<const CrossingPair> pairs, const std::vector<bool>& of_input) {
    std::map<int32_t, AddedFault> worst;              // of each added triangle that crosses
    std::map<int32_t, std::vector<int32_t>> crossed;  // the fills' triangles that it crosses
    for (size_t i = 0; i < pairs.size(); ++i) {
      const auto [a, b] = pairs[i];
      const AddedFault fault = of_input[i]                ? AddedFault::kCrossedRim
                               : IsAdded(a) && IsAdded(b) ? AddedFault::kCrossedFill
                                                          : AddedFault::kCrossedSurface;
      for (const int32_t f : {a, b}) {
        if (!IsAdded(f)) continue;
        AddedFault& known = worst.try_emplace(f, fault).first->second;
        known = std::min(known, fault);
        if (fault == AddedFault::kCrossedFill) crossed[f].push_back(faces_[f == a ? b : a].number);
      }
    }
    for (const auto& [f, fault] : worst) {
      const SpaceTriangle placed = InSpace(f);
      std::vector<int32_t>& others = crossed[f];
      std::ranges::sort(others);
      found_.faults[fault].push_back({(placed[0] + placed[1] + placed[2]) / 3, faces_[f].number, std::move(others)});
    }
  }

  PositionIndex index_;
  int32_t originals_ = 0;       // vertices of the tile before: the first of index_
  std::vector<Point3> points_;  // welded
  std::vector<Face> faces_;     // of the tile after, and then those that are missing there
  size_t count_after_ = 0;      // faces of the tile after
  std::vector<EdgeSide> once_;  // of WithoutCopies
  AddedFindings found_;
};

}  // namespace

AddedFindings FindAddedFaults(const TriMesh& before, const TriMesh& after, const TileChange& change) {
  return AddedFaultFinder(before, after, change).Run();
}

}  // namespace tilemend
