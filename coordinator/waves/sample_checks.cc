#include "coordinator/waves/sample_checks.h"

#include <cmath>
#include <iterator>

#include "absl/strings/str_cat.h"

namespace tilemend {

absl::Status CheckSample(const Plan& plan, int32_t vertex, double height) {
  if (vertex < 0 || vertex >= std::ssize(plan.vertices)) {
    return absl::InvalidArgumentError(absl::StrCat("vertex ", vertex, " is not in the plan"));
  }
  if (std::isfinite(height)) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat("the height of vertex ", vertex, " is no number"));
}

absl::Status CheckSamples(const Plan& plan, std::span<const SeamSample> samples) {
  for (const SeamSample& sample : samples) {
    absl::Status status = CheckSample(plan, sample.vertex, sample.height);
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

absl::Status CheckSamples(const Plan& plan, std::span<const ClusterSample> samples) {
  for (const ClusterSample& sample : samples) {
    absl::Status status = CheckSample(plan, sample.vertex, sample.height);
    if (!status.ok()) return status;
    if (!std::isfinite(sample.laplacian) || !sample.slope.allFinite()) {
      return absl::InvalidArgumentError(
          absl::StrCat("the Laplacian or slope of vertex ", sample.vertex, " is no number"));
    }
  }
  return absl::OkStatus();
}

}  // namespace tilemend
