// What is wrong with the faces that a tile got, apart from what was wrong with the tile before.
#ifndef TILEMEND_WORKER_CHECK_ADDED_FAULTS_H_
#define TILEMEND_WORKER_CHECK_ADDED_FAULTS_H_

#include <cstdint>
#include <map>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/check/tile_change.h"

namespace tilemend {

enum class AddedFault {
  kCrossedFill,      // an added triangle that crosses another added one (TrianglesCross), not as kCrossedRim
  kCrossedSurface,   // an added triangle that crosses no added one, but an original one
  kCrossedRim,       // one that crosses others only along curves that go on between two original triangles, through the
                     // boundary of a filled hole (ContinueCrossings). The input's fault: no patch is free of it
  kNonManifoldEdge,  // an edge with more than two triangles that had at most two before
  kTurnedEdge,       // an edge whose two triangles face opposite ways, one of them or both added
  kFlatTriangle,     // an added triangle without area
};

// An edge with one triangle, before or after. In a tile; counts over several tiles are sums.
struct OpenEdge {
  Point3 from, to;     // the lower position first (by x, y, z)
  int32_t before = 0;  // triangles that have it
  int32_t after = 0;
  bool is_added = false;    // of one that is there after: its triangle was added
  bool is_inner = false;    // and has no vertex at an original one
  bool is_covered = false;  // the tile has other surface there: pieces of a tile overlap (set by CoverOpenEdges)
  int32_t forward = 0;      // triangles that have it after, and go round from `from` to `to`
  int32_t triangle = -1;    // of `after`, one that was added and has it; -1: none
  int64_t hole = -1;        // the hole of that triangle's fill (set by the caller); -1: not known
};

struct AddedFaultPlace {
  Point3 at;                         // the middle of an edge or a triangle
  int32_t triangle = -1;             // of `after`: the added triangle, or one that has the edge; -1: none was added
  std::vector<int32_t> others = {};  // of kCrossedFill: added triangles that it crosses, rising
};

struct AddedFindings {
  std::map<AddedFault, std::vector<AddedFaultPlace>> faults;
  std::vector<OpenEdge> open;  // in order of their positions
  std::vector<bool> inner;     // of each triangle of `after`: it was added, and has no vertex at an original one
};

// Compares the tile `after` with what it was `before`; `change` says which triangles were removed and added
// (CompareTiles). Vertices at equal positions are one. Triangles without area count for no edge. Touching is decided by
// exact signs. Pure. O(n log n); crossings are looked for at added triangles alone.
AddedFindings FindAddedFaults(const TriMesh& before, const TriMesh& after, const TileChange& change);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_CHECK_ADDED_FAULTS_H_
