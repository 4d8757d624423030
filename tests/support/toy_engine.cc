#include "tests/support/toy_engine.h"

#include <chrono>
#include <map>
#include <thread>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "absl/strings/strip.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

struct ToyScene {
  int cols = 0, rows = 0;
  std::map<std::string, std::string> options;

  std::string Option(const std::string& key) const {
    const auto it = options.find(key);
    return it == options.end() ? "" : it->second;
  }
};

absl::StatusOr<ToyScene> ParseToyScene(const std::string& text) {
  absl::string_view rest = text;
  if (!absl::ConsumePrefix(&rest, "toy://")) return absl::NotFoundError(absl::StrCat(text, ": no such scene"));
  ToyScene scene;
  const std::pair<std::string, std::string> parts = absl::StrSplit(rest, absl::MaxSplits('?', 1));
  const std::pair<std::string, std::string> size = absl::StrSplit(parts.first, absl::MaxSplits('x', 1));
  if (!absl::SimpleAtoi(size.first, &scene.cols) || !absl::SimpleAtoi(size.second, &scene.rows) || scene.cols < 1 ||
      scene.rows < 1) {
    return absl::InvalidArgumentError(absl::StrCat(text, ": expected toy://COLSxROWS"));
  }
  for (const auto& option : absl::StrSplit(parts.second, '&', absl::SkipEmpty())) {
    scene.options.insert(std::pair<std::string, std::string>(absl::StrSplit(option, absl::MaxSplits('=', 1))));
  }
  return scene;
}

class ToyPipeline : public JobPipeline {
 public:
  ToyPipeline(ToyScene scene, JobSpec spec) : scene_(std::move(scene)), spec_(std::move(spec)) {}

  absl::StatusOr<std::vector<NewTask>> Start() override {
    std::vector<NewTask> tasks;
    for (int row = 0; row < scene_.rows; ++row) {
      for (int col = 0; col < scene_.cols; ++col) {
        const bool fail = scene_.Option("fail") == absl::StrCat(col, ",", row);
        tasks.push_back(
            {{col, row},
             Stage::kSurvey,
             absl::StrCat(col, " ", row, " ", fail ? 1 : 0, " ", Number("bytes"), " ", Number("sleep_ms"))});
      }
    }
    waiting_ = tasks.size();
    return tasks;
  }

  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult result) override {
    --waiting_;
    int64_t value = 0;
    if (!result.output.ok()) {
      ++left_;
    } else if (!absl::SimpleAtoi(result.output->substr(0, result.output->find(' ')), &value)) {
      return absl::InternalError("a toy stage returned no number");
    }
    (result.stage == Stage::kAssemble ? total_ : values_[result.cell]) += value;
    return waiting_ > 0 ? std::vector<NewTask>() : NextTasks();
  }

  bool Done() const override { return waiting_ == 0 && phase_ == kFinished; }

  Progress GetProgress() const override {
    Progress progress;
    progress.phase = phase_ == 0 ? "survey" : assembling_ ? "assemble" : absl::StrCat("fill layer ", phase_);
    progress.cells = static_cast<int64_t>(scene_.cols) * scene_.rows;
    return progress;
  }

  absl::StatusOr<JobOutcome> Finish() override {
    JobOutcome outcome;
    outcome.partial = left_ > 0;
    outcome.message = absl::StrCat("total ", total_);
    if (spec_.dry_run()) return outcome;
    outcome.report = absl::StrCat(spec_.out(), "/report.json");
    TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(
        outcome.report,
        absl::StrCat("{\"total\": ", total_, ", \"left\": [], \"cells\": ", scene_.cols * scene_.rows, "}\n")));
    return outcome;
  }

 private:
  static constexpr int kFinished = -1;

  std::string Number(const std::string& key) const {
    const std::string value = scene_.Option(key);
    return value.empty() ? "0" : value;
  }

  int LayerOf(CellId cell) const {
    return 1 + std::min(std::min(cell.col, scene_.cols - 1 - cell.col), std::min(cell.row, scene_.rows - 1 - cell.row));
  }

  absl::StatusOr<std::vector<NewTask>> NextTasks() {
    if (phase_ == 0 && scene_.Option("plan_error") == "1") return absl::DataLossError("the toy plan went wrong");
    if (scene_.Option("stall") == "1") return std::vector<NewTask>();
    std::vector<NewTask> tasks;
    if (assembling_) {
      phase_ = kFinished;
      return tasks;
    }
    ++phase_;
    for (const auto& [cell, value] : values_) {
      if (LayerOf(cell) == phase_) tasks.push_back({cell, Stage::kFill, NeighbourValues(cell)});
    }
    if (tasks.empty()) {
      assembling_ = true;
      for (const auto& [cell, value] : values_) tasks.push_back({cell, Stage::kAssemble, absl::StrCat(value)});
    }
    waiting_ = tasks.size();
    return tasks;
  }

  std::string NeighbourValues(CellId cell) const {
    std::vector<int64_t> near;
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) {
        const auto it = values_.find({cell.col + dc, cell.row + dr});
        if (it != values_.end()) near.push_back(it->second);
      }
    }
    return absl::StrJoin(near, " ");
  }

  const ToyScene scene_;
  const JobSpec spec_;
  std::map<CellId, int64_t> values_;
  size_t waiting_ = 0;
  int phase_ = 0;
  bool assembling_ = false;
  int64_t total_ = 0;
  int64_t left_ = 0;
};

absl::StatusOr<std::string> Survey(const std::string& input, const CancelToken& cancel) {
  std::vector<int64_t> numbers;
  for (const auto& word : absl::StrSplit(input, ' ')) {
    if (!absl::SimpleAtoi(word, &numbers.emplace_back())) return absl::InternalError("a toy survey needs numbers");
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(numbers.at(4));
  while (std::chrono::steady_clock::now() < end) {
    if (cancel.cancelled()) return absl::CancelledError("the toy survey was cancelled");
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (numbers[2] != 0) return absl::InvalidArgumentError("the toy tile is broken");
  return absl::StrCat((numbers[0] * 7 + numbers[1] * 13) % 10 + 1, " ",
                      std::string(static_cast<size_t>(numbers[3]), 'x'));
}

absl::StatusOr<std::string> Fill(const std::string& input) {
  int64_t value = 1;
  for (const auto& word : absl::StrSplit(input, ' ')) {
    int64_t number = 0;
    if (!absl::SimpleAtoi(word, &number)) return absl::InternalError("a toy fill needs numbers");
    value = (value * 31 + number) % 1'000'003;
  }
  return absl::StrCat(value);
}

}  // namespace

PipelineFactory ToyPipelineFactory() {
  return [](const JobSpec& spec, const std::stop_token&) -> absl::StatusOr<std::unique_ptr<JobPipeline>> {
    TILEMEND_ASSIGN_OR_RETURN(ToyScene scene, ParseToyScene(spec.scene()));
    return std::make_unique<ToyPipeline>(std::move(scene), spec);
  };
}

StageRunner ToyStageRunner() {
  return [](Stage stage, const std::string& input, const CancelToken& cancel) -> absl::StatusOr<std::string> {
    switch (stage) {
      case Stage::kSurvey:
        return Survey(input, cancel);
      case Stage::kFill:
        return Fill(input);
      case Stage::kAssemble:
        return input;
      default:
        return absl::InternalError("the toy has no such stage");
    }
  };
}

}  // namespace tilemend
