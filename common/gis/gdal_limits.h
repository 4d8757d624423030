// What one request to the process that GDAL runs in may take (gdal_process.h).
#ifndef TILEMEND_COMMON_GIS_GDAL_LIMITS_H_
#define TILEMEND_COMMON_GIS_GDAL_LIMITS_H_

#include <algorithm>
#include <cstdint>

namespace tilemend {

// Bytes of a vector file with those beside it. The coordinator holds it twice while it is read.
inline constexpr int64_t kMostVectorBytes = int64_t{256} << 20;

// Bytes of address space: far above what files take (60 MB of GeoJSON: 3 GB), since GDAL's libraries alone take 0.6 GB.
// More than the upper bound is a danger to the machine.
constexpr uint64_t GdalMemory(uint64_t input_bytes) {
  constexpr uint64_t kBase = uint64_t{2} << 30, kForAByte = 64, kMost = uint64_t{8} << 30;
  return std::min(kBase + kForAByte * input_bytes, kMost);
}

// Seconds of a processor: far above what files take (300,000 polygons of GeoJSON, 60 MB: 5 s), and below what anyone
// waits for. The DXF driver of GDAL 3.6 never ends on some drawings that are cut off.
constexpr uint64_t GdalCpuSeconds(uint64_t input_bytes) {
  constexpr uint64_t kBase = 20, kBytesForASecond = 1 << 18;
  return kBase + input_bytes / kBytesForASecond;
}

// Seconds of the clock. A process may wait for others on a busy machine, so it is given three times its own time. Only
// a process that waits for something that never comes gets here.
constexpr uint64_t GdalClockSeconds(uint64_t input_bytes) { return 3 * GdalCpuSeconds(input_bytes); }

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_GDAL_LIMITS_H_
