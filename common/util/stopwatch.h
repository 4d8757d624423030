// Wall time, lap by lap.
#ifndef TILEMEND_COMMON_UTIL_STOPWATCH_H_
#define TILEMEND_COMMON_UTIL_STOPWATCH_H_

#include <chrono>

namespace tilemend {

class Stopwatch {
 public:
  // Seconds since the last lap, or since the start.
  double Lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_STOPWATCH_H_
