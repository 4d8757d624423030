// A patch for the pond of OsgbScene.
#ifndef TILEMEND_TESTS_SUPPORT_POND_FAN_H_
#define TILEMEND_TESTS_SUPPORT_POND_FAN_H_

#include <cmath>
#include <cstdint>

#include "common/codec/mesh_file.h"
#include "tests/support/osgb_scene.h"

namespace tilemend {

// A fan at the pond's level over a part of it, for a surface with `first` vertices.
inline FilePatch FanInPond(int32_t first) {
  FilePatch patch;
  patch.new_points = {{56, 32, OsgbScene::kLevel}};
  for (int k = 0; k < 40; ++k) {
    const double angle = k * M_PI / 20;
    patch.new_points.emplace_back(56 + 7 * std::cos(angle), 32 + 7 * std::sin(angle), OsgbScene::kLevel);
    patch.triangles.push_back({first, first + 1 + k, first + 1 + (k + 1) % 40});
  }
  patch.like.assign(patch.new_points.size(), -1);
  patch.materials = {{0, "water"}};
  return patch;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_POND_FAN_H_
