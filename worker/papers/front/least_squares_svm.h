// Regression by a least-squares support vector machine.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_LEAST_SQUARES_SVM_H_
#define TILEMEND_WORKER_PAPERS_FRONT_LEAST_SQUARES_SVM_H_

#include <Eigen/Core>
#include <optional>

namespace tilemend {

// A function f(x) = sum of a_i exp(-(x - x_i)^2 / (2 width^2)) + b, x a number (Xu 2014, eq. 15). The kernel is the
// usual one; the paper has none.
struct SvmFunction {
  Eigen::VectorXd at, weights;
  double offset = 0, width = 1;

  double operator()(double x) const;
};

// Learns f from samples (Xu 2014, eq. 14).
//   gamma  of eq. 11: how much errors count beside the smoothness of f; > 0
//   width  of the kernel; > 0
// Nothing without samples, or if the equations have no solution. O(samples^3), 8 samples^2 bytes.
std::optional<SvmFunction> LearnSvm(const Eigen::VectorXd& at, const Eigen::VectorXd& values, double gamma,
                                    double width);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_LEAST_SQUARES_SVM_H_
