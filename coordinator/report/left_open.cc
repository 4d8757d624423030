#include "coordinator/report/left_open.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

bool IsChosen(const SceneReportInput& input, CellId cell) {
  return input.outcome.chosen.empty() || input.outcome.chosen.contains(cell);
}

// Open holes that were given up early have no area yet.
bool IsTiny(const PlannedHole& hole) {
  const bool is_known = hole.kind == HoleKind::kClosed || (hole.area > 0 && hole.failure.empty());
  return is_known && hole.area < kTinyHole;
}

// The holes that stay open.
struct LeftCounts {
  int64_t all = 0;
  int64_t tiny = 0;     // of them
  int64_t decided = 0;  // of them, by decision; not among the tiny
};

std::string SmallerThan() { return absl::StrCat("smaller than ", kTinyHole, " m2"); }

// "; 5 left open, 1 of them smaller than 0.05 m2 and 2 by decision, which do not count"
std::string TextOfSome(const LeftCounts& left) {
  const int64_t uncounted = left.tiny + left.decided;
  std::string text = absl::StrCat("; ", left.all, " left open");
  if (left.tiny > 0) absl::StrAppend(&text, ", ", left.tiny, " of them ", SmallerThan());
  if (left.decided > 0) absl::StrAppend(&text, left.tiny > 0 ? " and " : ", ", left.decided);
  if (left.decided > 0) absl::StrAppend(&text, left.tiny > 0 ? "" : " of them", " by decision");
  return absl::StrCat(text, ", which ", uncounted == 1 ? "does" : "do", " not count");
}

std::string TextOfUncounted(const LeftCounts& left) {
  const int64_t uncounted = left.tiny + left.decided;
  if (uncounted > 0 && left.all > uncounted) return TextOfSome(left);
  std::string text;
  if (left.tiny > 0) {
    absl::StrAppend(&text, "; ", left.tiny, " left open ", left.tiny == 1 ? "is " : "are ", SmallerThan(), " and ",
                    left.tiny == 1 ? "does" : "do", " not count");
  }
  if (left.decided > 0) {
    absl::StrAppend(&text, "; ", left.decided, " left open by decision ", left.decided == 1 ? "does" : "do",
                    " not count");
  }
  return text;
}

bool IsLeft(const std::string& failure) { return !failure.empty() && failure != kNotChosen; }

enum class RowKind { kNotLeft, kTiny, kDecided, kCounts };

// Of a row of per_hole in report.json.
RowKind KindOfRow(const nlohmann::ordered_json& hole) {
  const std::string reason = Text(Member(hole, "reason"));
  const nlohmann::ordered_json& area = Member(hole, "area_m2");
  if (Text(Member(hole, "outcome")) != "left" || !IsInChosenCell(hole)) return RowKind::kNotLeft;
  if (reason == kLeftByDecision) return RowKind::kDecided;
  return area.is_number() && std::abs(Number(area)) < kTinyHole ? RowKind::kTiny : RowKind::kCounts;
}

}  // namespace

bool IsInChosenCell(const nlohmann::ordered_json& hole) { return Text(Member(hole, "reason")) != kNotChosen; }

const char* OutcomeOf(const std::string& failure) {
  if (failure.empty()) return "filled";
  return failure == kNotChosen ? "not chosen" : "left";
}

std::string UncountedText(const SceneReportInput& input) {
  LeftCounts counts;
  for (size_t h = 0; h < input.plan->holes.size(); ++h) {
    counts.all += IsLeft(FailureOf(input, static_cast<int32_t>(h)));
  }
  for (const LeftOpen& left : LeftOf(input)) {
    if (!left.is_hole || left.hole < 0) continue;
    const bool is_decided = left.reason == kLeftByDecision;
    counts.decided += is_decided;
    counts.tiny += !is_decided && IsTiny(input.plan->holes[static_cast<size_t>(left.hole)]);
  }
  return TextOfUncounted(counts);
}

std::string UncountedText(const nlohmann::ordered_json& report) {
  LeftCounts counts;
  for (const nlohmann::ordered_json& hole : Member(report, "per_hole")) {
    const RowKind kind = KindOfRow(hole);
    counts.all += kind != RowKind::kNotLeft;
    counts.decided += kind == RowKind::kDecided;
    counts.tiny += kind == RowKind::kTiny;
  }
  return TextOfUncounted(counts);
}

bool CountsAsLeft(const nlohmann::ordered_json& hole) { return KindOfRow(hole) == RowKind::kCounts; }

std::vector<LeftOpen> LeftOf(const SceneReportInput& input) {
  std::vector<LeftOpen> left = input.plan->left;
  // They come in the order in which they were lost.
  std::vector<LeftOpen> unwritten = input.outcome.unwritten;
  std::ranges::sort(unwritten, {}, &LeftOpen::cell);
  left.insert(left.end(), unwritten.begin(), unwritten.end());
  for (const auto& [hole, reason] : input.outcome.failures) {
    const PlannedHole& planned = input.plan->holes[hole];
    left.push_back({planned.cell, reason, hole, planned.boundary_vertices});
  }
  std::erase_if(left, [&](const LeftOpen& l) { return !IsChosen(input, l.cell); });
  return left;
}

bool SomeHolesLeft(const SceneReportInput& input) {
  const std::vector<LeftOpen> left = LeftOf(input);
  return std::ranges::any_of(left, &LeftOpen::is_hole) ||
         std::ranges::any_of(input.plan->holes, [](const PlannedHole& h) { return !h.failure.empty(); });
}

bool IsPartial(const SceneReportInput& input) {
  const std::vector<LeftOpen> left = LeftOf(input);
  return !input.outcome.impaired.empty() || std::ranges::any_of(left, [&](const LeftOpen& l) {
    return l.is_hole && l.reason != kLeftByDecision &&
           (l.hole < 0 || !IsTiny(input.plan->holes[static_cast<size_t>(l.hole)]));
  });
}

std::string FailureOf(const SceneReportInput& input, int32_t hole) {
  if (!IsChosen(input, input.plan->holes[hole].cell)) return kNotChosen;
  const auto it = input.outcome.failures.find(hole);
  return it != input.outcome.failures.end() ? it->second : input.plan->holes[hole].failure;
}

}  // namespace tilemend
