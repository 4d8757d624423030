// What the commands print.
#ifndef TILEMEND_CLIENT_OUTPUT_H_
#define TILEMEND_CLIENT_OUTPUT_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "common/util/exit_codes.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

enum class OutputFormat { kTable, kJson };

// The most rows of one table on a terminal.
inline constexpr size_t kMostListedRows = 30;

// "and 12 more; WHERE" with a line's end, if a table shows only the first rows of `count`; else "".
std::string MoreText(size_t count, const std::string& where);

// Metres with three decimals: of a number, or "first to last" of two.
std::string LevelText(const nlohmann::ordered_json& level);

// Rows under their headings, columns lined up; columns of numbers alone at their right.
std::string Table(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows);

// "1 tension", "2 tensions".
std::string Counted(size_t count, const std::string& noun);

std::string JobText(const v1::Job& job, OutputFormat format);
std::string JobsText(const std::vector<v1::Job>& jobs, OutputFormat format);

std::string WorkersText(const std::vector<v1::WorkerInfo>& workers, OutputFormat format);

// By the job's end; kExitDone for a job that still runs.
ExitCode ExitCodeOf(const v1::Job& job);

// One line on stderr; gives the exit code.
ExitCode PrintError(const absl::Status& status);

// Shows on stderr how a job goes: a bar on a terminal, else a line for each phase.
class ProgressDisplay {
 public:
  ProgressDisplay();
  ~ProgressDisplay();
  void Show(const v1::Job& job);

 private:
  const bool is_terminal_;
  bool has_bar_ = false;
  int warnings_ = 0;             // shown so far
  double share_ = 0;             // of the bar, which never runs back
  std::string phase_, waiting_;  // as said last
};

// The same for work without a job: a bar on a terminal, else nothing. It goes when this object goes.
class StepDisplay {
 public:
  StepDisplay();
  ~StepDisplay();
  // `all` 0: it is not known how much there is. Shown at most ten times a second, each step at least once.
  void Show(std::string_view step, size_t done, size_t all);

 private:
  const bool is_terminal_;
  std::string step_;
  absl::Time begin_, shown_;
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_OUTPUT_H_
