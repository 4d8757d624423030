#include "client/filler_flags.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "common/records/filler.h"
#include "common/records/surface.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

using Value = decltype(ReportedOption::value);

// A number that some fillers have.
struct FillerFlag {
  const char* name;
  double low, high;
  std::vector<Filler> fillers;
  std::function<void(FillerOptions&, double)> set;
  std::function<Value(const FillerOptions&)> get;
  bool whole = false;
};

const std::vector<Filler>& Fronts() {
  using enum Filler;
  static const std::vector<Filler> fronts = {kAdvancingFrontNormal, kAdvancingFrontCurvature, kAdvancingFrontPoisson,
                                             kSvmLaplacian};
  return fronts;
}

FillerFlag Whole(const char* name, double low, double high, std::vector<Filler> fillers, int32_t FillerOptions::*to) {
  return {name,
          low,
          high,
          std::move(fillers),
          [to](FillerOptions& o, double x) { o.*to = static_cast<int32_t>(x); },
          [to](const FillerOptions& o) -> Value { return double{1} * o.*to; },
          true};
}

FillerFlag Number(const char* name, double low, double high, std::vector<Filler> fillers, double FillerOptions::*to) {
  return {name,
          low,
          high,
          std::move(fillers),
          [to](FillerOptions& o, double x) { o.*to = x; },
          [to](const FillerOptions& o) -> Value { return o.*to; }};
}

std::vector<FillerFlag> Numbers() {
  using enum Filler;
  using O = FillerOptions;
  return {Number("front-merge", 0, 1, Fronts(), &O::merge),
          Whole("longest-rim", 3, 100'000, Fronts(), &O::longest_rim),
          Whole("filler-work", 1, 1e6, Fronts(), &O::most_work),
          {"front-bend",
           0,
           1e4,
           {kAdvancingFrontNormal},
           [](O& o, double x) { o.bend = x; },
           [](const O& o) -> Value { return o.bend ? Value(*o.bend) : Value(std::string("auto")); }},
          Number("long-edge", 1, 100, {kSvmLaplacian}, &O::long_edge),
          Whole("svm-rings", 1, 20, {kSvmLaplacian}, &O::rings),
          Number("svm-gamma", 1e-3, 1e6, {kSvmLaplacian}, &O::gamma),
          Number("svm-width", 0.5, 1000, {kSvmLaplacian}, &O::kernel_width),
          Whole("halvings", 0, 10, {kAdvancingFrontCurvature}, &O::halvings),
          Whole("centroid-steps", 0, 1000, {kAdvancingFrontCurvature}, &O::centroid_steps)};
}

absl::Status CheckHas(const char* flag, const std::vector<Filler>& fillers, Filler filler) {
  if (std::ranges::count(fillers, filler) > 0) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat("--", flag, ": ", NoSuchOption(filler, fillers)));
}

// A choice of words that some fillers have.
template <class Choice>
absl::Status ReadChoice(const Args& args, const char* flag, const std::vector<Filler>& fillers, Filler filler,
                        std::optional<Choice> (*named)(std::string_view), const char* expected, Choice& to) {
  if (!args.IsGiven(flag)) return absl::OkStatus();
  TILEMEND_RETURN_IF_ERROR(CheckHas(flag, fillers, filler));
  const std::optional<Choice> choice = named(args.Text(flag));
  if (!choice) {
    return absl::InvalidArgumentError(absl::StrCat("--", flag, " '", args.Text(flag), "': expected ", expected));
  }
  to = *choice;
  return absl::OkStatus();
}

}  // namespace

FlagSpec FrontStepsFlag() {
  return {"front-steps", "steady|printed",
          "of fronts: printed: new vertices on the plane of their two edges, as in the papers",
          FrontStepsName(FillerOptions().steps)};
}

std::vector<FlagSpec> FillerFlags() {
  const FillerOptions d;
  const auto text = [](const auto& value) { return absl::StrCat(value); };
  return {FrontStepsFlag(),
          {"front-merge", "X", "of fronts: new vertices nearer to the front, in edges, join it, 0 to 1", text(d.merge)},
          {"longest-rim", "N", "of fronts: longer boundaries stay open, 3 to 100000", text(d.longest_rim)},
          {"filler-work", "N", "of fronts: million edges to look at for one hole, else it stays open, 1 to 1e6",
           text(d.most_work)},
          {"front-bend", "METRES", "of advancing-front-normal: eta, 0 to 10000 (default: half the new edge)", ""},
          {"long-edge", "X", "of svm-laplacian: longer edges, in mean ones, are split, 1 to 100", text(d.long_edge)},
          {"svm-laplacian", "area|mean", "of svm-laplacian: Laplacians over areas (eq. 4) or over weights (eq. 2)",
           LaplacianScaleName(d.scale)},
          {"svm-rings", "N", "of svm-laplacian: rings that are learnt from, 1 to 20", text(d.rings)},
          {"svm-gamma", "X", "of svm-laplacian: weight of errors, 0.001 to 1e6", text(d.gamma)},
          {"svm-width", "X", "of svm-laplacian: kernel, in mean edges, 0.5 to 1000", text(d.kernel_width)},
          {"halvings", "N", "of advancing-front-curvature: how often edges are halved, 0 to 10", text(d.halvings)},
          {"centroid-steps", "N", "of advancing-front-curvature: moves to the centroid, 0 to 1000",
           text(d.centroid_steps)}};
}

absl::Status ReadFillerFlags(const Args& args, FillOptions& options) {
  FillerOptions& filling = options.filling;
  TILEMEND_RETURN_IF_ERROR(
      ReadChoice(args, "front-steps", Fronts(), options.filler, FrontStepsNamed, kFrontStepsNames, filling.steps));
  TILEMEND_RETURN_IF_ERROR(ReadChoice(args, "svm-laplacian", {Filler::kSvmLaplacian}, options.filler,
                                      LaplacianScaleNamed, "area or mean", filling.scale));
  for (const FillerFlag& flag : Numbers()) {
    if (!args.IsGiven(flag.name)) continue;
    TILEMEND_RETURN_IF_ERROR(CheckHas(flag.name, flag.fillers, options.filler));
    TILEMEND_ASSIGN_OR_RETURN(const double value, args.Number(flag.name, flag.low, flag.high));
    if (flag.whole && value != std::floor(value)) {
      return absl::InvalidArgumentError(
          absl::StrCat("--", flag.name, " '", args.Text(flag.name), "': expected a whole number"));
    }
    flag.set(options.filling, value);
  }
  return absl::OkStatus();
}

std::vector<ReportedOption> ReportedFillerOptions(const FillOptions& options) {
  std::vector<ReportedOption> reported = {{"surface", SurfaceName(options.surface)},
                                          {"filler", FillerName(options.filler)}};
  if (std::ranges::count(Fronts(), options.filler) > 0) {
    reported.push_back({"front-steps", FrontStepsName(options.filling.steps)});
  }
  if (options.filler == Filler::kSvmLaplacian) {
    reported.push_back({"svm-laplacian", LaplacianScaleName(options.filling.scale)});
  }
  for (const FillerFlag& flag : Numbers()) {
    if (std::ranges::count(flag.fillers, options.filler) > 0)
      reported.push_back({flag.name, flag.get(options.filling)});
  }
  if (options.surface == Surface::kWang || options.filler == Filler::kMinimumArea) {
    reported.push_back({"longest-loop", double{1} * options.wang.longest_loop});
    reported.push_back({"fairing-steps", double{1} * options.wang.fairing_steps});
  }
  return reported;
}

}  // namespace tilemend
