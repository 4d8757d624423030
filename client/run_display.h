// What `tilemend run` shows a person at a terminal: stages while it runs, then the result. Nothing of jobs and tasks.
#ifndef TILEMEND_CLIENT_RUN_DISPLAY_H_
#define TILEMEND_CLIENT_RUN_DISPLAY_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "absl/time/time.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// "fill the holes, 12 of 85 holes": the stage of the job and how far it is.
std::string StageText(const v1::Job& job);

// The end of a run: what was filled, the levels of water, what to look at, what is left. `columns` as of SummaryText.
std::string ResultText(const nlohmann::ordered_json& report, size_t columns = 0);

// One moving line on stderr, which stays with its seconds when the next stage begins. For a terminal.
class RunDisplay {
 public:
  RunDisplay();
  ~RunDisplay();
  void Show(const v1::Job& job);

 private:
  void EndStage();

  std::string stage_;  // of the line
  double share_ = 0;   // of the bar, which never runs back
  absl::Time begin_;   // of the stage
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_RUN_DISPLAY_H_
