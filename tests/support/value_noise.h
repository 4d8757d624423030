// Numbers that look random and are the same everywhere, for made scenes.
#ifndef TILEMEND_TESTS_SUPPORT_VALUE_NOISE_H_
#define TILEMEND_TESTS_SUPPORT_VALUE_NOISE_H_

#include <cmath>
#include <cstdint>

namespace tilemend {

// A number in [0, 1) for a place and a purpose; the finaliser of MurmurHash3.
inline double HashedNumber(uint64_t seed, int64_t i, int64_t j, uint64_t purpose) {
  uint64_t h = (static_cast<uint64_t>(i) * 73856093) ^ (static_cast<uint64_t>(j) * 19349663) ^ (seed * 83492791 + 1);
  h += purpose * 0x9e3779b97f4a7c15;
  h = (h ^ (h >> 33)) * 0xff51afd7ed558ccd;
  h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53;
  return static_cast<double>((h ^ (h >> 33)) >> 11) * 0x1p-53;
}

// One octave of value noise in [0, 1], twice differentiable, over a lattice of side 1.
inline double ValueNoise(uint64_t seed, double x, double y, uint64_t purpose) {
  const double i = std::floor(x);
  const double j = std::floor(y);
  const auto fade = [](double t) { return t * t * t * (t * (6 * t - 15) + 10); };
  const auto corner = [&](int di, int dj) {
    return HashedNumber(seed, static_cast<int64_t>(i) + di, static_cast<int64_t>(j) + dj, purpose);
  };
  const double u = fade(x - i);
  const double v = fade(y - j);
  return std::lerp(std::lerp(corner(0, 0), corner(1, 0), u), std::lerp(corner(0, 1), corner(1, 1), u), v);
}

// Octaves of value noise, each half as wide and 0.45 times as high as the one before; about 0 to 1.
inline double FractalNoise(uint64_t seed, double x, double y, int octaves, uint64_t purpose) {
  double sum = 0;
  double total = 0;
  double weight = 1;
  for (int k = 0; k < octaves; ++k, weight *= 0.45, x *= 2, y *= 2) {
    sum += weight * ValueNoise(seed, x, y, purpose + k);
    total += weight;
  }
  return sum / total;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_VALUE_NOISE_H_
