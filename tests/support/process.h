// Programs as processes, for tests of what a user sees.
#ifndef TILEMEND_TESTS_SUPPORT_PROCESS_H_
#define TILEMEND_TESTS_SUPPORT_PROCESS_H_

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "absl/time/time.h"

namespace tilemend {

struct Ended {
  int code = -1;  // the exit code, or minus the signal that ended it
  std::string out, err;
  double seconds = 0;
  int64_t peak_bytes = 0;  // of resident memory
};

// At most 512 MB, and at most 20 s: 2 s on a machine that has nothing else to do. Memory is not checked under a
// sanitizer, which has its own.
void ExpectFrugal(const Ended& ended);

// A process whose output goes to files in `folder`, which must live longer. It does not outlive the thread that made
// it.
class Process {
 public:
  Process(const std::string& folder, const std::string& program, const std::vector<std::string>& words);
  ~Process();  // kills it if it still runs
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void Signal(int signal);
  // Until it ends. After `limit` it is killed and the test fails.
  Ended Wait(absl::Duration limit = absl::Minutes(1));
  // Waits until the process' standard error holds `text`, and gives what follows it on that line. The test fails if it
  // ends before, or within a minute does not say it.
  std::string AwaitLine(const std::string& text);

 private:
  bool Runs() const;

  pid_t pid_ = -1;
  absl::Time start_;
  std::string out_, err_;
};

// Calls `done` every few milliseconds until it gives true, for `limit` at most; whether it did.
bool Await(const std::function<bool()>& done, absl::Duration limit = absl::Minutes(1));

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_PROCESS_H_
