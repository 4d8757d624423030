#include "common/util/texture_wrap.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace tilemend {
namespace {

using Uv = std::vector<std::array<float, 2>>;

TEST(RepeatsImageTest, WhatGoesBeyondTheImageRepeatsIt) {
  EXPECT_FALSE(RepeatsImage(Uv{}));
  EXPECT_FALSE(RepeatsImage(Uv{{0, 1}, {1, 0.5F}, {-0.0005F, 1.0005F}})) << "rounding";
  EXPECT_TRUE(RepeatsImage(Uv{{0, 1}, {1.5F, 0.5F}}));
  EXPECT_TRUE(RepeatsImage(Uv{{0.5F, -0.5F}}));
}

}  // namespace
}  // namespace tilemend
