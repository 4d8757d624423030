#include "coordinator/report/ring_chains.h"

#include <map>
#include <set>
#include <utility>

namespace tilemend {

std::vector<std::vector<int32_t>> RingsOf(const std::vector<RimSegment>& segments) {
  std::multiset<std::pair<int32_t, int32_t>> walks;
  for (const RimSegment& s : segments) {
    if (const auto back = walks.find({s.to, s.from}); back != walks.end()) {
      walks.erase(back);
    } else {
      walks.insert({s.from, s.to});
    }
  }
  std::vector<std::vector<int32_t>> rings;
  while (!walks.empty()) {
    std::vector<int32_t> walk = {walks.begin()->first};
    std::map<int32_t, size_t> place = {{walk[0], 0}};
    for (auto step = walks.begin(); step != walks.end(); step = walks.lower_bound({walk.back(), INT32_MIN})) {
      if (step->first != walk.back()) break;
      const int32_t to = step->second;
      walks.erase(step);
      const auto [seen, fresh] = place.try_emplace(to, walk.size());
      if (fresh) {
        walk.push_back(to);
        continue;
      }
      // A ring is closed wherever the walk meets itself, so that rings that touch at a vertex are two.
      rings.emplace_back(walk.begin() + static_cast<ptrdiff_t>(seen->second), walk.end());
      for (size_t i = seen->second + 1; i < walk.size(); ++i) place.erase(walk[i]);
      walk.resize(seen->second + 1);
    }
  }
  return rings;
}

}  // namespace tilemend
