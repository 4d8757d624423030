#include "common/mesh/quality_tally.h"

#include <algorithm>
#include <cmath>

namespace tilemend {

void QualityTally::Add(double quality, bool forced) {
  ++triangles;
  sum_millionths += std::llround(quality * 1e6);
  least = std::min(least, quality);
  ++histogram[static_cast<size_t>(std::clamp(static_cast<int>(quality * kBins), 0, kBins - 1))];
  if (quality >= kPoorQuality) return;
  ++poor;
  if (forced) ++poor_forced;
}

void QualityTally::Merge(const QualityTally& other) {
  triangles += other.triangles;
  sum_millionths += other.sum_millionths;
  least = std::min(least, other.least);
  for (size_t k = 0; k < histogram.size(); ++k) histogram[k] += other.histogram[k];
  poor += other.poor;
  poor_forced += other.poor_forced;
}

double QualityTally::Mean() const {
  return triangles > 0 ? static_cast<double>(sum_millionths) / 1e6 / static_cast<double>(triangles) : 0;
}

double QualityTally::Quantile(double share) const {
  double before = share * static_cast<double>(triangles);
  for (int k = 0; k < kBins; ++k) {
    const auto count = static_cast<double>(histogram[static_cast<size_t>(k)]);
    if (count > 0 && before <= count) return (k + before / count) / kBins;
    before -= count;
  }
  return 0;
}

}  // namespace tilemend
