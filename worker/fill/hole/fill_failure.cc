#include "worker/fill/hole/fill_failure.h"

#include <cstddef>
#include <string>

#include "worker/fill/hole/fill_options.h"

namespace tilemend {
namespace {

// Of what is wrong with a patch.
std::string TextOfFault(FillFailure failure) {
  switch (failure) {
    case FillFailure::kNoSolution:
      return "the equations of its surface have no solution";
    case FillFailure::kTurnsOver:
      return "a triangle of its patch turns over where the output rounds";
    case FillFailure::kFlatTriangle:
      return "a triangle of its patch would have no area";
    case FillFailure::kRepeatsTriangle:
      return "its patch would repeat a triangle of the surface";
    case FillFailure::kOverfullEdge:
      return "its patch would make an edge with three triangles";
    case FillFailure::kNotClosed:
      return "its patch would not close on its whole boundary";
    case FillFailure::kFrontOpen:
      return "the advancing front did not close";
    case FillFailure::kNoBridge:
      return "its islands cannot be joined to the rest of its boundary";
    case FillFailure::kTooMuchWork:
      return "the advancing front needs more work than --filler-work allows";
    case FillFailure::kPatchCrosses:
      return "its patch passes through itself or the surface around it";
    case FillFailure::kGoesFar:
      return "its patch goes further from its boundary than that is wide";
    case FillFailure::kFoldsBack:
      return "every patch that was tried folds back at its boundary; --allow-creases takes such patches, --weld closes "
             "cracks whose sides overlap";
    default:
      return "";
  }
}

std::string TextOfLength(FillFailure failure, size_t boundary_edges) {
  const std::string has = "it has " + std::to_string(boundary_edges) + " boundary ";
  return failure == FillFailure::kTooLongForArea ? has + "vertices, more than --longest-loop allows"
                                                 : has + "edges, more than --longest-rim allows";
}

std::string TextOfLimit(const FailedHole& hole) {
  constexpr int64_t kMillion = 1'000'000;
  const int64_t limit = hole.max_vertices;
  const std::string vertices =
      (limit >= kMillion && limit % kMillion == 0 ? std::to_string(limit / kMillion) + " million"
                                                  : std::to_string(limit)) +
      " vertices or more";
  return hole.is_in_scene
             ? "the fill of its cell would have " + vertices + "; smaller cells or a larger --gradation make it smaller"
             : "the fill of the mesh would have " + vertices + "; a larger --gradation makes it smaller";
}

}  // namespace

std::string TextOf(FillFailure failure, const FailedHole& hole) {
  switch (failure) {
    case FillFailure::kNone:
    case FillFailure::kNotApplicable:
      return "";
    case FillFailure::kNoArea:
      return "its boundary encloses no area";
    case FillFailure::kUnknownHeights:
      return "no height was found for one of its seams";
    case FillFailure::kCrossesSeenFromAbove:
      return "its boundary crosses itself seen from above";
    case FillFailure::kCrossesOnItsPlane:
      return "its boundary crosses itself on its own plane";
    case FillFailure::kRepeatsEdges:
      return "its patch would need an edge that the surface already has";
    case FillFailure::kTooLongForSpace:
      return "it projects on no plane without overlap and has " + std::to_string(hole.boundary_edges) +
             " boundary vertices; at most " + std::to_string(kLongestSpatialLoop) + " can be filled in space";
    case FillFailure::kCrosses:
      return "every patch that was tried passes through itself or the surface around it";
    case FillFailure::kRimIsCrossed:
      return "the surface around it passes through its boundary and through every patch that was tried; repair the "
             "mesh first";
    case FillFailure::kTooLarge:
      return TextOfLimit(hole);
    case FillFailure::kTooLongForArea:
    case FillFailure::kTooLongForFront:
      return TextOfLength(failure, hole.boundary_edges);
    default:
      return TextOfFault(failure);
  }
}

}  // namespace tilemend
