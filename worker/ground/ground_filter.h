// The ground filter of Pingel, Clarke and McBride 2013 (SMRF) on a raster.
#ifndef TILEMEND_WORKER_GROUND_GROUND_FILTER_H_
#define TILEMEND_WORKER_GROUND_GROUND_FILTER_H_

#include <cmath>
#include <cstdint>
#include <limits>

#include "common/records/ground_raster.h"
#include "worker/ground/square_blocks.h"

namespace tilemend {

// Values of the paper where no other source is given (docs/decisions/2026-11-26-ground-filter.md has the experiments).
struct GroundFilterOptions {
  double slope = 0.1;          // rise / run, above which what stands out of an opening is an object; paper: 0.15
  double window = 50;          // metres: radius of the largest opening, half the width of the widest object; paper: 18
  double threshold = 0.5;      // metres: how far ground may be above the filtered surface
  double slope_factor = 1.25;  // of the slope, added to the threshold
  double outlier_slope = 5;    // rise / run of pits that are no surface
};

// How far ground is looked for around an object, to tell the height of the ground under it, metres.
inline constexpr double kGroundSight = 20;

// What is told of a square depends on the surface within this distance alone, metres.
inline double FilterReach(const GroundFilterOptions& options) { return 2 * options.window + kGroundSight; }

// Tells ground from objects. The raster is opened with disks of growing radius. What an opening takes away by more than
// slope * radius is an object (section 2.1, steps 2 and 3). Squares without surface neither lower nor lift (as printed,
// the paper interpolates them first, which spreads roofs into holes). Radii grow by one square up to 10 and by a tenth
// to a fifth then. Against growth by one, 0 to 1.2 % of the squares differ on nine real and made sites, in a third of
// the time.
//
// Under objects the ground is linear between the nearest ground squares in opposite directions. It is the mean of eight
// pairs of directions weighted by their distance. The paper has an interpolation over the whole raster, which is no
// local one. So what was taken for an object but lies on that ground is ground again (step 4). At the edge of the
// surface ground may be seen on one side alone. There it goes on as far as it is seen: from the nearest square and that
// twice as far off.
//
// The tolerance is that of step 4: threshold + slope_factor * slope of the ground. On ground the slope is the smaller
// of those to either side, so ground beside a wall is not steep. Under objects it is the mean one of the pairs.
//
// Cost: some 400 operations on 8 squares each, for windows of 50 squares. Openings with growing radius are made only
// for what is asked for, or seen from there. Pits, and the lowest surface of blocks, are looked for in the whole
// raster.
class FilteredGround {
 public:
  //   lowest  the lowest surface in each square (lowest_surface.h)
  FilteredGround(GroundRaster lowest, const GroundFilterOptions& options);

  // For questions about the squares of `asked` alone, which is a set for this raster. What is told of others has no
  // meaning.
  FilteredGround(GroundRaster lowest, const GroundFilterOptions& options, const SquareBlocks& asked);

  // Whether the square has surface that is no object.
  bool IsGround(int32_t col, int32_t row) const { return !std::isnan(At(ground_, col, row)); }

  struct Place {
    float height;             // of the ground, metres, also under objects; NaN where nothing is known of it
    float tolerance;          // metres: what lies higher is no ground
    bool is_between = false;  // the square has ground, or lies between such; else it goes on from one side
  };

  // Of a square with surface. O(1) on ground, else O(kGroundSight / side of a square).
  Place GroundAt(int32_t col, int32_t row) const;

 private:
  // Ground that is seen from a square; metres, NaN where there is none.
  struct Sight {
    double distance = std::numeric_limits<double>::quiet_NaN();
    float height = std::numeric_limits<float>::quiet_NaN();
    float farther = std::numeric_limits<float>::quiet_NaN();  // height of the ground twice as far off
  };

  // Weighted by the inverse of distances.
  struct Mean {
    double weights = 0, heights = 0, slopes = 0;

    void Add(double height, double slope, double distance) {
      weights += 1 / distance;
      heights += height / distance;
      slopes += slope / distance;
    }
  };

  void DropObjects(const SquareBlocks& asked);
  static float At(const GroundRaster& raster, int32_t col, int32_t row);
  Sight Look(int32_t col, int32_t row, int32_t dx, int32_t dy) const;
  float SlopeOfGround(int32_t col, int32_t row) const;
  Place UnderObject(int32_t col, int32_t row) const;
  Place WithTolerance(const Mean& mean) const;

  const GroundFilterOptions options_;
  GroundRaster ground_;  // NaN where an object stands, or there is no surface
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_GROUND_GROUND_FILTER_H_
