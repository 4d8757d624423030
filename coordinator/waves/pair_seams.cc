#include "coordinator/waves/pair_seams.h"

namespace tilemend {

std::map<CellPair, PairSeam> FindPairSeams(const Plan& plan, std::span<const int32_t> holes,
                                           const SeamHeights& heights) {
  std::map<std::pair<int32_t, int32_t>, int32_t> hole_at;  // seam segments: from, to
  for (const int32_t h : holes) {
    if (plan.holes[h].layer == 0 || plan.holes[h].water >= 0) continue;
    for (const RimSegment& s : plan.holes[h].segments) {
      if (s.seam) hole_at[{s.from, s.to}] = h;
    }
  }
  std::map<CellPair, PairSeam> seams;
  for (const auto& [segment, h] : hole_at) {
    const auto across = hole_at.find({segment.second, segment.first});
    if (across == hole_at.end()) continue;
    const PlannedHole &hole = plan.holes[h], &other = plan.holes[across->second];
    if (!(hole.cell < other.cell) || hole.layer != other.layer) continue;
    PairSeam& seam = seams[{hole.cell, other.cell}];
    seam.holes_of_first.insert(h);
    seam.holes_of_second.insert(across->second);
    for (const int32_t v : {segment.first, segment.second}) {
      if (plan.vertices[v].index < 0 && heights.height.contains(v)) seam.vertices.insert(v);
    }
  }
  const PairSeam* before = nullptr;
  CellId first;
  for (auto& [cells, seam] : seams) {
    if (before != nullptr && cells.first == first) seam.number = before->number + 1;
    before = &seam;
    first = cells.first;
  }
  return seams;
}

}  // namespace tilemend
