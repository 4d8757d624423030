#include "worker/fill/space/mend_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "common/mesh/box_tree.h"
#include "common/mesh/disjoint_sets.h"
#include "common/mesh/edge_loops.h"
#include "common/mesh/triangle_shape.h"
#include "worker/fill/space/cone_fill.h"
#include "worker/fill/space/crossing_index.h"
#include "worker/fill/space/kept_ground.h"
#include "worker/fill/space/loop_bridges.h"
#include "worker/fill/space/move_points.h"
#include "worker/fill/space/patch_crossings.h"
#include "worker/fill/space/patch_edit.h"
#include "worker/fill/space/sound_triangulation.h"
#include "worker/fill/space/untangle_patch.h"

namespace tilemend {
namespace {

// How many rings of triangles around those that cross are taken out, and whether only steep ones: so walls and cut
// folds go before the surface beside them. More than one ring leaves out what ends at the outline of a tile: walls
// there stay near the neighbour's.
struct Reach {
  int rings = 0;
  bool steep_only = false;
};
constexpr Reach kMendReaches[] = {{0, false}, {1, true}, {1, false}, {3, true}, {2, false}};
// A longer loop is not closed: its triangulation takes the cube of its length.
constexpr size_t kLongestLoop = 150;
// Triangles: with more of them single points and edges are not changed. Tries end after some 50 of them.
constexpr size_t kMostUntangled = 500;

// A loop that passes its bridges to and fro.
struct BridgedLoop {
  VertexLoop loop;
  std::set<VertexPair> bridges;
};

using Boundary = std::vector<BridgedLoop>;  // of a piece; each is closed by itself

// How many of the triangles from `first` on, which were put in, cross something.
//   there  what is there, these among it
int64_t CountCrossed(int32_t first, const PatchEdit& edit, const CrossingIndex& there) {
  std::vector<SpaceTriangle> placed;
  for (int32_t t = first; t < edit.count(); ++t) {
    if (!edit.IsGone(t)) placed.push_back(edit.Placed(t));
  }
  std::vector<SpaceTriangle> others;
  std::ranges::copy_if(there.triangles(), std::back_inserter(others),
                       [&](const SpaceTriangle& t) { return std::ranges::find(placed, t) == placed.end(); });
  return std::ssize(CrossedTriangles(placed, others));
}

std::vector<VertexLoop> LoopsAround(const Piece& piece, const PatchEdit& edit) {
  std::set<std::pair<int32_t, int32_t>> sides;
  for (const int32_t t : piece) {
    const Triangle& c = edit.Corners(t);
    for (int k = 0; k < 3; ++k) sides.insert({c[k], c[(k + 1) % 3]});
  }
  std::vector<DirectedEdge> edges;
  for (const auto& [from, to] : sides) {
    if (!sides.contains({to, from})) edges.push_back({from, to});
  }
  std::vector<VertexLoop> loops;
  for (const EdgeWalk& walk : LinkEdges(edges)) {
    VertexLoop& loop = loops.emplace_back();
    for (const int32_t e : walk.edges) loop.push_back(edges[e].from);
  }
  return loops;
}

bool FacesDown(const VertexLoop& loop, const PatchEdit& edit) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (size_t i = 1; i + 1 < loop.size(); ++i) {
    area += TwiceVectorArea(SpaceTriangle{edit.At(loop[0]), edit.At(loop[i]), edit.At(loop[i + 1])});
  }
  return area.z() < -kFacesUp * area.norm();
}

// Each loop closed by itself, unless one faces down.
void AddApart(std::span<const VertexLoop> loops, const PatchEdit& edit, std::vector<Boundary>& boundaries) {
  if (std::ranges::any_of(loops, [&](const VertexLoop& loop) { return FacesDown(loop, edit); })) return;
  Boundary& apart = boundaries.emplace_back();
  for (const VertexLoop& loop : loops) apart.push_back({loop, {}});
}

// None if no bridge may be built.
std::optional<BridgedLoop> Tied(std::vector<VertexLoop> loops, const PatchEdit& edit) {
  std::set<VertexPair> bridges;
  const BridgeEnds ends = {
      [&](int32_t v) { return edit.At(v); },
      [&](int32_t a, int32_t b) { return edit.MayJoin(a, b) && !bridges.contains(Undirected(a, b)); }};
  while (loops.size() > 1) {
    const std::vector<Bridge> next = BridgesFrom(ends, loops);
    if (next.empty()) return std::nullopt;
    const VertexPair tied = Undirected(loops[0][next[0].from], loops[next[0].loop][next[0].to]);
    if (BuildBridge(next[0], loops)) bridges.insert(tied);
  }
  return BridgedLoop{std::move(loops[0]), std::move(bridges)};
}

// The ways to see the boundary, the best first. Several loops are closed one by one, as a hole in a facade over one
// in the ground. Or they are tied to one loop by the shortest ways, as the outer and the inner loop of a ring. Or
// they are cut where they pass a vertex more than once, and the parts closed one by one. None if it forms no loops,
// or they are too long; one without loops if there is no boundary: the piece closes nothing.
std::vector<Boundary> BoundariesOf(const Piece& piece, const PatchEdit& edit) {
  const std::vector<VertexLoop> loops = LoopsAround(piece, edit);
  std::vector<Boundary> boundaries;
  if (loops.size() > 1) AddApart(loops, edit, boundaries);
  if (loops.size() == 1) boundaries.push_back({{loops[0], {}}});
  if (loops.size() > 1) {
    if (std::optional<BridgedLoop> tied = Tied(loops, edit)) boundaries.push_back({*std::move(tied)});
  }
  if (loops.empty()) boundaries.emplace_back();
  std::vector<VertexLoop> parts;
  for (const VertexLoop& loop : loops) std::ranges::move(CutWhereItTouches<int32_t>(loop), std::back_inserter(parts));
  const bool closable = std::ranges::all_of(parts, [](const VertexLoop& part) { return part.size() > 2; });
  if (closable && parts.size() > loops.size()) AddApart(parts, edit, boundaries);
  std::erase_if(boundaries, [](const Boundary& boundary) {
    return std::ranges::any_of(boundary, [](const BridgedLoop& b) { return b.loop.size() > kLongestLoop; });
  });
  return boundaries;
}

// Of a piece, and the triangles from `first` on.
Eigen::AlignedBox3d BoxAround(const Piece& piece, int32_t first, const PatchEdit& edit) {
  Eigen::AlignedBox3d box;
  for (const int32_t t : piece) box.extend(BoxOf(edit.Placed(t)));
  for (int32_t t = first; t < edit.count(); ++t) box.extend(BoxOf(edit.Placed(t)));
  return box;
}

bool CrossThemselves(std::span<const Triangle> triangles, std::span<const Point3> places) {
  std::vector<SpaceTriangle> placed;
  for (const Triangle& t : triangles) placed.push_back({places[t[0]], places[t[1]], places[t[2]]});
  return !SelfCrossings(placed).empty();
}

class CrossingMender {
 public:
  CrossingMender(const LocalHole& hole, LocalPatch patch, CrossingCheck& check,
                 const std::function<bool()>& is_cancelled)
      : hole_(hole),
        check_(check),
        is_cancelled_(is_cancelled),
        patch_(std::move(patch)),
        surface_(check.Surface().begin(), check.Surface().end()) {
    first_through_rim_ = static_cast<int32_t>(surface_.size());
    surface_.insert(surface_.end(), check.ThroughRim().begin(), check.ThroughRim().end());
    surface_tree_ = TreeOver(surface_);
    FindOutline();
  }

