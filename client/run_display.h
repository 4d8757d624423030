// What `tilemend run` shows a person: stages while it runs, then the result. Nothing of jobs and tasks.
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

// The end of a run without a report: its warnings, and what it found or that it was cancelled. "" if it failed: then
// the error is shown.
std::string EndWithoutReport(const v1::Job& job);

// The short end of a run: what was filled, the levels of water, what to look at, what is left. `columns` as of
// SummaryText.
std::string ResultText(const nlohmann::ordered_json& report, size_t columns = 0);

// On a terminal one moving line on stderr, which stays with its seconds when the next stage begins. Else a line when a
// stage begins, and one with its seconds when it ends.
class RunDisplay {
 public:
  RunDisplay();
  ~RunDisplay();
  void Show(const v1::Job& job);

 private:
  void EndStage();

  const bool is_terminal_;
  std::string stage_;  // of the line
  double share_ = 0;   // of the bar, which never runs back
  absl::Time begin_;   // of the stage
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_RUN_DISPLAY_H_
