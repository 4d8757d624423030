#include "worker/texture/square_lattice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tilemend {
namespace {

TEST(SquareLatticeTest, SquaresBeginAtMultiplesOfTheirSide) {
  const RasterFrame frame{0.125, -3, 5, 10, 4};
  const SquareLattice lattice = LatticeOver(frame, 0.5);
  EXPECT_EQ(lattice.pixels, 4);
  EXPECT_EQ(lattice.column, -1);
  EXPECT_EQ(lattice.row, 1);
  EXPECT_EQ(lattice.width, 3);
  EXPECT_EQ(lattice.height, 2);
  EXPECT_EQ(SquareOf(lattice, frame, 2, 0), 0U);
  EXPECT_EQ(SquareOf(lattice, frame, 3, 3), 4U);
}

TEST(SquareLatticeTest, ValuesAreBilinearBetweenCentres) {
  const RasterFrame frame{1, 0, 0, 8, 8};
  SquareLattice lattice = LatticeOver(frame, 2);
  for (int32_t y = 0; y < lattice.height; ++y) {
    for (int32_t x = 0; x < lattice.width; ++x) lattice.values[lattice.At(x, y)] = {2.0F * x, 0, 1.0F * y};
  }
  EXPECT_NEAR(ValueAt(lattice, frame, 3, 2)[0], 2.5, 1e-6);
  EXPECT_NEAR(ValueAt(lattice, frame, 2, 3)[2], 1.25, 1e-6);
  EXPECT_EQ(ValueAt(lattice, frame, 0, 0)[0], 0);
}

// In one dimension the solution is a hyperbolic cosine.
TEST(SquareLatticeTest, ValuesFadeBetweenKnownSquares) {
  SquareLattice lattice = LatticeOver({1, -6, -3, 21, 8}, 1);
  for (int32_t y = 0; y < lattice.height; ++y) {
    for (const int32_t x : {0, lattice.width - 1}) {
      lattice.values[lattice.At(x, y)] = {100, 5, 0};
      lattice.weights[lattice.At(x, y)] = 1;
    }
  }
  FadeSquares(4, 60, lattice);
  for (int32_t x = 0; x < lattice.width; ++x) {
    EXPECT_NEAR(lattice.values[lattice.At(x, 4)][0], 100 * std::cosh((x - 10) / 4.0) / std::cosh(2.5), 0.5);
  }
}

TEST(SquareLatticeTest, EndsOnBothSidesOfTheOrigin) {
  for (const int32_t width : {1, 2, 3, 8}) {
    SquareLattice lattice = LatticeOver({1, -1, -1, width, 2}, 1);
    lattice.values[0] = {7, 7, 7};
    lattice.weights[0] = 1;
    FillSquares(lattice);
    for (const Channels& value : lattice.values) EXPECT_NEAR(value[1], 7, 1e-3);
  }
}

TEST(SquareLatticeTest, NothingKnownGivesZeros) {
  SquareLattice lattice = LatticeOver({1, 0, 0, 5, 5}, 1);
  lattice.values[3] = {9, 9, 9};
  FillSquares(lattice);
  for (const Channels& value : lattice.values) EXPECT_EQ(value, (Channels{0, 0, 0}));
}

TEST(SquareLatticeTest, SmoothingKeepsAConstantAndSpreadsIt) {
  SquareLattice lattice = LatticeOver({1, 0, 0, 30, 1}, 1);
  for (size_t i = 0; i < 10; ++i) {
    lattice.values[i] = {3, 4, 5};
    lattice.weights[i] = 1;
  }
  SmoothSquares(2, lattice);
  EXPECT_NEAR(lattice.values[12][2], 5, 1e-5);
  EXPECT_EQ(lattice.weights[12], 1);
  EXPECT_EQ(lattice.weights[20], 0);
}

}  // namespace
}  // namespace tilemend