  LocalPatch Run(std::vector<int32_t> crossed) {
    Try([&] { MovePoints(hole_, surface_, crossed, patch_); }, crossed);
    for (const Misfits misfits : {Misfits::kNone, Misfits::kFew}) {
      for (const Reach& reach : kMendReaches) {
        for (const bool through_rim : {false, true}) {
          if (through_rim && (misfits == Misfits::kFew || check_.ThroughRim().empty())) continue;
          misfits_ = misfits;
          may_cross_through_rim_ = through_rim;
          Try([&] { ReplaceAround(crossed, reach); }, crossed);
        }
      }
    }
    if (crossed.size() <= kMostUntangled) {
      Try([&] { UntanglePatch(hole_, check_.InputSurface(), check_.EarlierSurface(), is_cancelled_, patch_); },
          crossed);
    }
    DropUnusedPoints(hole_, patch_);
    patch_.crossings = static_cast<int32_t>(crossed.size());
    return std::move(patch_);
  }

 private:
  // Changes the patch, if no more of it crosses then.
  void Try(const std::function<void()>& change, std::vector<int32_t>& crossed) {
    if (crossed.empty() || IsCancelled()) return;
    LocalPatch before = patch_;
    change();
    std::vector<int32_t> now = check_.CrossedAvoidably(patch_);
    if (FaultOf(hole_, patch_) == FillFailure::kNone && now.size() <= crossed.size()) {
      crossed = std::move(now);
    } else {
      patch_ = std::move(before);
    }
  }

