#include "coordinator/plan/overlap/piece_outlines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

constexpr double kLeastLength = 1.0;  // metres of boundary that a piece has along its outline
constexpr int kLeastEdges = 2;        // there: a single edge is straight by itself, and level by chance

using Eigen::AlignedBox3d;

// The boundary that a piece has along a face of its box.
struct Stretch {
  double length = 0;
  int edges = 0;
};

// Where a piece has its boundary along a face of its box.
struct Face {
  double place = 0;  // on the axis
  int32_t piece = 0;
};

class OutlineFinder {
 public:
  OutlineFinder(const SurveyRecord& record, double reach) : record_(record), reach_(reach) {
    for (size_t e = 0; e < record.edges.size(); ++e) {
      const auto piece = static_cast<size_t>(record.edges[e].piece);
      if (piece >= box_.size()) box_.resize(piece + 1);
      box_[piece].extend(Begin(e)).extend(End(e));
    }
  }

  std::vector<bool> Run() {
    std::vector<bool> on_outline(record_.edges.size(), false);
    if (box_.size() < 2) return on_outline;
    for (int axis = 0; axis < 3; ++axis) {
      const std::set<double> planes = PlanesAcross(axis);
      for (size_t e = 0; e < record_.edges.size(); ++e) {
        const double a = Begin(e)[axis], b = End(e)[axis];
        const auto plane = planes.lower_bound(std::max(a, b) - kMeetTolerance);
        if (plane != planes.end() && *plane <= std::min(a, b) + kMeetTolerance) on_outline[e] = true;
      }
    }
    return on_outline;
  }

 private:
  const Point3& Begin(size_t e) const { return record_.vertices[record_.edges[e].from].position; }
  const Point3& End(size_t e) const { return record_.vertices[record_.edges[e].to].position; }

  // Where pieces end and others begin.
  std::set<double> PlanesAcross(int axis) const {
    const std::vector<Face> begins = FacesOf(axis, false), ends = FacesOf(axis, true);
    std::set<double> planes;
    for (const Face& begin : begins) {
      auto end = std::upper_bound(ends.begin(), ends.end(), begin.place,
                                  [](double place, const Face& face) { return place < face.place; });
      for (; end != ends.end() && end->place - begin.place <= reach_; ++end) {
        if (planes.contains(begin.place) && planes.contains(end->place)) continue;
        if (AreBeside(axis, begin, *end)) planes.insert({begin.place, end->place});
      }
    }
    return planes;
  }

  // Along the axis.
  std::vector<Face> FacesOf(int axis, bool upper) const {
    std::map<int32_t, Stretch> along;
    const auto place_of = [&](int32_t piece) { return upper ? box_[piece].max()[axis] : box_[piece].min()[axis]; };
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      const int32_t piece = record_.edges[e].piece;
      const double place = place_of(piece);
      if (std::abs(Begin(e)[axis] - place) > kMeetTolerance || std::abs(End(e)[axis] - place) > kMeetTolerance)
        continue;
      along[piece].length += (End(e) - Begin(e)).norm();
      ++along[piece].edges;
    }
    std::vector<Face> faces;
    for (const auto& [piece, stretch] : along) {
      if (stretch.length >= kLeastLength && stretch.edges >= kLeastEdges) faces.push_back({place_of(piece), piece});
    }
    std::sort(faces.begin(), faces.end(),
              [](const Face& a, const Face& b) { return std::pair(a.place, a.piece) < std::pair(b.place, b.piece); });
    return faces;
  }

  // Whether two pieces lie side by side along an axis.
  bool AreBeside(int axis, const Face& begin, const Face& end) const {
    const AlignedBox3d &a = box_[begin.piece], &b = box_[end.piece];
    if (begin.piece == end.piece) return false;
    for (int other = 0; other < 3; ++other) {
      if (other != axis && (a.min()[other] > b.max()[other] || b.min()[other] > a.max()[other])) return false;
    }
    return true;
  }

  const SurveyRecord& record_;
  const double reach_;
  std::vector<AlignedBox3d> box_;  // by piece
};

}  // namespace

std::vector<bool> FindPieceOutlines(const SurveyRecord& record, double reach) {
  return OutlineFinder(record, reach).Run();
}

}  // namespace tilemend
