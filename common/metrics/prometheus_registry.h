// Metrics for Prometheus, served on http://HOST:PORT/metrics.
#ifndef TILEMEND_COMMON_METRICS_PROMETHEUS_REGISTRY_H_
#define TILEMEND_COMMON_METRICS_PROMETHEUS_REGISTRY_H_

#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
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

  // Starts a small web server on `address` ("HOST:PORT", port 0 takes a free one) that lives as long as the registry.
  // kUnavailable if the address cannot be had. Call at most once.
  absl::Status Expose(const std::string& address);

  // The port of Expose, 0 before.
  int port() const;

  // The text that /metrics gives.
  std::string Text() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_METRICS_PROMETHEUS_REGISTRY_H_
