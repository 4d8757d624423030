#include "worker/fill/plane/folded_fill.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/rounding.h"
#include "common/mesh/triangle_shape.h"
#include "common/mesh/winding/wound_region.h"
#include "worker/fill/plane/plane_fill.h"
#include "worker/fill/region/planar_region.h"
#include "worker/fill/space/space_fill.h"

namespace tilemend {
namespace {

// Moving a crossing to where a file can hold it may make new ones.
constexpr int kMostRounds = 5;
// Vertices of a loop that is closed at once; a longer one is parted by a chord first.
constexpr size_t kLongestLoop = 60;
// Of its size: a crossing lies so far below the lower edge, or the triangle between the two would be flat.
constexpr double kDrop = 0.125;
// Cosine: what faces down more than this is no wall.
constexpr double kFacesDown = 0.5;
// A chord leaves each side at least this share of the loop.
constexpr size_t kLeastShare = 4;

// Leaves out inner edges that the region's boundary crosses or touches: it was simple without them.
void DropCutInnerEdges(const ProjectionFrame& frame, LocalHole& part) {
  std::vector<Point2> flat;
  for (const Point3& p : part.positions) flat.emplace_back(frame.ToFrame(p).head<2>());
  const std::vector<LatticePoint> points = RoundToWindow(flat, part.sizes).points;
  while (!part.inner_edges.empty()) {
    std::vector<RegionSegment> fixed = part.segments;
    fixed.insert(fixed.end(), part.inner_edges.begin(), part.inner_edges.end());
    std::set<VertexPair> edges;
    std::set<int32_t> ends;
    for (const RegionConflict& c : TriangulateRegion(points, fixed).conflicts) {
      const bool of_points = c.kind == RegionConflict::Kind::kCoincidentPoints;
      if (of_points) ends.insert(c.first);
      if (of_points || c.kind == RegionConflict::Kind::kPointOnSegment) ends.insert(c.second);
      if (!of_points) edges.insert(Undirected(fixed[c.first].from, fixed[c.first].to));
      if (c.kind == RegionConflict::Kind::kCrossing) edges.insert(Undirected(fixed[c.second].from, fixed[c.second].to));
    }
    const auto is_cut = [&](const RegionSegment& s) {
      return edges.contains(Undirected(s.from, s.to)) || ends.contains(s.from) || ends.contains(s.to);
    };
    if (std::erase_if(part.inner_edges, is_cut) == 0) return;
  }
}

// Closes what lies between the boundaries of a hole and of the region that it winds around.
class FoldCloser {
 public:
  //   whole  the hole, then the corners of the region
  FoldCloser(const LocalHole& hole, const LocalHole& whole, CrossingCheck& check, LocalPatch& patch)
      : hole_(hole), whole_(whole), taken_(check.Surface()), patch_(patch) {
    Use(patch.triangles);
    for (const Triangle& t : patch.triangles) taken_.Add(InSpace(hole, patch, t));
  }

  void Close(std::vector<std::vector<int32_t>> loops) {
    loops_ = std::move(loops);
    while (!loops_.empty()) {
      const std::vector<int32_t> loop = std::move(loops_.back());
      loops_.pop_back();
      if (loop.size() > kLongestLoop && Part(loop)) continue;
      std::vector<Triangle> triangles = TriangulateInSpace(whole_, loop, used_, taken_);
      if (triangles.empty()) triangles = TriangulateInSpace(whole_, loop, used_, CrossingIndex({}));
      Use(triangles);
      for (const Triangle& t : triangles) {
        taken_.Add({whole_.positions[t[0]], whole_.positions[t[1]], whole_.positions[t[2]]});
      }
      if (triangles.empty() || (loop.size() == 3 && IsOnSurface(loop))) {
        AddFan(loop);
      } else {
        patch_.triangles.insert(patch_.triangles.end(), triangles.begin(), triangles.end());
      }
    }
  }

