// What one level of detail of tiles got, in numbers.
#ifndef TILEMEND_COMMON_RECORDS_LEVEL_COUNTS_H_
#define TILEMEND_COMMON_RECORDS_LEVEL_COUNTS_H_

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace tilemend {

// Of all nodes as deep in their trees: what a viewer replaces by finer nodes, or shows last.
struct LevelCounts {
  int64_t nodes = 0;
  int64_t filled = 0;   // nodes that got triangles
  int64_t added = 0;    // triangles
  int64_t removed = 0;  // triangles that polygons cleared

  bool operator==(const LevelCounts&) const = default;
};

// Adds the counts of one tile, the coarsest level first, to those of others.
inline void AddLevels(std::span<const LevelCounts> tile, std::vector<LevelCounts>& sum) {
  sum.resize(std::max(sum.size(), tile.size()));
  for (size_t l = 0; l < tile.size(); ++l) {
    sum[l].nodes += tile[l].nodes;
    sum[l].filled += tile[l].filled;
    sum[l].added += tile[l].added;
    sum[l].removed += tile[l].removed;
  }
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_LEVEL_COUNTS_H_
