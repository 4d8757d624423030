// The toy in place of the geometry, for the programs of the tests.
#include "coordinator/jobs/result_checks.h"
#include "coordinator/jobs/scene_pipeline.h"
#include "tests/support/toy_engine.h"
#include "worker/service/scene_stages.h"

namespace tilemend {

PipelineFactory ScenePipelineFactory(std::string, VerifiedShares, std::shared_ptr<DecodedSurveys>) {
  return ToyPipelineFactory();
}  // NOLINT: as declared

ResultCheck SceneResultCheck(TileCheck, std::shared_ptr<DecodedSurveys>) { return {}; }

std::vector<std::string> AttemptsOfScene(Stage, const std::string&) { return {}; }

StageRunner SceneStageRunner(int64_t) { return ToyStageRunner(); }

}  // namespace tilemend
