#include "client/fitted_table.h"

#include <algorithm>
#include <numeric>

#include "client/output.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr size_t kBetween = 2;  // columns of the terminal
constexpr size_t kEasy = 20, kLeast = 8;

using Rows = std::vector<std::vector<std::string>>;

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
  for (auto& row : rows) {
    for (std::string& cell : row) cell = Printable(cell);
  }
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

}  // namespace tilemend
