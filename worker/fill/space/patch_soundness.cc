#include "worker/fill/space/patch_soundness.h"

#include <algorithm>
#include <set>
#include <utility>

#include "common/mesh/box_tree.h"
#include "common/mesh/triangle_shape.h"
#include "common/mesh/vertex_lists.h"
#include "worker/fill/space/crossing_curves.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

using Eigen::AlignedBox3d;

bool HasFlatTriangle(const LocalHole& hole, const LocalPatch& patch) {
  return std::any_of(patch.triangles.begin(), patch.triangles.end(),
                     [&](const Triangle& t) { return TwiceVectorArea(InSpace(hole, patch, t)).squaredNorm() <= 0; });
}

// The new points of a patch that something else has as well: another of them, the rim, the surface. In what is written
// they would be one vertex.
class TakenPoints {
 public:
  TakenPoints(const LocalPatch& patch, std::span<const Point3> rim, std::span<const SpaceTriangle> surface)
      : points_(patch.new_points) {
    std::ranges::sort(points_, IsBefore);
    is_taken_.assign(points_.size(), false);
    for (size_t k = 1; k < points_.size(); ++k) {
      if (points_[k - 1] == points_[k]) is_taken_[k - 1] = is_taken_[k] = true;
    }
    AlignedBox3d box;
    for (const Point3& p : points_) box.extend(p);
    const auto take = [&](const Point3& p) {
      if (!box.contains(p)) return;
      const auto [first, last] = std::equal_range(points_.begin(), points_.end(), p, IsBefore);
      std::fill(is_taken_.begin() + (first - points_.begin()), is_taken_.begin() + (last - points_.begin()), true);
    };
    std::ranges::for_each(rim, take);
    for (const SpaceTriangle& t : surface) std::ranges::for_each(t, take);
  }

  bool any() const { return std::ranges::find(is_taken_, true) != is_taken_.end(); }
  bool Has(const Point3& p) const {
    const auto it = std::ranges::lower_bound(points_, p, IsBefore);
    return it != points_.end() && *it == p && is_taken_[static_cast<size_t>(it - points_.begin())];
  }

 private:
  static bool IsBefore(const Point3& a, const Point3& b) { return std::ranges::lexicographical_compare(a, b); }

  std::vector<Point3> points_;  // sorted
  std::vector<bool> is_taken_;
};

}  // namespace

bool IsOfSurface(const LocalHole& hole, const Triangle& t) {
  if (std::any_of(t.begin(), t.end(), [&](int32_t v) { return v >= hole.size() || hole.vertices[v] < 0; })) {
    return false;
  }
  return hole.band->HasTriangle({hole.vertices[t[0]], hole.vertices[t[1]], hole.vertices[t[2]]});
}

FillFailure FaultOf(const LocalHole& hole, const LocalPatch& patch) {
  if (HasFlatTriangle(hole, patch)) return FillFailure::kFlatTriangle;
  if (std::any_of(patch.triangles.begin(), patch.triangles.end(),
                  [&](const Triangle& t) { return IsOfSurface(hole, t); })) {
    return FillFailure::kRepeatsTriangle;
  }
  const VertexLists ends = EdgeEndsFrom(patch.triangles, static_cast<size_t>(hole.size()) + patch.new_points.size());
  const auto count = [&](int32_t from, int32_t to) { return std::ranges::count(ends.Of(from), to); };
  for (const Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t[k], b = t[(k + 1) % 3];
      const int others = a < hole.size() && b < hole.size() ? hole.TrianglesBeside(a, b) : 0;
      const auto times = count(a, b);
      if (times > 1 || times + count(b, a) + others > 2) return FillFailure::kOverfullEdge;
    }
  }
  std::set<std::pair<int32_t, int32_t>> segments;  // two to and fro are closed by themselves
  for (const RegionSegment& s : hole.segments) segments.insert({s.from, s.to});
  const bool closes = std::all_of(hole.segments.begin(), hole.segments.end(), [&](const RegionSegment& s) {
    return count(s.from, s.to) > 0 || segments.contains({s.to, s.from}) ||
           std::ranges::binary_search(patch.left_edges, Undirected(s.from, s.to));
  });
  return closes ? FillFailure::kNone : FillFailure::kNotClosed;
}

bool FacesDown(const LocalHole& hole, const LocalPatch& patch, const ProjectionFrame& frame) {
  return std::any_of(patch.triangles.begin(), patch.triangles.end(), [&](const Triangle& t) {
    return frame.HeightAlong(TwiceVectorArea(InSpace(hole, patch, t))) <= 0;
  });
}

const std::vector<SpaceTriangle>& CrossingCheck::Surroundings(const AlignedBox3d& box) {
  if (looked_at_.contains(box)) return surroundings_;
  looked_at_.extend(box);
  surroundings_.clear();
  if (near_) {
    surroundings_ = near_(looked_at_.min(), looked_at_.max());
  } else {
    const TriMesh& band = hole_.cell->band;
    const std::vector<Point3>& points = band.points;
    for (const Triangle& t : band.triangles) surroundings_.push_back({points[t[0]], points[t[1]], points[t[2]]});
  }
  of_input_ = surroundings_.size();
  if (earlier_ != nullptr) earlier_->AppendNear(looked_at_, surroundings_);
  if (knows_crossed_) LeaveOutCrossed();
  return surroundings_;
}

