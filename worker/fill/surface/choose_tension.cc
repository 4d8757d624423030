#include "worker/fill/surface/choose_tension.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <unordered_map>
#include <unsupported/Eigen/SpecialFunctions>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

constexpr std::array<double, 6> kCandidates = {0, 3, 10, 30, 100, 300};  // times 1 / width^2, rising
constexpr size_t kStart = 2;        // the likeliest candidate before any height is known
constexpr double kStepPenalty = 1;  // of log-likelihood, for each step away from it
constexpr double kLeastNoise = 1e-7, kMostNoise = 1, kNoiseStep = 10;  // variances of a height, over the kernel's scale
constexpr std::array<double, 2> kBlockSides = {0.5, 1.0};              // times width
constexpr std::array<std::pair<double, double>, 4> kBlockOffsets = {
    {{0, 0}, {0.5, 0.5}, {0.5, 0}, {0, 0.5}}};  // times the side
constexpr size_t kMostRimPoints = 100;
constexpr size_t kLeastBlocks = 4;
constexpr double kThinning = 1.2;
constexpr double kWidthShare = 0.5;
// Variance of a sample, over the largest of the kernel: the matrix stays positive definite where points all but
// coincide.
constexpr double kNugget = 1e-12;

using BlockKey = std::pair<int64_t, int64_t>;

BlockKey KeyOf(const Point3& p, double side, double x_offset, double y_offset) {
  return {static_cast<int64_t>(std::floor(p.x() / side + x_offset)),
          static_cast<int64_t>(std::floor(p.y() / side + y_offset))};
}

