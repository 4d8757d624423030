// Which worker may work on which job.
#ifndef TILEMEND_COORDINATOR_JOBS_WORKER_TRUST_H_
#define TILEMEND_COORDINATOR_JOBS_WORKER_TRUST_H_

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/time/time.h"
#include "coordinator/jobs/job_folders.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

// A worker gets tasks of a job when it has shown that it can write there. It must also see the same files of the scene
// and of the output as the coordinator. One that does not is asked again from time to time: mounts come back. A worker
// whose result was refused may be suspected until that is cleared, or set aside until its process is started anew.
//
// What workers see is kept in memory alone: a coordinator that starts anew asks again. Not thread-safe.
class WorkerTrust {
 public:
  // Without files the job is anybody's.
  void AddJob(const std::string& job, JobFolders folders);
  void RemoveJob(const std::string& job) { jobs_.erase(job); }
  const JobFolders* FoldersOf(const std::string& job) const;

  // What `worker` is to look at now, without the jobs that it is `busy` with.
  std::vector<v1::JobFolders> ToLookAt(const std::string& worker, const std::set<std::string>& busy,
                                       absl::Time now) const;
  // What it has seen. If it gets no task of the job: why, for people.
  std::optional<std::string> TakeSeen(const std::string& worker, const v1::FoldersSeen& seen, absl::Time now);
  // It is to look again before its next task.
  void Doubt(const std::string& worker, const std::string& job);
  void RemoveWorker(const std::string& worker);

  // It gets no task until it is cleared.
  void Suspect(const std::string& worker, const std::string& reason) { Put(worker, {reason, false}); }
  // Nothing if it is set aside. Whether it was suspected.
  bool Clear(const std::string& worker);
  // It gets no task any more.
  void SetAside(const std::string& worker, const std::string& reason) { Put(worker, {reason, true}); }
  // Why it is suspected or set aside. Empty if it is not.
  std::string WhySetAside(const std::string& worker) const;

  // Whether it is set aside for good.
  bool IsSetAside(const std::string& worker) const;

  bool MayWorkOn(const std::string& worker, const std::string& job) const;

  // Whether it gets no task of the job until something changes: not one that has yet to look.
  bool IsBarred(const std::string& worker, const std::string& job) const;

  // Whether it has been looking at the job's folders for so long that it seems unable to come back: a mount that hangs.
  bool SeemsStuck(const std::string& worker, const std::string& job, absl::Time now) const;

  // Jobs whose folders it does not see.
  std::vector<std::string> BlindTo(const std::string& worker) const;

  struct Counts {
    size_t set_aside = 0;
    size_t blind = 0;  // workers that do not see some job's folders, counted for each job
  };
  Counts Count() const;

 private:
  struct JobView {
    JobFolders folders;
    std::map<std::string, absl::Time> seen_by;  // workers; when they are to look again: InfiniteFuture if they see them
    std::map<std::string, absl::Time> looks_since;  // workers that are looking; when they first said so
    size_t blind = 0;                               // of seen_by: not InfiniteFuture

    void See(const std::string& worker, absl::Time look_again);
    void Forget(const std::string& worker);  // what it has seen
  };
  struct Aside {
    std::string reason;
    bool is_for_good = false;
  };
  void Put(const std::string& worker, Aside aside);

  std::map<std::string, JobView> jobs_;
  std::map<std::string, Aside> set_aside_;  // by worker
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_WORKER_TRUST_H_
