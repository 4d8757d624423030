#include "common/grid/area_shares.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace tilemend {
namespace {

constexpr double kUpright = 1e-6;  // columns: over less a line is taken for upright

// An edge that rises, in units of squares from the first one.
struct Edge {
  Point2 low, high;
  double XAt(double y) const { return low.x() + (y - low.y()) / (high.y() - low.y()) * (high.x() - low.x()); }
};

// In order of their lower ends. Level edges bound nothing that the others do not.
std::vector<Edge> EdgesOf(const PlanePolygon& area, const Grid& grid, CellId from) {
  const auto in_squares = [&](const Point2& p) -> Point2 {
    return ((p - grid.corner).array() / grid.cell_size.array()).matrix() - Point2(from.col, from.row);
  };
  std::vector<Edge> edges;
  for (const std::vector<Point2>& ring : area.rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      Edge edge{in_squares(ring[i]), in_squares(ring[(i + 1) % ring.size()])};
      if (edge.low.y() == edge.high.y()) continue;
      if (edge.low.y() > edge.high.y()) std::swap(edge.low, edge.high);
      edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.low.y() < b.low.y(); });
  return edges;
}

// Between two of these heights lies no point, and nothing but one row.
std::vector<double> KnotsOf(const std::vector<Edge>& edges, int32_t rows) {
  std::vector<double> knots;
  for (int32_t row = 0; row <= rows; ++row) knots.push_back(row);
  for (const Edge& edge : edges) knots.insert(knots.end(), {edge.low.y(), edge.high.y()});
  std::sort(knots.begin(), knots.end());
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

// Where an edge crosses the lower and the upper end of a strip.
struct Crossing {
  double low, high;
  double middle() const { return (low + high) / 2; }
};

// What of [0, 1] x strip lies left of a line, for a strip of height 1.
double LeftOf(double low, double high) {
  const double a = std::min(low, high), b = std::max(low, high);
  if (a >= 1) return 1;
  if (b <= 0) return 0;
  if (b - a < kUpright) return std::clamp((a + b) / 2, 0.0, 1.0);
  const auto sum = [](double x) { return x <= 0 ? 0 : x >= 1 ? x - 0.5 : x * x / 2; };  // of clamp(x, 0, 1)
  return (sum(b) - sum(a)) / (b - a);
}

// Adds what lies inside of a strip, of the weight `height`, to the shares of a row.
void AddStrip(const std::vector<Crossing>& crossings, double height, double* shares, int32_t cols) {
  for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const Crossing &from = crossings[i], &to = crossings[i + 1];
    const double end = std::min<double>(cols, std::max(to.low, to.high));
    for (auto col = static_cast<int32_t>(std::max(0.0, std::min(from.low, from.high))); col < end; ++col) {
      shares[col] += height * (LeftOf(to.low - col, to.high - col) - LeftOf(from.low - col, from.high - col));
    }
  }
}

// The cells that meet the bounds of the area, row by row.
std::vector<CellId> CellsInBounds(const PlanePolygon& area, const Grid& grid, std::span<const CellId> cells) {
  Point2 lo = Point2::Constant(std::numeric_limits<double>::infinity()), hi = -lo;
  for (const std::vector<Point2>& ring : area.rings) {
    for (const Point2& p : ring) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
  }
  std::vector<CellId> found;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(found), [&](CellId cell) {
    const Point2 low = grid.corner + Point2(cell.col, cell.row).cwiseProduct(grid.cell_size);
    return (hi.array() >= low.array()).all() && (lo.array() <= (low + grid.cell_size).array()).all();
  });
  std::sort(found.begin(), found.end(),
            [](CellId a, CellId b) { return std::pair(a.row, a.col) < std::pair(b.row, b.col); });
  return found;
}

// Cells that are sorted row by row as rectangles: runs of a row, each with equal runs of the rows above it.
std::vector<Squares> RectanglesOf(const std::vector<CellId>& cells) {
  std::vector<Squares> done;
  std::map<std::pair<int32_t, int32_t>, Squares> growing;  // by the columns [from, to)
  for (size_t i = 0; i < cells.size();) {
    size_t end = i + 1;
    while (end < cells.size() && cells[end].row == cells[i].row && cells[end].col == cells[end - 1].col + 1) ++end;
    const Squares run{cells[i], {cells[end - 1].col + 1, cells[i].row + 1}};
    Squares& rectangle = growing.try_emplace({run.from.col, run.to.col}, run).first->second;
    if (rectangle.to.row < run.from.row) done.push_back(std::exchange(rectangle, run));
    rectangle.to = run.to;
    i = end;
  }
  for (const auto& [columns, rectangle] : growing) done.push_back(rectangle);
  return done;
}

}  // namespace

std::vector<double> SharesOf(const PlanePolygon& area, const Grid& grid, const Squares& squares) {
  std::vector<double> shares(static_cast<size_t>(squares.cols()) * squares.rows());
  const std::vector<Edge> edges = EdgesOf(area, grid, squares.from);
  const std::vector<double> knots = KnotsOf(edges, squares.rows());
  size_t next = 0;
  std::vector<Edge> here;  // the edges at `y`
  std::vector<Crossing> crossings;
  for (size_t k = 0; k + 1 < knots.size(); ++k) {
    const double y = (knots[k] + knots[k + 1]) / 2;
    while (next < edges.size() && edges[next].low.y() <= y) here.push_back(edges[next++]);
    std::erase_if(here, [&](const Edge& edge) { return edge.high.y() <= y; });
    if (y <= 0 || y >= squares.rows()) continue;
    crossings.clear();
    for (const Edge& edge : here) crossings.push_back({edge.XAt(knots[k]), edge.XAt(knots[k + 1])});
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.middle() < b.middle(); });
    const size_t row = static_cast<size_t>(y) * squares.cols();
    AddStrip(crossings, knots[k + 1] - knots[k], shares.data() + row, squares.cols());
  }
  return shares;
}

double AreaInCells(const PlanePolygon& area, const Grid& grid, std::span<const CellId> cells) {
  double squares = 0;
  for (const Squares& rectangle : RectanglesOf(CellsInBounds(area, grid, cells))) {
    for (const double share : SharesOf(area, grid, rectangle)) squares += share;
  }
  return squares * grid.cell_size.prod();
}

}  // namespace tilemend
