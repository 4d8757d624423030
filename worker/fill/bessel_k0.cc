#include "worker/fill/bessel_k0.h"

#include <array>
#include <cmath>
#include <numbers>

namespace tilemend {
namespace {

// -(ln(x / 2) + gamma) I0(x) + sum over k of (x^2 / 4)^k / k!^2 (1 + 1/2 + ... + 1/k); Abramowitz and Stegun, 9.6.13.
double Near(double x) {
  constexpr int kTerms = 12;  // 1 / 13!^2 is below 1e-19
  const double quarter = x * x / 4;
  double term = 1, i0 = 1, harmonic = 0, sum = 0;
  for (int k = 1; k <= kTerms; ++k) {
    term *= quarter / (k * k);
    harmonic += 1.0 / k;
    i0 += term;
    sum += term * harmonic;
  }
  return sum - (std::log(x / 2) + std::numbers::egamma) * i0;
}

// A Chebyshev series in 8 / x - 2 for sqrt(x) e^x K0(x).
double Far(double x) {
  constexpr std::array<double, 25> kSeries = {
      5.30043377268626276149E-18, -1.64758043015242134646E-17, 5.21039150503902756861E-17, -1.67823109680541210385E-16,
      5.51205597852431940784E-16, -1.84859337734377901440E-15, 6.34007647740507060557E-15, -2.22751332699166985548E-14,
      8.03289077536357521100E-14, -2.98009692317273043925E-13, 1.14034058820847496303E-12, -4.51459788337394416547E-12,
      1.85594911495471785253E-11, -7.95748924447710747776E-11, 3.57739728140030116597E-10, -1.69753450938905987466E-9,
      8.57403401741422608519E-9,  -4.66048989768794782956E-8,  2.76681363944501510342E-7,  -1.83175552271911948767E-6,
      1.39498137188764993662E-5,  -1.28495495816278026384E-4,  1.56988388573005337491E-3,  -3.14481013119645005427E-2,
      2.44030308206595545468E0};
  const double y = 8 / x - 2;
  double b0 = 0, b1 = 0, b2 = 0;
  for (const double coefficient : kSeries) {
    b2 = b1;
    b1 = b0;
    b0 = y * b1 - b2 + coefficient;
  }
  return std::exp(-x) * (b0 - b2) / 2 / std::sqrt(x);
}

}  // namespace

double BesselK0(double x) { return x <= 2 ? Near(x) : Far(x); }

}  // namespace tilemend
