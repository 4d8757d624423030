// Rounding to what a file can hold.
#ifndef TILEMEND_COMMON_CODEC_ROUNDING_H_
#define TILEMEND_COMMON_CODEC_ROUNDING_H_

#include "common/codec/mesh_file.h"

namespace tilemend {

// The double that a file of `type` gives back for `value`.
//
// The store to memory is needed: g++ 12 at -O2 turns neighbouring `double(float(x))` into nothing when it vectorises
// them (a[0] = double(float(a[0])); a[1] = double(float(a[1])); leaves `a` as it was), Eigen's
// cast<float>().cast<double>() included.
inline double RoundedTo(NumberType type, double value) {
  if (type == NumberType::kFloat64) return value;
  volatile float rounded = static_cast<float>(value);
  return static_cast<double>(rounded);
}

inline Point3 RoundedTo(NumberType type, const Point3& p) {
  return {RoundedTo(type, p[0]), RoundedTo(type, p[1]), RoundedTo(type, p[2])};
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_ROUNDING_H_
