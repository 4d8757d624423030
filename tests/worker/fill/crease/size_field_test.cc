#include "worker/fill/crease/size_field.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

CreaseCurve Straight(const Point3& from, const Point3& to) { return {0, 1, from, to, to - from, to - from}; }

class SizeFieldTest : public testing::Test {
 protected:
  const CellHoles work_ = WorkOfSheet(
      Disc(0, 5, 8), [](const Point3& p) { return p; }, 0);
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
};

TEST_F(SizeFieldTest, GrowsFromTheRimInward) {
  const SizeField size(hole_, {});
  EXPECT_DOUBLE_EQ(size.At(hole_.positions[3]), hole_.sizes[3]);
  EXPECT_GT(size.At(Point3(0, 5, 0)), 2);
  RefineOptions limited;
  limited.size_limit = 1.5;
  EXPECT_NEAR(SizeField(hole_, limited).At(Point3(0, 5, 0)), 1.5, 1e-9);
}

TEST_F(SizeFieldTest, KeepsTheRimsSizeWhenUniform) {
  RefineOptions uniform;
  uniform.uniform = true;
  EXPECT_NEAR(SizeField(hole_, uniform).At(Point3(0, 5, 0)), 1, 1e-9);
}

TEST_F(SizeFieldTest, PutsPointsFurtherApartInside) {
  const std::vector<Point3> points = PointsAlong(Straight({-7.5, 5, 0}, {7.5, 5, 0}), SizeField(hole_, {}), 0);
  ASSERT_GT(points.size(), 4u);
  EXPECT_LT(points.size(), 14u);
  const double outer = (points[1] - points[0]).norm();
  const double inner = (points[points.size() / 2] - points[points.size() / 2 - 1]).norm();
  EXPECT_GT(inner, outer);
  for (size_t k = 0; k < points.size(); ++k) {
    EXPECT_NEAR(points[k].x(), -points[points.size() - 1 - k].x(), 0.02) << "alike from both ends";
  }
}

TEST_F(SizeFieldTest, PutsAsManyAsAskedForOnAShortCurve) {
  const CreaseCurve curve = Straight({0, 5, 0}, {0.2, 5, 0});
  EXPECT_TRUE(PointsAlong(curve, SizeField(hole_, {}), 0).empty());
  EXPECT_EQ(PointsAlong(curve, SizeField(hole_, {}), 1).size(), 1u);
}

}  // namespace
}  // namespace tilemend
