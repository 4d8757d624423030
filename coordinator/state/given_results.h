// Who gave the results of a job's tasks.
#ifndef TILEMEND_COORDINATOR_STATE_GIVEN_RESULTS_H_
#define TILEMEND_COORDINATOR_STATE_GIVEN_RESULTS_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tilemend {

// By task, the worker whose result was taken. Memory: 4 bytes a task.
class GivenResults {
 public:
  // `task` is 1 or more. A later call for the same task replaces what is there.
  void Put(int64_t task, const std::string& worker);
  // Forgets what a worker gave; returns these tasks, rising. Cost O(tasks).
  std::vector<int64_t> Revoke(const std::string& worker);

 private:
  std::map<std::string, int32_t> numbers_;  // of workers, from 1
  std::vector<int32_t> given_by_;           // by task - 1; 0: nobody
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_GIVEN_RESULTS_H_
