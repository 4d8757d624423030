#include "client/fitted_table.h"

#include <gtest/gtest.h>

#include "absl/strings/str_split.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

using Rows = std::vector<std::vector<std::string>>;

const std::vector<FittedColumn> kColumns = {{"ID"}, {"CELLS", 2}, {"AGE", 1}, {"OUT", 0, true}};
const Rows kRows = {{"jobs/1", "30/30", "5 min 02 s", "/data/a/very/long/path/to/one"},
                    {"jobs/2", "2/3", "1 s", "/data/b"}};

size_t Longest(const std::string& text) {
  size_t longest = 0;
  for (const absl::string_view line : absl::StrSplit(text, '\n')) {
    longest = std::max(longest, ColumnsOf({line.data(), line.size()}));
  }
  return longest;
}

TEST(FittedTableTest, ShowsAllWhereThereIsRoomOrNoTerminal) {
  const std::string all =
      "ID      CELLS  AGE         OUT\n"
      "jobs/1  30/30  5 min 02 s  /data/a/very/long/path/to/one\n"
      "jobs/2  2/3    1 s         /data/b\n";
  EXPECT_EQ(FittedTable(kColumns, kRows, 0), all);
  EXPECT_EQ(FittedTable(kColumns, kRows, 56), all);
}

TEST(FittedTableTest, SqueezesLongCellsThenLeavesColumnsOutThenSqueezesMore) {
  EXPECT_EQ(FittedTable(kColumns, kRows, 55),
            "ID      CELLS  AGE         OUT\n"
            "jobs/1  30/30  5 min 02 s  /data/a/.../long/path/to/one\n"
            "jobs/2  2/3    1 s         /data/b\n");
  EXPECT_EQ(FittedTable(kColumns, kRows, 46),
            "ID      AGE         OUT\n"
            "jobs/1  5 min 02 s  /data.../path/to/one\n"
            "jobs/2  1 s         /data/b\n");
  EXPECT_EQ(FittedTable(kColumns, kRows, 20),
            "ID      OUT\n"
            "jobs/1  /da...to/one\n"
            "jobs/2  /data/b\n");
}

TEST(FittedTableTest, NoLineIsLongerWhereThatCanBe) {
  for (size_t columns = 16; columns < 70; ++columns) {
    EXPECT_LE(Longest(FittedTable(kColumns, kRows, columns)), columns);
  }
  EXPECT_EQ(FittedTable(kColumns, kRows, 1), FittedTable(kColumns, kRows, 16));  // that is the least
}

TEST(FittedTableTest, LastCellsThatAreEmptyTakeNoRoom) {
  EXPECT_EQ(FittedTable({{"A"}, {"B", 0, true}}, {{"12345678", ""}}, 11), "       A  B\n12345678\n");
}

TEST(FittedTableTest, WhatIsSqueezedIsPrintable) {
  const std::string text = FittedTable({{"A", 0, true}}, {{std::string("\x1b[31m") + std::string(30, 'a')}}, 12);
  EXPECT_EQ(text, "A\n\\x1...aaaaaa\n");
}

const Rows kTexts = {{"7", "12.5", "its rim is too short to tell a level"}, {"12", "3.0", ""}, {"3", "1.0", "[1]"}};

TEST(TableWithTextsTest, TextsStandBesideTheirRowsWhereThereIsRoom) {
  const std::string beside =
      "hole  area  because\n"
      "   7  12.5  its rim is too short to tell a level\n"
      "  12   3.0\n"
      "   3   1.0  [1]\n";
  EXPECT_EQ(TableWithTexts({"hole", "area", "because"}, kTexts, 0), beside);
  EXPECT_EQ(TableWithTexts({"hole", "area", "because"}, kTexts, 48), beside);
}

TEST(TableWithTextsTest, ElseTheyStandBelowBrokenBetweenWords) {
  EXPECT_EQ(TableWithTexts({"hole", "area", "because"}, kTexts, 30),
            "hole  area\n"
            "      because\n"
            "   7  12.5\n"
            "      its rim is too short to\n"
            "      tell a level\n"
            "  12   3.0\n"
            "   3   1.0\n"
            "      [1]\n");
}

TEST(TableWithTextsTest, AsManyColumnsStandBelowAsNeeded) {
  EXPECT_EQ(TableWithTexts({"hole", "taken for", "because"}, {{"7", "lake at 4 m", "level"}, {"8", "", "no rim"}}, 16),
            "hole\n"
            "      taken for;\n"
            "      because\n"
            "   7\n"
            "      lake at 4\n"
            "      m; level\n"
            "   8\n"
            "      no rim\n");
}

TEST(TableWithTextsTest, TextsStandBelowTheirRowsIfOneHasNothingElse) {
  EXPECT_EQ(TableWithTexts({"hole", "because"}, {{"7", "level"}, {"", "its rim is open"}, {"8", "no rim"}}, 16),
            "hole\n"
            "      because\n"
            "   7\n"
            "      level\n"
            "\n"
            "      its rim is\n"
            "      open\n"
            "   8\n"
            "      no rim\n");
}

TEST(TableWithTextsTest, WhatIsBrokenIsPrintable) {
  EXPECT_EQ(TableWithTexts({"a", "b"}, {{"x", "one\ntwo three"}}, 16),
            "a\n      b\nx\n      one\\x0atwo\n      three\n");
}

}  // namespace
}  // namespace tilemend