 private:
  // Edges of the patch, which no triangle may have again.
  void Use(const std::vector<Triangle>& triangles) {
    for (const Triangle& t : triangles) {
      for (int k = 0; k < 3; ++k) {
        const VertexPair edge = Undirected(t[k], t[(k + 1) % 3]);
        if (edge.second < whole_.size()) used_.insert(edge);
      }
    }
  }

  // Parts a loop by its shortest chord that may be made.
  bool Part(const std::vector<int32_t>& loop) {
    const size_t n = loop.size(), least = n / kLeastShare;
    double shortest = std::numeric_limits<double>::infinity();
    std::pair<size_t, size_t> best{0, 0};
    for (size_t i = 0; i < n; ++i) {
      for (size_t k = i + least; k < n && k - i <= n - least; ++k) {
        const double length = (whole_.positions[loop[i]] - whole_.positions[loop[k]]).squaredNorm();
        if (length >= shortest || !whole_.MayJoin(loop[i], loop[k])) continue;
        if (used_.contains(Undirected(loop[i], loop[k]))) continue;
        shortest = length;
        best = {i, k};
      }
    }
    const auto [i, k] = best;
    if (k == 0) return false;
    const auto at = [&](size_t j) { return loop.begin() + static_cast<ptrdiff_t>(j); };
    used_.insert(Undirected(loop[i], loop[k]));
    loops_.emplace_back(at(i), at(k + 1));
    std::vector<int32_t>& rest = loops_.emplace_back(at(k), loop.end());
    rest.insert(rest.end(), at(0), at(i + 1));
    return true;
  }

  bool HasArea(const std::vector<int32_t>& loop) const {
    for (size_t k = 1; k + 1 < loop.size(); ++k) {
      const SpaceTriangle t = {whole_.positions[loop[0]], whole_.positions[loop[k]], whole_.positions[loop[k + 1]]};
      if (TwiceVectorArea(t).squaredNorm() > 0) return true;
    }
    return false;
  }

  bool IsOnSurface(const std::vector<int32_t>& loop) const {
    const bool of_rim = std::all_of(loop.begin(), loop.end(), [&](int32_t v) { return v < hole_.size(); });
    return of_rim &&
           hole_.band->HasTriangle({hole_.vertices[loop[0]], hole_.vertices[loop[1]], hole_.vertices[loop[2]]});
  }

  // Closes a loop about a new vertex in its middle: possible where every chord is an edge already. A loop without area,
  // as where a vertex of one side lies on an edge of the other, no triangle closes.
  void AddFan(const std::vector<int32_t>& loop) {
    if (!HasArea(loop)) {
      patch_.failure = FillFailure::kFlatTriangle;
      return;
    }
    Point3 middle = Point3::Zero();
    for (const int32_t v : loop) middle += whole_.positions[v];
    const auto centre = hole_.size() + static_cast<int32_t>(patch_.new_points.size());
    patch_.new_points.push_back(
        RoundedToLattice(Point3(middle / static_cast<double>(loop.size())), hole_.cell->lattice_step));
    for (size_t k = 0; k < loop.size(); ++k) {
      patch_.triangles.push_back({loop[k], loop[(k + 1) % loop.size()], centre});
    }
  }

  const LocalHole& hole_;
  const LocalHole& whole_;
  CrossingIndex taken_;
  LocalPatch& patch_;
  std::vector<std::vector<int32_t>> loops_;  // still to be closed
  std::set<VertexPair> used_;                // edges between vertices of whole_ that the patch has
};

class FoldedFiller {
 public:
  FoldedFiller(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options, CrossingCheck& check)
      : hole_(hole), frame_(frame), options_(options), check_(check), whole_(hole) {}

  LocalPatch Run() {
    if (!FindRegion() || IsInsideOut()) {
      return {hole_.open ? FillFailure::kCrossesSeenFromAbove : FillFailure::kCrossesOnItsPlane};
    }
    loops_ = LoopsBetween(hole_.segments, segments_);
    LocalPatch patch;
    patch.new_points.assign(whole_.positions.begin() + hole_.size(), whole_.positions.end());
    if (!segments_.empty()) {
      const HolePart part = RegionPart();
      LocalPatch of_region = FillOverPlane(part.hole, frame_, options_, {RimUse::kWhole, true});
      if (!of_region.ok()) return of_region;
      patch.hold_out = of_region.hold_out;
      AddPart(part, of_region, hole_, patch);
      LowerCorners(part, of_region, patch);
    }
    FoldCloser(hole_, whole_, check_, patch).Close(loops_);
    DropUnusedPoints(hole_, patch);
    return patch;
  }

