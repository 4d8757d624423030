#include "worker/service/smooth_stage.h"

#include <cstdint>
#include <span>
#include <vector>

#include "common/records/cell_holes.h"
#include "common/rpc/smoothed_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/util/status_macros.h"
#include "worker/fill/seam/smooth_seam.h"

namespace tilemend {
namespace {

template <typename T>
std::span<const T> ColumnOf(const google::protobuf::RepeatedField<T>& values) {
  return {values.data(), static_cast<size_t>(values.size())};
}

struct DecodedSide {
  std::vector<RimVertex> vertices;
  std::vector<HolePatch> patches;
  std::vector<int32_t> holes;

  SeamSide View() const { return {vertices, patches, holes}; }
};

absl::StatusOr<DecodedSide> Decode(const v1::SeamSide& proto) {
  DecodedSide side;
  TILEMEND_ASSIGN_OR_RETURN(side.vertices, FromProto(proto.vertices()));
  TILEMEND_ASSIGN_OR_RETURN(side.patches, FromProto(proto.patches(), side.vertices.size()));
  side.holes.assign(proto.holes().begin(), proto.holes().end());
  return side;
}

}  // namespace

absl::StatusOr<std::string> RunSmoothSeam(const v1::SmoothSeamInput& input) {
  TILEMEND_ASSIGN_OR_RETURN(const DecodedSide a, Decode(input.a()));
  TILEMEND_ASSIGN_OR_RETURN(const DecodedSide b, Decode(input.b()));
  if (input.height_size() != input.seam_vertex_size() || !(input.lattice_step() > 0)) {
    return absl::InvalidArgumentError("malformed payload: seam");
  }
  const SmoothedPatches smoothed =
      SmoothSeam(a.View(), b.View(), {ColumnOf(input.seam_vertex()), ColumnOf(input.height())},
                 {input.smoothing(), input.buffer(), input.lattice_step()});
  v1::SmoothSeamOutput output;
  output.set_number(input.number());
  output.mutable_height()->Add(smoothed.heights.begin(), smoothed.heights.end());
  *output.mutable_a() = ToProto(smoothed.a);
  *output.mutable_b() = ToProto(smoothed.b);
  return output.SerializeAsString();
}

}  // namespace tilemend
