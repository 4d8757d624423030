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

PackedTally::PackedTally(const QualityTally& tally)
    : sum_millionths_(tally.sum_millionths),
      least_(tally.least),
      triangles_(static_cast<int32_t>(tally.triangles)),
      poor_(static_cast<int32_t>(tally.poor)),
      poor_forced_(static_cast<int32_t>(tally.poor_forced)) {
  for (int32_t k = 0; k < QualityTally::kBins; ++k) {
    const auto count = static_cast<int32_t>(tally.histogram[static_cast<size_t>(k)]);
    if (count != 0) bins_.push_back({k, count});
  }
  bins_.shrink_to_fit();
}

QualityTally PackedTally::Unpack() const {
  QualityTally tally;
  tally.triangles = triangles_;
  tally.sum_millionths = sum_millionths_;
  tally.least = least_;
  tally.poor = poor_;
  tally.poor_forced = poor_forced_;
  for (const Bin& bin : bins_) tally.histogram[static_cast<size_t>(bin.number)] = bin.triangles;
  return tally;
}

}  // namespace tilemend
