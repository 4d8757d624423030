#include "coordinator/jobs/smooth_check.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include "common/records/cell_holes.h"
#include "common/rpc/smoothed_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/wrong_result.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {
namespace {

struct HeightRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void Add(double z) {
    low = std::min(low, z);
    high = std::max(high, z);
  }
};

// The heights of what is smoothed, as far as one side tells: means stay between them.
absl::Status AddHeights(const v1::SeamSide& side, const v1::SmoothedPoints& moved, HeightRange& heights) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<RimVertex> vertices, FromProto(side.vertices()));
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<HolePatch> patches, FromProto(side.patches(), vertices.size()));
  int64_t points = 0;
  for (const RimVertex& v : vertices) heights.Add(v.position.z());
  for (const HolePatch& patch : patches) {
    points += std::ssize(patch.new_points);
    for (const Point3& p : patch.new_points) heights.Add(p.z());
  }
  return AsWrong(FromProto(moved, points).status());
}

}  // namespace

absl::Status CheckSmoothResult(const std::string& input_bytes, const v1::SmoothSeamOutput& output) {
  TILEMEND_ASSIGN_OR_RETURN(const auto input, ParseResult<v1::SmoothSeamInput>(input_bytes));
  if (output.number() != input.number() || output.height_size() != input.seam_vertex_size()) {
    return Wrong("another seam");
  }
  HeightRange heights;
  for (const double z : input.height()) heights.Add(z);
  TILEMEND_RETURN_IF_ERROR(AddHeights(input.a(), output.a(), heights));
  TILEMEND_RETURN_IF_ERROR(AddHeights(input.b(), output.b(), heights));
  const double low = heights.low - input.lattice_step(), high = heights.high + input.lattice_step();
  for (const auto* column : {&output.height(), &output.a().height(), &output.b().height()}) {
    if (!std::all_of(column->begin(), column->end(), [&](double z) { return z >= low && z <= high; })) {
      return Wrong("a height beyond those of the patches");
    }
  }
  return absl::OkStatus();
}

}  // namespace tilemend
