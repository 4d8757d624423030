#include "common/grid/cell_choice.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

// Takes "3,4" from the front of `text`; false if that is not there.
bool TakeCell(std::string_view& text, CellId& cell) {
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  const auto number = [&](int32_t& value) {
    const auto [after, error] = std::from_chars(at, end, value);
    at = after;
    return error == std::errc();
  };
  if (!number(cell.col) || at == end || *at++ != ',' || !number(cell.row)) return false;
  text.remove_prefix(static_cast<size_t>(at - text.data()));
  return true;
}

absl::Status NoCell(std::string_view word, const char* what) {
  return absl::InvalidArgumentError(absl::StrCat("'", Printable(std::string(word)), "': ", what));
}

absl::StatusOr<CellRange> ParseRange(std::string_view word) {
  std::string_view rest = word;
  CellRange range;
  bool is_range = TakeCell(rest, range.low);
  range.high = range.low;
  if (is_range && !rest.empty()) {
    is_range = rest.front() == '-';
    rest.remove_prefix(1);
    is_range = is_range && TakeCell(rest, range.high) && rest.empty();
  }
  if (!is_range) return NoCell(word, "expected a cell (column,row: 3,4) or a range of them (0,0-5,9)");
  if (range.high.col < range.low.col || range.high.row < range.low.row) {
    return NoCell(word, "a range goes from the lowest column and row to the highest");
  }
  return range;
}

bool IsIn(CellId cell, const CellRange& range) {
  return cell.col >= range.low.col && cell.col <= range.high.col && cell.row >= range.low.row &&
         cell.row <= range.high.row;
}

}  // namespace

absl::StatusOr<std::vector<CellRange>> ParseCells(const std::string& text) {
  std::vector<CellRange> ranges;
  for (const absl::string_view word : absl::StrSplit(text, ' ', absl::SkipEmpty())) {
    TILEMEND_ASSIGN_OR_RETURN(ranges.emplace_back(), ParseRange({word.data(), word.size()}));
  }
  if (ranges.empty() && !text.empty()) return NoCell(text, "names no cell; all cells are chosen by leaving it out");
  return ranges;
}

absl::StatusOr<std::set<CellId>> ChooseCells(const std::string& text, const Scene& scene) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<CellRange> ranges, ParseCells(text));
  std::set<CellId> cells;
  for (const CellRange& range : ranges) {
    bool any = false;
    for (const SceneTile& tile : scene.tiles) {
      if (!IsIn(tile.cell, range)) continue;
      any = true;
      cells.insert(tile.cell);
    }
    if (any) continue;
    if (range.low == range.high) {
      return absl::InvalidArgumentError(absl::StrCat("cell ", ToString(range.low), ": the scene does not have it"));
    }
    return absl::InvalidArgumentError(
        absl::StrCat("cells ", ToString(range.low), " to ", ToString(range.high), ": the scene has none of them"));
  }
  return cells;
}

}  // namespace tilemend
