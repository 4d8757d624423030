// Boundaries of tiles that are stored as several pieces, drawn ring by ring.
#ifndef TILEMEND_TESTS_SUPPORT_PIECE_RINGS_H_
#define TILEMEND_TESTS_SUPPORT_PIECE_RINGS_H_

#include <string>
#include <vector>

#include "common/records/survey_record.h"
#include "coordinator/plan/overlap/piece_walk.h"

namespace tilemend {

struct PieceRings {
  SurveyRecord record;
  std::vector<BoundaryKind> kinds;

  // A piece of its own, counter-clockwise. For each edge from a corner to the next, `edges` has a letter. It is o on
  // the tile's outline, p on the piece's, c in a chain.
  void Add(const std::vector<Point2>& corners, const std::string& edges) {
    const auto base = static_cast<int32_t>(record.vertices.size()), count = static_cast<int32_t>(corners.size());
    for (int32_t k = 0; k < count; ++k) {
      record.vertices.push_back({-1, {corners[k].x(), corners[k].y(), 0}});
      record.lo = record.lo.cwiseMin(record.vertices.back().position);
      record.hi = record.hi.cwiseMax(record.vertices.back().position);
      record.edges.push_back({base + k, base + (k + 1) % count, pieces});
      kinds.push_back(edges[k] == 'o'   ? BoundaryKind::kOutline
                      : edges[k] == 'p' ? BoundaryKind::kPiece
                                        : BoundaryKind::kChain);
    }
    ++pieces;
  }

  PieceBoundary Boundary() const {
    PieceBoundary boundary{record, kinds, {}};
    boundary.on_outline.resize(record.vertices.size(), false);
    for (size_t e = 0; e < kinds.size(); ++e) {
      if (kinds[e] != BoundaryKind::kOutline) continue;
      boundary.on_outline[record.edges[e].from] = boundary.on_outline[record.edges[e].to] = true;
    }
    return boundary;
  }

  // The vertex there; there must be one alone.
  int32_t At(double x, double y) const {
    int32_t found = -1;
    for (int32_t v = 0; v < std::ssize(record.vertices); ++v) {
      if (record.vertices[v].position.head<2>() == Point2(x, y)) found = found < 0 ? v : -2;
    }
    return found;
  }

  int32_t pieces = 0;
};

// A river's end in a tile of 20 m by 10 m. The west and the north are there, and the south-eastern piece up to its
// outline at y = 5.2.
inline PieceRings RiversEnd() {
  PieceRings tile;
  tile.Add({{0, 0}, {10.2, 0}, {10.2, 10}, {0, 10}}, "opoo");
  tile.Add({{9.8, 0}, {20, 0}, {20, 5.2}, {9.8, 5.2}}, "oopp");
  tile.Add({{9.8, 8}, {20, 8}, {20, 10}, {9.8, 10}}, "coop");
  return tile;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_PIECE_RINGS_H_
