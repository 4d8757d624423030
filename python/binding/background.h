// Long work on a thread of its own, while the caller's thread answers Ctrl-C.
#ifndef TILEMEND_PYTHON_BINDING_BACKGROUND_H_
#define TILEMEND_PYTHON_BINDING_BACKGROUND_H_

#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

#include "common/util/cancel_token.h"

namespace tilemend {

// What the work does now, told by one thread and read by another.
class SharedStep {
 public:
  struct Step {
    std::string name;
    size_t done = 0, all = 0;  // holes; 0 of 0 where none are counted
    bool operator==(const Step&) const = default;
  };

  void Set(std::string_view name, size_t done, size_t all);
  Step Get() const;

 private:
  mutable std::mutex mutex_;
  Step step_;
};

// Runs `work` without the GIL. Each 50 ms looks for signals and, if the step changed, calls `show` with the GIL. An
// exception of a signal's handler or of `show` cancels `cancel`. It is thrown once `work` has ended. A std::bad_alloc
// of `work` is thrown here. If the interpreter ends, raises SystemExit, once `work` has ended. Precondition: the caller
// holds the GIL; `work` ends soon after `cancel`, and once InterpreterEnds().
void RunInBackground(const std::function<void()>& work, CancelToken& cancel, const SharedStep& step,
                     const std::function<void(const SharedStep::Step&)>& show);

}  // namespace tilemend

#endif  // TILEMEND_PYTHON_BINDING_BACKGROUND_H_
