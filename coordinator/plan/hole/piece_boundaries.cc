#include "coordinator/plan/hole/piece_boundaries.h"

#include <algorithm>

#include "common/mesh/edge_key.h"

namespace tilemend {

std::optional<bool> PieceBoundaries::ReachBeyond(const std::vector<RimSegment>& loop) {
  Read();
  const RimSegment& first = loop.front();  // the other way round than its edge
  const RimPoint &to = site_.rim.points[first.to], &from = site_.rim.points[first.from];
  if (to.tile != boundary_.cell || from.tile != boundary_.cell) return std::nullopt;
  const auto piece = piece_of_.find(EdgeKey(to.index, from.index));
  if (piece == piece_of_.end()) return std::nullopt;
  Eigen::AlignedBox2d of_loop;
  for (const RimSegment& s : loop) of_loop.extend(Point2(site_.position[s.from].head<2>()));
  return !of_loop.contains(extent_of_[piece->second]);
}

void PieceBoundaries::Read() {
  if (is_read_) return;
  is_read_ = true;
  if (boundary_.surface == nullptr) return;
  const StoredRecord::Pointer record = boundary_.surface->Outline();
  for (const BoundaryEdge& e : record->edges) {
    const BoundaryVertex &from = record->vertices[e.from], &to = record->vertices[e.to];
    piece_of_.emplace(EdgeKey(from.index, to.index), e.piece);
    extent_of_.resize(std::max<size_t>(extent_of_.size(), static_cast<size_t>(e.piece) + 1));
    extent_of_[e.piece].extend(Point2(from.position.head<2>()));
  }
}

}  // namespace tilemend
