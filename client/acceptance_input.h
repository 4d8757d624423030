// What the acceptance check reads before the tiles: the scene, and the report of the output.
#ifndef TILEMEND_CLIENT_ACCEPTANCE_INPUT_H_
#define TILEMEND_CLIENT_ACCEPTANCE_INPUT_H_

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "client/reported_output.h"
#include "common/grid/scene.h"

namespace tilemend {

struct AcceptanceInput {
  Scene scene;  // the input's, with its area
  std::string out;
  nlohmann::ordered_json report;
  std::string format;       // that the tiles were written in; empty: their own
  std::set<CellId> chosen;  // the cells that the job was to write; empty: all
  bool has_area = true;     // false: the area of the job could not be read
};

// Adds a warning if the report names another scene, and one if the area cannot be read. kNotFound and kInvalidArgument
// if `in` is no scene or `out` no complete output. Linear in the report.
absl::StatusOr<AcceptanceInput> ReadAcceptanceInput(const std::string& in, const std::string& out,
                                                    std::vector<std::string>& warnings);

// The report of the output, with the boundaries of its holes.geojson and the levels of detail that were written.
// Linear.
ReportedOutput ReportedOf(const AcceptanceInput& input);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_ACCEPTANCE_INPUT_H_
