#include "client/left_holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr double kLeftReach = 1;  // metres around the boundary of a hole that was left

Eigen::AlignedBox3d WidenedBox(const Point2& lo, const Point2& hi, double reach) {
  return {Point3(lo.x() - reach, lo.y() - reach, 0), Point3(hi.x() + reach, hi.y() + reach, 0)};
}

// The sides of a cell, as one way around it counter-clockwise from its lower left corner.
class CellSides {
 public:
  CellSides(const Grid& grid, CellId cell) : size_(grid.cell_size) {
    const Point2 lo = grid.corner + size_.cwiseProduct(Point2(cell.col, cell.row)), hi = lo + size_;
    corners_ = {lo, Point2(hi.x(), lo.y()), hi, Point2(lo.x(), hi.y())};
  }

  double length() const { return 2 * size_.sum(); }

  // How far along the way the place on it is that is nearest to p.
  double AlongOf(const Point2& p) const {
    double best = 0, nearest = std::numeric_limits<double>::infinity(), start = 0;
    for (size_t k = 0; k < 4; ++k) {
      const Point2 &a = corners_[k], &b = corners_[(k + 1) % 4];
      const double side = (b - a).norm(), along = std::clamp((p - a).dot(b - a) / side, 0.0, side);
      const double distance = (a + along / side * (b - a) - p).norm();
      if (distance < nearest) std::tie(nearest, best) = std::pair(distance, start + along);
      start += side;
    }
    return best;
  }

  // The boxes of the parts of sides from one place to the next, counter-clockwise.
  std::vector<Eigen::AlignedBox2d> Between(double from, double to) const {
    if (to < from) to += length();
    std::vector<Eigen::AlignedBox2d> parts;
    double start = 0;
    for (size_t k = 0; k < 8; ++k) {  // twice around
      const Point2 &a = corners_[k % 4], &b = corners_[(k + 1) % 4];
      const double side = (b - a).norm(), lo = std::max(from, start), hi = std::min(to, start + side);
      const Point2 along = (b - a) / side;
      if (lo < hi) {
        Eigen::AlignedBox2d& part = parts.emplace_back(Point2(a + (lo - start) * along));
        part.extend(Point2(a + (hi - start) * along));
      }
      start += side;
    }
    return parts;
  }

 private:
  Point2 size_;
  std::array<Point2, 4> corners_;
};

// The places where the lines of a boundary begin, and where they end.
std::pair<std::vector<Point2>, std::vector<Point2>> EndsOf(const std::vector<std::vector<Point2>>& lines) {
  std::map<std::pair<double, double>, int> more_begin;
  for (const std::vector<Point2>& line : lines) {
    ++more_begin[{line.front().x(), line.front().y()}];
    --more_begin[{line.back().x(), line.back().y()}];
  }
  std::pair<std::vector<Point2>, std::vector<Point2>> ends;
  for (const auto& [place, more] : more_begin) {
    if (more != 0) (more > 0 ? ends.first : ends.second).emplace_back(place.first, place.second);
  }
  return ends;
}

}  // namespace

// A boundary has its hole on the left. Where it ends at a side of its cell, the hole goes on along the sides up to
// where the next line of the boundary begins. A seam there may go over vertices of rims, beside the grid line.
void LeftHoles::AddSides(const Grid& grid, const ReportedOutput::Left& hole) {
  const auto [begins, ends] = EndsOf(hole.rim);
  const CellSides sides(grid, hole.cell);
  for (const Point2& end : ends) {
    const double from = sides.AlongOf(end);
    double shortest = std::numeric_limits<double>::infinity();
    for (const Point2& begin : begins) {
      const double way = sides.AlongOf(begin) - from;
      shortest = std::min(shortest, way < 0 ? way + sides.length() : way);
    }
    if (!std::isfinite(shortest)) return;
    for (const Eigen::AlignedBox2d& part : sides.Between(from, from + shortest))
      beyond_.push_back({hole.cell, part, true});
  }
}

LeftHoles::LeftHoles(const Grid& grid, std::span<const ReportedOutput::Left> left) {
  for (const ReportedOutput::Left& hole : left) {
    const Point2 at = hole.at.head<2>();
    if (hole.rim.empty()) parts_.push_back({at, at, hole.reach + kLeftReach});
    for (const std::vector<Point2>& ring : hole.rim) {
      for (size_t k = 1; k < ring.size(); ++k) parts_.push_back({ring[k - 1], ring[k], kLeftReach});
    }
    if (!hole.reaches_border || hole.box.isEmpty()) continue;
    beyond_.push_back({hole.cell, hole.box, false});
    AddSides(grid, hole);
  }
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Part& part : parts_) {
    boxes.push_back(WidenedBox(part.a.cwiseMin(part.b), part.a.cwiseMax(part.b), part.reach));
  }
  part_tree_ = BoxTree(boxes);
  boxes.clear();
  for (const Beyond& hole : beyond_) boxes.push_back(WidenedBox(hole.box.min(), hole.box.max(), kLeftReach));
  beyond_tree_ = BoxTree(boxes);
}

bool LeftHoles::AreAt(const Point2& p, std::span<const CellId> beside) const {
  const Eigen::AlignedBox3d at(Point3(p.x(), p.y(), 0));
  const bool is_near = part_tree_.AnyMeeting(
      at, [&](int32_t i) { return DistanceToSegment(p, parts_[i].a, parts_[i].b) <= parts_[i].reach; });
  return is_near || beyond_tree_.AnyMeeting(at, [&](int32_t i) {
    const Beyond& hole = beyond_[i];
    const bool is_beside = hole.is_side || std::ranges::find(beside, hole.cell) != beside.end();
    return is_beside && hole.box.exteriorDistance(p) <= kLeftReach;
  });
}

}  // namespace tilemend
