#include "common/metrics/process_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <ctime>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/metrics/prometheus_registry.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

double ValueOf(const PrometheusRegistry& registry, const std::string& name) {
  const std::string text = absl::StrCat("\n", registry.Text());
  const size_t at = text.find(absl::StrCat("\n", name, " "));
  EXPECT_NE(at, std::string::npos) << name;
  return at == std::string::npos ? 0 : std::stod(text.substr(at + name.size() + 2));
}

TEST(ProcessMetricsTest, TellsOfThisProcess) {
  PrometheusRegistry registry;
  const ProcessMetrics metrics(registry, "tilemend-test", "1.2.3");
  EXPECT_THAT(registry.Text(), HasSubstr("tilemend_build_info{program=\"tilemend-test\",version=\"1.2.3\"} 1\n"));
  EXPECT_GT(ValueOf(registry, "process_resident_memory_bytes"), 1e6);
  EXPECT_GT(ValueOf(registry, "process_virtual_memory_bytes"), ValueOf(registry, "process_resident_memory_bytes"));
  EXPECT_GE(ValueOf(registry, "process_threads"), 1);
  EXPECT_GT(ValueOf(registry, "process_max_fds"), ValueOf(registry, "process_open_fds"));
  const double now = static_cast<double>(std::time(nullptr));
  EXPECT_NEAR(ValueOf(registry, "process_start_time_seconds"), now, 120);
}

TEST(ProcessMetricsTest, SeesWhatChanged) {
  PrometheusRegistry registry;
  ProcessMetrics metrics(registry, "tilemend-test", "1.2.3");
  const double files = ValueOf(registry, "process_open_fds");
  const double cpu = ValueOf(registry, "process_cpu_seconds_total");
  const int fd = dup(0);
  const std::clock_t until = std::clock() + CLOCKS_PER_SEC / 20;
  while (std::clock() < until) {
  }
  metrics.Update();
  EXPECT_EQ(ValueOf(registry, "process_open_fds"), files + 1);
  EXPECT_GT(ValueOf(registry, "process_cpu_seconds_total"), cpu);
  close(fd);
}

TEST(MemoryLimitBytesTest, IsAtMostTheMemoryOfTheMachine) {
  const double machine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  EXPECT_GT(MemoryLimitBytes(), 0);
  EXPECT_LE(MemoryLimitBytes(), machine);
}

TEST(MemoryLimitBytesTest, IsTheLeastOfAGroupAndThoseAroundIt) {
  const TemporaryFolder folder;
  const std::string own = folder.Write("own", "3:cpu,cpuacct:/x\n0::/slice/service\n");
  EXPECT_GT(MemoryLimitBytes(own, folder.path()), 1e6);
  folder.Write("slice/service/memory.max", "max\n");
  folder.Write("slice/memory.max", "5000\n");
  EXPECT_EQ(MemoryLimitBytes(own, folder.path()), 5000);
  folder.Write("slice/service/memory.max", "4000\n");
  EXPECT_EQ(MemoryLimitBytes(own, folder.path()), 4000);
  folder.Write("memory.max", "3000\n");  // as a container sees its own
  EXPECT_EQ(MemoryLimitBytes(own, folder.path()), 3000);
  const std::string older = folder.Write("older", "4:memory:/job\nno line\n");
  folder.Write("memory/job/memory.limit_in_bytes", "2000\n");
  EXPECT_EQ(MemoryLimitBytes(older, folder.path()), 2000);
}

}  // namespace
}  // namespace tilemend
