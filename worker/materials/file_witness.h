// Whether the files beside a tile are as a survey found them.
#ifndef TILEMEND_WORKER_MATERIALS_FILE_WITNESS_H_
#define TILEMEND_WORKER_MATERIALS_FILE_WITNESS_H_

#include <string>

#include "common/records/tile_files.h"

namespace tilemend {

// Whether each name in the scene `root` still leads to where it led, and each file that was read has the same bytes. A
// path that is not one of the scene's, as it may come from elsewhere, holds never. Cost: reads these files.
bool Holds(const std::string& root, const FileWitness& witness);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_MATERIALS_FILE_WITNESS_H_
