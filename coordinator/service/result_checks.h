// Whether a worker's result can be taken, before it is.
#ifndef TILEMEND_COORDINATOR_SERVICE_RESULT_CHECKS_H_
#define TILEMEND_COORDINATOR_SERVICE_RESULT_CHECKS_H_

#include <functional>
#include <string>

#include "absl/status/status.h"
#include "common/util/stage.h"

namespace tilemend {

// `input` is what the worker was given, `output` what it gave. kDataLoss, saying what is wrong, if no sound worker
// gives that; any other error if this machine cannot tell. Called by several threads at once, without locks.
using ResultCheck = std::function<absl::Status(Stage stage, const std::string& input, const std::string& output)>;

// How closely the written tiles are looked at: their sizes, or every byte against the digest that the worker told.
enum class TileCheck { kSize, kDigest };

// For the stages of real scenes: coordinator/check on what was decoded, and
//  - survey: the tile's own size; a tile that is said to be closed, or to lie outside its cell, is read here;
//  - assemble: each file is there under the attempt's name, with its size. A tile without patches has the digest of the
//    original, and a carried file the size of the original. With kDigest every tile is read.
// What it cannot tell: a surface or a patched tile that is sound, but not the one that a sound worker makes.
ResultCheck SceneResultCheck(TileCheck tiles);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_SERVICE_RESULT_CHECKS_H_
