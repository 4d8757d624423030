// The stages of a job, in the order in which a cell goes through them.
#ifndef TILEMEND_COMMON_UTIL_STAGE_H_
#define TILEMEND_COMMON_UTIL_STAGE_H_

#include <array>
#include <string_view>

namespace tilemend {

// The values are those of tilemend.v1.Stage and do not change.
enum class Stage { kSurvey = 1, kSample = 2, kFill = 3, kAssemble = 4 };

inline constexpr std::array<Stage, 4> kAllStages = {Stage::kSurvey, Stage::kSample, Stage::kFill, Stage::kAssemble};

// "survey", "sample", "fill" or "assemble"; "unknown" for a value that names none.
constexpr std::string_view StageName(Stage stage) {
  switch (stage) {
    case Stage::kSurvey:
      return "survey";
    case Stage::kSample:
      return "sample";
    case Stage::kFill:
      return "fill";
    case Stage::kAssemble:
      return "assemble";
  }
  return "unknown";
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_STAGE_H_
