#include "common/mesh/exact_signs.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace tilemend {
namespace {

// Half an ulp of 1, as in Shewchuk 1997, and his bounds for the rounding errors of the two determinants.
template <typename Real>
constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon() / 2;
constexpr double kAreaError = (3 + 16 * kEpsilon<double>)*kEpsilon<double>;
template <typename Real>
constexpr Real kVolumeError = (7 + 56 * kEpsilon<Real>)*kEpsilon<Real>;

// A number as an exact sum of doubles that do not overlap, by growing magnitude.
class Expansion {
 public:
  static Expansion Difference(double a, double b) {
    Expansion e;
    e.Add(a);
    e.Add(-b);
    return e;
  }

  // Grow-expansion, zeros left out.
  void Add(double b) {
    size_t kept = 0;
    for (const double term : terms_) {
      const double s = b + term, virtual_term = s - b;
      const double rest = (b - (s - virtual_term)) + (term - virtual_term);
      if (rest != 0) terms_[kept++] = rest;
      b = s;
    }
    terms_.resize(kept);
    if (b != 0) terms_.push_back(b);
  }

  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    Expansion product;
    for (const double x : a.terms_) {
      for (const double y : b.terms_) {
        const double p = x * y;
        product.Add(std::fma(x, y, -p));
        product.Add(p);
      }
    }
    return product;
  }

  friend Expansion operator-(Expansion a, const Expansion& b) {
    for (const double y : b.terms_) a.Add(-y);
    return a;
  }

  friend Expansion operator+(Expansion a, const Expansion& b) {
    for (const double y : b.terms_) a.Add(y);
    return a;
  }

  int Sign() const { return terms_.empty() ? 0 : terms_.back() > 0 ? 1 : -1; }

 private:
  std::vector<double> terms_;
};

using ExactVector = std::array<Expansion, 3>;

ExactVector ExactDifference(const Point3& a, const Point3& b) {
  return {Expansion::Difference(a.x(), b.x()), Expansion::Difference(a.y(), b.y()),
          Expansion::Difference(a.z(), b.z())};
}

int ExactSideOfPlane(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const ExactVector u = ExactDifference(b, a), v = ExactDifference(c, a), w = ExactDifference(d, a);
  const Expansion x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
  return (x * w[0] + y * w[1] + z * w[2]).Sign();
}

int SignOf(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// Nothing where rounding errors decide.
template <typename Real>
std::optional<int> RoundedSideOfPlane(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  using Vector = Eigen::Matrix<Real, 3, 1>;
  const Vector u = b.cast<Real>() - a.cast<Real>(), v = c.cast<Real>() - a.cast<Real>(),
               w = d.cast<Real>() - a.cast<Real>();
  const Real volume = u.cross(v).dot(w);
  const Vector p = u.cwiseAbs(), q = v.cwiseAbs(), r = w.cwiseAbs();
  const Real magnitude = (p.y() * q.z() + p.z() * q.y()) * r.x() + (p.z() * q.x() + p.x() * q.z()) * r.y() +
                         (p.x() * q.y() + p.y() * q.x()) * r.z();
  if (std::abs(volume) < kVolumeError<Real> * magnitude) return std::nullopt;
  return volume > 0 ? 1 : volume < 0 ? -1 : 0;  // both zero: it is exactly so
}

}  // namespace

int SideOfPlane(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (const auto side = RoundedSideOfPlane<double>(a, b, c, d)) return *side;
  // Points that were on one plane before they were rounded, or turned, are as a rule off it by so little, and not less.
  if (const auto side = RoundedSideOfPlane<long double>(a, b, c, d)) return *side;
  return ExactSideOfPlane(a, b, c, d);
}

int TurnOf(const Point2& a, const Point2& b, const Point2& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
  if (std::abs(left - right) >= kAreaError * (std::abs(left) + std::abs(right))) return SignOf(left - right);
  const auto difference = [](double p, double q) { return Expansion::Difference(p, q); };
  return (difference(b.x(), a.x()) * difference(c.y(), a.y()) - difference(b.y(), a.y()) * difference(c.x(), a.x()))
      .Sign();
}

}  // namespace tilemend
