// Work on a scene that can be done now.
#ifndef TILEMEND_COORDINATOR_WAVES_WORK_QUEUE_H_
#define TILEMEND_COORDINATOR_WAVES_WORK_QUEUE_H_

#include <cstdint>
#include <deque>
#include <optional>

#include "coordinator/waves/tile_writes.h"
#include "coordinator/waves/wave_order.h"

namespace tilemend {

struct WorkItem {
  Wave wave = Wave::kSurvey;
  CellId cell = {};
  int32_t number = -1;  // of kCluster that of the cluster, of kSmooth that of the seam
};

// Gives out each item once, in the order in which they came. Tiles to write come beside the rest (TileWrites).
class WorkQueue {
 public:
  void Push(const WorkItem& item) { ready_.push_back(item); }
  TileWrites& writes() { return writes_; }
  const TileWrites& writes() const { return writes_; }

  std::optional<WorkItem> Next() {
    if (const auto cell = writes_.Next(awaited_, !ready_.empty())) return WorkItem{Wave::kAssemble, *cell};
    if (ready_.empty()) return std::nullopt;
    const WorkItem item = ready_.front();
    ready_.pop_front();
    ++awaited_;
    return item;
  }
  // The result of one that was given out is there. For tiles it is TileWrites that hears of it.
  void Settle() { --awaited_; }
  // Takes back the items of a cell that has no holes to fill any more.
  void Drop(CellId cell) {
    std::erase_if(ready_, [&](const WorkItem& item) { return item.cell == cell && item.wave != Wave::kCluster; });
  }
  // Whether there is no item, except for tiles to write, to give out or to wait for.
  bool is_over() const { return ready_.empty() && awaited_ == 0; }

 private:
  std::deque<WorkItem> ready_;
  int64_t awaited_ = 0;
  TileWrites writes_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_WORK_QUEUE_H_
