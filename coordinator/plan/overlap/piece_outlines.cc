#include "coordinator/plan/overlap/piece_outlines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace tilemend {
namespace {

constexpr double kStraight = 2e-3;    // metres: an outline whose vertices agree to this is straight
constexpr double kLeastLength = 1.0;  // metres of boundary that a piece has along its outline

using Eigen::AlignedBox3d;

// Where a piece has its boundary along a face of its box.
struct Face {
  double place = 0;  // on the axis
  int32_t piece = 0;
};

class OutlineFinder {
 public:
  OutlineFinder(const SurveyRecord& record, double reach) : record_(record), reach_(reach) {
    for (size_t e = 0; e < record.edges.size(); ++e) box_[record.edges[e].piece].extend(Begin(e)).extend(End(e));
  }

  std::vector<bool> Run() {
    std::vector<bool> on_outline(record_.edges.size(), false);
    if (box_.size() < 2) return on_outline;
    for (int axis = 0; axis < 3; ++axis) {
      const std::set<double> planes = PlanesAcross(axis);
      for (size_t e = 0; e < record_.edges.size(); ++e) {
        const double a = Begin(e)[axis], b = End(e)[axis];
        const auto plane = planes.lower_bound(std::max(a, b) - kStraight);
        if (plane != planes.end() && *plane <= std::min(a, b) + kStraight) on_outline[e] = true;
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
      for (const Face& end : ends) {
        if (end.place <= begin.place || end.place - begin.place > reach_ || !AreBeside(axis, begin, end)) continue;
        planes.insert({begin.place, end.place});
      }
    }
    return planes;
  }

  std::vector<Face> FacesOf(int axis, bool upper) const {
    std::map<int32_t, double> length;
    const auto place_of = [&](int32_t piece) {
      return upper ? box_.at(piece).max()[axis] : box_.at(piece).min()[axis];
    };
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      const int32_t piece = record_.edges[e].piece;
      const double place = place_of(piece);
      if (std::abs(Begin(e)[axis] - place) > kStraight || std::abs(End(e)[axis] - place) > kStraight) continue;
      length[piece] += (End(e) - Begin(e)).norm();
    }
    std::vector<Face> faces;
    for (const auto& [piece, metres] : length) {
      if (metres >= kLeastLength) faces.push_back({place_of(piece), piece});
    }
    return faces;
  }

  // Whether two pieces lie side by side along an axis.
  bool AreBeside(int axis, const Face& begin, const Face& end) const {
    AlignedBox3d a = box_.at(begin.piece), b = box_.at(end.piece);
    for (AlignedBox3d* box : {&a, &b}) box->min()[axis] = 0, box->max()[axis] = 0;
    return begin.piece != end.piece && a.intersects(b);
  }

  const SurveyRecord& record_;
  const double reach_;
  std::map<int32_t, AlignedBox3d> box_;
};

}  // namespace

std::vector<bool> FindPieceOutlines(const SurveyRecord& record, double reach) {
  return OutlineFinder(record, reach).Run();
}

}  // namespace tilemend
