#include "coordinator/jobs/scene_options.h"

#include <string>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/options/job_options.h"
#include "common/options/method_options.h"
#include "common/util/colour.h"

namespace tilemend {

WaveOptions WaveOptionsOf(const JobSpec& spec, WaterOptions water, std::function<bool()> is_cancelled) {
  WaveOptions options;
  options.plan.is_cancelled = std::move(is_cancelled);
  options.plan.gradation = spec.gradation();
  options.plan.size_limit = spec.size_limit();
  options.plan.uniform = spec.uniform();
  options.plan.water = std::move(water);
  if (!spec.water_colour().empty()) options.plan.water_colour = ParseColour(spec.water_colour());
  options.surface = SurfaceNamed(spec.surface()).value_or(kDefaultSurface);
  options.wang = WangOptionsOf(spec);
  if (options.surface == Surface::kWang) options.plan.seam_points = options.wang.seam_points;
  options.plan_only = spec.dry_run();
  return options;
}

std::string SceneKey(const JobSpec& spec, const WaterChoice& water, const std::string& area_digest) {
  std::string key = absl::StrCat("scene ", spec.scene(), "\n");
  for (const ReportedOption& option : ReportedOptions(spec, kOfJobs)) {
    if (option.name == "clear" || option.name == "area" || option.name == "decisions") continue;
    const auto* number = std::get_if<double>(&option.value);
    const auto* text = std::get_if<std::string>(&option.value);
    const bool* is_on = std::get_if<bool>(&option.value);
    absl::StrAppend(&key, option.name, " ",
                    number != nullptr ? absl::StrFormat("%.17g", *number)
                    : text != nullptr ? *text
                                      : absl::StrCat(*is_on),
                    "\n");
  }
  return absl::StrCat(key, "files ", water.digest, " ", water.clear_digest, " ", area_digest, "\n");
}

std::string JobKey(const JobSpec& spec, const WaterChoice& water, const std::string& area_digest) {
  std::string key = SceneKey(spec, water, area_digest);
  if (!water.decisions_digest.empty()) absl::StrAppend(&key, "decisions ", water.decisions_digest, "\n");
  return key;
}

}  // namespace tilemend
