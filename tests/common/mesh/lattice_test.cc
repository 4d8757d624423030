#include "common/mesh/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace tilemend {
namespace {

// A sign-magnitude integer of 16-bit digits: slow, simple, and independent of 128-bit arithmetic.
class BigInt {
 public:
  BigInt(int64_t value) : negative_(value < 0) {  // NOLINT: implicit on purpose
    for (uint64_t v = static_cast<uint64_t>(negative_ ? -value : value); v > 0; v >>= 16) digits_.push_back(v & 0xffff);
  }
  friend BigInt operator*(const BigInt& a, const BigInt& b) {
    BigInt product(0);
    product.digits_.assign(a.digits_.size() + b.digits_.size() + 1, 0);
    for (size_t i = 0; i < a.digits_.size(); ++i) {
      uint64_t carry = 0;
      for (size_t j = 0; j < b.digits_.size() || carry > 0; ++j) {
        carry += product.digits_[i + j] + uint64_t{a.digits_[i]} * (j < b.digits_.size() ? b.digits_[j] : 0);
        product.digits_[i + j] = carry & 0xffff;
        carry >>= 16;
      }
    }
    product.negative_ = a.negative_ != b.negative_;
    return product.Trim();
  }
  friend BigInt operator+(const BigInt& a, const BigInt& b) {
    if (a.negative_ != b.negative_) {
      return Less(a, b) ? Subtract(b, a) : Subtract(a, b);
    }
    BigInt sum(0);
    sum.negative_ = a.negative_;
    uint32_t carry = 0;
    for (size_t i = 0; i < std::max(a.digits_.size(), b.digits_.size()) || carry > 0; ++i) {
      carry += a.Digit(i) + b.Digit(i);
      sum.digits_.push_back(carry & 0xffff);
      carry >>= 16;
    }
    return sum.Trim();
  }
  friend BigInt operator-(const BigInt& a, BigInt b) {
    b.negative_ = !b.negative_;
    return a + b;
  }
  int Sign() const { return digits_.empty() ? 0 : negative_ ? -1 : 1; }

 private:
  uint32_t Digit(size_t i) const { return i < digits_.size() ? digits_[i] : 0; }
  BigInt& Trim() {
    while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
    return *this;
  }
  static bool Less(const BigInt& a, const BigInt& b) {  // by magnitude
    if (a.digits_.size() != b.digits_.size()) return a.digits_.size() < b.digits_.size();
    return std::lexicographical_compare(a.digits_.rbegin(), a.digits_.rend(), b.digits_.rbegin(), b.digits_.rend());
  }
  static BigInt Subtract(const BigInt& a, const BigInt& b) {  // |a| >= |b|; the sign of a
    BigInt difference(0);
    difference.negative_ = a.negative_;
    int32_t borrow = 0;
    for (size_t i = 0; i < a.digits_.size(); ++i) {
      int32_t digit = static_cast<int32_t>(a.Digit(i)) - static_cast<int32_t>(b.Digit(i)) - borrow;
      borrow = digit < 0;
      difference.digits_.push_back(static_cast<uint16_t>(digit + (borrow << 16)));
    }
    return difference.Trim();
  }

  bool negative_;
  std::vector<uint16_t> digits_;
};

int SlowOrientation(LatticePoint a, LatticePoint b, LatticePoint c) {
  return (BigInt(b.x - a.x) * BigInt(c.y - a.y) - BigInt(b.y - a.y) * BigInt(c.x - a.x)).Sign();
}

// The determinant of the 4x4 matrix of rows (x, y, x^2 + y^2, 1), not of differences.
int SlowInCircle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const std::array<LatticePoint, 4> p = {a, b, c, d};
  const auto lift = [&](int i) { return BigInt(p[i].x) * BigInt(p[i].x) + BigInt(p[i].y) * BigInt(p[i].y); };
  BigInt sum(0);
  for (int i = 0; i < 4; ++i) {
    const int j = (i == 0), k = i <= 1 ? 2 : 1, l = i <= 2 ? 3 : 2;
    const BigInt minor = BigInt(p[j].x) * BigInt(p[k].y) - BigInt(p[k].x) * BigInt(p[j].y) +
                         BigInt(p[k].x) * BigInt(p[l].y) - BigInt(p[l].x) * BigInt(p[k].y) +
                         BigInt(p[l].x) * BigInt(p[j].y) - BigInt(p[j].x) * BigInt(p[l].y);
    sum = i % 2 == 0 ? sum + lift(i) * minor : sum - lift(i) * minor;
  }
  return sum.Sign();
}

class PredicateTest : public ::testing::TestWithParam<int64_t> {
 protected:
  LatticePoint Draw() {
    std::uniform_int_distribution<int64_t> draw(-GetParam(), GetParam());
    const int64_t x = draw(random_);
    return {x, draw(random_)};
  }
  std::mt19937_64 random_{7};
};

