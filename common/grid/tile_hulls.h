// Tiles seen from above, as far as their grid depends on it: the convex hulls of some of them.
#ifndef TILEMEND_COMMON_GRID_TILE_HULLS_H_
#define TILEMEND_COMMON_GRID_TILE_HULLS_H_

#include <cstddef>
#include <vector>

#include "common/grid/scene.h"

namespace tilemend {

struct TileHull {
  CellId cell;
  ConvexHull hull;  // not empty
};

// The median; of an even number, the larger of the middle two. Precondition: not empty. Linear.
double UpperMedian(std::vector<double> values);

// The convex hull of points, counter-clockwise, each corner once. Of points in one line its ends, of one point itself.
// O(n log n), by Andrew's monotone chain (1979).
ConvexHull HullOf(std::vector<Point2> points);

// The bounds of a hull along axes that are turned counter-clockwise by `turn`, radians. Heights are 0.
Box BoundsOf(const ConvexHull& hull, double turn);

// Which tiles tell the grid, as ascending indices: all if there are no more than kMostLookedAt; else so many at
// most: some that are evenly spread in the orders by rows and by columns, and their neighbours to the east and north.
// O(n log n).
std::vector<size_t> TilesToLookAt(const std::vector<CellId>& cells);

// Of 500 made surveys with a round edge, 24 tiles told one grid wrong, and 48 told all right.
inline constexpr size_t kMostLookedAt = 48;

// By which angle the sides of the hulls are turned, radians counter-clockwise: the median over those of which most of
// the length has one direction; 0 if none has, or below kLeastGridTurn.
double TurnOfSides(const std::vector<ConvexHull>& hulls);

inline constexpr double kLeastGridTurn = 1e-4;  // radians: 1 cm in 100 m

// By how much the bounds of neighbours overlap or gape along turned axes, metres: the median. Infinite if none is the
// neighbour of another. O(n log n).
double MedianGap(const std::vector<TileHull>& tiles, double turn);

// The median of the sides of their bounds along turned axes, metres. Precondition: not empty. O(corners).
double MedianSide(const std::vector<TileHull>& tiles, double turn);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_TILE_HULLS_H_