bool CrossingCheck::StaysNear(const LocalPatch& patch) const {
  return std::all_of(patch.new_points.begin(), patch.new_points.end(),
                     [&](const Point3& p) { return reach_.contains(p); });
}

std::pair<std::vector<SpaceTriangle>, AlignedBox3d> CrossingCheck::Place(const LocalPatch& patch) const {
  std::vector<SpaceTriangle> triangles;
  AlignedBox3d box = reach_;
  for (const Triangle& t : patch.triangles) {
    triangles.push_back(InSpace(hole_, patch, t));
    for (const Point3& p : triangles.back()) box.extend(p);
  }
  return {std::move(triangles), box};
}

bool CrossingCheck::Crosses(const LocalPatch& patch) {
  const auto [triangles, box] = Place(patch);
  const auto crosses = [&, &triangles = triangles] {
    return PatchCrosses(triangles, surroundings_) || TakenPoints(patch, hole_.positions, surroundings_).any();
  };
  Surroundings(box);
  if (!crosses()) return false;
  if (knows_crossed_) return true;
  LeaveOutCrossed();
  return crosses();
}

std::vector<int32_t> CrossingCheck::Crossed(const LocalPatch& patch) {
  const auto [triangles, box] = Place(patch);
  Surroundings(box);
  if (!knows_crossed_) LeaveOutCrossed();
  std::vector<int32_t> crossed = CrossedTriangles(triangles, surroundings_);
  AddTaken(patch, crossed);
  return crossed;
}

std::vector<int32_t> CrossingCheck::CrossedAvoidably(const LocalPatch& patch) {
  const auto [triangles, box] = Place(patch);
  Surroundings(box);
  if (!knows_crossed_) LeaveOutCrossed();
  std::vector<int32_t> crossed = AvoidableCrossings(triangles, InputSurface(), EarlierSurface());
  AddTaken(patch, crossed);
  return crossed;
}

std::vector<SpaceTriangle> CrossingCheck::InputSurface() const {
  std::vector<SpaceTriangle> surface(surroundings_.begin(), surroundings_.begin() + static_cast<ptrdiff_t>(of_input_));
  surface.insert(surface.end(), through_rim_.begin(),
                 through_rim_.begin() + static_cast<ptrdiff_t>(of_input_through_rim_));
  return surface;
}

std::vector<SpaceTriangle> CrossingCheck::EarlierSurface() const {
  std::vector<SpaceTriangle> earlier(surroundings_.begin() + static_cast<ptrdiff_t>(of_input_), surroundings_.end());
  earlier.insert(earlier.end(), through_rim_.begin() + static_cast<ptrdiff_t>(of_input_through_rim_),
                 through_rim_.end());
  return earlier;
}

// Triangles at new points that something else has as well.
void CrossingCheck::AddTaken(const LocalPatch& patch, std::vector<int32_t>& crossed) const {
  const TakenPoints taken(patch, hole_.positions, surroundings_);
  if (!taken.any()) return;
  for (size_t t = 0; t < patch.triangles.size(); ++t) {
    const auto is_new_and_taken = [&](int32_t v) {
      return v >= hole_.size() && taken.Has(patch.new_points[v - hole_.size()]);
    };
    if (std::ranges::any_of(patch.triangles[t], is_new_and_taken)) crossed.push_back(static_cast<int32_t>(t));
  }
  std::ranges::sort(crossed);
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
}

std::span<const SpaceTriangle> CrossingCheck::Surface() {
  Surroundings(reach_);
  if (!knows_crossed_) LeaveOutCrossed();
  return surroundings_;
}

// They are looked for when a patch is first found to cross any surface.
void CrossingCheck::LeaveOutCrossed() {
  knows_crossed_ = true;
  std::vector<AlignedBox3d> boxes;
  for (const RegionSegment& s : hole_.segments) {
    boxes.emplace_back(hole_.positions[s.from]).extend(hole_.positions[s.to]);
  }
  const BoxTree tree(boxes);
  const auto passes_through_rim = [&](const SpaceTriangle& t) {
    const auto has = [&](const Point3& p) { return t[0] == p || t[1] == p || t[2] == p; };
    return tree.AnyMeeting(BoxOf(t), [&](int32_t k) {
      const Point3 &from = hole_.positions[hole_.segments[k].from], &to = hole_.positions[hole_.segments[k].to];
      return !has(from) && !has(to) && SegmentCrosses(from, to, t);
    });
  };
  const auto stays = [&](const SpaceTriangle& t) { return !passes_through_rim(t); };
  const auto earlier = surroundings_.begin() + static_cast<ptrdiff_t>(of_input_);
  const auto input_end = std::stable_partition(surroundings_.begin(), earlier, stays);
  const auto earlier_end = std::stable_partition(earlier, surroundings_.end(), stays);
  through_rim_.assign(input_end, earlier);
  of_input_through_rim_ = through_rim_.size();
  through_rim_.insert(through_rim_.end(), earlier_end, surroundings_.end());
  of_input_ = static_cast<size_t>(input_end - surroundings_.begin());
  surroundings_.erase(earlier_end, surroundings_.end());
  surroundings_.erase(input_end, earlier);
}

}  // namespace tilemend
