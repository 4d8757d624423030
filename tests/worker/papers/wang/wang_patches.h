// Patches for tests of the steps of Wang's surface.
#ifndef TILEMEND_TESTS_WORKER_FILL_WANG_WANG_PATCHES_H_
#define TILEMEND_TESTS_WORKER_FILL_WANG_WANG_PATCHES_H_

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "worker/fill/shape/new_patch.h"

namespace tilemend {

// A square of n x n cells of one metre, each cut into two triangles; the outer points are the rim. `height` of all.
inline NewPatch SquarePatch(int32_t n, const std::function<double(double, double)>& height) {
  NewPatch patch;
  std::vector<int32_t> number(static_cast<size_t>((n + 1) * (n + 1)), -1);
  const auto add = [&](bool rim) {
    for (int32_t y = 0; y <= n; ++y) {
      for (int32_t x = 0; x <= n; ++x) {
        if ((x == 0 || y == 0 || x == n || y == n) != rim) continue;
        number[y * (n + 1) + x] = patch.size();
        patch.points.emplace_back(x, y, height(x, y));
        patch.sizes.push_back(1);
      }
    }
  };
  add(true);
  patch.rim_count = patch.size();
  add(false);
  const auto at = [&](int32_t x, int32_t y) { return number[y * (n + 1) + x]; };
  for (int32_t y = 0; y < n; ++y) {
    for (int32_t x = 0; x < n; ++x) {
      patch.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      patch.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return patch;
}

// Nothing around it: it bends freely at its rim.
inline PatchSurroundings NothingAround(const NewPatch& patch) {
  return {{}, {}, std::vector<bool>(static_cast<size_t>(patch.rim_count), false)};
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_WORKER_FILL_WANG_WANG_PATCHES_H_