 private:
  // Finds the boundary of what is wound around, simple with its corners where a file can hold them.
  bool FindRegion() {
    segments_ = hole_.segments;
    for (int round = 0; round < kMostRounds; ++round) {
      if (segments_.empty()) break;
      const std::vector<LatticePoint> points = LatticePoints();
      const RegionTriangulation triangulation = TriangulateRegion(points, segments_);
      if (round > 0 && triangulation.conflicts.empty()) {
        DropFreeParts(triangulation);
        return true;
      }
      if (round + 1 == kMostRounds) return false;
      TakeRegion(FindWoundRegion(points, segments_));
      PartTakenChords();
    }
    return true;
  }

  // Parts of the region that reach no vertex of the hole, not even from corner to corner: folds cross around them, and
  // nothing of the hole is to be closed there.
  //   triangulation  of the region
  void DropFreeParts(const RegionTriangulation& triangulation) {
    DisjointSets sets(whole_.size() + triangulation.component_count);  // vertices, then connected parts
    std::vector<int32_t> part_of;
    for (size_t k = 0; k < segments_.size(); ++k) {
      part_of.push_back(whole_.size() + triangulation.component[triangulation.segment_triangle[k]]);
      sets.Join(segments_[k].from, part_of[k]);
      sets.Join(segments_[k].to, part_of[k]);
    }
    std::vector<RegionSegment> reached;
    for (size_t k = 0; k < segments_.size(); ++k) {
      // The vertices of the hole have the lowest numbers.
      if (sets.LowestOf(part_of[k]) < hole_.size()) reached.push_back(segments_[k]);
    }
    segments_ = std::move(reached);
  }

  // A corner that a file can only hold where a vertex is already becomes that vertex: beside it, it would come back in
  // every round.
  void TakeRegion(const WoundRegion& region) {
    const int32_t before = whole_.size();
    std::map<std::pair<double, double>, int32_t> at;
    for (const RegionSegment& s : segments_) at.try_emplace(PlaceOf(s.from), s.from);
    std::vector<int32_t> corner_vertex;
    for (const RegionCorner& corner : region.corners) {
      const int32_t vertex = AddCorner(corner);
      corner_vertex.push_back(at.try_emplace(PlaceOf(vertex), vertex).first->second);
    }
    const auto vertex_of = [&](int32_t v) { return v < before ? v : corner_vertex[v - before]; };
    segments_.clear();
    for (const RegionSegment& s : region.segments) {
      const RegionSegment segment{vertex_of(s.from), vertex_of(s.to)};
      if (segment.from != segment.to) segments_.push_back(segment);
    }
  }

  // Seen from above.
  std::pair<double, double> PlaceOf(int32_t v) const {
    const Point3 p = frame_.ToFrame(whole_.positions[v]);
    return {p.x(), p.y()};
  }

  // A hole that winds around nothing may be a wall, but not the outline of surface.
  bool IsInsideOut() const {
    const Eigen::Vector3d area = hole_.VectorArea();
    const Eigen::Vector3d up = frame_.ToScene(Point3(0, 0, 1)) - frame_.ToScene(Point3(0, 0, 0));
    return segments_.empty() && area.dot(up) < -kFacesDown * area.norm();
  }

  // Those of the segments; of others nothing. On the lattice that FillOverPlane will take for them.
  std::vector<LatticePoint> LatticePoints() {
    std::set<int32_t> used;
    for (const RegionSegment& s : segments_) used.insert({s.from, s.to});
    std::vector<Point2> flat;
    std::vector<double> sizes;
    for (const int32_t v : used) {
      flat.emplace_back(frame_.ToFrame(whole_.positions[v]).head<2>());
      sizes.push_back(whole_.sizes[v]);
    }
    const PlanarPoints planar = RoundToWindow(flat, sizes);
    window_.emplace(planar.window);
    std::vector<LatticePoint> points(whole_.positions.size());
    size_t k = 0;
    for (const int32_t v : used) points[v] = planar.points[k++];
    return points;
  }

