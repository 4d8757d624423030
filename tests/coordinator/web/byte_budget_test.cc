#include "coordinator/web/byte_budget.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(ByteBudgetTest, GivesNoMoreThanThereIs) {
  ByteBudget budget(10);
  auto first = budget.Take(6);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(budget.Take(5), nullptr);
  const auto second = budget.Take(4);
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(budget.Take(1), nullptr);
  first.reset();
  EXPECT_NE(budget.Take(6), nullptr);
}

TEST(ByteBudgetTest, AShareGivesBackWhatItDoesNotNeed) {
  ByteBudget budget(10);
  auto share = budget.Take(10);
  share->ShrinkTo(20);  // as it was
  EXPECT_EQ(budget.Take(1), nullptr);
  share->ShrinkTo(3);
  EXPECT_EQ(budget.Take(8), nullptr);
  EXPECT_NE(budget.Take(7), nullptr);
  share.reset();
  EXPECT_NE(budget.Take(10), nullptr);
  EXPECT_EQ(budget.Take(11), nullptr);
}

}  // namespace
}  // namespace tilemend
