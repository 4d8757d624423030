// Jobs that a state machine knows, and a registry of metrics about them.
#ifndef TILEMEND_TESTS_SUPPORT_KNOWN_JOBS_H_
#define TILEMEND_TESTS_SUPPORT_KNOWN_JOBS_H_

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/time/time.h"
#include "common/metrics/prometheus_registry.h"
#include "coordinator/state/coordinator_state.h"

namespace tilemend {

class KnownJobsTest : public ::testing::Test {
 protected:
  void ExpectLine(const std::string& line) {
    EXPECT_THAT(registry_.Text(), ::testing::HasSubstr(absl::StrCat("tilemend_coordinator_", line, "\n")));
  }
  // A job that the state machine knows, with `tasks` tasks of two cells.
  const Job& NewJob(const std::string& id, size_t tasks = 2) {
    EXPECT_TRUE(state_.Apply(JobCreated{id, "", start_}).ok());
    EXPECT_TRUE(state_.Apply(JobProgressed{id, {"survey", 2, 0, 0, 0}}).ok());
    EXPECT_TRUE(state_.Apply(TasksAdded{id, std::vector<TaskSpec>(tasks)}).ok());
    return *state_.FindJob(id);
  }

  const absl::Time start_ = absl::FromUnixSeconds(1000);
  PrometheusRegistry registry_;
  CoordinatorState state_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_KNOWN_JOBS_H_
