// Fills the holes of one cell.
#ifndef TILEMEND_WORKER_FILL_FILL_HOLES_H_
#define TILEMEND_WORKER_FILL_FILL_HOLES_H_

#include <vector>

#include "common/records/cell_holes.h"
#include "worker/fill/hole/fill_options.h"

namespace tilemend {

// Fills each hole with new triangles that close on its rim (Wang 2021, 3.3: triangulation, refinement, adjustment,
// fairing).
//
// Open holes are heights over the plane: constrained Delaunay triangulation of the region that rim and seams bound,
// refined, with heights by eq. 1 and eq. 2 to 4. Closed holes take the same way over the plane if the surface around
// them faces up, else over the plane of their own boundary; a boundary that projects without overlap on neither is
// triangulated in space (minimum weight, sound_triangulation.h), if it has at most kLongestSpatialLoop vertices;
// islands are tied to the rest of it. Boundaries that cross themselves on the plane (facades, trees, vertical edges)
// have their folds cut off (fold_cutting.h): the folds are closed in space, by a minimum-weight triangulation or about
// a new vertex, the rest over the plane.
//
// New vertices of water (CellHole::level) all get its level; the rest is the same.
//
// With kThinPlate closed holes are filled in parts along the sharp edges that go through them (crease_fill.h); those
// that are steep over every plane, or project on none, are refined in space (part_fill.h), if that makes a patch that
// does not face down where heights fill the hole.
//
// A patch of a closed hole that is no height over the ground is taken only if it crosses neither itself, nor `near`,
// nor the patches of the cell's holes before it, and folds back on none (patch_crossings.h); else the next way is
// tried. `near` is asked only then; without it the band stands for the surface. Open holes are not checked for
// crossings, nor those that project on the ground: their patches cannot cross themselves or what goes on from their
// rim.
//
// Guarantees: every rim segment of a filled hole has exactly one patch triangle, oriented like the surface around it;
// with the surface around it the patch makes no edge with three triangles and no triangle twice; new vertices lie on
// the lattice, or where that is too coarse on what the output holds; no triangle without area; a hole that cannot be
// filled so has a failure and no geometry. Heights of seam vertices must be known. Deterministic; pure; safe from any
// thread.
std::vector<HolePatch> FillHoles(const CellHoles& cell, const FillOptions& options, const SurfaceNear& near = {});

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_FILL_HOLES_H_
