#include "coordinator/waves/scene_outcome.h"

#include <iterator>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

void AddSize(const PatchExtent& patch, SceneOutcome& outcome) {
  PatchSize& size = outcome.sizes[patch.hole];
  size.new_vertices += patch.new_vertices;
  size.triangles += patch.triangles;
  outcome.triangles += patch.triangles;
  size.way = patch.way;
  size.loop_cuts += patch.loop_cuts;
  size.creases += patch.creases;
  size.crossings += patch.crossings;
  size.rim_is_crossed |= patch.rim_is_crossed;
}

}  // namespace

void SceneOutcome::Fail(int32_t hole, const std::string& reason) {
  failures[hole] = reason;
  if (const auto size = sizes.extract(hole)) triangles -= size.mapped().triangles;
}

absl::Status SceneOutcome::Add(const CellFill& result, const Plan& plan) {
  for (const PatchExtent& patch : result.patches.patches) {
    if (patch.hole < 0 || patch.hole >= std::ssize(plan.holes)) {
      return absl::InvalidArgumentError(absl::StrCat("hole ", patch.hole, " is not in the plan"));
    }
    if (patch.hold_out) of_holes[patch.hole] = *patch.hold_out;
    if (!patch.failure.empty()) {
      Fail(patch.hole, patch.failure);
      continue;
    }
    filled.insert(result.cell);
    if (!failures.contains(patch.hole)) AddSize(patch, *this);
  }
  quality_of.insert_or_assign(result.cell, PackedTally(result.patches.quality));
  return absl::OkStatus();
}

void SceneOutcome::DropTile(LeftOpen left) {
  quality_of.erase(left.cell);
  unwritten.push_back(std::move(left));
}

void SceneOutcome::SetGaps(std::map<std::pair<CellId, CellId>, SurfaceGap> gaps) {
  std::set<CellId> dropped;
  for (const LeftOpen& left : unwritten) dropped.insert(left.cell);
  fill_gaps = std::move(gaps);
  std::erase_if(fill_gaps, [&](const auto& gap) {
    return dropped.contains(gap.first.first) || dropped.contains(gap.first.second);
  });
}

QualityTally SceneOutcome::Quality() const {
  QualityTally quality;
  for (const auto& [cell, tally] : quality_of) quality.Merge(tally.Unpack());
  return quality;
}

}  // namespace tilemend