  void FindOutline() {
    at_outline_.assign(static_cast<size_t>(hole_.size()), false);
    for (const RegionSegment& s : hole_.inner_edges) at_outline_[s.from] = at_outline_[s.to] = true;
    for (const RegionSegment& s : hole_.segments) {
      if (hole_.TrianglesBeside(s.from, s.to) == 0) at_outline_[s.from] = at_outline_[s.to] = true;
    }
  }

  bool IsCancelled() const { return is_cancelled_ && is_cancelled_(); }

  void ReplaceAround(const std::vector<int32_t>& crossed, const Reach& reach) {
    PatchEdit edit(hole_, patch_);
    if (misfits_ == Misfits::kFew) FindCrossed(edit);
    const std::vector<Piece> pieces = edit.PiecesOf(Around(edit, crossed, reach));
    for (const std::vector<Piece>& group : GroupsOf(pieces, edit)) {
      if (IsCancelled()) break;
      if (Replace(group, edit) || group.size() == 1) continue;
      for (const Piece& piece : group) Replace({&piece, 1}, edit);
    }
    edit.Finish();
  }

  // As CountCrossed counts those that are put in: what cannot be avoided is in both.
  void FindCrossed(const PatchEdit& edit) {
    std::vector<SpaceTriangle> placed;
    for (int32_t t = 0; t < edit.count(); ++t) placed.push_back(edit.Placed(t));
    is_crossed_.assign(placed.size(), false);
    for (const int32_t t : CrossedTriangles(placed, surface_)) is_crossed_[t] = true;
  }

  // Pieces that cross each other, directly or by others: while one of them is there, it is in the way of the other.
  static std::vector<std::vector<Piece>> GroupsOf(std::span<const Piece> pieces, const PatchEdit& edit) {
    std::vector<SpaceTriangle> placed;
    std::vector<int32_t> piece_of;
    for (size_t k = 0; k < pieces.size(); ++k) {
      for (const int32_t t : pieces[k]) {
        placed.push_back(edit.Placed(t));
        piece_of.push_back(static_cast<int32_t>(k));
      }
    }
    DisjointSets sets(static_cast<int32_t>(pieces.size()));
    for (const auto& [a, b] : SelfCrossings(placed)) sets.Join(piece_of[a], piece_of[b]);
    std::map<int32_t, std::vector<Piece>> by_lowest;
    for (int32_t k = 0; k < std::ssize(pieces); ++k) by_lowest[sets.LowestOf(k)].push_back(pieces[k]);
    std::vector<std::vector<Piece>> groups;
    for (auto& [lowest, group] : by_lowest) groups.push_back(std::move(group));
    return groups;
  }

