#include "common/options/method_options.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(MethodOptionsTest, WhatIsAbsentIsAsTheStructsHaveIt) {
  const WangOptions wang = WangOptionsOf({});
  EXPECT_EQ(wang.longest_loop, WangOptions().longest_loop);
  EXPECT_EQ(wang.closure, WangOptions().closure);
  const FillerOptions filler = FillerOptionsOf({});
  EXPECT_EQ(filler.merge, FillerOptions().merge);
  EXPECT_FALSE(filler.bend.has_value());
}

TEST(MethodOptionsTest, TakesWhatIsGiven) {
  v1::JobSpec spec;
  spec.set_seam_smoothing(0);
  spec.set_fairing_steps(0);
  spec.set_seam_points("spaced");
  spec.set_closure("line");
  const WangOptions wang = WangOptionsOf(spec);
  EXPECT_EQ(wang.seam_smoothing, 0);
  EXPECT_EQ(wang.fairing_steps, 0);
  EXPECT_EQ(wang.seam_points, SeamPoints::kSpaced);
  EXPECT_EQ(wang.closure, Closure::kLine);
  spec.set_front_steps("printed");
  spec.set_front_bend(0.5);
  spec.set_svm_laplacian("mean");
  spec.set_svm_rings(5);
  const FillerOptions filler = FillerOptionsOf(spec);
  EXPECT_EQ(filler.steps, FrontSteps::kPrinted);
  EXPECT_EQ(filler.bend, 0.5);
  EXPECT_EQ(filler.scale, LaplacianScale::kMean);
  EXPECT_EQ(filler.rings, 5);
}

}  // namespace
}  // namespace tilemend
