#include "coordinator/waves/tile_writes.h"

namespace tilemend {

bool TileWrites::Queue(CellId cell) {
  if (!known_.insert(cell).second) return false;
  ready_.push_back(cell);
  return true;
}

std::optional<CellId> TileWrites::Next(int64_t others, bool others_wait) {
  const bool is_alone = others == 0 && !others_wait;
  if (ready_.empty() || (!is_alone && out_ >= others)) return std::nullopt;
  const CellId cell = ready_.front();
  ready_.pop_front();
  ++out_;
  return cell;
}

}  // namespace tilemend
