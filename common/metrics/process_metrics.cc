#include "common/metrics/process_metrics.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

namespace tilemend {
namespace {

// Fields of /proc/self/stat after the program's name, which may hold blanks: the first is the state.
std::vector<double> StatFields() {
  std::ifstream file("/proc/self/stat");
  std::string text;
  std::getline(file, text);
  const size_t name_end = text.rfind(") ");
  if (name_end == std::string::npos) return {};
  std::istringstream words(text.substr(name_end + 4));
  std::vector<double> fields = {0};
  for (double value = 0; words >> value;) fields.push_back(value);
  return fields;
}

// By their numbers in proc(5), less 3.
constexpr size_t kUserTime = 11, kSystemTime = 12, kThreads = 17, kStartTime = 19, kVirtualBytes = 20, kPages = 21;

double BootTime() {
  std::ifstream file("/proc/stat");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("btime ")) return std::stod(line.substr(6));
  }
  return 0;
}

double NumberIn(const std::string& path) {
  std::ifstream file(path);
  double value = HUGE_VAL;  // "max", or no such file
  file >> value;
  return file ? value : HUGE_VAL;
}

double LeastUpwards(const std::string& folder, std::string group, const std::string& file) {
  double least = NumberIn(folder + "/" + file);
  for (; group.size() > 1; group.erase(group.rfind('/'))) {
    least = std::min(least, NumberIn(folder + group + "/" + file));
  }
  return least;
}

}  // namespace

double MemoryLimitBytes(const std::string& groups, const std::string& folder) {
  double limit = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  std::ifstream file(groups);
  for (std::string line; std::getline(file, line);) {  // NUMBER:CONTROLLERS:/GROUP
    const size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos || line.compare(second + 1, 1, "/") != 0) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
    if (controllers.empty()) limit = std::min(limit, LeastUpwards(folder, group, "memory.max"));
    if (controllers == "memory") {
      limit = std::min(limit, LeastUpwards(folder + "/memory", group, "memory.limit_in_bytes"));
    }
  }
  return limit;
}

ProcessMetrics::ProcessMetrics(MetricsRegistry& registry, const std::string& program, const std::string& version)
    : cpu_seconds_(registry.AddCounter("process_cpu_seconds_total", "User and system time.", {})),
      resident_bytes_(registry.AddGauge("process_resident_memory_bytes", "Resident memory.", {})),
      virtual_bytes_(registry.AddGauge("process_virtual_memory_bytes", "Virtual memory.", {})),
      threads_(registry.AddGauge("process_threads", "Threads.", {})),
      open_files_(registry.AddGauge("process_open_fds", "Open file descriptors.", {})),
      most_files_(registry.AddGauge("process_max_fds", "File descriptors that may be open.", {})),
      memory_limit_(registry.AddGauge("tilemend_memory_limit_bytes",
                                      "The least of the machine's memory and the limit of the control group.", {})) {
  registry.AddGauge("tilemend_build_info", "1.", {{"program", program}, {"version", version}})->Set(1);
  const std::vector<double> fields = StatFields();
  if (fields.size() > kStartTime) {
    registry.AddGauge("process_start_time_seconds", "When the process started, seconds since 1970.", {})
        ->Set(BootTime() + fields[kStartTime] / static_cast<double>(sysconf(_SC_CLK_TCK)));
  }
  Update();
}

void ProcessMetrics::Update() {
  std::lock_guard<std::mutex> lock(mutex_);
  if (const std::vector<double> fields = StatFields(); fields.size() > kPages) {
    const double cpu = (fields[kUserTime] + fields[kSystemTime]) / static_cast<double>(sysconf(_SC_CLK_TCK));
    cpu_seconds_->Increment(std::max(0.0, cpu - cpu_seconds_shown_));
    cpu_seconds_shown_ = std::max(cpu, cpu_seconds_shown_);
    threads_->Set(fields[kThreads]);
    virtual_bytes_->Set(fields[kVirtualBytes]);
    resident_bytes_->Set(fields[kPages] * static_cast<double>(sysconf(_SC_PAGESIZE)));
  }
  std::error_code error;
  const auto files = std::filesystem::directory_iterator("/proc/self/fd", error);
  if (!error) open_files_->Set(static_cast<double>(std::distance(files, std::filesystem::directory_iterator())));
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) == 0) most_files_->Set(static_cast<double>(limit.rlim_cur));
  memory_limit_->Set(MemoryLimitBytes());
}

}  // namespace tilemend
