#include "worker/fill/surface/plate_equations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "tests/worker/fill/surface/plates.h"

namespace tilemend {
namespace {

using testing::Everywhere;
using testing::Hills;
using testing::MakePlate;
using testing::Noise;
using testing::Nowhere;
using testing::Plate;

// A plate on which all heights are known to the test, also those of unknown points.
PointValues Heights(const Plate& plate, const HeightFunction& height) {
  PointValues values(static_cast<Eigen::Index>(plate.problem.points.size()));
  for (const auto& [place, v] : plate.at) values[static_cast<Eigen::Index>(v)] = height(place.first, place.second);
  return values;
}

TEST(PlateEquationsTest, TheMatrixIsTheOperator) {
  for (const double tension : {0.0, 0.3}) {
    const Plate plate = MakePlate(Hills, Everywhere, Nowhere);
    const PlateEquations equations(plate.problem, true, tension);
    const PointValues x = Noise(plate.problem, false);
    const Eigen::VectorXd product = equations.LowerMatrix().selfadjointView<Eigen::Lower>() * equations.Gather(x);
    EXPECT_LT((product - equations.Gather(equations.Apply(x))).cwiseAbs().maxCoeff(), 1e-10);
    const Eigen::VectorXd diagonal = equations.LowerMatrix().diagonal();
    EXPECT_LT((diagonal - equations.Gather(equations.Diagonal())).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(PlateEquationsTest, KnowTheLaplacianOfAParaboloid) {
  const auto bowl = [](double x, double y) { return 0.5 * x * x + 0.25 * y * y - 3 * x + 7; };
  const Plate plate = MakePlate(bowl, Everywhere, Nowhere);
  const PointValues laplacians = PlateEquations(plate.problem, true, 0).Laplacians(Heights(plate, bowl));
  for (Eigen::Index v = 0; v < laplacians.size(); ++v) {
    EXPECT_NEAR(laplacians[v], plate.problem.has_equation[v] ? 1.5 : 0, 1e-9);
  }
}

// Along a plane of any slope they are those over the plane, seen from above.
TEST(PlateEquationsTest, AlongAPlaneAreThoseOfThePlane) {
  Plate tilted = MakePlate(Hills, Everywhere, Nowhere), flat = tilted;
  for (Point3& p : tilted.problem.points) tilted.problem.along.emplace_back(p.x(), p.y(), 0.75 * p.x());
  for (Point3& p : flat.problem.points) p.x() *= 1.25;
  const PlateEquations along(tilted.problem, true, 0.1), over(flat.problem, true, 0.1);
  const PointValues x = Noise(flat.problem, false);
  EXPECT_LT((along.Apply(x) - over.Apply(x)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(PlateEquationsTest, GiveTheLaplaciansThatAreKnownWhereThereIsNoEquation) {
  const auto middle = [](double x, double y) { return x == 0 && y == 0; };
  Plate plate = MakePlate(Hills, Everywhere, middle);
  const auto v = static_cast<Eigen::Index>(plate.at.at({0, 0}));
  plate.problem.laplacian.resize(plate.problem.points.size());
  plate.problem.laplacian[v] = 0.25;
  EXPECT_EQ(PlateEquations(plate.problem, true, 0).Laplacians(Heights(plate, Hills))[v], 0.25);
}

TEST(PlateEquationsTest, AreSolvedByAPlaneWhateverTheTension) {
  const auto plane = [](double x, double y) { return 400 + 0.5 * x - 0.25 * y; };
  const Plate plate = MakePlate(plane, Everywhere, Nowhere);
  for (const double tension : {0.0, 0.3, 100.0}) {
    for (const bool bends : {true, false}) {
      const PlateEquations equations(plate.problem, bends, tension);
      EXPECT_LT(equations.Residual(Heights(plate, plane)).cwiseAbs().maxCoeff(), 1e-8);
    }
  }
}

TEST(PlateEquationsTest, TheResidualOfNoHeightsIsTheRightSide) {
  const Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  const PlateEquations equations(plate.problem, true, 0.1);
  const PointValues known =
      Heights(plate, Hills)
          .cwiseProduct(PointValues::NullaryExpr(static_cast<Eigen::Index>(plate.problem.points.size()),
                                                 [&](Eigen::Index v) { return plate.problem.known[v] ? 1.0 : 0.0; }));
  const PointValues x = Noise(plate.problem, false);
  const PointValues changed = equations.Residual(known) - equations.Residual(known + x);
  EXPECT_LT((changed - equations.Apply(x)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(PlateEquationsTest, TheEnergyOfACorrectionIsItsProductWithTheOperator) {
  const Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  const PlateEquations equations(plate.problem, true, 0);
  const PointValues x = Noise(plate.problem, false);
  EXPECT_NEAR(equations.Energy(x), x.dot(equations.Apply(x)), 1e-9 * equations.Energy(x));
}

TEST(PlateEquationsTest, GatherAndSpreadAreInverse) {
  const Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  const PlateEquations equations(plate.problem, true, 0);
  EXPECT_EQ(equations.unknown_count(), (2 * testing::kHalf - 1) * (2 * testing::kHalf - 1));
  const PointValues x = Noise(plate.problem, false);
  EXPECT_EQ(equations.Spread(equations.Gather(x)), x);
}

}  // namespace
}  // namespace tilemend
