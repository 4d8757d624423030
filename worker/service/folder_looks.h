// The folders of jobs that a worker is to look at, so that the coordinator knows that both see the same ones.
#ifndef TILEMEND_WORKER_SERVICE_FOLDER_LOOKS_H_
#define TILEMEND_WORKER_SERVICE_FOLDER_LOOKS_H_

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "tilemend/v1/work.pb.h"

namespace tilemend {

// Not thread-safe.
class FolderLooks {
 public:
  // Forgets what the coordinator knows from the request, and takes what it asks for in its answer.
  void Take(const v1::SyncRequest& request, const v1::SyncResponse& response);
  // What to look at next; none if there is nothing.
  std::optional<v1::JobFolders> TakeNext();
  // What was seen in the folders of the job.
  void Add(const std::string& job, v1::FoldersSeen seen) { seen_[job] = std::move(seen); }
  void AddTo(v1::SyncRequest& request) const;

  bool has_next() const { return !to_look_.empty(); }
  bool has_seen() const;  // something that the coordinator does not know

 private:
  std::deque<v1::JobFolders> to_look_;
  std::map<std::string, v1::FoldersSeen> seen_;  // by job, from when it is asked for
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_FOLDER_LOOKS_H_
