// Which files of an output a job has put there itself.
#ifndef TILEMEND_COORDINATOR_STORE_OWN_FILES_H_
#define TILEMEND_COORDINATOR_STORE_OWN_FILES_H_

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "coordinator/store/job_notes.h"

namespace tilemend {

// Over all processes of the job, if its notes outlive them. Not thread-safe.
class OwnFiles {
 public:
  explicit OwnFiles(std::shared_ptr<JobNotes> notes) : notes_(std::move(notes)) {}

  bool Has(const std::string& file) const;
  // Durable when it returns. Call it before the files are there: what is not noted is of others.
  void Add(const std::vector<std::string>& files);

 private:
  std::shared_ptr<JobNotes> notes_;
  std::set<std::string> added_;  // by this process
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STORE_OWN_FILES_H_
