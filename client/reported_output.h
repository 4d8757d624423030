// What the report of an output says that the acceptance check asks for.
#ifndef TILEMEND_CLIENT_REPORTED_OUTPUT_H_
#define TILEMEND_CLIENT_REPORTED_OUTPUT_H_

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/grid/scene.h"
#include "worker/check/water_fill.h"

namespace tilemend {

struct ReportedOutput {
  // A hole that was left open, or boundary edges in no loop.
  struct Left {
    CellId cell;
    Point2 at{0, 0};
    double reach = 0;  // metres: all of its boundary is nearer to `at`
    double area = 0;   // m2
    std::string reason;
  };
  // A hole that was filled as water.
  struct Water {
    int64_t hole = 0;
    WaterHole fill;
  };

  std::vector<Left> left;
  std::map<CellId, std::vector<Water>> water;
  std::map<CellId, int64_t> cleared;  // triangles taken out
  double overlap = 0;                 // metres: how far tiles reach over the sides of their cells; 0: they do not
  bool has_textures = true;           // material files and images were to be carried
};

// Reads a report.json. Members that are missing or of another type count as empty. Linear.
ReportedOutput ReadReported(const nlohmann::ordered_json& report);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_REPORTED_OUTPUT_H_
