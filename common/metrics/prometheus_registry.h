// Metrics as Prometheus reads them.
#ifndef TILEMEND_COMMON_METRICS_PROMETHEUS_REGISTRY_H_
#define TILEMEND_COMMON_METRICS_PROMETHEUS_REGISTRY_H_

#include <memory>
#include <string>
#include <vector>

#include "common/metrics/metrics.h"

namespace tilemend {

// Thread-safe. Handles live as long as the registry.
class PrometheusRegistry : public MetricsRegistry {
 public:
  PrometheusRegistry();
  ~PrometheusRegistry() override;

  Counter* AddCounter(const std::string& name, const std::string& help, const Labels& labels) override;
  Gauge* AddGauge(const std::string& name, const std::string& help, const Labels& labels) override;
  Histogram* AddHistogram(const std::string& name, const std::string& help, const Labels& labels,
                          const std::vector<double>& bounds) override;

  // The text that /metrics gives.
  std::string Text() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_METRICS_PROMETHEUS_REGISTRY_H_
