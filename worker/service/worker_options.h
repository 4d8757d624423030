// How a worker works.
#ifndef TILEMEND_WORKER_SERVICE_WORKER_OPTIONS_H_
#define TILEMEND_WORKER_SERVICE_WORKER_OPTIONS_H_

#include <functional>
#include <string>

#include "absl/time/time.h"
#include "common/util/log.h"
#include "tilemend/v1/work.pb.h"
#include "worker/service/attempt_files.h"
#include "worker/service/look_at_folders.h"
#include "worker/service/stage_runner.h"

namespace tilemend {

struct WorkerOptions {
  std::string id;          // new for each process; NewWorkerId()
  int threads = 1;         // 1 to 1024
  std::string build = {};  // BuildId(); a coordinator of another refuses this worker
  // Tasks to hold beyond one for each thread, where there are enough for all workers: so that no thread waits for the
  // next, and that one is computed while another reads or writes.
  int prefetch = 0;
  absl::Duration first_backoff = absl::Milliseconds(50);
  absl::Duration max_backoff = absl::Seconds(1);
  // How long it calls its coordinator in vain, in pauses between calls, before it ends with the error.
  absl::Duration patience = absl::InfiniteDuration();
  std::function<void()> on_end;  // on a thread of its own, once it will take no more tasks; none: nobody is told
  OutputDiscarder discard = RemoveKept;  // for outputs of tasks that were given to others meanwhile
  std::function<v1::FoldersSeen(const v1::JobFolders&)> look = LookAtFolders;  // on a thread of tasks
  Log* log = Log::Null();                                                      // outlives the worker
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_WORKER_OPTIONS_H_
