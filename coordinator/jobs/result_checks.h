// Whether a worker's result can be taken, before it is.
#ifndef TILEMEND_COORDINATOR_JOBS_RESULT_CHECKS_H_
#define TILEMEND_COORDINATOR_JOBS_RESULT_CHECKS_H_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "common/util/stage.h"
#include "coordinator/jobs/decoded_surveys.h"
#include "coordinator/jobs/stage_output.h"

namespace tilemend {

// `input` is what the worker was given, `output` what it gave. kDataLoss, saying what is wrong, if no sound worker
// gives that; any other error if this machine cannot tell. Called by several threads at once, without locks.
using ResultCheck = std::function<absl::Status(Stage stage, const std::string& input, const std::string& output)>;

// Names of the files in the folder of attempts that a result lists as written.
using AttemptsOf = std::function<std::vector<std::string>(Stage stage, const std::string& output)>;

// How closely tiles are looked at: their sizes and what workers say of them, or what is in them.
enum class TileCheck { kSize, kContent };

// For the stages of real scenes: coordinator/check on what was decoded, and
//  - survey: the tile's own size. With kContent the digest, counts, bounds, boundary vertices and boundary edges of the
//    record are those of the tile. Else the tile is read if it is said to be closed, or to lie outside its cell;
//  - assemble: each file is there under the attempt's name, with its size. A tile without patches has the digest of the
//    original, and a carried file the size of the original. With kContent every file has the digest that is told, and a
//    tile with patches is made here again and compared byte by byte;
//  - verify: a digest for each file. What it says is for OutputVerification to judge.
// With kContent alone the coordinator holds tiles: some 24 MB of them at once, with what is made of them; a larger one
// by itself. What is not told then: a surface that is sound, but not the one that a sound worker makes.
// `surveys`, if given, gets the records of sound surveys.
ResultCheck SceneResultCheck(TileCheck tiles, std::shared_ptr<DecodedSurveys> surveys = nullptr);

// For the stages of real scenes.
std::vector<std::string> AttemptsOfScene(Stage stage, const std::string& output);

// As SceneResultCheck with kSize, for a result that was decoded before.
absl::Status CheckKnownOutput(const std::string& input, const StageOutput& output);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_RESULT_CHECKS_H_
