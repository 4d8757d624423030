// Numbers of a report.
#ifndef TILEMEND_COORDINATOR_REPORT_ROUNDED_H_
#define TILEMEND_COORDINATOR_REPORT_ROUNDED_H_

#include <cmath>

namespace tilemend {

inline constexpr int kMillimetres = 3;  // digits of metres

// To `digits` decimals.
inline double Rounded(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::round(value * scale) / scale;
}

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_ROUNDED_H_
