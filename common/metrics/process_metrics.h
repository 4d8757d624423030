// What Prometheus' clients tell of their own process in every language: process_* and build_info, and how much memory
// the process may have.
#ifndef TILEMEND_COMMON_METRICS_PROCESS_METRICS_H_
#define TILEMEND_COMMON_METRICS_PROCESS_METRICS_H_

#include <mutex>
#include <string>

#include "common/metrics/metrics.h"

namespace tilemend {

// Thread-safe.
class ProcessMetrics {
 public:
  ProcessMetrics(MetricsRegistry& registry, const std::string& program, const std::string& version);
  // Looks again. A figure that the system does not tell stays as it is.
  void Update();

 private:
  std::mutex mutex_;
  double cpu_seconds_shown_ = 0;
  Counter* cpu_seconds_;
  Gauge* resident_bytes_;
  Gauge* virtual_bytes_;
  Gauge* threads_;
  Gauge* open_files_;
  Gauge* most_files_;
  Gauge* memory_limit_;
};

// The least of the machine's memory and of the limits of control groups, version 2 and 1: the process's own group and
// those around it. The file `groups` says which group that is, as proc(5) does; `folder` is where groups are seen.
double MemoryLimitBytes(const std::string& groups = "/proc/self/cgroup", const std::string& folder = "/sys/fs/cgroup");

}  // namespace tilemend

#endif  // TILEMEND_COMMON_METRICS_PROCESS_METRICS_H_
