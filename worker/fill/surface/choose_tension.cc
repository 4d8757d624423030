#include "worker/fill/surface/choose_tension.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "worker/fill/surface/kriging.h"
#include "worker/fill/surface/rim_samples.h"

namespace tilemend {
namespace {

// Times 1 / width^2, rising. The last one is a membrane's.
constexpr std::array<double, 8> kCandidates = {0, 3, 10, 30, 100, 300, 1000, 1e5};
constexpr size_t kStart = 5;  // the search begins here; from 30 to 1000 all starts give the same errors to within 1 %
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

// Mean |error| of blocks over divisions: each division counts as much.
double MeanError(const std::vector<Eigen::VectorXd>& errors) {
  double sum = 0;
  for (const Eigen::VectorXd& e : errors) sum += e.mean();
  return sum / static_cast<double>(errors.size());
}

// Mean over all blocks of the root of their |error|: a block behind a car or a wall weighs little.
double RobustError(const std::vector<Eigen::VectorXd>& errors) {
  double sum = 0, blocks = 0;
  for (const Eigen::VectorXd& e : errors) {
    sum += e.cwiseSqrt().sum();
    blocks += static_cast<double>(e.size());
  }
  return sum / blocks;
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

// The errors of the candidate tensions at blocks that are left out. Each kriging is made when it is first asked for.
class Candidates {
 public:
  Candidates(const std::vector<Point3>& samples, double width, const std::vector<SampleBlocks>& divisions)
      : samples_(samples), width_(width), divisions_(divisions) {}

  // The first least robust error on the way from kStart, towards 0 or else towards the membrane.
  size_t Choose() {
    size_t chosen = kStart;
    while (chosen > 0 && RobustError(At(chosen - 1)) < RobustError(At(chosen))) --chosen;
    if (chosen < kStart) return chosen;
    while (chosen + 1 < kCandidates.size() && RobustError(At(chosen + 1)) < RobustError(At(chosen))) ++chosen;
    return chosen;
  }

  // The error of each block of each division.
  const std::vector<Eigen::VectorXd>& At(size_t candidate) {
    std::vector<Eigen::VectorXd>& errors = errors_[candidate];
    if (errors.empty()) errors = Kriging(samples_, width_, kCandidates[candidate]).BlockErrors(divisions_);
    return errors;
  }

 private:
  const std::vector<Point3>& samples_;
  const double width_;
  const std::vector<SampleBlocks>& divisions_;
  std::array<std::vector<Eigen::VectorXd>, kCandidates.size()> errors_;
};

// Whether most of the rim tells no slope, since it stands on objects or walls: what is left is not enough to test, and
// a plate from it may go anywhere.
bool IsMostlyWithoutSlope(const ThinPlateProblem& problem, int32_t rim_points) {
  std::vector<bool> without(problem.points.size(), false);
  for (const Triangle& t : problem.patch) {
    for (const int32_t v : t) without[v] = problem.known[v] && !problem.has_equation[v];
  }
  return std::ranges::count(without, true) > rim_points;
}

}  // namespace

HoldOut ChooseTension(const ThinPlateProblem& problem, double width) {
  HoldOut choice;
  if (!(width > 0)) return choice;
  const RimSamples rim = SampleRim(problem, width, kMostRimPoints);
  const std::vector<Point3>& samples = rim.samples;
  if (rim.in_a_plane) return choice;
  const std::vector<SampleBlocks> divisions = Divisions(samples, width, 2 * rim.spacing);
  if (rim.rim_points < kMinRimForHoldOut || divisions.empty()) {
    if (IsMostlyWithoutSlope(problem, rim.rim_points)) choice.tension = kCandidates[kStart] / (width * width);
    return choice;
  }
  Candidates candidates(samples, width, divisions);
  const size_t chosen = candidates.Choose();
  choice.tension = kCandidates[chosen] / (width * width);
  choice.error = MeanError(candidates.At(chosen));
  choice.error_at_start = MeanError(candidates.At(kStart));
  for (const SampleBlocks& blocks : divisions) choice.blocks += static_cast<int32_t>(blocks.size());
  return choice;
}

}  // namespace tilemend
