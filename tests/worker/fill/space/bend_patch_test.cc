#include "worker/fill/space/bend_patch.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

TEST(BendPatchTest, GoesOnFlatInAFlatSheet) {
  const CellHoles work = WorkOfSheet(
      Disc(0, 5, 3), [](const Point3& p) { return p; }, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const std::vector<int32_t>& loop = hole.loops[0].vertices;
  Point3 middle = Point3::Zero();
  for (const Point3& p : hole.positions) middle += p / hole.size();
  std::vector<Triangle> fan;
  for (size_t i = 0; i < loop.size(); ++i) fan.push_back({loop[i], loop[(i + 1) % loop.size()], hole.size()});
  std::vector<Point3> shape = hole.positions;
  shape.push_back(middle);
  const std::vector<Point3> off = {middle + Point3(0, 0, 2)};
  const std::optional<std::vector<Point3>> bent = BendPatch(hole, shape, off, fan);
  ASSERT_TRUE(bent && bent->size() == 1);
  EXPECT_NEAR((*bent)[0].z(), middle.z(), 1e-9);
}

}  // namespace
}  // namespace tilemend
