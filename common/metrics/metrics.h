// Metrics behind an interface, with a null object: code that counts needs neither prometheus-cpp nor an `if`.
//
// A family is registered once, at start; Add gives the handle of one combination of labels. Handles are kept for the
// life of the registry and may be used by any thread. Labels are few and known beforehand (a stage, a state): no cells,
// holes, jobs or workers.
#ifndef TILEMEND_COMMON_METRICS_METRICS_H_
#define TILEMEND_COMMON_METRICS_METRICS_H_

#include <map>
#include <string>
#include <vector>

namespace tilemend {

// Only grows.
class Counter {
 public:
  virtual ~Counter() = default;
  virtual void Increment(double by = 1) = 0;  // by >= 0
  static Counter* Null();
};

class Gauge {
 public:
  virtual ~Gauge() = default;
  virtual void Set(double value) = 0;
  static Gauge* Null();
};

class Histogram {
 public:
  virtual ~Histogram() = default;
  virtual void Observe(double value) = 0;
  static Histogram* Null();
  // `count` bounds, each `factor` times the one before. start > 0, factor > 1.
  static std::vector<double> ScaledBounds(double start, double factor, int count);
};

class MetricsRegistry {
 public:
  using Labels = std::map<std::string, std::string>;
  virtual ~MetricsRegistry() = default;
  // The same name and labels give the same handle. `name` after Prometheus' custom: unit last, _total for counters.
  virtual Counter* AddCounter(const std::string& name, const std::string& help, const Labels& labels) = 0;
  virtual Gauge* AddGauge(const std::string& name, const std::string& help, const Labels& labels) = 0;
  virtual Histogram* AddHistogram(const std::string& name, const std::string& help, const Labels& labels,
                                  const std::vector<double>& bounds) = 0;
  // Gives null handles only.
  static MetricsRegistry* Null();
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_METRICS_METRICS_H_
