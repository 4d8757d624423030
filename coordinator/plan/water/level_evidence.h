// Whether the rim of a hole tells of level water, at which level, and how sure that is.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_LEVEL_EVIDENCE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_LEVEL_EVIDENCE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "coordinator/plan/water/area_cover.h"
#include "coordinator/plan/water/half_sample_mode.h"

namespace tilemend {

// An edge of original surface on the rim of a hole.
struct ChainEdge {
  Point3 middle{0, 0, 0};
  double length = 0;  // metres, seen from above
};

// Edges in order along the rim, each beside the next one.
using RimChain = std::vector<ChainEdge>;

inline constexpr int64_t kMinWindows = 20;              // below that fractal terrain agrees on a level by chance
inline constexpr double kSigmas = 3;                    // of noise, or of a level: more is no chance
inline constexpr double kMinSigma = 0.02;               // metres: levels of two rims agree no better
inline constexpr double kDeviationsPerMedian = 1.4826;  // of the absolute value of normal noise

// Figures of a rim, in metres. The letters are those of docs/decisions/2026-11-26-water-by-evidence.md.
struct LevelEvidence {
  int64_t edges = 0;
  int64_t windows = 0;             // n
  double level = 0;                // c: LowerMode of all edges
  double lowest = 0, highest = 0;  // of all edges
  double second_percentile = 0;    // of the rim's length
  double median = 0;               // likewise
  double disagreement = 0;         // J
  double dry_difference = 0;       // D
  double noise = 0;                // nu
  double length = 0;               // of the rim, seen from above

  double sigma() const;          // standard deviation of `level`
  bool is_enough() const;        // there are windows enough to judge by
  bool agrees() const;           // J < D / 2: the far half of the rim tells the same level, seen from every side
  bool is_within_noise() const;  // D < 3 nu: level water and a dry surface are the same within noise
  bool is_level() const;         // enough, and one of the two
};

// The evidence of a rim:
//   c        LowerMode; an edge weighs its length over its roughness, which is 1 cm at least
//   windows  squares of side max(rim length / 64, 2 * mean edge, weighted by length) that hold an edge
//   J        root mean square, over all windows, of how far the level of the edges outside the nearer half of the
//            windows is from c
//   D        MeanOffLevel: how far a dry surface would be from the water, in the mean
//   nu       1.4826 times the median, over the lower half of the rim, of how far an edge is off its neighbours
// Roughness: how far an edge is off the mean of its two neighbours, in standard deviations' units; the median of the
// edge and its neighbours.
//
//   chains   at least one edge
//   outline  of the hole, as for MeanOffLevel; empty: D is 0
// Cost: O(n * edges + edges log edges), n at most about 130, and MeanOffLevel's. Deterministic.
LevelEvidence EvidenceOf(std::span<const RimChain> chains, std::span<const PlaneSegment> outline);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_LEVEL_EVIDENCE_H_
