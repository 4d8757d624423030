#include "worker/papers/front/front_index.h"

#include <algorithm>
#include <cmath>

namespace tilemend {
namespace {

// Of the length of edges here: shorter ones share the bins of such a length.
constexpr double kShortest = 1e-6;
constexpr double kLeastLength = 1e-200;
// A bin is this many powers of two larger than its edges: two to four of them long, so that a search meets few bins.
constexpr int kBinSize = 2;
// Numbers of bins; what lies further off is in the last ones.
constexpr double kFarthest = 1e18;

}  // namespace

size_t FrontIndex::PlaceHash::operator()(const Place& p) const {
  const auto mix = [](uint64_t hash, int64_t value) {
    return (hash ^ static_cast<uint64_t>(value)) * 0x9E3779B97F4A7C15ULL ^ (hash >> 29);
  };
  return mix(mix(mix(0, p.x), p.y), p.z);
}

FrontIndex::Place FrontIndex::PlaceOf(const Point3& p, double side) {
  const auto number = [side](double x) {
    return static_cast<int64_t>(std::clamp(std::floor(x / side), -kFarthest, kFarthest));
  };
  return {number(p.x()), number(p.y()), number(p.z())};
}

void FrontIndex::Add(int32_t node, const Point3& from, const Point3& to, double unit) {
  const int level = std::ilogb(std::max({(to - from).norm(), kShortest * unit, kLeastLength})) + kBinSize;
  levels_[level][PlaceOf((from + to) / 2, std::ldexp(1.0, level))].emplace_back(node, loops_[node].after);
}

std::vector<int32_t> FrontIndex::Near(const Eigen::AlignedBox3d& box) const {
  std::vector<int32_t> found;
  for (auto& [level, bins] : levels_) {
    // Middles lie within half an edge of the box.
    const double side = std::ldexp(1.0, level);
    const Eigen::AlignedBox3d middles(box.min().array() - side / 2, box.max().array() + side / 2);
    const Eigen::Vector3d most = (middles.sizes() / side).array() + 2;
    if (most.prod() > static_cast<double>(bins.size())) {
      for (auto bin = bins.begin(); bin != bins.end();) bin = Collect(bin->second, found) ? ++bin : bins.erase(bin);
    } else {
      CollectIn(middles, side, bins, found);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void FrontIndex::CollectIn(const Eigen::AlignedBox3d& middles, double side, Bins& bins,
                           std::vector<int32_t>& found) const {
  const Place first = PlaceOf(middles.min(), side), last = PlaceOf(middles.max(), side);
  for (int64_t x = first.x; x <= last.x; ++x) {
    for (int64_t y = first.y; y <= last.y; ++y) {
      for (int64_t z = first.z; z <= last.z; ++z) {
        const auto bin = bins.find({x, y, z});
        if (bin != bins.end() && !Collect(bin->second, found)) bins.erase(bin);
      }
    }
  }
}

bool FrontIndex::Collect(Bin& bin, std::vector<int32_t>& found) const {
  looked_at_ += std::ssize(bin);
  std::erase_if(bin, [&](const auto& edge) {
    const FrontLoops::Node& node = loops_[edge.first];
    return !node.alive || node.after != edge.second;
  });
  for (const auto& edge : bin) found.push_back(edge.first);
  return !bin.empty();
}

}  // namespace tilemend
