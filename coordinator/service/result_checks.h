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

// How closely tiles are looked at: their sizes, or every byte.
enum class TileCheck { kSize, kDigest };

// For the stages of real scenes: coordinator/check on what was decoded, and
//  - survey: the tile's own size. With kDigest the tile is read: it has the digest that is told, and the counts,
//  bounds,
//    boundary vertices and boundary edges of the record. Else it is read if it is said to be closed, or to lie outside
//    its cell;
//  - assemble: each file is there under the attempt's name, with its size. A tile without patches has the digest of the
//    original, and a carried file the size of the original. With kDigest every tile is read, and one with patches is
//    made here again and compared byte by byte.
// Tiles of some 24 MB in all are in memory at once, with what is made of them; one that is larger, alone. What it
// cannot tell: a surface that is sound, but not the one that a sound worker makes.
ResultCheck SceneResultCheck(TileCheck tiles);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_SERVICE_RESULT_CHECKS_H_
