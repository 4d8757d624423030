// SIGINT and SIGTERM as an exit code, or as calls on an ordinary thread.
#ifndef TILEMEND_COMMON_UTIL_SIGNALS_H_
#define TILEMEND_COMMON_UTIL_SIGNALS_H_

#include <functional>
#include <thread>

namespace tilemend {

// For the start of main: SIGINT and SIGTERM end the process with kExitCancelled and a line on stderr, while no
// SignalWatcher lives. A signal that the caller has ignored stays so.
void ExitOnSignal();

// While it lives, SIGINT and SIGTERM do not end the process. Make it before any other thread (gRPC starts some with the
// first channel): only threads that are made later are kept from taking the signals. At most one at a time.
class SignalWatcher {
 public:
  SignalWatcher();
  ~SignalWatcher();
  SignalWatcher(const SignalWatcher&) = delete;
  SignalWatcher& operator=(const SignalWatcher&) = delete;

  // From now on, calls `on_signal` on a thread of its own. The argument is 1 for the first signal (which may have come
  // before), 2 for the second, and so on. Once.
  void Start(std::function<void(int count)> on_signal);
  // No call begins after it returns; waits for one that runs. Signals stay blocked. The destructor does it too; it
  // drops signals that came since.
  void Stop();

 private:
  void Run();

  std::function<void(int)> on_signal_;
  int signal_fd_ = -1;
  int stop_fd_ = -1;
  std::thread thread_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_SIGNALS_H_