TEST_P(PredicateTest, AgreeWithBigIntegers) {
  for (int i = 0; i < 3000; ++i) {
    const LatticePoint a = Draw(), b = Draw(), c = Draw(), d = Draw();
    EXPECT_EQ(Orientation(a, b, c), SlowOrientation(a, b, c));
    EXPECT_EQ(Orientation(a, b, c), -Orientation(b, a, c));
    EXPECT_EQ(InCircle(a, b, c, d), SlowInCircle(a, b, c, d));
  }
}

// Nearly degenerate: points moved by at most one step off a line and off a circle.
TEST_P(PredicateTest, AgreeWithBigIntegersNearZero) {
  std::uniform_int_distribution<int64_t> shake(-1, 1);
  for (int i = 0; i < 3000; ++i) {
    const LatticePoint a = Draw(), b = Draw();
    const LatticePoint middle = {(a.x + b.x) / 2 + shake(random_), (a.y + b.y) / 2 + shake(random_)};
    EXPECT_EQ(Orientation(a, b, middle), SlowOrientation(a, b, middle));
    // a, b and their mirror images at the axes lie on one circle around the origin.
    const LatticePoint c = {-a.x, a.y}, d = {a.x + shake(random_), -a.y + shake(random_)};
    const LatticePoint e = {-a.x + shake(random_), -a.y};
    EXPECT_EQ(InCircle(a, c, e, d), SlowInCircle(a, c, e, d));
  }
}

INSTANTIATE_TEST_SUITE_P(Ranges, PredicateTest,
                         ::testing::Values(2, 10, 1000, int64_t{1} << 20, (int64_t{1} << 29) - 2));

TEST(InCircleTest, IsExactAtTheCornersOfTheRange) {
  const int64_t m = (int64_t{1} << 29) - 1;
  EXPECT_EQ(InCircle({-m, -m}, {m, -m}, {m, m}, {-m, m}), 0);
  EXPECT_EQ(InCircle({-m, -m}, {m, -m}, {m, m}, {-m + 1, m}), 1);
  EXPECT_EQ(InCircle({-m, -m}, {m, -m}, {m, m - 1}, {-m, m}), -1);
}

TEST(LatticeWindowTest, IsAsFineAsItsBoxAllows) {
  EXPECT_EQ(LatticeWindow({0, 0}, {0, 0}).step(), std::ldexp(1.0, -26));
  EXPECT_EQ(LatticeWindow({5, 5}, {205, 105}).step(), std::ldexp(1.0, -20));
  EXPECT_EQ(LatticeWindow({0, 0}, {250, 10}).step(), std::ldexp(1.0, -19));
}

TEST(LatticeWindowTest, IsAsFineForABoxOfAnySize) {
  for (const int power : {-60, -20, -10, -1, 1, 10, 20}) {
    const double factor = std::ldexp(1.0, power);
    const LatticeWindow plain({3, 4}, {3.7, 4.2}), other({3 * factor, 4 * factor}, {3.7 * factor, 4.2 * factor});
    EXPECT_EQ(other.step(), plain.step() * factor);
    EXPECT_EQ(other.Round(Point2(3.3, 4.1) * factor), plain.Round({3.3, 4.1}));
  }
}

TEST(LatticeWindowTest, HoldsItsBoxAndRoundTrips) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 200; ++i) {
    const double side = std::ldexp(1.0, i % 30 - 5);
    const Point2 lo = (Point2(unit(random), unit(random)) - Point2(0.5, 0.5)) * std::ldexp(1.0, i % 25);
    const Point2 hi = lo + Point2(side, side * unit(random));
    const LatticeWindow window(lo, hi);
    EXPECT_EQ(std::remainder(window.origin().x(), window.step()), 0);
    for (const Point2& p : {lo, hi, Point2(lo + (hi - lo) * unit(random))}) {
      const LatticePoint rounded = window.Round(p);
      EXPECT_GE(std::min(rounded.x, rounded.y), 0);
      EXPECT_LE(std::max(rounded.x, rounded.y), int64_t{1} << 28);
      EXPECT_LE((window.ToMetres(rounded) - p).cwiseAbs().maxCoeff(), window.step() / 2);
      EXPECT_EQ(window.Round(window.ToMetres(rounded)), rounded);
    }
  }
}

TEST(LatticeWindowTest, StaysExactFarFromTheOrigin) {
  const Point2 lo(4e12, -7e12);
  const LatticeWindow window(lo, lo + Point2(10, 10));
  const LatticePoint p = window.Round(lo + Point2(3, 4));
  EXPECT_EQ(window.Round(window.ToMetres(p)), p);
  EXPECT_GE(window.step(), std::ldexp(1.0, -11));
}

}  // namespace
}  // namespace tilemend
