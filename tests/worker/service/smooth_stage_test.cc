#include "worker/service/smooth_stage.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/rpc/stage_payloads.h"

namespace tilemend {
namespace {

TEST(SmoothStageTest, WithoutPatchesTheSeamKeepsItsHeights) {
  v1::SmoothSeamInput input;
  input.set_number(3);
  input.set_lattice_step(0.5);
  input.set_smoothing(0.5);
  input.set_buffer(2);
  for (v1::SeamSide* side : {input.mutable_a(), input.mutable_b()})
    *side->mutable_patches() = ToProto({}, {}, input.lattice_step());
  const auto bytes = RunSmoothSeam(input);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  v1::SmoothSeamOutput output;
  ASSERT_TRUE(output.ParseFromString(*bytes));
  EXPECT_EQ(output.number(), 3);
  EXPECT_EQ(output.height_size(), 0);
}

TEST(SmoothStageTest, RefusesASeamThatDoesNotFitTogether) {
  v1::SmoothSeamInput input;
  input.set_lattice_step(0.5);
  input.add_height(1);
  for (v1::SeamSide* side : {input.mutable_a(), input.mutable_b()})
    *side->mutable_patches() = ToProto({}, {}, input.lattice_step());
  EXPECT_TRUE(absl::IsInvalidArgument(RunSmoothSeam(input).status()));
  input.clear_height();
  input.set_lattice_step(0);
  EXPECT_TRUE(absl::IsInvalidArgument(RunSmoothSeam(input).status()));
}

}  // namespace
}  // namespace tilemend
