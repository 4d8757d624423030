#include "coordinator/api/scaler.h"

#include <cstdint>
#include <string>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr int64_t kMostSlots = 1024;  // as of a worker's --threads

absl::Status InvalidScaler(const std::string& field, const std::string& what) {
  return WithErrorInfo(absl::InvalidArgumentError(absl::StrCat(field, ": ", what)),
                       {"INVALID_SCALER", {{"field", field}}});
}

}  // namespace

absl::StatusOr<externalscaler::GetMetricSpecResponse> ScalerSpec(const externalscaler::ScaledObjectRef& object) {
  int64_t slots = 1;
  const auto given = object.scalermetadata().find("slots");
  if (given != object.scalermetadata().end() &&
      (!absl::SimpleAtoi(given->second, &slots) || slots < 1 || slots > kMostSlots)) {
    return InvalidScaler(
        "slots", absl::StrCat("'", Printable(given->second), "': expected a whole number from 1 to ", kMostSlots));
  }
  externalscaler::GetMetricSpecResponse response;
  externalscaler::MetricSpec& spec = *response.add_metricspecs();
  spec.set_metricname(kScalerMetric);
  spec.set_targetsize(slots);
  spec.set_targetsizefloat(static_cast<double>(slots));
  return response;
}

absl::StatusOr<externalscaler::GetMetricsResponse> ScalerMetrics(const externalscaler::GetMetricsRequest& request,
                                                                 const Demand& demand) {
  if (!request.metricname().empty() && request.metricname() != kScalerMetric) {
    return InvalidScaler("metricName", absl::StrCat("there is ", kScalerMetric, " alone"));
  }
  externalscaler::GetMetricsResponse response;
  externalscaler::MetricValue& value = *response.add_metricvalues();
  value.set_metricname(kScalerMetric);
  value.set_metricvalue(demand.tasks);
  value.set_metricvaluefloat(static_cast<double>(demand.tasks));
  return response;
}

}  // namespace tilemend
