// Boundaries of tiles that are stored as several pieces, drawn ring by ring.
#ifndef TILEMEND_TESTS_SUPPORT_PIECE_RINGS_H_
#define TILEMEND_TESTS_SUPPORT_PIECE_RINGS_H_

#include <string>
#include <vector>

#include "common/records/survey_record.h"
#include "coordinator/plan/overlap/piece_ends.h"

namespace tilemend {

struct PieceRings {
  SurveyRecord record;
  std::string kinds;  // of the edges

  // A piece of its own, counter-clockwise. For each edge from a corner to the next, `edges` has a letter. It is o on
  // the tile's outline, p on the piece's, c in a chain.
  void Add(const std::vector<Point2>& corners, const std::string& edges) {
    const auto base = static_cast<int32_t>(record.vertices.size()), count = static_cast<int32_t>(corners.size());
    for (int32_t k = 0; k < count; ++k) {
      record.vertices.push_back({-1, {corners[k].x(), corners[k].y(), 0}});
      record.lo = record.lo.cwiseMin(record.vertices.back().position);
      record.hi = record.hi.cwiseMax(record.vertices.back().position);
      record.edges.push_back({base + k, base + (k + 1) % count, pieces});
      kinds.push_back(edges[k]);
    }
    ++pieces;
  }

  PieceBoundary Boundary() const {
    PieceBoundary boundary{record, {}, {}, {}};
    boundary.on_outline.resize(record.vertices.size(), false);
    for (size_t e = 0; e < kinds.size(); ++e) {
      boundary.in_chain.push_back(kinds[e] == 'c');
      if (kinds[e] != 'o') continue;
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

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_PIECE_RINGS_H_
