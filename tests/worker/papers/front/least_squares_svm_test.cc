#include "worker/papers/front/least_squares_svm.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tilemend {
namespace {

struct Sine {
  Eigen::VectorXd at = Eigen::VectorXd::LinSpaced(41, 0, 4), values = at.array().sin();
};

TEST(LeastSquaresSvmTest, FollowsItsSamples) {
  const Sine sine;
  const auto f = LearnSvm(sine.at, sine.values, 1e6, 0.5);
  ASSERT_TRUE(f.has_value());
  for (const double x : {0.33, 1.0, 2.22, 3.7}) EXPECT_NEAR((*f)(x), std::sin(x), 1e-3);
}

TEST(LeastSquaresSvmTest, SolvesEquation14) {
  const Sine sine;
  const auto f = LearnSvm(sine.at, sine.values, 10, 0.5);
  ASSERT_TRUE(f.has_value());
  EXPECT_NEAR(f->weights.sum(), 0, 1e-9);
  for (Eigen::Index i = 0; i < sine.at.size(); ++i) {
    EXPECT_NEAR((*f)(sine.at[i]) + f->weights[i] / 10, sine.values[i], 1e-9);
  }
}

TEST(LeastSquaresSvmTest, GivesAConstantWhereErrorsCountForNothing) {
  const Sine sine;
  const auto f = LearnSvm(sine.at, sine.values, 1e-9, 0.5);
  ASSERT_TRUE(f.has_value());
  EXPECT_NEAR((*f)(0.5), sine.values.mean(), 1e-6);
  EXPECT_NEAR((*f)(3.5), sine.values.mean(), 1e-6);
}

TEST(LeastSquaresSvmTest, LearnsNothingFromNothing) { EXPECT_FALSE(LearnSvm({}, {}, 1, 1).has_value()); }

}  // namespace
}  // namespace tilemend
