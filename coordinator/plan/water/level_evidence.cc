#include "coordinator/plan/water/level_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "coordinator/plan/water/rim_membrane.h"

namespace tilemend {
namespace {

constexpr double kWindowsAlongRim = 64;
constexpr double kEdgesPerWindow = 2;
constexpr double kLowInWindow = 0.25;   // quantile: a bank or a tree may take up most of a window
constexpr double kSecond = 0.02;        // quantile
constexpr double kShareOfDry = 0.5;     // of D that J may be
constexpr double kMinRoughness = 0.01;  // metres: heights are told no better

// An edge with its roughness.
struct RoughEdge {
  Point3 middle{0, 0, 0};
  double length = 0;
  double roughness = 0;

  WeightedHeight height() const { return {middle.z(), length, length / std::max(roughness, kMinRoughness)}; }
};

// How far the edge is off the mean of its neighbours. An end of a chain is as rough as the edge beside it.
double OffNeighbours(const RimChain& chain, size_t i) {
  if (chain.size() < 3) return std::numeric_limits<double>::infinity();
  i = std::clamp<size_t>(i, 1, chain.size() - 2);
  const double mean = (chain[i - 1].middle.z() + chain[i + 1].middle.z()) / 2;
  return std::sqrt(2.0 / 3) * std::abs(chain[i].middle.z() - mean);
}

double MedianOfThree(double a, double b, double c) { return std::max(std::min(a, b), std::min(std::max(a, b), c)); }

// In the order of their heights, lengths and places, so that sums do not depend on where the chains begin.
std::vector<RoughEdge> RoughEdgesOf(std::span<const RimChain> chains) {
  std::vector<RoughEdge> edges;
  for (const RimChain& chain : chains) {
    for (size_t i = 0; i < chain.size(); ++i) {
      const size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, chain.size() - 1);
      RoughEdge e{chain[i].middle, chain[i].length};
      e.roughness = MedianOfThree(OffNeighbours(chain, before), OffNeighbours(chain, i), OffNeighbours(chain, after));
      edges.push_back(e);
    }
  }
  std::ranges::sort(edges, {}, [](const RoughEdge& e) { return std::tuple(e.height(), e.middle.x(), e.middle.y()); });
  return edges;
}

// Edges of one square of the plane.
struct Window {
  Point3 place{0, 0, 0};  // the mean of their middles, and their low height
  std::vector<WeightedHeight> heights;
};

double WindowSide(std::span<const RoughEdge> edges) {
  double length = 0, squares = 0;
  for (const RoughEdge& e : edges) length += e.length, squares += e.length * e.length;
  const double side = length > 0 ? std::max(length / kWindowsAlongRim, kEdgesPerWindow * squares / length) : 0;
  return side > 0 ? side : 1;
}

// A rim in windows.
class WindowedRim {
 public:
  explicit WindowedRim(std::span<const RoughEdge> edges) {
    const double side = WindowSide(edges);
    std::map<std::pair<int64_t, int64_t>, size_t> window_at;
    for (const RoughEdge& e : edges) {
      const std::pair<int64_t, int64_t> square(std::llround(std::floor(e.middle.x() / side)),
                                               std::llround(std::floor(e.middle.y() / side)));
      const auto [it, fresh] = window_at.try_emplace(square, windows_.size());
      if (fresh) windows_.emplace_back();
      Window& window = windows_[it->second];
      window.place += e.middle;
      window.heights.push_back(e.height());
      heights_.push_back(e.height());
      window_of_.push_back(it->second);
    }
    for (Window& window : windows_) {
      window.place /= static_cast<double>(window.heights.size());
      window.place.z() = WeightedQuantile(window.heights, kLowInWindow);
    }
  }

  std::span<const WeightedHeight> heights() const { return heights_; }

  std::vector<Point3> Places() const {
    std::vector<Point3> places;
    for (const Window& window : windows_) places.push_back(window.place);
    return places;
  }

  // J.
  double Disagreement(double level) const {
    double squares = 0;
    for (const Window& window : windows_) {
      const std::vector<WeightedHeight> far = HeightsFarFrom(window.place);
      const double off = far.empty() ? 0 : LowerMode(far) - level;
      squares += off * off;
    }
    return std::sqrt(squares / static_cast<double>(windows_.size()));
  }

 private:
  // Sorted, of the edges outside the half of the windows that is nearest.
  std::vector<WeightedHeight> HeightsFarFrom(const Point3& place) const {
    std::vector<size_t> order(windows_.size());
    std::iota(order.begin(), order.end(), size_t{0});
    const auto half = order.begin() + (std::ssize(order) + 1) / 2;
    std::ranges::nth_element(
        order, half, {}, [&](size_t w) { return std::pair((windows_[w].place - place).head<2>().squaredNorm(), w); });
    std::vector<bool> is_near(windows_.size(), false);
    std::for_each(order.begin(), half, [&](size_t w) { is_near[w] = true; });
    std::vector<WeightedHeight> far;
    far.reserve(heights_.size());
    for (size_t e = 0; e < heights_.size(); ++e) {
      if (!is_near[window_of_[e]]) far.push_back(heights_[e]);
    }
    return far;
  }

  std::vector<Window> windows_;
  std::vector<WeightedHeight> heights_;  // of the edges, sorted
  std::vector<size_t> window_of_;        // likewise
};

double NoiseOf(std::span<const RimChain> chains, double median) {
  std::vector<double> offs;
  for (const RimChain& chain : chains) {
    for (size_t i = 1; i + 1 < chain.size(); ++i) {
      const bool is_low = std::max({chain[i - 1].middle.z(), chain[i].middle.z(), chain[i + 1].middle.z()}) <= median;
      if (is_low) offs.push_back(OffNeighbours(chain, i));
    }
  }
  if (offs.empty()) return 0;
  const auto middle = offs.begin() + std::ssize(offs) / 2;
  std::ranges::nth_element(offs, middle);
  return kDeviationsPerMedian * *middle;
}

}  // namespace

double LevelEvidence::sigma() const { return std::hypot(disagreement, noise); }

bool LevelEvidence::is_enough() const { return windows >= kMinWindows; }

bool LevelEvidence::agrees() const { return disagreement < kShareOfDry * dry_difference; }

bool LevelEvidence::is_within_noise() const { return dry_difference < kSigmas * noise; }

bool LevelEvidence::is_level() const { return is_enough() && (agrees() || is_within_noise()); }

LevelEvidence EvidenceOf(std::span<const RimChain> chains, std::span<const PlaneSegment> outline) {
  const std::vector<RoughEdge> edges = RoughEdgesOf(chains);
  const WindowedRim rim(edges);
  const std::vector<Point3> places = rim.Places();
  LevelEvidence e;
  e.edges = std::ssize(edges);
  e.windows = std::ssize(places);
  for (const RoughEdge& edge : edges) e.length += edge.length;
  e.level = LowerMode(rim.heights());
  e.lowest = rim.heights().front().height;
  e.highest = rim.heights().back().height;
  e.second_percentile = WeightedQuantile(rim.heights(), kSecond);
  e.median = WeightedQuantile(rim.heights(), 0.5);
  e.noise = NoiseOf(chains, e.median);
  e.disagreement = rim.Disagreement(e.level);
  if (!outline.empty()) e.dry_difference = MeanOffLevel(outline, places, e.level);
  return e;
}

}  // namespace tilemend