  std::vector<bool> Around(const PatchEdit& edit, const std::vector<int32_t>& crossed, const Reach& reach) const {
    std::vector<bool> taken(static_cast<size_t>(edit.count()), false);
    std::vector<bool> is_near(static_cast<size_t>(hole_.size()) + patch_.new_points.size(), false);
    for (const int32_t t : crossed) taken[t] = true;
    const auto is_at_outline = [&](int32_t v) { return v < hole_.size() && at_outline_[v]; };
    for (int ring = 0; ring < reach.rings; ++ring) {
      for (int32_t t = 0; t < edit.count(); ++t) {
        for (const int32_t v : edit.Corners(t)) is_near[v] = is_near[v] || taken[t];
      }
      for (int32_t t = 0; t < edit.count(); ++t) {
        if (taken[t] || edit.IsGone(t) || (reach.steep_only && edit.FacesUp(t))) continue;
        if (reach.rings > 1 && std::ranges::any_of(edit.Corners(t), is_at_outline)) continue;
        taken[t] = std::ranges::any_of(edit.Corners(t), [&](int32_t v) { return is_near[v]; });
      }
    }
    return taken;
  }

  // Takes out pieces, and closes all of them with triangles that cross nothing. Returns false, with the pieces as they
  // were, if one of them is not closed.
  bool Replace(std::span<const Piece> pieces, PatchEdit& edit) const {
    std::vector<std::vector<Boundary>> boundaries;
    for (const Piece& piece : pieces) boundaries.push_back(BoundariesOf(piece, edit));
    for (const Piece& piece : pieces) std::ranges::for_each(piece, [&](int32_t t) { edit.TakeOut(t); });
    const int32_t before = edit.count();
    for (size_t k = 0; k < pieces.size(); ++k) {
      const auto closes = [&](const Boundary& boundary) { return CloseSoundly(pieces[k], boundary, edit); };
      if (std::ranges::any_of(boundaries[k], closes)) continue;
      edit.TakeOutFrom(before);
      for (const Piece& piece : pieces) std::ranges::for_each(piece, [&](int32_t t) { edit.PutBack(t); });
      return false;
    }
    return true;
  }

  bool CloseSoundly(const Piece& piece, const Boundary& boundary, PatchEdit& edit) const {
    const int32_t first = edit.count();
    const bool closes = std::ranges::all_of(boundary, [&](const BridgedLoop& loop) {
      const std::vector<Triangle> triangles = Close(loop, edit);
      for (const Triangle& t : triangles) edit.PutIn(t);
      return !triangles.empty();
    });
    if (closes && (misfits_ == Misfits::kNone || CrossesLess(piece, first, edit)) && IsManifold(first, edit) &&
        KeepsGround(piece, boundary, first, edit))
      return true;
    edit.TakeOutFrom(first);
    return false;
  }

