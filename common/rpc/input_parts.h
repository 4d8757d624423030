// Inputs of tasks that go on in blobs of their own. A message's bytes and those of its parts, one after the other, are
// the whole message: protobuf joins the fields.
#ifndef TILEMEND_COMMON_RPC_INPUT_PARTS_H_
#define TILEMEND_COMMON_RPC_INPUT_PARTS_H_

#include <string>
#include <vector>

#include "common/util/stage.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Digests of the parts of an input, in their order.
inline std::vector<std::string> PartsOf(Stage stage, const std::string& input) {
  v1::GroundInput ground;
  if (stage != Stage::kGround || !ground.ParseFromString(input)) return {};
  return {ground.parts().begin(), ground.parts().end()};
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_INPUT_PARTS_H_
