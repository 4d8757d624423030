#include "common/metrics/metrics.h"

namespace tilemend {
namespace {

class NullCounter : public Counter {
  void Increment(double) override {}
};

class NullGauge : public Gauge {
  void Set(double) override {}
};

class NullHistogram : public Histogram {
  void Observe(double) override {}
};

class NullRegistry : public MetricsRegistry {
  Counter* AddCounter(const std::string&, const std::string&, const Labels&) override { return Counter::Null(); }
  Gauge* AddGauge(const std::string&, const std::string&, const Labels&) override { return Gauge::Null(); }
  Histogram* AddHistogram(const std::string&, const std::string&, const Labels&, const std::vector<double>&) override {
    return Histogram::Null();
  }
};

}  // namespace

Counter* Counter::Null() {
  static NullCounter counter;
  return &counter;
}

Gauge* Gauge::Null() {
  static NullGauge gauge;
  return &gauge;
}

Histogram* Histogram::Null() {
  static NullHistogram histogram;
  return &histogram;
}

MetricsRegistry* MetricsRegistry::Null() {
  static NullRegistry registry;
  return &registry;
}

std::vector<double> Histogram::ScaledBounds(double start, double factor, int count) {
  std::vector<double> bounds;
  for (double bound = start; count > 0; --count, bound *= factor) bounds.push_back(bound);
  return bounds;
}

}  // namespace tilemend
