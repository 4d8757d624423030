// What a job does, in the words of its user: the one list for programs, the coordinator's page and Python.
#ifndef TILEMEND_COMMON_UTIL_STAGE_WORDS_H_
#define TILEMEND_COMMON_UTIL_STAGE_WORDS_H_

#include <span>
#include <string>
#include <string_view>

namespace tilemend {

struct StageWords {
  std::string_view beginning;  // of a phase (PhaseOf in coordinator/waves/wave_order.h), or of a task's stage
  std::string_view words;
};

// In the order of the work. web/src/stages.ts has the same list, which a test compares; Python asks for it.
std::span<const StageWords> AllStageWords();

// What a phase of a job does: "look at the tiles" for "survey". A phase that is not known stays as it is. Printable.
std::string StageWordsOf(std::string_view phase);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_STAGE_WORDS_H_
