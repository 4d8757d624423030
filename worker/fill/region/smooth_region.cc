#include "worker/fill/region/smooth_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tilemend::internal {
namespace {

// A move may make the worst triangle around a point worse as long as it stays this good (by Shape): evening out sizes
// is worth more than the last bit of a shape.
constexpr double kGoodShape = 0.7;

// 2 * sqrt(3) * area2 / (sum of squared edges): 1 for an equilateral triangle, no square roots.
double Shape(Point32 a, Point32 b, Point32 c) {
  const auto square = [](Point32 p, Point32 q) {
    const double x = double{1} * p.x - q.x, y = double{1} * p.y - q.y;
    return x * x + y * y;
  };
  return 2 * std::sqrt(3.0) * static_cast<double>(Turn(a, b, c)) / (square(a, b) + square(b, c) + square(c, a));
}

class Smoother {
 public:
  Smoother(DelaunayMesh& mesh, size_t first_movable, std::span<const double> size)
      : mesh_(mesh),
        first_(static_cast<int32_t>(first_movable)),
        size_(size),
        triangle_of_(size.size() - first_movable, -1) {
    for (size_t t = 0; t < mesh_.triangles.size(); ++t) Touch(static_cast<int32_t>(t));
  }

  void EvenRound() {
    for (size_t i = 0; i < triangle_of_.size(); ++i) Even(first_ + static_cast<int32_t>(i));
    MakeDelaunay();
  }

  void ShapeRound() {
    for (size_t i = 0; i < triangle_of_.size(); ++i) Improve(first_ + static_cast<int32_t>(i));
    MakeDelaunay();
  }

 private:
  // A triangle around the point: its far edge and the weight of its circumcentre.
  struct Sector {
    Point32 from;
    Point32 to;
    double weight;
  };

  void Touch(int32_t t) {
    mesh_.triangles[t].flags = 0;
    for (int32_t v : mesh_.triangles[t].corner) {
      if (v >= first_) triangle_of_[v - first_] = t;
    }
  }

  void GatherStar(int32_t v) {
    star_.clear();
    const int32_t start = triangle_of_[v - first_];
    int32_t t = start;
    do {
      const MeshTriangle& triangle = mesh_.triangles[t];
      const int k = triangle.corner[0] == v ? 0 : triangle.corner[1] == v ? 1 : 2;
      const int32_t a = triangle.corner[Next(k)], b = triangle.corner[Previous(k)];
      // Points of spacing h have the density h^-2, and the energy weighs densities to the power (d + 2) / d = 2.
      const double h2 = (size_[a] + size_[b] + size_[v]) * (size_[a] + size_[b] + size_[v]);
      star_.push_back({mesh_.points[a], mesh_.points[b], 1 / (h2 * h2)});
      t = triangle.twin[Next(k)] >> 2;
    } while (t != start);
  }

  struct StarShape {
    double worst;
    double sum;
  };

  // The shapes of the triangles around, were the point at p.
  StarShape ShapeAt(Point32 p) const {
    StarShape result{1, 0};
    for (const Sector& s : star_) {
      const double shape = Shape(p, s.from, s.to);
      result.worst = std::min(result.worst, shape);
      result.sum += shape;
    }
    return result;
  }

  // The weighted mean of the circumcentres, relative to p. Each times its triangle's area needs no division.
  std::array<double, 2> Pull(Point32 p) const {
    double sum = 0, x = 0, y = 0;
    for (const Sector& s : star_) {
      const double bx = double{1} * s.from.x - p.x, by = double{1} * s.from.y - p.y;
      const double cx = double{1} * s.to.x - p.x, cy = double{1} * s.to.y - p.y;
      const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
      x += s.weight * (cy * b2 - by * c2);
      y += s.weight * (bx * c2 - cx * b2);
      sum += s.weight * 2 * (bx * cy - by * cx);
    }
    return {x / sum, y / sum};
  }

