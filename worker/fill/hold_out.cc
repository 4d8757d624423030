#include "worker/fill/hold_out.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "worker/fill/bessel_k0.h"

namespace tilemend {
namespace {

constexpr std::array<double, 6> kCandidates = {0, 3, 10, 30, 100, 300};  // times 1 / width^2, rising
constexpr size_t kStart = 3;  // candidate that is taken where hold-out has nothing against it
constexpr std::array<double, 2> kBlockSides = {0.5, 1.0};  // times width
constexpr std::array<std::pair<double, double>, 4> kBlockOffsets = {
    {{0, 0}, {0.5, 0.5}, {0.5, 0}, {0, 0.5}}};  // times the side
constexpr size_t kMostRimPoints = 100;
constexpr size_t kLeastBlocks = 4;
constexpr double kThinning = 1.2;
constexpr double kStandardErrors = 0.75;
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

bool IsRim(const ThinPlateProblem& problem, int32_t v) { return problem.known[v] && problem.full_ring[v]; }

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

// Lengths in units of the hole's width, tension in units of 1 / width^2.
double Kernel(double r, double tension) {
  if (tension == 0) return r > 0 ? r * r * std::log(r) / (8 * std::numbers::pi) : 0;
  const double scale = std::sqrt(tension), x = scale * r;
  constexpr double kFar = 30;  // K0 is below 1e-13 there, and slow
  // ln r + K0(x) tends to ln(2 / scale) - Euler's constant.
  const double value = x > kFar   ? std::log(r)
                       : x > 1e-9 ? std::log(r) + BesselK0(x)
                                  : std::log(2 / scale) - std::numbers::egamma;
  return -value / (2 * std::numbers::pi * tension);
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

// The inverse of the kriging matrix of the samples, without the rows and columns of the drift. The kernel is positive
// definite on what is orthogonal to the drift (Wahba 1990, 2.4), the last coordinates after reflections that take the
// drift to the first.
Eigen::MatrixXd InverseOf(const std::vector<Point3>& samples, double width, double tension) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  const Eigen::Index drift_count = tension == 0 ? 3 : 1;
  Eigen::MatrixXd matrix(n, n), drift(n, drift_count);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      matrix(i, j) = matrix(j, i) = Kernel((samples[i] - samples[j]).head<2>().norm() / width, tension);
    }
    matrix(i, i) = Kernel(0, tension);
    drift(i, 0) = 1;
    for (Eigen::Index k = 1; k < drift_count; ++k) drift(i, k) = (samples[i] - samples[0])[k - 1] / width;
  }
  matrix.diagonal().array() += kNugget * matrix.cwiseAbs().maxCoeff();
  const Eigen::HouseholderQR<Eigen::MatrixXd> reflections(drift);
  matrix.applyOnTheLeft(reflections.householderQ().adjoint());
  matrix.applyOnTheRight(reflections.householderQ());
  const Eigen::Index free = n - drift_count;
  const Eigen::MatrixXd inverse = InverseOfPositive(matrix.bottomRightCorner(free, free));
  matrix.setZero();
  matrix.bottomRightCorner(free, free) = inverse;
  matrix.applyOnTheLeft(reflections.householderQ());
  matrix.applyOnTheRight(reflections.householderQ().adjoint());
  return matrix;
}

// The mean |error| of each block of each division, when it is left out.
std::vector<Eigen::VectorXd> BlockErrors(const std::vector<Point3>& samples,
                                         const std::vector<std::vector<std::vector<int>>>& divisions, double width,
                                         double tension) {
  const Eigen::MatrixXd inverse = InverseOf(samples, width, tension);
  Eigen::VectorXd heights(inverse.rows());
  for (size_t i = 0; i < samples.size(); ++i) heights[static_cast<Eigen::Index>(i)] = samples[i].z() - samples[0].z();
  const Eigen::VectorXd weights = inverse * heights;
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

double Mean(const std::vector<Eigen::VectorXd>& errors) {
  double sum = 0;
  for (const Eigen::VectorXd& e : errors) sum += e.mean();
  return sum / static_cast<double>(errors.size());
}

// How far the errors lie above `best` on average, less the standard errors that are allowed for.
double Excess(const std::vector<Eigen::VectorXd>& errors, const std::vector<Eigen::VectorXd>& best) {
  double mean = 0, standard_error = 0;
  for (size_t d = 0; d < errors.size(); ++d) {
    const Eigen::VectorXd more = errors[d] - best[d];
    const auto n = static_cast<double>(more.size());
    mean += more.mean();
    standard_error += std::sqrt((more.array() - more.mean()).square().sum() / (n - 1) / n);
  }
  return mean - kStandardErrors * standard_error;
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
  std::array<std::vector<Eigen::VectorXd>, kCandidates.size()> known;
  const auto errors = [&](size_t c) -> const std::vector<Eigen::VectorXd>& {
    if (known[c].empty()) known[c] = BlockErrors(samples, divisions, width, kCandidates[c]);
    return known[c];
  };
  const auto improves = [&](size_t from, size_t to) { return Mean(errors(to)) < Mean(errors(from)); };
  size_t best = kStart;
  while (best > 0 && improves(best, best - 1)) --best;
  while (best >= kStart && best + 1 < kCandidates.size() && improves(best, best + 1)) ++best;
  size_t chosen = kStart;
  while (chosen != best && Excess(errors(chosen), errors(best)) > 0) chosen = chosen < best ? chosen + 1 : chosen - 1;
  choice.tension = kCandidates[chosen] / (width * width);
  choice.error = Mean(errors(chosen));
  choice.error_at_start = Mean(errors(kStart));
  for (const auto& blocks : divisions) choice.blocks += static_cast<int32_t>(blocks.size());
  return choice;
}

}  // namespace tilemend
