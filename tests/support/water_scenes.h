// Scenes with a hole over nine cells in ground of a given shape.
#ifndef TILEMEND_TESTS_SUPPORT_WATER_SCENES_H_
#define TILEMEND_TESTS_SUPPORT_WATER_SCENES_H_

#include <cmath>
#include <functional>

#include "tests/support/scene_maker.h"

namespace tilemend {

inline constexpr double kWaterLevel = 12.3;

// Three by three cells of 40 m; the hole is about 100 m across, over all of them. The height at (x, y) is `ground(d, x,
// y)`, about d metres landward of the hole's rim (negative inside). Vertices are 2 m apart and have noise of 5 cm, peak
// to peak.
inline SceneMakerOptions HoleOverNineCells(Cut cut, const std::function<double(double d, double x, double y)>& ground) {
  SceneMakerOptions options;
  options.cols = options.rows = 3;
  options.cell_size = 40;
  options.spacing = 2;
  options.cut = cut;
  options.noise = 0.05;
  const EllipseHole hole{{61, 59}, {52, 47}};
  options.ellipses = {hole};
  options.terrain = [hole, ground](double x, double y) {
    const double from_centre = (Point2(x, y) - hole.centre).cwiseQuotient(hole.radii).norm();
    return ground((from_centre - 1) * hole.radii.mean(), x, y);
  };
  return options;
}

// A lake at kWaterLevel, with banks that rise by `bank` metres a metre.
inline SceneMakerOptions LakeOverNineCells(Cut cut, double bank = 0.1) {
  return HoleOverNineCells(cut, [bank](double d, double, double) { return kWaterLevel + bank * std::fmax(d, 0); });
}

// A valley that rises by `slope` metres a metre towards the east.
inline SceneMakerOptions ValleyOverNineCells(Cut cut, double slope) {
  return HoleOverNineCells(
      cut, [slope](double d, double x, double) { return kWaterLevel + slope * x + 0.1 * std::fmax(d, 0); });
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_WATER_SCENES_H_
