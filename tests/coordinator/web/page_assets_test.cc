#include "coordinator/web/page_assets.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(PageAssetsTest, AreCompressedAndSmallEnoughTogether) {
  for (const std::string_view file : {ConsoleScript(), ConsoleStyle(), DracoDecoder()}) {
    EXPECT_EQ(file.substr(0, 2), "\x1f\x8b");
    EXPECT_GT(file.size(), 500U);
  }
  EXPECT_LT(ConsoleScript().size() + ConsoleStyle().size() + DracoDecoder().size(), 400'000U);
}

}  // namespace
}  // namespace tilemend
