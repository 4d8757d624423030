#include "client/progress_display.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "client/output.h"
#include "common/util/stage_words.h"
#include "common/util/standard_streams.h"
#include "common/util/text.h"
#include "coordinator/jobs/job_metrics.h"
#include "coordinator/jobs/job_pipeline.h"

namespace tilemend {
namespace {

constexpr char kEraseLine[] = "\r\033[K";  // of a terminal

bool IsTerminal() { return isatty(STDERR_FILENO) == 1; }

void DrawBar(double share, const std::string& text) {
  std::fprintf(stderr, "%s%s", kEraseLine, BarLine(share, text, ColumnsOfTerminal(STDERR_FILENO)).c_str());
  std::fflush(stderr);
}

// Begins a line on a job. One of this process has no name.
std::string Beginning(const v1::Job& job, const char* otherwise) {
  return job.name().empty() ? otherwise : job.name() + ": ";
}

}  // namespace

std::string TimesText(const v1::Job& job, double share, absl::Time now) {
  constexpr double kLeastShare = 0.05;
  const absl::Time end = job.has_end_time() ? TimeOf(job.end_time()) : now;
  const absl::Duration elapsed = end - TimeOf(job.create_time());
  // Without the time in the queue.
  const absl::Duration at_work = end - TimeOf(job.has_start_time() ? job.start_time() : job.create_time());
  std::string text = ", " + DurationText(elapsed);
  if (job.has_end_time() || share <= kLeastShare) return text;
  return absl::StrCat(text, ", ", DurationText(at_work * ((1 - share) / share)), " left");
}

std::string ProgressText(const v1::Job& job, double share, absl::Time now) {
  const v1::Progress& p = job.progress();
  const auto counted = [](int64_t done, int64_t all, const char* of) {
    return all == 0 ? "" : absl::StrCat(", ", Share(done, all), of);
  };
  return absl::StrCat(p.phase().empty() ? "prepare" : StageWordsOf(p.phase()),
                      counted(p.tasks_done(), p.tasks(), " tasks"), counted(p.cells_done(), p.cells(), " cells"),
                      job.waiting().empty() ? TimesText(job, share, now) : ", waits: " + Printable(job.waiting()));
}

std::string StepText(std::string_view step, size_t done, size_t all, std::string_view unit, absl::Duration elapsed) {
  return absl::StrCat(std::string(step), all == 0 ? "" : absl::StrCat(", ", done, "/", Counted(all, std::string(unit))),
                      ", ", DurationText(elapsed));
}

std::string BarLine(double share, const std::string& text, size_t columns) {
  constexpr size_t kLongest = 30, kShortest = 10, kFrame = 3;  // brackets and a blank
  size_t length = kLongest;
  std::string shown = text;
  if (columns > 0) {
    // The last column stays free: some terminals go to the next line when it is written.
    const auto room = static_cast<std::ptrdiff_t>(columns) - 1;
    const auto left = room - static_cast<std::ptrdiff_t>(kFrame + ColumnsOf(text));
    length = static_cast<size_t>(std::clamp<std::ptrdiff_t>(left, kShortest, kLongest));
    const auto most =
        static_cast<size_t>(std::max<std::ptrdiff_t>(0, room - static_cast<std::ptrdiff_t>(kFrame + length)));
    shown = CutToColumns(text, most);
  }
  const auto full = static_cast<size_t>(static_cast<double>(length) * share);
  return absl::StrCat("[", std::string(full, '#'), std::string(length - full, '.'), "] ", shown);
}

void EraseBar() {
  if (IsTerminal()) std::fputs(kEraseLine, stderr);
}

ProgressDisplay::ProgressDisplay() : is_terminal_(IsTerminal()) {}

ProgressDisplay::~ProgressDisplay() {
  if (has_bar_) std::fputs(kEraseLine, stderr);
}

void ProgressDisplay::Show(const v1::Job& job) {
  for (; warnings_ < job.warnings_size(); ++warnings_) {
    std::fprintf(stderr, "%s%s%s\n", has_bar_ ? kEraseLine : "", Beginning(job, "tilemend: warning: ").c_str(),
                 Printable(job.warnings(warnings_)).c_str());
  }
  if (job.progress().phase() == kResumePhase) return;  // it runs through what was shown before
  if (is_terminal_) {
    ShowBar(job);
  } else {
    ShowLines(job);
  }
}

void ProgressDisplay::ShowLines(const v1::Job& job) {
  if (stage_.empty() && job.state() != v1::RUNNING) return;  // it was over before
  const std::string stage = StageWordsOf(job.progress().phase());
  if (stage != stage_) std::fprintf(stderr, "%s%s\n", Beginning(job, "").c_str(), stage.c_str());
  stage_ = stage;
  if (job.waiting() != waiting_ && !job.waiting().empty()) {
    std::fprintf(stderr, "%swaits: %s\n", Beginning(job, "").c_str(), Printable(job.waiting()).c_str());
  }
  waiting_ = job.waiting();
}

void ProgressDisplay::ShowBar(const v1::Job& job) {
  const v1::Progress& p = job.progress();
  share_ = std::max(share_, ShareDone(p.phase(), p.cells(), p.cells_done(), p.tasks(), p.tasks_done()));
  DrawBar(share_, ProgressText(job, share_, absl::Now()));
  has_bar_ = true;
}

StepDisplay::StepDisplay() : is_terminal_(IsTerminal()), begin_(absl::Now()) {}

StepDisplay::~StepDisplay() {
  if (!step_.empty()) std::fputs(kEraseLine, stderr);
}

StepWatcher StepDisplay::Watcher() {
  return [this](std::string_view step, size_t done, size_t all, std::string_view unit) { Show(step, done, all, unit); };
}

void StepDisplay::Show(std::string_view step, size_t done, size_t all, std::string_view unit) {
  constexpr absl::Duration kBetween = absl::Milliseconds(100);
  const absl::Time now = absl::Now();
  if (!is_terminal_ || (step == step_ && now - shown_ < kBetween)) return;
  step_ = step;
  shown_ = now;
  DrawBar(all == 0 ? 0 : static_cast<double>(done) / static_cast<double>(all),
          StepText(step, done, all, unit, now - begin_));
}

}  // namespace tilemend
