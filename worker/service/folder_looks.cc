#include "worker/service/folder_looks.h"

#include <algorithm>

namespace tilemend {

void FolderLooks::Take(const v1::SyncRequest& request, const v1::SyncResponse& response) {
  for (const v1::FoldersSeen& seen : request.seen()) {
    if (!seen.looking()) seen_.erase(seen.job());
  }
  for (const v1::JobFolders& folders : response.look()) {
    v1::FoldersSeen looking;
    looking.set_job(folders.job());
    looking.set_looking(true);
    if (seen_.emplace(folders.job(), std::move(looking)).second) to_look_.push_back(folders);
  }
}

std::optional<v1::JobFolders> FolderLooks::TakeNext() {
  if (to_look_.empty()) return std::nullopt;
  v1::JobFolders next = std::move(to_look_.front());
  to_look_.pop_front();
  return next;
}

void FolderLooks::AddTo(v1::SyncRequest& request) const {
  for (const auto& [job, seen] : seen_) *request.add_seen() = seen;
}

bool FolderLooks::has_seen() const {
  return std::ranges::any_of(seen_, [](const auto& seen) { return !seen.second.looking(); });
}

}  // namespace tilemend
