#include "client/fitted_table.h"

#include <algorithm>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "client/output.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr size_t kBetween = 2;  // columns of the terminal
constexpr size_t kEasy = 20, kLeast = 8;

using Rows = std::vector<std::vector<std::string>>;

void MakePrintable(Rows& rows) {
  for (auto& row : rows) {
    for (std::string& cell : row) cell = Printable(cell);
  }
}

size_t WidthOf(const std::vector<FittedColumn>& table, const Rows& rows, size_t column) {
  size_t width = table[column].heading.size();
  for (const auto& row : rows) width = std::max(width, ColumnsOf(row[column]));
  return width;
}

// By how much the lines are too long. Blanks at their end are not printed.
size_t Excess(const std::vector<FittedColumn>& table, const Rows& rows, size_t columns) {
  size_t longest = 0;
  std::vector<size_t> begin(table.size() + 1, 0);
  for (size_t i = 0; i < table.size(); ++i) {
    longest = std::max(longest, begin[i] + table[i].heading.size());
    for (const auto& row : rows) {
      if (!row[i].empty()) longest = std::max(longest, begin[i] + ColumnsOf(row[i]));
    }
    begin[i + 1] = begin[i] + WidthOf(table, rows, i) + kBetween;
  }
  return longest > columns ? longest - columns : 0;
}

void Squeeze(const std::vector<FittedColumn>& table, Rows& rows, size_t columns, size_t least) {
  for (size_t i = table.size(); i-- > 0;) {  // messages and paths stand last
    const size_t excess = Excess(table, rows, columns), width = WidthOf(table, rows, i);
    if (!table[i].squeezable || excess == 0 || width <= least) continue;
    const size_t most = std::max(least, width - std::min(width, excess));
    for (auto& row : rows) row[i] = SqueezedTo(row[i], most);
  }
}

// Broken between words into lines of at most `columns`, where no word is longer.
std::string Indented(const std::string& text, size_t columns) {
  constexpr std::string_view kIndent = "      ";
  std::string lines, line(kIndent);
  for (const absl::string_view word : absl::StrSplit(text, ' ', absl::SkipEmpty())) {
    const bool is_first = line.size() == kIndent.size();
    const std::string longer = absl::StrCat(line, is_first ? "" : " ", word);
    if (is_first || ColumnsOf(longer) <= columns) {
      line = longer;
    } else {
      absl::StrAppend(&lines, line, "\n");
      line = absl::StrCat(std::string(kIndent), word);
    }
  }
  return line.size() == kIndent.size() ? lines : absl::StrCat(lines, line, "\n");
}

std::string Joined(const std::string& text, const std::string& more) {
  return absl::StrCat(text, text.empty() || more.empty() ? "" : "; ", more);
}

// False if every column is needed.
bool LeaveOutOne(std::vector<FittedColumn>& table, Rows& rows) {
  const auto spare =
      std::max_element(table.begin(), table.end(), [](const auto& a, const auto& b) { return a.spare < b.spare; });
  if (spare->spare == 0) return false;
  const auto column = spare - table.begin();
  table.erase(spare);
  for (auto& row : rows) row.erase(row.begin() + column);
  return true;
}

}  // namespace

std::string FittedTable(std::vector<FittedColumn> table, Rows rows, size_t columns) {
  MakePrintable(rows);
  if (columns > 0) {
    Squeeze(table, rows, columns, kEasy);
    while (Excess(table, rows, columns) > 0 && LeaveOutOne(table, rows)) {
    }
    Squeeze(table, rows, columns, kLeast);
  }
  std::vector<std::string> headings;
  for (const FittedColumn& column : table) headings.push_back(column.heading);
  return Table(headings, rows);
}

std::string TableWithTexts(std::vector<std::string> headings, Rows rows, size_t columns) {
  std::vector<FittedColumn> table;
  for (const std::string& heading : headings) table.push_back({heading});
  MakePrintable(rows);
  if (columns == 0 || Excess(table, rows, columns) == 0) return Table(headings, rows);
  std::vector<std::string> texts(rows.size() + 1);  // the first is of the headings
  while (table.size() > 1 && Excess(table, rows, columns) > 0) {
    table.pop_back();
    texts[0] = Joined(headings.back(), texts[0]);
    headings.pop_back();
    for (size_t i = 0; i < rows.size(); ++i) {
      texts[i + 1] = Joined(rows[i].back(), texts[i + 1]);
      rows[i].pop_back();
    }
  }
  const std::string narrow = Table(headings, rows);
  const std::vector<std::string> lines = absl::StrSplit(narrow, '\n');  // the piece behind the last line is empty
  std::string text;
  for (size_t i = 0; i < texts.size(); ++i) absl::StrAppend(&text, lines[i], "\n", Indented(texts[i], columns));
  return text;
}

}  // namespace tilemend
