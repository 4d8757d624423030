// Times RefineRegion on one core and prints the quality of its triangles.
#include <chrono>
#include <cstdio>

#include "tests/worker/fill/region/refine_quality.h"

namespace tilemend {
namespace {

using testing::SizedRegion;

void Report(const char* name, const SizedRegion& region, const RefineOptions& options) {
  double best = 1e9;
  RefinedRegion refined;
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    refined = RefineRegion(region.points, region.segments, region.size, options);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  if (!refined.triangulation.conflicts.empty()) {
    std::printf("%-24s conflicts %zu\n", name, refined.triangulation.conflicts.size());
    return;
  }
  const testing::Quality q = testing::Measure(region, refined);
  const size_t vertices = region.points.size() + refined.new_points.size();
  std::printf("%-24s %-8s rim %7zu new %8zu  %7.1f ms  %5.2f us/vertex  q mean %.4f p5 %.3f min %.3f inside %.3f\n",
              name, options.uniform ? "uniform" : "graded", region.points.size(), refined.new_points.size(), best * 1e3,
              best * 1e6 / static_cast<double>(vertices), q.mean, q.fifth_percentile, q.least, q.least_inside);
}

void Run() {
  for (bool uniform : {true, false}) {
    RefineOptions options;
    options.uniform = uniform;
    Report("river 2000x30", testing::River(2000, 30, 20000, 0.2, 1), options);
    Report("river 300x80", testing::River(300, 80, 20000, 0.2, 2), options);
    Report("river 3000x90", testing::River(3000, 90, 20000, 0.2, 3), options);
    Report("river even", testing::River(1000, 40, 20000, 0, 4), options);
    Report("river rough", testing::River(1000, 40, 20000, 0.35, 5), options);
    Report("disc 100", testing::Disc(100, 20000, 0.2, 6), options);
    Report("disc 290", testing::Disc(290, 20000, 0.1, 7), options);
    Report("grid square 100", testing::GridSquare(100, 20000), options);
    Report("thin river 4", testing::River(1000, 4, 20000, 0.15, 8), options);
  }
}

}  // namespace
}  // namespace tilemend

int main() { tilemend::Run(); }
