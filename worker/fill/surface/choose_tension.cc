#include "worker/fill/surface/choose_tension.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "worker/fill/surface/kriging.h"
#include "worker/fill/surface/rim_samples.h"

namespace tilemend {
namespace {

// Times 1 / width^2, rising; the last one is for rims that are nothing but noise, and is no step of the ladder.
constexpr std::array<double, 7> kCandidates = {0, 3, 10, 30, 100, 300, 1e5};
constexpr size_t kTaut = kCandidates.size() - 1;
constexpr size_t kStart = 2;                               // the likeliest candidate before any height is known
constexpr double kStepPenalty = 1;                         // of log-likelihood, for each step away from it
constexpr std::array<double, 2> kBlockSides = {0.5, 1.0};  // times width
constexpr std::array<std::pair<double, double>, 4> kBlockOffsets = {
    {{0, 0}, {0.5, 0.5}, {0.5, 0}, {0, 0.5}}};  // times the side
constexpr size_t kMostRimPoints = 100;
constexpr size_t kLeastBlocks = 4;

// A division of the samples into blocks.
SampleBlocks Blocks(const std::vector<Point3>& samples, double side, double x_offset, double y_offset) {
  std::map<RasterSquare, std::vector<int>> blocks;
  for (size_t i = 0; i < samples.size(); ++i) {
    blocks[SquareOf(samples[i], side, x_offset, y_offset)].push_back(static_cast<int>(i));
  }
  SampleBlocks list;
  for (auto& [key, block] : blocks) list.push_back(std::move(block));
  return list;
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
      : samples_(samples), width_(width), noise_(At(kStart).LikeliestNoise()) {}

  // Whether a plane and a variance of each height's own tell all, to within a step: slopes at the rim say nothing then.
  bool IsAllNoise() {
    return At(kStart).LogLikelihood(Kriging::kMostNoise) > At(kStart).LogLikelihood(noise_) - kStepPenalty;
  }

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
  if (!(width > 0)) return choice;
  const RimSamples rim = SampleRim(problem, width, kMostRimPoints);
  const std::vector<Point3>& samples = rim.samples;
  if (rim.rim_points < kLeastRimForNoise || rim.in_a_plane) return choice;
  const std::vector<SampleBlocks> divisions = Divisions(samples, width, 2 * rim.spacing);
  if (divisions.empty()) return choice;
  Candidates candidates(samples, width);
  if (rim.rim_points < kLeastRimForHoldOut && !candidates.IsAllNoise()) return choice;
  const size_t chosen = candidates.Choose();
  choice.tension = kCandidates[chosen] / (width * width);
  choice.error = candidates.Error(chosen, divisions);
  choice.error_at_start = chosen == kStart ? choice.error : candidates.Error(kStart, divisions);
  for (const SampleBlocks& blocks : divisions) choice.blocks += static_cast<int32_t>(blocks.size());
  return choice;
}

}  // namespace tilemend
