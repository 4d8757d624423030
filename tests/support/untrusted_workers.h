// A real coordinator that checks what it is given, and workers of the test's.
#ifndef TILEMEND_TESTS_SUPPORT_UNTRUSTED_WORKERS_H_
#define TILEMEND_TESTS_SUPPORT_UNTRUSTED_WORKERS_H_

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "coordinator/jobs/result_checks.h"
#include "coordinator/jobs/scene_pipeline.h"
#include "tests/support/output_checks.h"
#include "tests/support/test_cluster.h"
#include "worker/service/scene_stages.h"

namespace tilemend {

class UntrustedWorkerTest : public ::testing::Test {
 protected:
  explicit UntrustedWorkerTest(const ClusterOptions& options = Options()) : cluster_(options) {
    WriteMade(SmallScene(Cut::kClipped), scene_);
  }

  static ClusterOptions Options() {
    ClusterOptions options;
    options.factory = ScenePipelineFactory("", {.files = 1});
    options.check_result = SceneResultCheck(TileCheck::kContent);
    options.attempts_of = AttemptsOfScene;
    return options;
  }
  static std::string Out(const v1::Job& job) { return job.spec().out(); }
  // The tiles of an undisturbed job.
  std::map<std::string, std::string> Undisturbed() {
    cluster_.AddWorker("undisturbed", 2, SceneStageRunner());
    const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
    EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
    cluster_.KillWorker("undisturbed");
    return TilesBelow(Out(job));
  }

  TestCluster cluster_;
  const std::string scene_ = cluster_.folder() / "scene";
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_UNTRUSTED_WORKERS_H_
