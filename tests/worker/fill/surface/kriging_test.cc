#include "worker/fill/surface/kriging.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace tilemend {
namespace {

constexpr double kWidth = 10;

double Hill(const Point2& p) { return std::sin(0.4 * p.x()) * std::cos(0.3 * p.y()) + 0.1 * p.x(); }

// Scattered places over a square of the width.
std::vector<Point3> Samples(const std::function<double(const Point2&)>& height, size_t count = 40) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> within(0, kWidth);
  std::vector<Point3> samples;
  while (samples.size() < count) {
    const double x = within(random), y = within(random);
    samples.emplace_back(x, y, height({x, y}));
  }
  return samples;
}

SampleBlocks Singles(size_t count) {
  SampleBlocks blocks;
  for (size_t i = 0; i < count; ++i) blocks.push_back({static_cast<int>(i)});
  return blocks;
}

// The height at `place` of the thin-plate spline through samples: the kernel of no tension with a linear drift.
double Spline(const std::vector<Point3>& samples, const Point2& place) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  const auto kernel = [](double r) { return r > 0 ? r * r * std::log(r) / (8 * std::numbers::pi) : 0; };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 3, n + 3);
  Eigen::VectorXd heights = Eigen::VectorXd::Zero(n + 3), row = Eigen::VectorXd::Zero(n + 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Point2 p = samples[i].head<2>();
    for (Eigen::Index k = 0; k < n; ++k) matrix(i, k) = kernel((p - samples[k].head<2>()).norm());
    matrix.block(i, n, 1, 3) << 1, p.x(), p.y();
    matrix.block(n, i, 3, 1) = matrix.block(i, n, 1, 3).transpose();
    heights[i] = samples[i].z();
    row[i] = kernel((p - place).norm());
  }
  row.tail(3) << 1, place.x(), place.y();
  return row.dot(matrix.fullPivLu().solve(heights));
}

TEST(KrigingTest, LeavesASampleOutAsTheSplineOfTheOthersDoes) {
  const std::vector<Point3> samples = Samples(Hill, 20);
  const auto errors = Kriging(samples, kWidth, 0).BlockErrors({Singles(samples.size())});
  for (size_t i = 0; i < samples.size(); ++i) {
    std::vector<Point3> others = samples;
    others.erase(others.begin() + static_cast<ptrdiff_t>(i));
    const double error = std::abs(Spline(others, samples[i].head<2>()) - samples[i].z());
    EXPECT_NEAR(errors[0][static_cast<Eigen::Index>(i)], error, 1e-5 * (1 + error)) << i;
  }
}

TEST(KrigingTest, ForetellsAPlaneExactly) {
  const std::vector<Point3> samples = Samples([](const Point2& p) { return 5 + 0.3 * p.x() - 2 * p.y(); });
  for (const double tension : {0.0, 10.0, 300.0}) {
    const auto errors = Kriging(samples, kWidth, tension).BlockErrors({Singles(samples.size()), {{0, 1, 2, 3, 4}}});
    for (const Eigen::VectorXd& e : errors) EXPECT_LT(e.maxCoeff(), 1e-6) << tension;
  }
}

TEST(KrigingTest, ItsTrendIsTheSplineThroughTheSamples) {
  const std::vector<Point3> samples = Samples(Hill);
  const HeightTrend trend = Kriging(samples, kWidth, 0).Trend(0);
  for (const Point2& place : {Point2(3, 4), Point2(-6, 2), Point2(25, 30)}) {
    EXPECT_NEAR(trend.At(place), Spline(samples, place), 1e-6);
  }
  for (const Point3& p : samples) EXPECT_NEAR(trend.At(p.head<2>()), p.z(), 1e-6);
}

TEST(KrigingTest, NoiseDrawsTheTrendTowardsThePlane) {
  const auto plane = [](const Point2& p) { return 2 + 0.3 * p.x() - 0.1 * p.y(); };
  std::vector<Point3> samples = Samples(plane);
  samples[0].z() += 1;
  const Point2 place = samples[0].head<2>();
  const double with = Kriging(samples, kWidth, 0).Trend(1).At(place);
  EXPECT_NEAR(Kriging(samples, kWidth, 0).Trend(0).At(place), plane(place) + 1, 1e-6);
  EXPECT_GT(with, plane(place));
  EXPECT_LT(with, plane(place) + 0.2);
}

// Far away a plane goes on, and what has but a mean in common is level.
TEST(KrigingTest, WithoutALinearDriftNothingRisesForEver) {
  const std::vector<Point3> samples = Samples([](const Point2& p) { return 0.3 * p.x(); });
  const auto rise = [&](Kriging::Drift drift) {
    const HeightTrend trend = Kriging(samples, kWidth, 10, drift).Trend(0);
    EXPECT_NEAR(trend.At(samples[3].head<2>()), samples[3].z(), 1e-6);
    return trend.At({200, 5}) - trend.At({100, 5});
  };
  EXPECT_NEAR(rise(Kriging::Drift::kLinear), 30, 1e-6);
  EXPECT_NEAR(rise(Kriging::Drift::kConstant), 0, 0.1);
}

TEST(KrigingTest, TurningTheSamplesChangesNothing) {
  std::vector<Point3> samples = Samples(Hill);
  const auto errors = [&] { return Kriging(samples, kWidth, 10).BlockErrors({Singles(samples.size())})[0]; };
  const Eigen::VectorXd before = errors();
  for (Point3& p : samples) p.head<2>() = Point2(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y());
  EXPECT_LT((errors() - before).cwiseAbs().maxCoeff(), 1e-6 * before.maxCoeff());
}

}  // namespace
}  // namespace tilemend
