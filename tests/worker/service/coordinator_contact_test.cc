#include "worker/service/coordinator_contact.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/metrics/prometheus_registry.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST(CoordinatorContactTest, TellsWhyThereAreNoTasks) {
  PrometheusRegistry registry;
  WorkerMetrics metrics(registry);
  CoordinatorContact contact(*Log::Null(), metrics);
  EXPECT_FALSE(contact.is_connected());
  EXPECT_EQ(contact.WhyNotReady(), "has not reached its coordinator yet");
  contact.SetConnected(absl::UnavailableError("gone"));
  EXPECT_EQ(contact.WhyNotReady(), "cannot reach its coordinator: gone");
  contact.SetConnected(absl::OkStatus());
  EXPECT_TRUE(contact.is_connected());
  EXPECT_EQ(contact.WhyNotReady(), "");
  EXPECT_THAT(registry.Text(), HasSubstr("tilemend_worker_connected 1\n"));
  contact.SetAside("sees another folder");
  EXPECT_EQ(contact.WhyNotReady(), "sees another folder");
  contact.SetConnected(absl::UnavailableError("gone"));
  EXPECT_EQ(contact.WhyNotReady(), "cannot reach its coordinator: gone") << "that comes first";
}

}  // namespace
}  // namespace tilemend
