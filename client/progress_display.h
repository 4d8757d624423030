// How a job or a command goes, on stderr.
#ifndef TILEMEND_CLIENT_PROGRESS_DISPLAY_H_
#define TILEMEND_CLIENT_PROGRESS_DISPLAY_H_

#include <cstddef>
#include <string>
#include <string_view>

#include "absl/time/time.h"
#include "client/step_watcher.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// One line of a terminal of `columns` columns, 0 if that is not known: a bar for `share`, 0 to 1, and `text`. The bar
// gets shorter before the text is cut, which must not reach into a second line: that would not be erased. `text` is
// printable.
std::string BarLine(double share, const std::string& text, size_t columns);

// ", 2 min 05 s, 1 min 10 s left": since the job was made and, once `share` is enough to guess it by, until its end. Of
// a job that is over how long it took.
std::string TimesText(const v1::Job& job, double share, absl::Time now);

// "fill, 3/24 tasks, 2/9 cells, 12 s": what is said of a job beside its bar, with TimesText or why it waits. What is
// not known yet is left out.
std::string ProgressText(const v1::Job& job, double share, absl::Time now);

// "look at the tiles, 3/24 tiles, 12 s". `all` 0: nothing is counted.
std::string StepText(std::string_view step, size_t done, size_t all, std::string_view unit, absl::Duration elapsed);

// Erases the bar that may be on stderr.
void EraseBar();

// How a job goes: a bar on a terminal, else a line for each phase, which begins with the name that the job has. The bar
// goes when this object goes.
class ProgressDisplay {
 public:
  ProgressDisplay();
  ~ProgressDisplay();
  void Show(const v1::Job& job);

 private:
  void ShowLines(const v1::Job& job);
  void ShowBar(const v1::Job& job);

  const bool is_terminal_;
  bool has_bar_ = false;
  int warnings_ = 0;             // shown so far
  double share_ = 0;             // of the bar, which never runs back
  std::string stage_, waiting_;  // as said last
};

// The same for work without a job: a bar on a terminal, else nothing.
class StepDisplay {
 public:
  StepDisplay();
  ~StepDisplay();
  // `all` 0: it is not known how much there is. Shown at most ten times a second, each step at least once.
  void Show(std::string_view step, size_t done, size_t all, std::string_view unit);
  // Calls Show. This object outlives it.
  StepWatcher Watcher();

 private:
  const bool is_terminal_;
  std::string step_;
  absl::Time begin_, shown_;
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_PROGRESS_DISPLAY_H_