bool IsLess(const Point3& a, const Point3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

bool IsRim(const ThinPlateProblem& problem, int32_t v) { return problem.known[v] && problem.has_equation[v]; }

// The rim points of the problem, by position.
std::vector<int32_t> RimOf(const ThinPlateProblem& problem) {
  std::vector<int32_t> rim;
  for (size_t v = 0; v < problem.points.size(); ++v) {
    if (IsRim(problem, static_cast<int32_t>(v))) rim.push_back(static_cast<int32_t>(v));
  }
  std::sort(rim.begin(), rim.end(), [&](int32_t a, int32_t b) { return IsLess(problem.points[a], problem.points[b]); });
  return rim;
}

double Circumdiameter(const Point3& a, const Point3& b, const Point3& c, double area) {
  return (a - b).head<2>().norm() * (b - c).head<2>().norm() * (c - a).head<2>().norm() / (2 * area);
}

// One point for each square of a raster, as coarse as it takes to leave few enough; `step` is its spacing.
std::vector<int32_t> Thinned(const ThinPlateProblem& problem, const std::vector<int32_t>& rim, double& step) {
  std::vector<int32_t> kept = rim;
  while (kept.size() > kMostRimPoints) {
    step *= kThinning;
    std::set<BlockKey> taken;
    kept.clear();
    for (const int32_t v : rim) {
      if (taken.insert(KeyOf(problem.points[v], step, 0, 0)).second) kept.push_back(v);
      if (kept.size() > kMostRimPoints) break;
    }
  }
  return kept;
}

// The rim points and, for each, the farthest point beside it: the two together tell the slope there.
std::vector<Point3> Samples(const ThinPlateProblem& problem, const std::vector<int32_t>& rim) {
  constexpr int32_t kNotAsked = -2, kNone = -1;
  std::vector<int32_t> beside(problem.points.size(), kNotAsked);
  for (const int32_t v : rim) beside[v] = kNone;
  const auto distance = [&](int32_t a, int32_t b) { return (problem.points[a] - problem.points[b]).head<2>().norm(); };
  for (const Triangle& t : problem.band) {
    for (const int32_t v : t) {
      int32_t& best = beside[v];
      if (best == kNotAsked) continue;
      for (const int32_t u : t) {
        if (IsRim(problem, u)) continue;
        const double gain = best < 0 ? 1 : distance(v, u) - distance(v, best);
        if (gain > 0 || (gain == 0 && IsLess(problem.points[u], problem.points[best]))) best = u;
      }
    }
  }
  std::set<int32_t> used;
  for (const int32_t v : rim) {
    used.insert(v);
    if (beside[v] != kNone) used.insert(beside[v]);
  }
  std::vector<Point3> samples;
  for (const int32_t v : used) samples.push_back(problem.points[v]);
  std::sort(samples.begin(), samples.end(), IsLess);
  const auto same_place = [](const Point3& a, const Point3& b) { return a.head<2>() == b.head<2>(); };
  samples.erase(std::unique(samples.begin(), samples.end(), same_place), samples.end());
  return samples;
}

// A division of the samples into blocks.
std::vector<std::vector<int>> Blocks(const std::vector<Point3>& samples, double side, double x_offset,
                                     double y_offset) {
  std::map<BlockKey, std::vector<int>> blocks;
  for (size_t i = 0; i < samples.size(); ++i) {
    blocks[KeyOf(samples[i], side, x_offset, y_offset)].push_back(static_cast<int>(i));
  }
  std::vector<std::vector<int>> list;
  for (auto& [key, block] : blocks) list.push_back(std::move(block));
  return list;
}

// The kernel at distances above 0, in units of the hole's width, tension in units of 1 / width^2. ln r + K0(x) tends to
// ln(2 / scale) - Euler's constant.
Eigen::ArrayXd Kernel(const Eigen::ArrayXd& r, double tension) {
  if (tension == 0) return r.square() * r.log() / (8 * std::numbers::pi);
  constexpr double kFar = 30;  // K0 is below 1e-13 there
  const Eigen::ArrayXd x = (std::sqrt(tension) * r).min(kFar);
  return (r.log() + Eigen::bessel_k0(x)) / (-2 * std::numbers::pi * tension);
}

double KernelAtZero(double tension) {
  if (tension == 0) return 0;
  return (std::log(2 / std::sqrt(tension)) - std::numbers::egamma) / (-2 * std::numbers::pi * tension);
}

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

// What the plate with one tension foretells of the samples.
class Kriging {
 public:
  Kriging(const std::vector<Point3>& samples, double width, double tension)
      : matrix_(samples.size(), samples.size()), heights_(samples.size()) {
    const Eigen::Index n = matrix_.rows();
    Eigen::MatrixXd drift(n, kDrift);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Point3 p = samples[i] - samples[0];
      drift.row(i) << 1, p.x() / width, p.y() / width;
      heights_[i] = p.z();
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Index below = n - i - 1;
      const Eigen::MatrixXd way = drift.bottomRows(below).rowwise() - drift.row(i);
      matrix_.col(i).tail(below) = Kernel(way.rowwise().norm().array(), tension).matrix();
      matrix_.row(i).tail(below) = matrix_.col(i).tail(below).transpose();
    }
    matrix_.diagonal().setConstant(KernelAtZero(tension));
    matrix_.diagonal().array() += kNugget * matrix_.cwiseAbs().maxCoeff();
    reflections_.compute(drift);
    matrix_.applyOnTheLeft(reflections_.householderQ().adjoint());
    matrix_.applyOnTheRight(reflections_.householderQ());
  }

  // Of the heights, but for what the drift explains and for a constant; with the scale of heights that suits them best.
  //   noise  variance of each height by itself, over that scale
  double LogLikelihood(double noise) const {
    const Eigen::Index free = matrix_.rows() - kDrift;
    Eigen::MatrixXd covariance = matrix_.bottomRightCorner(free, free);
    covariance.diagonal().array() += noise;
    const Eigen::LLT<Eigen::MatrixXd> factors(covariance);
    const Eigen::VectorXd reflected = reflections_.householderQ().adjoint() * heights_;
    const Eigen::VectorXd whitened = factors.matrixL().solve(reflected.tail(free));
    const auto n = static_cast<double>(free);
    return -n / 2 * std::log(whitened.squaredNorm() / n) - factors.matrixLLT().diagonal().array().log().sum();
  }

  // The mean |error| of each block of each division, when it is left out.
  std::vector<Eigen::VectorXd> BlockErrors(const std::vector<std::vector<std::vector<int>>>& divisions) const {
    const Eigen::MatrixXd inverse = Inverse();
    const Eigen::VectorXd weights = inverse * heights_;
    std::vector<Eigen::VectorXd> errors;
    for (const auto& blocks : divisions) {
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

 private:
  static constexpr Eigen::Index kDrift = 3;  // linear

  // The inverse of the kriging matrix, without the rows and columns of the drift.
  Eigen::MatrixXd Inverse() const {
    const Eigen::Index n = matrix_.rows(), free = n - kDrift;
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(n, n);
    inverse.bottomRightCorner(free, free) = InverseOfPositive(matrix_.bottomRightCorner(free, free));
    inverse.applyOnTheLeft(reflections_.householderQ());
    inverse.applyOnTheRight(reflections_.householderQ().adjoint());
    return inverse;
  }

  // The covariances after reflections that take the drift to the first coordinates: positive definite in the others
  // (Wahba 1990, 2.4).
  Eigen::MatrixXd matrix_;
  Eigen::HouseholderQR<Eigen::MatrixXd> reflections_;
  Eigen::VectorXd heights_;
};

// The first noise of the ladder that the next one does not better. What is rough at the scale of a triangle says
// nothing of the hole's.
double LikeliestNoise(const Kriging& kriging) {
  double best = 0, likelihood = kriging.LogLikelihood(0);
  for (double noise = kLeastNoise; noise <= kMostNoise; noise *= kNoiseStep) {
    const double next = kriging.LogLikelihood(noise);
    if (next <= likelihood) break;
    best = noise;
    likelihood = next;
  }
  return best;
}

double Mean(const std::vector<Eigen::VectorXd>& errors) {
  double sum = 0;
  for (const Eigen::VectorXd& e : errors) sum += e.mean();
  return sum / static_cast<double>(errors.size());
}

}  // namespace

double HoleWidth(std::span<const Point3> points, std::span<const RegionSegment> segments) {
  if (segments.empty()) return 0;
  Point2 lo = points[segments[0].from].head<2>(), hi = lo;
  for (const RegionSegment& s : segments) {
    lo = lo.cwiseMin(points[s.from].head<2>());
    hi = hi.cwiseMax(points[s.from].head<2>());
  }
  const LatticeWindow window(lo, hi);
  std::vector<LatticePoint> lattice;
  std::vector<RegionSegment> own;
  std::unordered_map<int32_t, int32_t> number;
  const auto local = [&](int32_t v) {
    const auto [it, fresh] = number.try_emplace(v, static_cast<int32_t>(lattice.size()));
    if (fresh) lattice.push_back(window.Round(points[v].head<2>()));
    return it->second;
  };
  for (const RegionSegment& s : segments) {
    const int32_t from = local(s.from);
    own.push_back({from, local(s.to)});
  }
  std::vector<std::pair<double, double>> shares;  // circumdiameter, area
  double total = 0;
  std::vector<Point3> flat;
  for (const LatticePoint& p : lattice) flat.emplace_back(window.ToMetres(p).x(), window.ToMetres(p).y(), 0);
  for (const Triangle& t : TriangulateRegion(lattice, own).triangles) {
    const Point3 &a = flat[t[0]], &b = flat[t[1]], &c = flat[t[2]];
    const double area = (b - a).cross(c - a).z() / 2;
    shares.emplace_back(Circumdiameter(a, b, c, area), area);
    total += area;
  }
  std::sort(shares.begin(), shares.end());
  double sum = 0;
  for (const auto& [diameter, area] : shares) {
    sum += area;
    if (sum >= kWidthShare * total) return diameter;
  }
  return 0;
}

HoldOut ChooseTension(const ThinPlateProblem& problem, double width) {
  HoldOut choice;
  const std::vector<int32_t> rim = RimOf(problem);
  if (rim.size() < kLeastRimForHoldOut || !(width > 0)) return choice;
  double step = width / static_cast<double>(kMostRimPoints);
  const std::vector<Point3> samples = Samples(problem, Thinned(problem, rim, step));
  std::vector<std::vector<std::vector<int>>> divisions;
  for (const double side : kBlockSides) {
    for (const auto& [x, y] : kBlockOffsets) {
      auto blocks = Blocks(samples, std::max(side * width, 2 * step), x, y);
      if (blocks.size() >= kLeastBlocks) divisions.push_back(std::move(blocks));
    }
  }
  if (divisions.empty()) return choice;
  std::array<std::optional<Kriging>, kCandidates.size()> krigings;
  const auto kriging = [&](size_t c) -> const Kriging& {
    if (!krigings[c]) krigings[c].emplace(samples, width, kCandidates[c]);
    return *krigings[c];
  };
  const double noise = LikeliestNoise(kriging(kStart));
  std::array<std::optional<double>, kCandidates.size()> scores;
  const auto score = [&](size_t c) {
    if (!scores[c]) {
      const auto steps = static_cast<double>(c < kStart ? kStart - c : c - kStart);
      scores[c] = kriging(c).LogLikelihood(noise) - kStepPenalty * steps;
    }
    return *scores[c];
  };
  size_t chosen = kStart;
  while (chosen > 0 && score(chosen - 1) > score(chosen)) --chosen;
  while (chosen >= kStart && chosen + 1 < kCandidates.size() && score(chosen + 1) > score(chosen)) ++chosen;
  const auto error = [&](size_t c) { return Mean(kriging(c).BlockErrors(divisions)); };
  choice.tension = kCandidates[chosen] / (width * width);
  choice.error = error(chosen);
  choice.error_at_start = chosen == kStart ? choice.error : error(kStart);
  for (const auto& blocks : divisions) choice.blocks += static_cast<int32_t>(blocks.size());
  return choice;
}

}  // namespace tilemend
