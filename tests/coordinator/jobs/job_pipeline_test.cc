#include "coordinator/jobs/job_pipeline.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

InputPart PartWith(const absl::StatusOr<std::string>& bytes) {
  return {"digest", [bytes] { return bytes; }};
}

TEST(WholeInputTest, HasThePartsInTheirOrder) {
  NewTask task{{}, Stage::kGround, "head", {}, {PartWith("-one"), PartWith("-two")}};
  EXPECT_EQ(WholeInput(task).value(), "head-one-two");
}

TEST(WholeInputTest, FailsWithAPart) {
  const NewTask task{{}, Stage::kGround, "head", {}, {PartWith(absl::UnavailableError("gone"))}};
  EXPECT_EQ(WholeInput(task).status(), absl::UnavailableError("gone"));
}

}  // namespace
}  // namespace tilemend
