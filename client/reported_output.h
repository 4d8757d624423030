// What the report of an output says that the acceptance check asks for.
#ifndef TILEMEND_CLIENT_REPORTED_OUTPUT_H_
#define TILEMEND_CLIENT_REPORTED_OUTPUT_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "common/grid/scene.h"
#include "common/records/level_counts.h"
#include "worker/check/water_fill.h"

namespace tilemend {

struct ReportedOutput {
  // A hole that was left open, or boundary edges in no loop.
  struct Left {
    CellId cell;
    Point3 at{0, 0, 0};                         // at the mean height of its rim; z 0: not known
    double reach = 0;                           // metres: all of its boundary is nearer to `at`
    int64_t hole = -1;                          // its number; -1: none
    bool reaches_border = false;                // it goes on beyond the sides of its cell
    std::vector<std::vector<Point2>> rim = {};  // its boundary from above; empty: not known
    Eigen::AlignedBox2d box = {};               // of the rim
    double area = 0;                            // m2
    std::string reason;
  };
  // A hole that was filled as water.
  struct Water {
    int64_t hole = 0;
    WaterHole fill;
  };

  // The hole that a boundary is of.
  struct RimOwner {
    int64_t hole = 0;
    std::string cell;  // as ToString has it
  };

  // Metres: of the rim of a hole that was filled, and of its water.
  struct HeightRange {
    double lowest = 0;
    double highest = 0;
  };

  std::vector<Left> left;
  std::vector<std::vector<Point2>> filled_rims;   // boundaries of holes that were filled, from above
  std::vector<RimOwner> filled_rim_owners;        // by boundary
  std::map<int64_t, HeightRange> filled_heights;  // of these holes, by number; none of those without known heights
  std::set<int64_t> height_fields;                // of these holes, those whose fill has one height at each place
  std::map<CellId, std::vector<Water>> water;
  std::map<CellId, int64_t> cleared;  // triangles taken out
  std::map<CellId, double> filled;    // m2 of its holes that were filled
  std::vector<LevelCounts> levels;    // of detail, the coarsest first
  double overlap = 0;                 // metres: of tiles over the sides of their cells, or of pieces; 0: none
  bool has_textures = true;           // material files and images were to be carried
};

// Reads a report.json. Members that are missing or of another type count as empty. Linear.
ReportedOutput ReadReported(const nlohmann::ordered_json& report);

// Takes the boundaries of holes that were left or filled from a holes.geojson, whose coordinates have the scene's
// origin in them. The same of members. Linear.
void AddRims(const nlohmann::ordered_json& holes, const Point2& origin, ReportedOutput& reported);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_REPORTED_OUTPUT_H_
