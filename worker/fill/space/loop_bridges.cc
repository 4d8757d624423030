#include "worker/fill/space/loop_bridges.h"

#include <algorithm>
#include <utility>

namespace tilemend {
namespace {

// Places of a loop that bridges begin or end at, at most; of a longer one every second, third and so on.
constexpr size_t kBridgeEnds = 600;

}  // namespace

std::vector<Bridge> BridgesFrom(const BridgeEnds& ends, const std::vector<VertexLoop>& loops) {
  std::vector<Bridge> bridges;
  for (size_t l = 1; l < loops.size(); ++l) {
    const size_t step = 1 + loops[0].size() / kBridgeEnds, other_step = 1 + loops[l].size() / kBridgeEnds;
    for (size_t i = 0; i < loops[0].size(); i += step) {
      for (size_t k = 0; k < loops[l].size(); k += other_step) {
        const int32_t a = loops[0][i], b = loops[l][k];
        if (a == b || ends.may_be_tied(a, b)) bridges.push_back({i, l, k, (ends.at(a) - ends.at(b)).norm()});
      }
    }
  }
  std::stable_sort(bridges.begin(), bridges.end(),
                   [](const Bridge& a, const Bridge& b) { return a.length < b.length; });
  return bridges;
}

bool BuildBridge(const Bridge& bridge, std::vector<VertexLoop>& loops) {
  VertexLoop around = std::move(loops[bridge.loop]);
  loops.erase(loops.begin() + static_cast<ptrdiff_t>(bridge.loop));
  std::ranges::rotate(around, around.begin() + static_cast<ptrdiff_t>(bridge.to));
  VertexLoop& loop = loops[0];
  const int32_t start = around[0], end = loop[bridge.from];
  around.push_back(start);
  if (start == end) {
    around.erase(around.begin());
  } else {
    around.push_back(end);
  }
  loop.insert(loop.begin() + static_cast<ptrdiff_t>(bridge.from) + 1, around.begin(), around.end());
  return start != end;
}

}  // namespace tilemend
