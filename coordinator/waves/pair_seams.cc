#include "coordinator/waves/pair_seams.h"

#include <algorithm>
#include <iterator>

#include "coordinator/waves/sample_checks.h"

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

std::vector<CellId> PairSmoothing::Begin(const PlannedScene& scene, const std::map<int32_t, std::string>& failures,
                                         const WaveOptions& options) {
  std::vector<CellId> cells_of;
  std::vector<int32_t> filled;
  for (const auto& [cell, holes] : scene.holes_of) {
    std::copy_if(holes.begin(), holes.end(), std::back_inserter(filled),
                 [&](int32_t h) { return !failures.contains(h); });
  }
  for (auto& [cells, seam] : FindPairSeams(scene.plan, filled, scene.heights)) {
    if (!options.TouchesChosen(cells.first, cells.second)) continue;
    cells_of.push_back(cells.first);
    seams_.emplace_back(cells, std::move(seam));
  }
  return cells_of;
}

SmoothWork PairSmoothing::WorkOf(int32_t seam, const PlannedScene& scene) const {
  const auto& [cells, pair] = seams_[seam];
  SmoothWork work{{cells.first, cells.second}, pair.number};
  for (int side = 0; side < 2; ++side) {
    work.sides[side] = HolesAsFilled(scene, work.cells[side]);
    const std::set<int32_t>& holes = side == 0 ? pair.holes_of_first : pair.holes_of_second;
    work.holes[side].assign(holes.begin(), holes.end());
  }
  for (const int32_t v : pair.vertices) {
    work.vertices.push_back(v);
    work.heights.push_back(scene.heights.height.at(v));
  }
  return work;
}

absl::Status PairSmoothing::Take(const SmoothedSeam& result, const Plan& plan) {
  if (result.heights.size() != result.vertices.size()) return absl::InvalidArgumentError("columns of unequal length");
  for (size_t i = 0; i < result.vertices.size(); ++i) {
    absl::Status status = CheckSample(plan, result.vertices[i], result.heights[i]);
    if (!status.ok()) return status;
    smoothed_[result.vertices[i]][{result.cells[0], result.cells[1]}] = result.heights[i];
  }
  return absl::OkStatus();
}

}  // namespace tilemend
