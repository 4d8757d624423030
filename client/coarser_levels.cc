#include "client/coarser_levels.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"

namespace tilemend {

CoarserLevels::CoarserLevels(std::vector<LevelCounts> reported)
    : reported_(std::move(reported)), found_(reported_.size()) {}

void CoarserLevels::Add(CellId cell, const std::vector<TileChange>& levels, bool is_cleared) {
  const size_t count = std::min(levels.size(), found_.size());
  for (size_t l = 0; l < count; ++l) {
    found_[l].added += levels[l].added_count;
    if (is_cleared) found_[l].missing += std::ssize(levels[l].missing);
    if (levels[l].added_count == 0 && levels.back().added_count > 0) found_[l].without.push_back(cell);
  }
}

std::vector<CoarserLevels::Fault> CoarserLevels::Unfilled() const {
  std::vector<Fault> faults;
  int64_t removed = 0;  // a fill may put some of what was taken out there again, to the bit
  for (size_t l = 0; l < found_.size(); ++l) {
    removed += reported_[l].removed;
    if (found_[l].added + removed >= reported_[l].added) continue;
    for (const CellId cell : found_[l].without) {
      faults.push_back(
          {cell, absl::StrCat("cell ", cell.col, ",", cell.row, ": level of detail ", l, " (0 the coarsest)")});
    }
  }
  return faults;
}

std::vector<CoarserLevels::Fault> CoarserLevels::Cleared() const {
  std::vector<Fault> faults;
  int64_t removed = 0;  // a level shows triangles of coarser ones where nothing replaces these
  for (size_t l = 0; l < found_.size(); ++l) {
    removed += reported_[l].removed;
    if (found_[l].missing <= removed) continue;
    faults.push_back({{},
                      absl::StrCat("level of detail ", l, " (0 the coarsest): ", found_[l].missing, " taken out, ",
                                   removed, " reported")});
  }
  return faults;
}

}  // namespace tilemend
