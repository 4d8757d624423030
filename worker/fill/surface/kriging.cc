#include "worker/fill/surface/kriging.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tilemend {
namespace {

// Variance of a sample, over the largest of the kernel: the matrix stays positive definite where points all but
// coincide.
constexpr double kNugget = 1e-12;

// The inverse of a positive definite matrix. Both halves of the work, L^-1 and L^-T L^-1, leave out what is zero.
Eigen::MatrixXd InverseOfPositive(const Eigen::MatrixXd& matrix) {
  constexpr Eigen::Index kColumns = 32;
  const Eigen::Index n = matrix.rows();
  const Eigen::MatrixXd lower = matrix.llt().matrixL();
  Eigen::MatrixXd lower_inverse = Eigen::MatrixXd::Zero(n, n), upper_half = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; j += kColumns) {
    const Eigen::Index width = std::min(kColumns, n - j);
    auto columns = lower_inverse.block(j, j, n - j, width);
    columns.setIdentity();
    lower.bottomRightCorner(n - j, n - j).triangularView<Eigen::Lower>().solveInPlace(columns);
    upper_half.block(0, j, j + width, width).noalias() =
        lower_inverse.block(j, 0, n - j, j + width).transpose() * columns;
  }
  return upper_half.selfadjointView<Eigen::Upper>();
}

}  // namespace

Kriging::Kriging(const std::vector<Point3>& samples, double width, double tension, Drift drift)
    : samples_(samples),
      width_(width),
      tension_(tension),
      drift_terms_(static_cast<Eigen::Index>(drift)),
      matrix_(samples.size(), samples.size()),
      heights_(samples.size()) {
  const Eigen::Index n = matrix_.rows();
  Eigen::MatrixXd terms(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Point3 p = samples[i] - samples[0];
    terms.row(i) << 1, p.x() / width, p.y() / width;
    heights_[i] = p.z();
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index below = n - i - 1;
    const Eigen::MatrixXd way = terms.bottomRows(below).rowwise() - terms.row(i);
    matrix_.col(i).tail(below) = TensionKernel(way.rowwise().norm().array(), tension).matrix();
    matrix_.row(i).tail(below) = matrix_.col(i).tail(below).transpose();
  }
  matrix_.diagonal().setConstant(TensionKernelAtZero(tension));
  matrix_.diagonal().array() += kNugget * matrix_.cwiseAbs().maxCoeff();
  reflections_.compute(terms.leftCols(drift_terms_));
  matrix_.applyOnTheLeft(reflections_.householderQ().adjoint());
  matrix_.applyOnTheRight(reflections_.householderQ());
}

HeightTrend Kriging::Trend(double noise) const {
  const Eigen::Index n = matrix_.rows(), free = n - drift_terms_;
  Eigen::MatrixXd covariance = matrix_.bottomRightCorner(free, free);
  covariance.diagonal().array() += noise;
  const Eigen::VectorXd reflected = reflections_.householderQ().adjoint() * heights_;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(n);
  weights.tail(free) = covariance.llt().solve(reflected.tail(free));
  const Eigen::VectorXd unexplained =
      reflected.head(drift_terms_) - matrix_.topRightCorner(drift_terms_, free) * weights.tail(free);
  HeightTrend trend(tension_);
  trend.origin_ = samples_[0];
  trend.width_ = width_;
  for (const Point3& p : samples_) trend.places_.emplace_back(p.head<2>());
  trend.drift_.head(drift_terms_) = reflections_.matrixQR()
                                        .topLeftCorner(drift_terms_, drift_terms_)
                                        .triangularView<Eigen::Upper>()
                                        .solve(unexplained);
  trend.weights_ = reflections_.householderQ() * weights;
  return trend;
}

double HeightTrend::At(const Point2& place) const {
  const Point2 way = (place - origin_.head<2>()) / width_;
  double height = origin_.z() + drift_[0] + drift_.tail<2>().dot(way);
  for (size_t i = 0; i < places_.size(); ++i) {
    height += weights_[static_cast<Eigen::Index>(i)] * kernel_.At((place - places_[i]).norm() / width_);
  }
  return height;
}

std::vector<Eigen::VectorXd> Kriging::BlockErrors(const std::vector<SampleBlocks>& divisions) const {
  const Eigen::MatrixXd inverse = Inverse();
  const Eigen::VectorXd weights = inverse * heights_;
  std::vector<Eigen::VectorXd> errors;
  for (const SampleBlocks& blocks : divisions) {
    Eigen::VectorXd of_division(static_cast<Eigen::Index>(blocks.size()));
    for (size_t b = 0; b < blocks.size(); ++b) {
      const Eigen::MatrixXd own = inverse(blocks[b], blocks[b]);
      const Eigen::VectorXd error = own.partialPivLu().solve(weights(blocks[b]));
      of_division[static_cast<Eigen::Index>(b)] = error.cwiseAbs().mean();
    }
    errors.push_back(std::move(of_division));
  }
  return errors;
}

// The inverse of the kriging matrix, without the rows and columns of the drift.
Eigen::MatrixXd Kriging::Inverse() const {
  const Eigen::Index n = matrix_.rows(), free = n - drift_terms_;
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(n, n);
  inverse.bottomRightCorner(free, free) = InverseOfPositive(matrix_.bottomRightCorner(free, free));
  inverse.applyOnTheLeft(reflections_.householderQ());
  inverse.applyOnTheRight(reflections_.householderQ().adjoint());
  return inverse;
}

}  // namespace tilemend
