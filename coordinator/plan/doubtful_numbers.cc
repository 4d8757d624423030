#include "coordinator/plan/doubtful_numbers.h"

namespace tilemend {
namespace {

constexpr double kLeastCell = 1;         // metres, as a square of the ground raster
constexpr double kMostRelief = 8848.86;  // metres

}  // namespace

void RemarkOnNumbers(const PlanInput& input, PlanRemarks& remarks) {
  if (!input.has_grid) return;
  const double side = input.grid.cell_size.minCoeff();
  remarks.tiny_cell = side < kLeastCell ? side : 0;
  ImpossibleHeights& impossible = remarks.impossible_heights;
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr || record->triangle_count == 0) continue;
    const double lowest = record->lo.z(), highest = record->hi.z();
    if (highest - lowest <= kMostRelief) continue;
    if (impossible.tiles++ == 0) impossible = {1, cell, lowest, highest};
  }
}

}  // namespace tilemend