  // Where the sum of shapes around p has no gradient, its denominators held fixed; relative to p. A triangle of doubled
  // area A and sum of squared edges S, over the far edge from a to b, has the gradient
  // (turn(b - a) - 2 A (2 p - a - b) / S) / S, but for a factor; turn() is a quarter turn to the left.
  std::array<double, 2> ShapePull(Point32 p) const {
    double sum = 0, x = 0, y = 0;
    for (const Sector& s : star_) {
      const double ax = double{1} * s.from.x - p.x, ay = double{1} * s.from.y - p.y;
      const double bx = double{1} * s.to.x - p.x, by = double{1} * s.to.y - p.y;
      const double squares = 2 * (ax * (ax - bx) + ay * (ay - by) + bx * bx + by * by);
      const double weight = 2 * (ax * by - ay * bx) / (squares * squares);
      x += (ay - by) / squares + weight * (ax + bx);
      y += (bx - ax) / squares + weight * (ay + by);
      sum += 2 * weight;
    }
    return {x / sum, y / sum};
  }

  void Even(int32_t v) {
    GatherStar(v);
    const double needed = std::min(ShapeAt(mesh_.points[v]).worst, kGoodShape);
    Move(v, Pull(mesh_.points[v]), [&](const StarShape& after) { return after.worst >= needed; });
  }

  void Improve(int32_t v) {
    GatherStar(v);
    const StarShape before = ShapeAt(mesh_.points[v]);
    Move(v, ShapePull(mesh_.points[v]), [&](const StarShape& after) {
      return after.sum > before.sum && after.worst >= std::min(before.worst, kGoodShape);
    });
  }

  // Tries the whole way, then half of it.
  template <typename Accepts>
  void Move(int32_t v, const std::array<double, 2>& way, const Accepts& accepts) {
    const Point32 p = mesh_.points[v];
    for (double step : {1.0, 0.5}) {
      const double x = p.x + step * way[0], y = p.y + step * way[1];
      // Flat triangles have circumcentres far outside any window; the negation also catches NaN.
      if (!(std::abs(x) < kCoordinateBound - 1 && std::abs(y) < kCoordinateBound - 1)) continue;
      const Point32 q = {static_cast<int32_t>(std::lround(x)), static_cast<int32_t>(std::lround(y))};
      if (q == p) return;
      const StarShape after = ShapeAt(q);
      if (after.worst > 0 && accepts(after)) {
        mesh_.points[v] = q;
        return;
      }
    }
  }

  // Lawson flips from every edge on.
  void MakeDelaunay() {
    for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (int32_t k = 0; k < 3; ++k) {
        const int32_t e = static_cast<int32_t>(4 * t) + k;
        if (mesh_.Twin(e) > e && mesh_.IsIllegal(e)) FlipFrom(e);
      }
    }
  }

  void FlipFrom(int32_t first) {
    todo_.assign(1, first);
    while (!todo_.empty()) {
      const int32_t e = todo_.back();
      todo_.pop_back();
      if (!mesh_.IsIllegal(e)) continue;
      const int32_t u = mesh_.Twin(e) >> 2;
      mesh_.Flip(e);
      Touch(e >> 2);
      Touch(u);
      for (int j = 0; j < 3; ++j) {
        todo_.push_back((e & ~3) + j);
        todo_.push_back(4 * u + j);
      }
    }
  }

  DelaunayMesh& mesh_;
  int32_t first_;
  std::span<const double> size_;
  std::vector<int32_t> triangle_of_;
  std::vector<Sector> star_;
  std::vector<int32_t> todo_;
};

}  // namespace

void SmoothRegion(DelaunayMesh& mesh, size_t first_movable, std::span<const double> size, int even_rounds,
                  int shape_rounds) {
  Smoother smoother(mesh, first_movable, size);
  for (int i = 0; i < even_rounds; ++i) smoother.EvenRound();
  for (int i = 0; i < shape_rounds; ++i) smoother.ShapeRound();
}

}  // namespace tilemend::internal