  int32_t AddCorner(const RegionCorner& corner) {
    const Point2 place = window_->ToMetres(corner.place);
    double height = std::numeric_limits<double>::infinity(), size = height;
    for (const int32_t s : corner.through) {
      const int32_t from = segments_[s].from, to = segments_[s].to;
      const Point3 a = frame_.ToFrame(whole_.positions[from]), b = frame_.ToFrame(whole_.positions[to]);
      const double length = (b - a).head<2>().squaredNorm();
      const double share = length > 0 ? std::clamp((place - a.head<2>()).dot((b - a).head<2>()) / length, 0., 1.) : 0;
      height = std::min(height, a.z() + share * (b.z() - a.z()));
      size = std::min({size, whole_.sizes[from], whole_.sizes[to]});
    }
    Point3 at = frame_.ToScene(Point3(place.x(), place.y(), height - kDrop * size));
    // A new vertex of water lies in its level, unless that would be above the edges.
    if (const auto level = hole_.WaterLevelAt(at.head<2>())) at.z() = std::min(at.z(), *level);
    return AddVertex(at, size);
  }

  // An edge between two rim vertices that the surface has already gets a vertex in its middle: a new one, or the one
  // that is there.
  void PartTakenChords() {
    std::set<std::pair<int32_t, int32_t>> rim;
    for (const RegionSegment& s : hole_.segments) rim.insert({s.from, s.to});
    for (size_t k = 0, n = segments_.size(); k < n; ++k) {
      const auto [from, to] = segments_[k];
      if (std::max(from, to) >= hole_.size() || rim.contains({from, to}) || hole_.MayJoin(from, to)) continue;
      const Point3 a = whole_.positions[from], b = whole_.positions[to];
      const auto there = std::ranges::find(whole_.positions, hole_.Storable((a + b) / 2));
      const int32_t middle = there != whole_.positions.end()
                                 ? static_cast<int32_t>(there - whole_.positions.begin())
                                 : AddVertex((a + b) / 2, std::min(whole_.sizes[from], whole_.sizes[to]));
      segments_[k].to = middle;
      segments_.push_back({middle, to});
    }
  }

  int32_t AddVertex(const Point3& place, double size) {
    whole_.vertices.push_back(-1);
    whole_.positions.push_back(hole_.Storable(place));
    whole_.sizes.push_back(size);
    whole_.has_equation.push_back(false);
    whole_.normals.emplace_back(Eigen::Vector3d::Zero());
    // Where the boundary folds it runs up something.
    if (!whole_.on_object.empty()) whole_.on_object.push_back(true);
    if (!whole_.ground.empty()) whole_.ground.emplace_back(std::nullopt);
    return whole_.size() - 1;
  }

  LocalHole WithoutVertices() const {
    LocalHole like;
    like.cell = hole_.cell;
    like.band = hole_.band;
    like.open = hole_.open;
    like.slope = hole_.slope;
    like.tension = hole_.tension;
    like.walls = hole_.walls;
    like.level = hole_.level;
    like.river = hole_.river;
    like.in_ground = hole_.in_ground;
    like.own_outline = hole_.own_outline;
    return like;
  }

