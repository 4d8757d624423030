// Fills the holes of one cell.
#ifndef TILEMEND_WORKER_FILL_FILL_HOLES_H_
#define TILEMEND_WORKER_FILL_FILL_HOLES_H_

#include <functional>
#include <vector>

#include "common/records/cell_holes.h"
#include "worker/fill/hole/fill_options.h"

namespace tilemend {

// Fills each hole with new triangles that close on its rim (Wang 2021, 3.3: triangulation, refinement, adjustment,
// fairing). The ways below are tried in this order, each where it applies. The first sound patch is taken. In a mesh
// that may lie in any way, it is the first that has no creases, or none but bevelled ones (patch_creases.h). If every
// sound patch has others, the hole stays open. Exceptions are kCreases, whose creases go on from those around the hole,
// and options.allow_creases.
//
//   FillWay       holes                                     see
//   kCreases      closed, thin plate                        crease_fill.h
//   kUnrolled     closed, thin plate, steep                unrolled_fill.h
//   kGround       open, in the ground; closed if all around it faces up    plane_fill.h (kWater with CellHole::level)
//   kOwnPlane     closed                                    plane_fill.h
//   kFacingPlane  closed, thin plate                        plane_fill.h
//   kUnrolled     closed, thin plate, not steep             unrolled_fill.h
//   kSpace        closed                                    space_fill.h
//   kFoldsCut     all, same planes                          folded_fill.h
//
// With options.filler but kAuto closed holes without a level are filled by that one alone
// (options.published), their patches checked for crossings.
//
// A closed hole in the ground (LocalHole::in_ground), or with a level, is filled as an open one. That is over the
// ground, if need be with its folds cut off. New vertices of water all get its level.
//
// A patch of a closed hole that is no height over the ground must cross neither itself nor `near`. Nor may it cross the
// patches of the cell's holes before it. It must also fold back on none (patch_soundness.h). Else the next way is
// tried. The surface `near` is asked only then; without it the band stands for the surface. Heights over the ground are
// not checked for crossings: they cannot cross themselves or what goes on from their rim. Where folds are cut off or
// walls stand at a tile's outline, crossings are mended as far as that is possible (mend_crossings.h). A patch in
// parts, unrolled or over the facing plane may not face down where heights fill the hole. Nor may it go further than
// half the hole's extent from it.
//
// Guarantees: every rim segment of a filled hole has exactly one patch triangle, oriented like the surface around it.
// With the surface around it the patch makes no edge with three triangles and no triangle twice. No triangle is without
// area. New vertices lie on the lattice, or where that is too coarse on what the output holds. A hole that cannot be
// filled so has a failure and no geometry. The same goes for a hole whose patch would bring the vertices of the cell
// and its patches so far to options.refine.max_new_points or more; no further way is tried then. Once options.refine is
// cancelled, patches are missing or failed. Heights of seam vertices must be known. Deterministic; pure; safe from any
// thread. After each hole `hole_done` is called.
std::vector<HolePatch> FillHoles(const CellHoles& cell, const FillOptions& options, const SurfaceNear& near = {},
                                 const std::function<void()>& hole_done = {});

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_FILL_HOLES_H_
