// Fills a closed hole as the published fillers with an advancing front do.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_FRONT_FILL_H_
#define TILEMEND_WORKER_PAPERS_FRONT_FRONT_FILL_H_

#include <functional>
#include <span>

#include "common/mesh/tri_mesh.h"
#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Fills a hole with the filler that is named, and with no other. A patch may cross itself or the surface: the caller
// checks it. New points lie on the scene's lattice.
//
//   advancing-front-normal     Sun 2012: the front with NormalCurvatureRule
//   advancing-front-poisson    Zhao 2007: the front with PlainRule, then ShapeByNormals
//   svm-laplacian              Xu 2014: the same front from a rim without long edges, then ShapeByLaplacians; the rim's
//                              own edges again (TieBack)
//   advancing-front-curvature  the same front, then RefineByCurvature
//
//   hole     closed, with loops
//   surface  gives the surface around it; asked by svm-laplacian alone
// Precondition: the filler is one of these. Failures: no loops, a front that does not close, equations without a
// solution, a split edge that cannot be made whole.
LocalPatch FillWithFront(const LocalHole& hole, const FillOptions& options,
                         const std::function<std::span<const SpaceTriangle>()>& surface);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_FRONT_FILL_H_