  HolePart RegionPart() const {
    std::set<int32_t> at_fold;
    for (const std::vector<int32_t>& loop : loops_) at_fold.insert(loop.begin(), loop.end());
    HolePart part{WithoutVertices(), {}};
    LocalHole& local = part.hole;
    std::vector<int32_t> number(whole_.vertices.size(), -1);
    const auto take = [&](int32_t v) {
      if (number[v] >= 0) return number[v];
      number[v] = local.size();
      part.vertices.push_back(v);
      local.vertices.push_back(whole_.vertices[v]);
      local.positions.push_back(whole_.positions[v]);
      local.sizes.push_back(whole_.sizes[v]);
      local.normals.push_back(whole_.normals[v]);
      local.has_equation.push_back(whole_.has_equation[v] && !at_fold.contains(v));
      if (!whole_.on_object.empty()) local.on_object.push_back(whole_.on_object[v]);
      if (!whole_.ground.empty()) local.ground.push_back(whole_.ground[v]);
      return number[v];
    };
    for (const RegionSegment& s : segments_) {
      const int32_t from = take(s.from), to = take(s.to);
      local.segments.push_back({from, to});
      local.boundary.push_back(Undirected(from, to));
    }
    AddRestOfBoundary(number, local);
    for (const RegionSegment& s : hole_.inner_edges) {
      if (!IsInRegion(s)) continue;
      const int32_t from = take(s.from), to = take(s.to);
      local.inner_edges.push_back({from, to});
    }
    DropCutInnerEdges(frame_, local);
    return part;
  }

  // Corners with a wall go down to its foot instead: what closes the folds comes down to the ground by itself.
  void LowerCorners(const HolePart& part, const LocalPatch& of_region, LocalPatch& patch) {
    const auto first_new = static_cast<int32_t>(patch.new_points.size() - of_region.new_points.size());
    std::map<int32_t, int32_t> corner_at;  // by foot
    for (size_t k = 0; k < of_region.feet.size(); ++k) {
      const int32_t corner = part.vertices[k];
      if (of_region.feet[k] < 0 || corner < hole_.size()) continue;
      const int32_t foot = first_new + of_region.feet[k] - part.hole.size();
      whole_.positions[corner] = patch.new_points[corner - hole_.size()] = patch.new_points[foot];
      corner_at[hole_.size() + foot] = corner;
    }
    for (Triangle& t : patch.triangles) {
      for (int32_t& v : t) {
        if (const auto there = corner_at.find(v); there != corner_at.end()) v = there->second;
      }
    }
    std::erase_if(patch.triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  }

  // The hole's boundary that is none of the region's: the loops are closed on it, so that no edge of the part may lie
  // there.
  //   number  of each vertex, in the part; -1: none
  void AddRestOfBoundary(const std::vector<int32_t>& number, LocalHole& part) const {
    std::sort(part.boundary.begin(), part.boundary.end());
    std::vector<VertexPair> rest;
    for (const RegionSegment& s : hole_.segments) {
      if (number[s.from] < 0 || number[s.to] < 0) continue;
      const VertexPair edge = Undirected(number[s.from], number[s.to]);
      if (!std::binary_search(part.boundary.begin(), part.boundary.end(), edge)) rest.push_back(edge);
    }
    part.boundary.insert(part.boundary.end(), rest.begin(), rest.end());
    std::sort(part.boundary.begin(), part.boundary.end());
  }

  // Whether a way from the edge to the far east leaves the region an odd number of times. The edge may end on its
  // boundary.
  bool IsInRegion(const RegionSegment& edge) const {
    const auto at = [&](int32_t v) -> Point2 { return frame_.ToFrame(whole_.positions[v]).head<2>(); };
    const Point2 p = (at(edge.from) + at(edge.to)) / 2;
    const auto crossed = std::count_if(segments_.begin(), segments_.end(), [&](const RegionSegment& s) {
      const Point2 a = at(s.from), b = at(s.to);
      return (a.y() > p.y()) != (b.y() > p.y()) && a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x();
    });
    return crossed % 2 == 1;
  }

  const LocalHole& hole_;
  const ProjectionFrame& frame_;
  const FillOptions& options_;
  CrossingCheck& check_;
  LocalHole whole_;  // the hole, then the corners of the region
  std::optional<LatticeWindow> window_;
  std::vector<RegionSegment> segments_;      // of the region, in whole_
  std::vector<std::vector<int32_t>> loops_;  // between the two boundaries
};

}  // namespace

LocalPatch FillFolded(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options,
                      CrossingCheck& check) {
  return FoldedFiller(hole, frame, options, check).Run();
}

}  // namespace tilemend
