#include "worker/texture/square_lattice.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace tilemend {
namespace {

int64_t FloorDiv(int64_t a, int64_t b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

// The lattice of squares of twice the side.
SquareLattice Coarser(const SquareLattice& fine) {
  SquareLattice coarse;
  coarse.pixels = fine.pixels * 2;
  coarse.column = FloorDiv(fine.column, 2);
  coarse.row = FloorDiv(fine.row, 2);
  coarse.width = static_cast<int32_t>(FloorDiv(fine.column + fine.width - 1, 2) + 1 - coarse.column);
  coarse.height = static_cast<int32_t>(FloorDiv(fine.row + fine.height - 1, 2) + 1 - coarse.row);
  coarse.values.resize(static_cast<size_t>(coarse.width) * static_cast<size_t>(coarse.height));
  coarse.weights.resize(coarse.values.size());
  for (int32_t y = 0; y < fine.height; ++y) {
    for (int32_t x = 0; x < fine.width; ++x) {
      const size_t from = fine.At(x, y);
      const size_t to = coarse.At(static_cast<int32_t>(FloorDiv(fine.column + x, 2) - coarse.column),
                                  static_cast<int32_t>(FloorDiv(fine.row + y, 2) - coarse.row));
      for (size_t c = 0; c < 3; ++c) coarse.values[to][c] += fine.weights[from] * fine.values[from][c];
      coarse.weights[to] += fine.weights[from];
    }
  }
  for (size_t i = 0; i < coarse.values.size(); ++i) {
    if (coarse.weights[i] > 0) {
      for (float& value : coarse.values[i]) value /= coarse.weights[i];
    }
    coarse.weights[i] = std::min(coarse.weights[i], 1.0F);
  }
  return coarse;
}

// Bilinear at a place in squares of the lattice, its first square's centre at 0.5.
Channels Bilinear(const SquareLattice& lattice, double px, double py) {
  const double x = std::clamp(px - 0.5, 0.0, static_cast<double>(lattice.width - 1));
  const double y = std::clamp(py - 0.5, 0.0, static_cast<double>(lattice.height - 1));
  const auto x0 = static_cast<int32_t>(x), y0 = static_cast<int32_t>(y);
  const int32_t x1 = std::min(x0 + 1, lattice.width - 1), y1 = std::min(y0 + 1, lattice.height - 1);
  const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
  const Channels& a = lattice.values[lattice.At(x0, y0)];
  const Channels& b = lattice.values[lattice.At(x1, y0)];
  const Channels& d = lattice.values[lattice.At(x0, y1)];
  const Channels& e = lattice.values[lattice.At(x1, y1)];
  Channels result;
  for (size_t c = 0; c < 3; ++c) {
    const float below = a[c] + fx * (b[c] - a[c]), above = d[c] + fx * (e[c] - d[c]);
    result[c] = below + fy * (above - below);
  }
  return result;
}

void FillWithMean(SquareLattice& lattice) {
  Channels mean{};
  float all = 0;
  for (size_t i = 0; i < lattice.values.size(); ++i) {
    for (size_t c = 0; c < 3; ++c) mean[c] += lattice.weights[i] * lattice.values[i][c];
    all += lattice.weights[i];
  }
  for (size_t i = 0; i < lattice.values.size(); ++i) {
    const float weight = std::min(lattice.weights[i], 1.0F);
    for (size_t c = 0; c < 3; ++c) {
      lattice.values[i][c] = weight * lattice.values[i][c] + (1 - weight) * mean[c] / std::max(all, 1e-6F);
    }
  }
}

// Fills what is not known from ever coarser lattices.
void PushPull(SquareLattice& lattice) {
  // Two squares on both sides of a line through the origin never become one.
  if (lattice.width <= 2 && lattice.height <= 2) return FillWithMean(lattice);
  if (std::all_of(lattice.weights.begin(), lattice.weights.end(), [](float w) { return w >= 1; })) return;
  SquareLattice coarse = Coarser(lattice);
  PushPull(coarse);
  for (int32_t y = 0; y < lattice.height; ++y) {
    for (int32_t x = 0; x < lattice.width; ++x) {
      const size_t at = lattice.At(x, y);
      const float weight = std::min(lattice.weights[at], 1.0F);
      if (weight >= 1) continue;
      const double px = (static_cast<double>(lattice.column + x) + 0.5) / 2 - static_cast<double>(coarse.column);
      const double py = (static_cast<double>(lattice.row + y) + 0.5) / 2 - static_cast<double>(coarse.row);
      const Channels from = Bilinear(coarse, px, py);
      for (size_t c = 0; c < 3; ++c) {
        lattice.values[at][c] = weight * lattice.values[at][c] + (1 - weight) * from[c];
      }
    }
  }
}

// A square that relaxation changes, with its neighbours.
struct FreeSquare {
  int32_t at = 0;
  std::array<int32_t, 4> around{};
  int32_t count = 0;  // of `around`
};

// The free squares of one colour of the chessboard. Absolute coordinates, so that the order is the same in all rasters.
std::vector<FreeSquare> FreeSquares(const std::vector<uint8_t>& fixed, int64_t colour, const SquareLattice& lattice) {
  std::vector<FreeSquare> found;
  for (int32_t y = 0; y < lattice.height; ++y) {
    for (auto x = static_cast<int32_t>((lattice.column + lattice.row + y + colour) & 1); x < lattice.width; x += 2) {
      const auto at = static_cast<int32_t>(lattice.At(x, y));
      if (fixed[static_cast<size_t>(at)] != 0) continue;
      FreeSquare square{at};
      const auto add = [&](int32_t of) { square.around[static_cast<size_t>(square.count++)] = of; };
      if (x > 0) add(at - 1);
      if (x + 1 < lattice.width) add(at + 1);
      if (y > 0) add(at - lattice.width);
      if (y + 1 < lattice.height) add(at + lattice.width);
      if (square.count > 0) found.push_back(square);
    }
  }
  return found;
}

// One value a column, padded to what a processor adds at once.
using SquareValues = Eigen::Array<float, 4, Eigen::Dynamic>;

void Relax(const std::vector<FreeSquare>& squares, float screen, SquareValues& values) {
  constexpr float kOverRelaxation = 1.8F;
  for (const FreeSquare& square : squares) {
    Eigen::Array4f sum = values.col(square.around[0]);
    for (int32_t k = 1; k < square.count; ++k) sum += values.col(square.around[static_cast<size_t>(k)]);
    values.col(square.at) +=
        kOverRelaxation * (sum / (static_cast<float>(square.count) + screen) - values.col(square.at));
  }
}

// The membrane between fixed squares, drawn to 0 by `screen`.
void RelaxAll(int sweeps, float screen, const std::vector<uint8_t>& fixed, SquareLattice& lattice) {
  SquareValues values = SquareValues::Zero(4, static_cast<Eigen::Index>(lattice.values.size()));
  for (size_t i = 0; i < lattice.values.size(); ++i)
    for (size_t c = 0; c < 3; ++c)
      values(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(i)) = lattice.values[i][c];
  const std::array<std::vector<FreeSquare>, 2> free = {FreeSquares(fixed, 0, lattice), FreeSquares(fixed, 1, lattice)};
  for (int i = 0; i < sweeps; ++i) {
    for (const std::vector<FreeSquare>& squares : free) Relax(squares, screen, values);
  }
  for (size_t i = 0; i < lattice.values.size(); ++i)
    for (size_t c = 0; c < 3; ++c)
      lattice.values[i][c] = values(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(i));
}

// The Gaussian along rows of `width` columns, and across them. Sums from one side to the other.
void SmoothAlongRows(const std::vector<float>& kernel, Eigen::Index width, const SquareValues& from, SquareValues& to) {
  const auto reach = static_cast<Eigen::Index>(kernel.size()) - 1;
  to.setZero();
  for (Eigen::Index row = 0; row < from.cols(); row += width) {
    for (Eigen::Index k = std::max(-reach, 1 - width); k <= std::min(reach, width - 1); ++k) {
      const Eigen::Index begin = std::max<Eigen::Index>(0, -k), count = width - std::abs(k);
      to.middleCols(row + begin, count) +=
          kernel[static_cast<size_t>(std::abs(k))] * from.middleCols(row + begin + k, count);
    }
  }
}

void SmoothAcrossRows(const std::vector<float>& kernel, Eigen::Index width, const SquareValues& from,
                      SquareValues& to) {
  const auto reach = static_cast<Eigen::Index>(kernel.size()) - 1;
  const Eigen::Index height = from.cols() / width;
  to.setZero();
  for (Eigen::Index y = 0; y < height; ++y) {
    for (Eigen::Index other = std::max<Eigen::Index>(0, y - reach); other <= std::min(height - 1, y + reach); ++other) {
      to.middleCols(y * width, width) +=
          kernel[static_cast<size_t>(std::abs(other - y))] * from.middleCols(other * width, width);
    }
  }
}

}  // namespace

SquareLattice LatticeOver(const RasterFrame& frame, double side) {
  SquareLattice lattice;
  while (lattice.pixels * frame.texel < side * 0.75) lattice.pixels *= 2;
  lattice.column = FloorDiv(frame.column, lattice.pixels);
  lattice.row = FloorDiv(frame.row, lattice.pixels);
  lattice.width = static_cast<int32_t>(FloorDiv(frame.column + frame.width - 1, lattice.pixels) + 1 - lattice.column);
  lattice.height = static_cast<int32_t>(FloorDiv(frame.row + frame.height - 1, lattice.pixels) + 1 - lattice.row);
  lattice.values.resize(static_cast<size_t>(lattice.width) * static_cast<size_t>(lattice.height));
  lattice.weights.resize(lattice.values.size());
  return lattice;
}

size_t SquareOf(const SquareLattice& lattice, const RasterFrame& frame, int32_t x, int32_t y) {
  return lattice.At(static_cast<int32_t>(FloorDiv(frame.column + x, lattice.pixels) - lattice.column),
                    static_cast<int32_t>(FloorDiv(frame.row + y, lattice.pixels) - lattice.row));
}

Channels ValueAt(const SquareLattice& lattice, const RasterFrame& frame, int32_t x, int32_t y) {
  const auto place = [&](int64_t pixel, int64_t first) {
    return (static_cast<double>(pixel - first * lattice.pixels) + 0.5) / lattice.pixels;
  };
  return Bilinear(lattice, place(frame.column + x, lattice.column), place(frame.row + y, lattice.row));
}

void SmoothSquares(double sigma, SquareLattice& lattice) {
  const auto reach = static_cast<int32_t>(std::ceil(3 * sigma));
  std::vector<float> kernel;
  for (int32_t k = 0; k <= reach; ++k) kernel.push_back(static_cast<float>(std::exp(-0.5 * k * k / (sigma * sigma))));
  const auto count = static_cast<Eigen::Index>(lattice.values.size());
  SquareValues from(4, count), to(4, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const float w = lattice.weights[static_cast<size_t>(i)];
    const Channels& v = lattice.values[static_cast<size_t>(i)];
    from.col(i) << w * v[0], w * v[1], w * v[2], w;
  }
  SmoothAlongRows(kernel, lattice.width, from, to);
  SmoothAcrossRows(kernel, lattice.width, to, from);
  constexpr float kLeastWeight = 1e-4F;
  for (size_t i = 0; i < lattice.values.size(); ++i) {
    const Eigen::Array4f sum = from.col(static_cast<Eigen::Index>(i));
    const bool known = sum[3] > kLeastWeight;
    lattice.weights[i] = known ? 1.0F : 0.0F;
    for (size_t c = 0; c < 3; ++c) lattice.values[i][c] = known ? sum[static_cast<Eigen::Index>(c)] / sum[3] : 0;
  }
}

void FillSquares(SquareLattice& lattice) {
  for (float& weight : lattice.weights) weight = weight > 0 ? 1 : 0;
  if (std::find(lattice.weights.begin(), lattice.weights.end(), 1) == lattice.weights.end()) {
    std::fill(lattice.values.begin(), lattice.values.end(), Channels{});
    return;
  }
  PushPull(lattice);
}

void FadeSquares(double reach, int sweeps, SquareLattice& lattice) {
  std::vector<uint8_t> fixed(lattice.weights.size());
  for (size_t i = 0; i < fixed.size(); ++i) {
    fixed[i] = lattice.weights[i] > 0 ? 1 : 0;
    if (fixed[i] == 0) lattice.values[i] = {};
  }
  RelaxAll(sweeps, static_cast<float>(1 / (reach * reach)), fixed, lattice);
}

}  // namespace tilemend
