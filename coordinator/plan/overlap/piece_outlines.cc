#include "coordinator/plan/overlap/piece_outlines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "common/mesh/segment_distance.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

constexpr int kUp = 2;
constexpr double kLeastLength = 1.0;  // metres of boundary that a piece has along its outline
constexpr int kLeastEdges = 2;        // there: a single edge is straight by itself, and level by chance
// Of the reach: by how much pieces overlap that are joined to others beyond their boxes. In 8 tiles of an export at two
// levels of detail 33 planes were .093 to .096 m apart, and 14 by chance less than .004 m; the reach was .3 m.
constexpr double kLeastOverlap = 0.1;

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// Where a piece ends or begins: boundary of it in a plane across an axis, with its surface on one side.
struct OutlineStretch {
  double place = 0;  // on the axis
  int32_t piece = 0;
  bool is_face = false;       // the plane is a face of the piece's box
  std::vector<size_t> edges;  // of the record
};

// Of the boundary along pairs of upright planes, metres seen from above.
struct StripTally {
  double length = 0;
  double doubled = 0;  // where between the planes surface lies above surface
};

// A boundary edge in a plane across an axis.
struct LevelEdge {
  double place = 0;
  size_t edge = 0;
};

class OutlineFinder {
 public:
  OutlineFinder(const SurveyRecord& record, const PieceLayout& layout) : record_(record), reach_(layout.reach) {
    turn_ << layout.axis.x(), layout.axis.y(), 0, -layout.axis.y(), layout.axis.x(), 0, 0, 0, 1;
    for (const BoundaryVertex& v : record.vertices) extent_.extend(places_.emplace_back(turn_ * v.position));
    for (size_t e = 0; e < record.edges.size(); ++e) {
      const auto piece = static_cast<size_t>(record.edges[e].piece);
      if (piece >= box_.size()) box_.resize(piece + 1);
      box_[piece].extend(Begin(e)).extend(End(e));
    }
  }

  std::vector<bool> Run() {
    std::vector<bool> on_outline(record_.edges.size(), false);
    if (reach_ <= 0) return on_outline;
    std::array<std::set<double>, 3> planes_across;
    StripTally strips;
    for (int axis = 0; axis < 3; ++axis) planes_across[axis] = PlanesAcross(axis, strips);
    if (strips.doubled < strips.length / 2) return on_outline;
    for (int axis = 0; axis < 3; ++axis) {
      const std::set<double>& planes = planes_across[axis];
      for (size_t e = 0; e < record_.edges.size(); ++e) {
        const double a = Begin(e)[axis], b = End(e)[axis];
        const auto plane = planes.lower_bound(std::max(a, b) - kMeetTolerance);
        if (plane != planes.end() && *plane <= std::min(a, b) + kMeetTolerance) on_outline[e] = true;
      }
    }
    return on_outline;
  }

 private:
  const Point3& Begin(size_t e) const { return places_[record_.edges[e].from]; }
  const Point3& End(size_t e) const { return places_[record_.edges[e].to]; }

  // Where surface ends and other surface has begun.
  std::set<double> PlanesAcross(int axis, StripTally& strips) const {
    const std::vector<OutlineStretch> begins = StretchesAcross(axis, false), ends = StretchesAcross(axis, true);
    std::set<double> planes;
    for (const OutlineStretch& begin : begins) {
      auto end = std::upper_bound(ends.begin(), ends.end(), begin.place,
                                  [](double place, const OutlineStretch& other) { return place < other.place; });
      for (; end != ends.end() && end->place - begin.place <= reach_; ++end) {
        if (planes.contains(begin.place) && planes.contains(end->place)) continue;
        if (IsAtTheEnd(axis, begin, *end) || !AreBeside(axis, begin, *end)) continue;
        planes.insert({begin.place, end->place});
        if (axis != kUp) Tally(axis, begin, *end, strips);
      }
    }
    return planes;
  }

  // Whether one of two upright planes is the tile's own outline: no piece goes on beyond.
  bool IsAtTheEnd(int axis, const OutlineStretch& begin, const OutlineStretch& end) const {
    return axis != kUp &&
           (begin.place - extent_.min()[axis] <= kMeetTolerance || extent_.max()[axis] - end.place <= kMeetTolerance);
  }

  // Overlapping pieces both have surface between their planes, while a strip of surface between a hole and another, or
  // the tile's outline, is there once.
  void Tally(int axis, const OutlineStretch& begin, const OutlineStretch& end, StripTally& strips) const {
    const std::map<double, int> surfaces = SurfacesAlong(axis, (begin.place + end.place) / 2);
    for (const OutlineStretch* const stretch : {&begin, &end}) {
      for (const size_t e : stretch->edges) {
        const double from = Begin(e)[1 - axis], to = End(e)[1 - axis];
        const auto beyond = surfaces.upper_bound((from + to) / 2);
        const int count = beyond == surfaces.begin() ? 0 : std::prev(beyond)->second;
        strips.length += std::abs(to - from);
        if (count > 1) strips.doubled += std::abs(to - from);
      }
    }
  }

