// What a worker sees of a job's folders.
#ifndef TILEMEND_WORKER_SERVICE_LOOK_AT_FOLDERS_H_
#define TILEMEND_WORKER_SERVICE_LOOK_AT_FOLDERS_H_

#include "tilemend/v1/work.pb.h"

namespace tilemend {

// Reads the fingerprint of each file, and makes and removes a file in the folder of attempts. May take as long as the
// file system does.
v1::FoldersSeen LookAtFolders(const v1::JobFolders& folders);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_LOOK_AT_FOLDERS_H_