  // Triangles that close the loop and cross nothing; empty if none are found.
  std::vector<Triangle> Close(const BridgedLoop& bridged, PatchEdit& edit) const {
    const VertexLoop& loop = bridged.loop;
    const std::set<VertexPair>& bridges = bridged.bridges;
    std::vector<Point3> places;
    std::vector<Eigen::Vector3d> outside;
    Eigen::AlignedBox3d box;
    for (size_t i = 0; i < loop.size(); ++i) {
      places.push_back(edit.At(loop[i]));
      box.extend(places.back());
      outside.push_back(edit.NormalBeside(loop[i], loop[(i + 1) % loop.size()]));
    }
    const std::function<bool(int32_t, int32_t)> allowed = [&](int32_t i, int32_t k) {
      return edit.MayJoin(loop[i], loop[k]) && !bridges.contains(Undirected(loop[i], loop[k]));
    };
    std::vector<Triangle> triangles = TriangulateSoundly(places, outside, allowed, Within(box, edit), misfits_);
    VertexLoop vertices = loop;
    if (misfits_ == Misfits::kNone && (triangles.empty() || CrossThemselves(triangles, places))) {
      if (hole_.level) return {};                                    // a new point would not be at it
      const Point3 reach = Point3::Constant(box.diagonal().norm());  // no tip lies farther from the middle
      const CrossingIndex taken = Within({box.min() - reach, box.max() + reach}, edit);
      const std::optional<ConeFill> cone =
          CloseByCone(places, outside, allowed, taken, [&](const Point3& p) { return FreePlaceAt(p, taken); });
      if (!cone) return {};
      triangles = cone->triangles;
      vertices.push_back(edit.AddPoint(cone->tip));
    }
    for (Triangle& t : triangles) t = {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
    return triangles;
  }

  // What new triangles may not cross.
  CrossingIndex Within(const Eigen::AlignedBox3d& box, const PatchEdit& edit) const {
    std::vector<SpaceTriangle> there;
    surface_tree_.AnyMeeting(box, [&](int32_t t) {
      if (!may_cross_through_rim_ || t < first_through_rim_) there.push_back(surface_[t]);
      return false;
    });
    edit.ForEachIn(box, [&](const SpaceTriangle& t) { there.push_back(t); });
    return CrossingIndex(there);
  }

  // Where a file can hold a point near p; none (not finite) where there is a corner: both would be written as one
  // vertex.
  Point3 FreePlaceAt(const Point3& p, const CrossingIndex& taken) const {
    const Point3 place = hole_.Storable(p);
    const auto is_corner_of = [&](const SpaceTriangle& t) { return std::ranges::find(t, place) != t.end(); };
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    return std::ranges::any_of(taken.triangles(), is_corner_of) ? Point3::Constant(kNowhere) : place;
  }

  bool CrossesLess(const Piece& piece, int32_t first, const PatchEdit& edit) const {
    Eigen::AlignedBox3d box;
    for (int32_t t = first; t < edit.count(); ++t) box.extend(BoxOf(edit.Placed(t)));
    const auto before = std::ranges::count_if(piece, [&](int32_t t) { return is_crossed_[t]; });
    return CountCrossed(first, edit, Within(box, edit)) < before;
  }

  bool IsManifold(int32_t first, const PatchEdit& edit) const {
    for (int32_t t = first; t < edit.count(); ++t) {
      if (edit.HasOverfullEdge(t) || IsOfSurface(hole_, edit.Corners(t))) return false;
    }
    return true;
  }

  // The ground inside a piece. Where what comes instead, from triangle `first` on, is too far from it, some of its
  // vertices are put back.
  bool KeepsGround(const Piece& piece, const Boundary& boundary, int32_t first, PatchEdit& edit) const {
    std::set<int32_t> at_boundary;
    for (const BridgedLoop& b : boundary) at_boundary.insert(b.loop.begin(), b.loop.end());
    const KeptGround ground(piece, at_boundary, edit);
    if (ground.IsKept(first, edit)) return true;
    const Eigen::AlignedBox3d box = BoxAround(piece, first, edit);
    ground.PutBack(
        first, [&] { return Within(box, edit); }, edit);
    return ground.IsKept(first, edit);
  }

  const LocalHole& hole_;
  CrossingCheck& check_;
  const std::function<bool()>& is_cancelled_;
  LocalPatch patch_;
  std::vector<SpaceTriangle> surface_;  // what passes through the hole's boundary comes last
  int32_t first_through_rim_ = 0;
  BoxTree surface_tree_;
  // Of a round: whether a piece is closed with triangles that cross something where no others are found, and whether
  // new triangles may cross what passes through the boundary; with misfits also which triangles cross before.
  Misfits misfits_ = Misfits::kNone;
  bool may_cross_through_rim_ = false;
  std::vector<bool> is_crossed_;
  std::vector<bool> at_outline_;  // of each vertex of the hole: it is on the tile's outline, or a neighbour's
};

}  // namespace

LocalPatch MendCrossings(const LocalHole& hole, LocalPatch patch, CrossingCheck& check,
                         const std::function<bool()>& is_cancelled) {
  std::vector<int32_t> crossed = check.CrossedAvoidably(patch);
  if (crossed.empty()) return patch;
  return CrossingMender(hole, std::move(patch), check, is_cancelled).Run(std::move(crossed));
}

}  // namespace tilemend