  // How many surfaces lie above each other along a line across an upright plane's axis, from each place on.
  std::map<double, int> SurfacesAlong(int axis, double place) const {
    std::map<double, int> surfaces;
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      const Point3 &a = Begin(e), &b = End(e);
      if ((a[axis] < place) == (b[axis] < place)) continue;
      const double share = (place - a[axis]) / (b[axis] - a[axis]);
      const int turn = axis == 0 ? 1 : -1;  // the surface lies on the left
      surfaces[a[1 - axis] + share * (b[1 - axis] - a[1 - axis])] += a[axis] < place ? turn : -turn;
    }
    int count = 0;
    for (auto& [along, surface] : surfaces) surface = count += surface;
    return surfaces;
  }

  // Along the axis, those long enough.
  //   ends  whether the surface lies before the plane, else behind it
  std::vector<OutlineStretch> StretchesAcross(int axis, bool ends) const {
    std::map<int32_t, std::vector<LevelEdge>> of_piece;
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      const double a = Begin(e)[axis], b = End(e)[axis];
      if (std::abs(a - b) > kMeetTolerance || !LiesBeside(e, axis, ends)) continue;
      of_piece[record_.edges[e].piece].push_back({ends ? std::max(a, b) : std::min(a, b), e});
    }
    std::vector<OutlineStretch> stretches;
    for (auto& [piece, edges] : of_piece) {
      std::sort(edges.begin(), edges.end(), [](const LevelEdge& a, const LevelEdge& b) {
        return std::pair(a.place, a.edge) < std::pair(b.place, b.edge);
      });
      for (size_t first = 0, next = 0; first < edges.size(); first = next) {
        while (next < edges.size() && edges[next].place - edges[first].place <= kMeetTolerance) ++next;
        OutlineStretch stretch;
        stretch.place = ends ? edges[next - 1].place : edges[first].place;
        stretch.piece = piece;
        const double face = ends ? box_[piece].max()[axis] : box_[piece].min()[axis];
        stretch.is_face = stretch.place == face;
        for (size_t k = first; k < next; ++k) stretch.edges.push_back(edges[k].edge);
        if (LengthOf(stretch) >= kLeastLength && std::ssize(stretch.edges) >= kLeastEdges) {
          stretches.push_back(std::move(stretch));
        }
      }
    }
    std::sort(stretches.begin(), stretches.end(), [](const OutlineStretch& a, const OutlineStretch& b) {
      return std::pair(a.place, a.piece) < std::pair(b.place, b.piece);
    });
    return stretches;
  }

  // Whether the surface at an edge in a plane lies before the plane (`ends`) or behind it; at a face of its piece's box
  // it does wherever it lies.
  bool LiesBeside(size_t e, int axis, bool ends) const {
    const AlignedBox3d& box = box_[record_.edges[e].piece];
    const double place = Begin(e)[axis];
    if (std::abs(place - (ends ? box.max()[axis] : box.min()[axis])) <= kMeetTolerance) return true;
    const Vector3d normal =
        record_.vertices[record_.edges[e].from].normal + record_.vertices[record_.edges[e].to].normal;
    const double inward = (turn_ * normal).cross(End(e) - Begin(e))[axis];
    return ends ? inward < 0 : inward > 0;
  }

  double LengthOf(const OutlineStretch& stretch) const {
    double length = 0;
    for (const size_t e : stretch.edges) length += (End(e) - Begin(e)).norm();
    return length;
  }

  // Whether what ends at one plane goes on at the other: the pieces lie side by side, or, where a piece is joined to
  // others beyond its box, most of the one boundary runs along the other.
  bool AreBeside(int axis, const OutlineStretch& begin, const OutlineStretch& end) const {
    if (begin.piece != end.piece && begin.is_face && end.is_face) {
      const AlignedBox3d &a = box_[begin.piece], &b = box_[end.piece];
      for (int other = 0; other < 3; ++other) {
        if (other != axis && (a.min()[other] > b.max()[other] || b.min()[other] > a.max()[other])) return false;
      }
      return true;
    }
    if (end.place - begin.place < kLeastOverlap * reach_) return false;
    return RunsAlong(begin, end) || RunsAlong(end, begin);
  }

  bool RunsAlong(const OutlineStretch& one, const OutlineStretch& other) const {
    double along = 0;
    for (const size_t e : one.edges) {
      const Point3 middle = (Begin(e) + End(e)) / 2;
      const bool is_near = std::ranges::any_of(
          other.edges, [&](size_t o) { return DistanceToSegment(middle, Begin(o), End(o)) <= reach_; });
      if (is_near) along += (End(e) - Begin(e)).norm();
    }
    return along > LengthOf(one) / 2;
  }

  const SurveyRecord& record_;
  const double reach_;
  Eigen::Matrix3d turn_;           // so that the planes lie across the axes
  std::vector<Point3> places_;     // of the record's vertices, turned
  AlignedBox3d extent_;            // of those
  std::vector<AlignedBox3d> box_;  // by piece
};

}  // namespace

std::vector<bool> FindPieceOutlines(const SurveyRecord& record, const PieceLayout& layout) {
  return OutlineFinder(record, layout).Run();
}

}  // namespace tilemend
