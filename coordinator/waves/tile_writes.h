// The order in which tiles are assembled.
#ifndef TILEMEND_COORDINATOR_WAVES_TILE_WRITES_H_
#define TILEMEND_COORDINATOR_WAVES_TILE_WRITES_H_

#include <cstdint>
#include <deque>
#include <optional>
#include <set>

#include "common/grid/scene.h"

namespace tilemend {

// Gives out each tile once. Assembling waits for disks and computing for cores, so while other work is out there are at
// most as many tiles beside it.
class TileWrites {
 public:
  // False if the cell was queued or dismissed before.
  bool Queue(CellId cell);
  // It has nothing to write, unless it was queued or dismissed before.
  void Dismiss(CellId cell) { cells_done_ += known_.insert(cell).second ? 1 : 0; }
  // `others` pieces of other work are out, and if `others_wait` there are more of them.
  std::optional<CellId> Next(int64_t others, bool others_wait);
  // The result of one that was given out is there, and whether it was written.
  void Settle(bool written) { --out_, cells_done_ += written ? 1 : 0; }
  // Cells that are written, or have nothing to write.
  int64_t cells_done() const { return cells_done_; }
  // Whether there is none to give out or to wait for.
  bool is_over() const { return ready_.empty() && out_ == 0; }

 private:
  std::set<CellId> known_;
  std::deque<CellId> ready_;
  int64_t out_ = 0;
  int64_t cells_done_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_TILE_WRITES_H_
