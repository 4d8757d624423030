#include "worker/fill/surface/choose_tension.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "worker/fill/surface/kriging.h"

namespace tilemend {
namespace {

// Times 1 / width^2, rising; the last one is for rims that are nothing but noise, and is no step of the ladder.
constexpr std::array<double, 7> kCandidates = {0, 3, 10, 30, 100, 300, 1e5};
constexpr size_t kTaut = kCandidates.size() - 1;
constexpr size_t kStart = 2;        // the likeliest candidate before any height is known
constexpr double kStepPenalty = 1;  // of log-likelihood, for each step away from it
constexpr double kLeastNoise = 1e-7, kMostNoise = 1, kNoiseStep = 10;  // variances of a height, over the kernel's scale
constexpr std::array<double, 2> kBlockSides = {0.5, 1.0};              // times width
constexpr std::array<std::pair<double, double>, 4> kBlockOffsets = {
    {{0, 0}, {0.5, 0.5}, {0.5, 0}, {0, 0.5}}};  // times the side
constexpr size_t kMostRimPoints = 100;
constexpr double kFlat = 1e-9;  // of the width: rounding
constexpr size_t kLeastBlocks = 4;
constexpr double kThinning = 1.2;

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

// Whether every tension gives the plane that the samples lie in.
bool LieInAPlane(const std::vector<Point3>& samples, double width) {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  const auto drift = [&](const Point3& p) {
    return Eigen::Vector3d(1, (p.x() - samples[0].x()) / width, (p.y() - samples[0].y()) / width);
  };
  for (const Point3& p : samples) {
    products += drift(p) * drift(p).transpose();
    sums += drift(p) * (p.z() - samples[0].z());
  }
  const Eigen::Vector3d plane = products.ldlt().solve(sums);
  return std::ranges::all_of(samples, [&](const Point3& p) {
    return std::abs(p.z() - samples[0].z() - plane.dot(drift(p))) <= kFlat * width;
  });
}

// A division of the samples into blocks.
SampleBlocks Blocks(const std::vector<Point3>& samples, double side, double x_offset, double y_offset) {
  std::map<BlockKey, std::vector<int>> blocks;
  for (size_t i = 0; i < samples.size(); ++i) {
    blocks[KeyOf(samples[i], side, x_offset, y_offset)].push_back(static_cast<int>(i));
  }
  SampleBlocks list;
  for (auto& [key, block] : blocks) list.push_back(std::move(block));
  return list;
}

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

// All divisions of the samples that have enough blocks.
std::vector<SampleBlocks> Divisions(const std::vector<Point3>& samples, double width, double least_side) {
  std::vector<SampleBlocks> divisions;
  for (const double side : kBlockSides) {
    for (const auto& [x, y] : kBlockOffsets) {
      SampleBlocks blocks = Blocks(samples, std::max(side * width, least_side), x, y);
      if (blocks.size() >= kLeastBlocks) divisions.push_back(std::move(blocks));
    }
  }
  return divisions;
}

// The candidate tensions by how well they foretell the samples; each kriging is made when it is first asked for.
class Candidates {
 public:
  Candidates(const std::vector<Point3>& samples, double width)
      : samples_(samples), width_(width), noise_(LikeliestNoise(At(kStart))) {}

  // Whether a plane and a variance of each height's own tell all, to within a step: slopes at the rim say nothing then.
  bool IsAllNoise() { return At(kStart).LogLikelihood(kMostNoise) > At(kStart).LogLikelihood(noise_) - kStepPenalty; }

  // The best of the ladder, tried from kStart on as long as the score rises.
  size_t Choose() {
    if (IsAllNoise()) return kTaut;
    size_t chosen = kStart;
    while (chosen > 0 && Score(chosen - 1) > Score(chosen)) --chosen;
    while (chosen >= kStart && chosen + 1 < kTaut && Score(chosen + 1) > Score(chosen)) ++chosen;
    return chosen;
  }

  // The mean |error| at samples whose block is left out.
  double Error(size_t candidate, const std::vector<SampleBlocks>& divisions) {
    return Mean(At(candidate).BlockErrors(divisions));
  }

 private:
  const Kriging& At(size_t candidate) {
    std::optional<Kriging>& kriging = krigings_[candidate];
    if (!kriging) kriging.emplace(samples_, width_, kCandidates[candidate]);
    return *kriging;
  }

  double Score(size_t candidate) {
    std::optional<double>& score = scores_[candidate];
    if (!score) {
      const auto steps = static_cast<double>(candidate < kStart ? kStart - candidate : candidate - kStart);
      score = At(candidate).LogLikelihood(noise_) - kStepPenalty * steps;
    }
    return *score;
  }

  const std::vector<Point3>& samples_;
  const double width_;
  std::array<std::optional<Kriging>, kCandidates.size()> krigings_;
  std::array<std::optional<double>, kCandidates.size()> scores_;
  const double noise_;
};

}  // namespace

HoldOut ChooseTension(const ThinPlateProblem& problem, double width) {
  HoldOut choice;
  const std::vector<int32_t> rim = RimOf(problem);
  if (rim.size() < kLeastRimForNoise || !(width > 0)) return choice;
  double step = width / static_cast<double>(kMostRimPoints);
  const std::vector<Point3> samples = Samples(problem, Thinned(problem, rim, step));
  if (LieInAPlane(samples, width)) return choice;
  const std::vector<SampleBlocks> divisions = Divisions(samples, width, 2 * step);
  if (divisions.empty()) return choice;
  Candidates candidates(samples, width);
  if (rim.size() < kLeastRimForHoldOut && !candidates.IsAllNoise()) return choice;
  const size_t chosen = candidates.Choose();
  choice.tension = kCandidates[chosen] / (width * width);
  choice.error = candidates.Error(chosen, divisions);
  choice.error_at_start = chosen == kStart ? choice.error : candidates.Error(kStart, divisions);
  for (const SampleBlocks& blocks : divisions) choice.blocks += static_cast<int32_t>(blocks.size());
  return choice;
}

}  // namespace tilemend
