#include "coordinator/jobs/smooth_check.h"

#include <gtest/gtest.h>

#include "common/rpc/stage_payloads.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {
namespace {

// A seam of two vertices at heights of 1 and 2 m between cells without patches.
class SmoothCheckTest : public ::testing::Test {
 protected:
  SmoothCheckTest() {
    input_.set_number(4);
    input_.set_lattice_step(0.5);
    for (v1::SeamSide* side : {input_.mutable_a(), input_.mutable_b()})
      *side->mutable_patches() = ToProto({}, {}, input_.lattice_step());
    for (const double z : {1.0, 2.0}) {
      input_.add_seam_vertex(0);
      input_.add_height(z);
      output_.add_height(z);
    }
    output_.set_number(4);
  }

  absl::Status Check() const { return CheckSmoothResult(input_.SerializeAsString(), output_); }

  v1::SmoothSeamInput input_;
  v1::SmoothSeamOutput output_;
};

TEST_F(SmoothCheckTest, HeightsMayLieBetweenThoseOfTheSeam) {
  output_.set_height(0, 1.5);
  EXPECT_TRUE(Check().ok()) << Check();
}

TEST_F(SmoothCheckTest, OthersAreTheWorkersFault) {
  output_.set_height(0, 3);
  EXPECT_TRUE(absl::IsDataLoss(Check()));
}

TEST_F(SmoothCheckTest, SoIsAnotherSeam) {
  output_.set_number(5);
  EXPECT_TRUE(absl::IsDataLoss(Check()));
  output_.set_number(4);
  output_.add_height(1);
  EXPECT_TRUE(absl::IsDataLoss(Check()));
}

TEST_F(SmoothCheckTest, SoAreMovesOfPointsThatAreNotThere) {
  output_.mutable_a()->add_point(0);
  output_.mutable_a()->add_height(1);
  EXPECT_TRUE(absl::IsDataLoss(Check()));
}

}  // namespace
}  // namespace tilemend
