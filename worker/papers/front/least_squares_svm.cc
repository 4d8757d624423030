#include "worker/papers/front/least_squares_svm.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace tilemend {
namespace {

double Kernel(double x, double y, double width) { return std::exp(-(x - y) * (x - y) / (2 * width * width)); }

}  // namespace

double SvmFunction::operator()(double x) const {
  double sum = offset;
  for (Eigen::Index i = 0; i < at.size(); ++i) sum += weights[i] * Kernel(x, at[i], width);
  return sum;
}

std::optional<SvmFunction> LearnSvm(const Eigen::VectorXd& at, const Eigen::VectorXd& values, double gamma,
                                    double width) {
  const Eigen::Index n = at.size();
  if (n == 0) return std::nullopt;
  Eigen::MatrixXd kernel(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) kernel(i, k) = Kernel(at[i], at[k], width) + (i == k ? 1 / gamma : 0);
  }
  const Eigen::LLT<Eigen::MatrixXd> solver(kernel);
  if (solver.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd ones = solver.solve(Eigen::VectorXd::Ones(n)), own = solver.solve(values);
  SvmFunction f{at, {}, own.sum() / ones.sum(), width};
  f.weights = own - f.offset * ones;
  if (!f.weights.allFinite() || !std::isfinite(f.offset)) return std::nullopt;
  return f;
}

}  // namespace tilemend
