// Where pieces of one tile end along each other.
#ifndef TILEMEND_COORDINATOR_PLAN_PIECES_PIECE_BORDERS_H_
#define TILEMEND_COORDINATOR_PLAN_PIECES_PIECE_BORDERS_H_

#include <vector>

#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/rim/rim_index.h"

namespace tilemend {

// For each rim edge the distance to another piece of the tile that ends along it, metres, or -1: an edge in a plane of
// constant x, y or z, with an edge in a plane of the same kind that runs the other way within `reach` metres, shares no
// vertex with it, and is of another loop or lies over the surface (else the two are the sides of a crack).
// Photogrammetry stores a tile in boxes of an octree whose borders overlap a little and do not weld; such an outline is
// no hole. Edges at the tile's own outline (`closing` is another cell) have -1. Cost in proportion to the edges near
// each edge.
std::vector<double> FindPieceBorders(const Rim& rim, const RimIndex& index, const ClosingCells& closing, double reach);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_PIECES_PIECE_BORDERS_H_
