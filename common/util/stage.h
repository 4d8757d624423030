// The stages of a job, in the order in which a cell goes through them.
#ifndef TILEMEND_COMMON_UTIL_STAGE_H_
#define TILEMEND_COMMON_UTIL_STAGE_H_

#include <array>
#include <cstddef>
#include <string_view>

namespace tilemend {

// The values are those of tilemend.v1.Stage and do not change.
enum class Stage {
  kMeasure = 9,
  kSurvey = 1,
  kGround = 8,
  kSampleCluster = 5,
  kSampleLayer = 6,
  kFill = 3,
  kSmoothSeam = 7,
  kAssemble = 4,
  kVerify = 10
};

inline constexpr std::array<Stage, 9> kAllStages = {Stage::kMeasure,       Stage::kSurvey,      Stage::kGround,
                                                    Stage::kSampleCluster, Stage::kSampleLayer, Stage::kFill,
                                                    Stage::kSmoothSeam,    Stage::kAssemble,    Stage::kVerify};

// "measure", "survey", "ground", "sample_cluster", "sample_layer", "fill", "smooth_seam", "assemble" or "verify";
// "unknown" for a value that names none.
constexpr std::string_view StageName(Stage stage) {
  switch (stage) {
    case Stage::kMeasure:
      return "measure";
    case Stage::kSurvey:
      return "survey";
    case Stage::kGround:
      return "ground";
    case Stage::kSampleCluster:
      return "sample_cluster";
    case Stage::kSampleLayer:
      return "sample_layer";
    case Stage::kFill:
      return "fill";
    case Stage::kSmoothSeam:
      return "smooth_seam";
    case Stage::kAssemble:
      return "assemble";
    case Stage::kVerify:
      return "verify";
  }
  return "unknown";
}

// Its place in kAllStages; their number for a value that names none.
constexpr size_t StageIndex(Stage stage) {
  size_t index = 0;
  while (index < kAllStages.size() && kAllStages[index] != stage) ++index;
  return index;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_STAGE_H_
