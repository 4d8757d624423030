#include "coordinator/journal/journal_rows.h"

#include <gtest/gtest.h>

#include <set>

namespace tilemend {
namespace {

TEST(JournalRowsTest, NoTwoListsOfPartsHaveOneSum) {
  EXPECT_NE(SumOf({"ab", "c"}), SumOf({"a", "bc"}));
  EXPECT_NE(SumOf({"a", ""}), SumOf({"a"}));
  EXPECT_EQ(SumOf({"a"}).size(), sizeof(NameBytes));
}

TEST(JournalRowsTest, ATasksNameIsThatOfAllItIsAsked) {
  const std::set<std::string> names = {NameOf({{1, 2}, Stage::kFill, "in"}), NameOf({{12, 0}, Stage::kFill, "in"}),
                                       NameOf({{1, 2}, Stage::kSurvey, "in"}), NameOf({{1, 2}, Stage::kFill, "on"})};
  EXPECT_EQ(names.size(), 4U);
}

TEST(JournalRowsTest, EveryColumnIsInTheSum) {
  const ResultRow row{1, 2, "name", 3, "output", 1, "error", "workers"};
  std::set<std::string> sums = {row.Sum()};
  for (int column = 0; column < 8; ++column) {
    ResultRow other = row;
    if (column == 0) ++other.number;
    if (column == 1) ++other.job;
    if (column == 2) other.name += "x";
    if (column == 3) ++other.state;
    if (column == 4) other.output += "x";
    if (column == 5) other.inside = 0;
    if (column == 6) other.error += "x";
    if (column == 7) other.lost_workers += "x";
    sums.insert(other.Sum());
  }
  EXPECT_EQ(sums.size(), 9U);
  EXPECT_NE(SumOfJob({1, "request", "body", true, false}), SumOfJob({1, "request", "body", false, true}));
  EXPECT_NE(SumOfAside({"worker", "reason"}), SumOfAside({"worker", "other"}));
}

}  // namespace
}  // namespace tilemend
