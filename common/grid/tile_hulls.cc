#include "common/grid/tile_hulls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "common/mesh/main_turn.h"

namespace tilemend {
namespace {

constexpr double kLeastOfSides = 0.5;  // of a hull's length: its tile was cut in this direction

double Cross(const Point2& o, const Point2& a, const Point2& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

// Of at least two different points, sorted: the lower or, backwards, the upper side without its last corner.
template <typename Iterator>
void AddSide(Iterator begin, Iterator end, ConvexHull& hull) {
  const size_t first = hull.size();
  for (Iterator p = begin; p != end; ++p) {
    while (hull.size() >= first + 2 && Cross(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
    hull.push_back(*p);
  }
  hull.pop_back();
}

}  // namespace

double UpperMedian(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

ConvexHull HullOf(std::vector<Point2> points) {
  std::ranges::sort(points, {}, [](const Point2& p) { return std::pair(p.x(), p.y()); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;
  ConvexHull hull;
  AddSide(points.begin(), points.end(), hull);
  AddSide(points.rbegin(), points.rend(), hull);
  return hull;
}

Box BoundsOf(const ConvexHull& hull, double turn) {
  Box box{Point3(INFINITY, INFINITY, 0), Point3(-INFINITY, -INFINITY, 0)};
  const double c = std::cos(turn), s = std::sin(turn);
  for (const Point2& p : hull) {
    const Point3 turned(c * p.x() + s * p.y(), c * p.y() - s * p.x(), 0);
    box.lo = box.lo.cwiseMin(turned);
    box.hi = box.hi.cwiseMax(turned);
  }
  return box;
}

std::vector<size_t> TilesToLookAt(const std::vector<CellId>& cells) {
  std::vector<size_t> order(cells.size());
  std::iota(order.begin(), order.end(), size_t{0});
  if (cells.size() <= kMostLookedAt) return order;
  std::map<CellId, size_t> at;
  for (size_t t = 0; t < cells.size(); ++t) at.emplace(cells[t], t);
  std::set<size_t> chosen;
  constexpr size_t kPlaces = kMostLookedAt / 6;
  for (const bool by_rows : {true, false}) {
    std::ranges::sort(order, {}, [&](size_t t) {
      return by_rows ? std::pair(cells[t].row, cells[t].col) : std::pair(cells[t].col, cells[t].row);
    });
    for (size_t k = 0; k < kPlaces; ++k) {
      const CellId c = cells[order[k * (order.size() - 1) / (kPlaces - 1)]];
      for (const CellId& there : {c, CellId{c.col + 1, c.row}, CellId{c.col, c.row + 1}}) {
        if (const auto found = at.find(there); found != at.end()) chosen.insert(found->second);
      }
    }
  }
  return {chosen.begin(), chosen.end()};
}

double TurnOfSides(const std::vector<ConvexHull>& hulls) {
  std::vector<double> turns;
  for (const ConvexHull& hull : hulls) {
    std::vector<Point2> sides;
    for (size_t i = 0; i < hull.size(); ++i) sides.emplace_back(hull[(i + 1) % hull.size()] - hull[i]);
    if (const std::optional<double> turn = MainTurn(sides, kLeastOfSides)) turns.push_back(*turn);
  }
  if (turns.empty()) return 0;
  const double turn = UpperMedian(std::move(turns));
  return std::abs(turn) < kLeastGridTurn ? 0 : turn;
}

double MedianGap(const std::vector<TileHull>& tiles, double turn) {
  std::map<CellId, Box> bounds;
  for (const TileHull& tile : tiles) bounds.emplace(tile.cell, BoundsOf(tile.hull, turn));
  std::vector<double> gaps;
  for (const auto& [cell, box] : bounds) {
    const auto compare = [&bounds, &gaps, &box = box](const CellId& next, int axis) {
      const auto there = bounds.find(next);
      if (there != bounds.end()) gaps.push_back(std::abs(box.hi[axis] - there->second.lo[axis]));
    };
    compare({cell.col + 1, cell.row}, 0);
    compare({cell.col, cell.row + 1}, 1);
  }
  return gaps.empty() ? std::numeric_limits<double>::infinity() : UpperMedian(std::move(gaps));
}

double MedianSide(const std::vector<TileHull>& tiles, double turn) {
  std::vector<double> sides;
  for (const TileHull& tile : tiles) {
    const Box bounds = BoundsOf(tile.hull, turn);
    for (const int axis : {0, 1}) sides.push_back(bounds.hi[axis] - bounds.lo[axis]);
  }
  return UpperMedian(std::move(sides));
}

}  // namespace tilemend
