// The holes that the fills of a tile belong to.
#ifndef TILEMEND_CLIENT_FILL_OWNERS_H_
#define TILEMEND_CLIENT_FILL_OWNERS_H_

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "client/hole_numbers.h"
#include "worker/check/added_faults.h"
#include "worker/check/fill_pieces.h"

namespace tilemend {

// Finds the hole of an added triangle by the rim of the fill that has it (HoleNumbers::OfRim).
class FillOwners {
 public:
  // All three must outlive it. O(1): the fills are looked for when a hole is first asked for.
  FillOwners(const HoleNumbers& numbers, CellId cell, const TriMesh& after, const std::vector<bool>& added)
      : numbers_(numbers), cell_(cell), after_(after), added_(added) {}

  // The number of the hole. None if the boundary of the fill is not known, or `triangle` is -1 or original. The first
  // call takes O(n log n), and the first for each fill what OfRim takes.
  std::optional<int64_t> Of(int32_t triangle);

  // The added triangles that face down (FacesDown) in fills that have one height at each place. All holes with an edge
  // of the rim of such a fill are in `height_fields`, and there are some. O(triangles), and AllOfRim for each such
  // fill.
  std::vector<int32_t> FoldedTriangles(const std::set<int64_t>& height_fields);

  // "crosses the fill of hole 14", of holes other than that of the place's triangle; empty if it crosses none of them.
  std::string CrossedText(const AddedFaultPlace& place);

 private:
  const TileFills& Fills();

  const HoleNumbers& numbers_;
  const CellId cell_;
  const TriMesh& after_;
  const std::vector<bool>& added_;
  std::optional<TileFills> fills_;
  std::vector<std::optional<int64_t>> holes_;  // by fill that was asked for; -1: not known
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_FILL_OWNERS_H_
