// Who wants to know how far a command is.
#ifndef TILEMEND_CLIENT_STEP_WATCHER_H_
#define TILEMEND_CLIENT_STEP_WATCHER_H_

#include <cstddef>
#include <functional>
#include <string_view>

namespace tilemend {

// Is told how many things of a step are done, of how many, and what one of them is called ("tile"); by one thread at a
// time. `all` is 0 where nothing is counted.
using StepWatcher = std::function<void(std::string_view step, size_t done, size_t all, std::string_view unit)>;

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_STEP_WATCHER_H_
