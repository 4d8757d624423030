// Heights of the seam vertices: one agreed height each.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_HEIGHTS_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_HEIGHTS_H_

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// A height that the holes of one cell give to a seam vertex.
struct SeamSample {
  CellId cell;
  int32_t vertex = 0;  // into Plan::vertices
  double height = 0;   // metres
};

// The surface under a vertex on an object.
struct GroundSurface {
  double height = 0;  // metres
  Point2 slope{0, 0};
};

// The slope of the surface that a seam vertex has its height of.
struct SeamSlope {
  Point2 slope{0, 0};
  int32_t cluster = 0;  // of that surface
};

struct SeamHeights {
  std::map<int32_t, double> height = {};                         // of the seam vertices that are settled
  std::map<std::pair<int32_t, int32_t>, double> laplacian = {};  // by cluster and vertex on a seam, where it is known
  std::map<int32_t, SeamSlope> slope = {};                       // of those that a cluster settled
  std::map<std::pair<int32_t, int32_t>, GroundSurface> ground = {};  // by cluster and original vertex
  std::map<int32_t, double> tension = {};                            // by cluster, where it has been chosen
  std::map<int32_t, GroundTrend> walls = {};  // by cluster, where the surface is ground with walls
};

// The surface of a cluster at a vertex on a seam, at the end of one, on an object; with walls at any original vertex.
struct ClusterSample {
  int32_t vertex = 0;    // into Plan::vertices
  double height = 0;     // metres
  double laplacian = 0;  // 1 / metre
  Point2 slope{0, 0};
};

// Settles the seam vertices of a cluster whose surface is known; heights.walls has the cluster already if that is
// ground with walls. Heights are rounded to the plan's lattice. A vertex of several clusters takes the height of the
// lowest number. The order of clusters is of no importance.
void SettleCluster(const Plan& plan, int32_t cluster, std::span<const ClusterSample> samples, SeamHeights& heights);

// Settles the seam vertices that one layer sampled: each gets the mean of its samples. Seams between two cells of the
// layer, where both gave heights, are Laplacian-smoothed once (Wang 2021, eq. 5 and 6). The factor is `gamma`, 0 <=
// gamma <= 1, over the two neighbours on either side. Heights are rounded to the plan's lattice. Samples of vertices
// that are settled already are ignored. The order of samples is of no importance.
void SettleLayer(const Plan& plan, std::span<const SeamSample> samples, double gamma, SeamHeights& heights);

// What the smoothing of seams gave to a vertex, by the cells of each seam.
using SmoothedHeights = std::map<int32_t, std::map<std::pair<CellId, CellId>, double>>;

// Gives smoothed vertices the mean of what their seams gave, rounded to the plan's lattice. Vertices that were given a
// height keep it.
void SettleSmoothed(const Plan& plan, const SmoothedHeights& smoothed, SeamHeights& heights);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_HEIGHTS_H_
