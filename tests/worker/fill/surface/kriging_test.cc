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

TEST(KrigingTest, TheLikelihoodCountsWhatTheDriftDoesNotExplain) {
  const auto tilted = [](const Point2& p) { return Hill(p) + 20 + 0.7 * p.x() - 0.2 * p.y(); };
  for (const double tension : {0.0, 30.0}) {
    const double level = Kriging(Samples(Hill), kWidth, tension).LogLikelihood(1e-4);
    EXPECT_NEAR(Kriging(Samples(tilted), kWidth, tension).LogLikelihood(1e-4), level, 1e-5 * std::abs(level));
  }
}

TEST(KrigingTest, TurningTheSamplesChangesNothing) {
  std::vector<Point3> samples = Samples(Hill);
  const double before = Kriging(samples, kWidth, 10).LogLikelihood(1e-3);
  for (Point3& p : samples) p.head<2>() = Point2(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y());
  EXPECT_NEAR(Kriging(samples, kWidth, 10).LogLikelihood(1e-3), before, 1e-6 * std::abs(before));
}

TEST(KrigingTest, RoughHeightsAreLikelierWithNoise) {
  std::mt19937 random(9);
  std::normal_distribution<double> rough(0, 0.5);
  const Kriging smooth(Samples(Hill), kWidth, 10);
  const Kriging noisy(Samples([&](const Point2& p) { return Hill(p) + rough(random); }), kWidth, 10);
  EXPECT_GT(smooth.LogLikelihood(1e-6), smooth.LogLikelihood(1e-1));
  EXPECT_LT(noisy.LogLikelihood(1e-6), noisy.LogLikelihood(1e-1));
}

}  // namespace
}  // namespace tilemend
