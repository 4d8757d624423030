#include "coordinator/jobs/scene_options.h"

#include <string>
#include <utility>

#include "absl/strings/str_format.h"
#include "common/util/colour.h"

namespace tilemend {

WangOptions WangOptionsOf(const JobSpec& spec) {
  WangOptions options;
  options.seam_smoothing = spec.seam_smoothing.value_or(options.seam_smoothing);
  options.seam_buffer = spec.seam_buffer.value_or(options.seam_buffer);
  options.longest_loop = spec.longest_loop.value_or(options.longest_loop);
  options.fairing_steps = spec.fairing_steps.value_or(options.fairing_steps);
  options.seam_points = SeamPointsNamed(spec.seam_points).value_or(options.seam_points);
  options.closure = ClosureNamed(spec.closure).value_or(options.closure);
  return options;
}

WaveOptions WaveOptionsOf(const JobSpec& spec, WaterOptions water, std::function<bool()> is_cancelled) {
  WaveOptions options;
  options.plan.is_cancelled = std::move(is_cancelled);
  options.plan.gradation = spec.gradation;
  options.plan.size_limit = spec.size_limit;
  options.plan.uniform = spec.uniform;
  options.plan.water = std::move(water);
  if (!spec.water_colour.empty()) options.plan.water_colour = ParseColour(spec.water_colour);
  options.surface = SurfaceNamed(spec.surface).value_or(kDefaultSurface);
  options.wang = WangOptionsOf(spec);
  if (options.surface == Surface::kWang) options.plan.seam_points = options.wang.seam_points;
  options.plan_only = spec.dry_run;
  return options;
}

v1::ShapeOptions ShapeOptionsOf(const JobSpec& spec) {
  v1::ShapeOptions options;
  options.set_gradation(spec.gradation);
  options.set_size_limit(spec.size_limit);
  options.set_uniform(spec.uniform);
  options.set_thin_plate(spec.surface == SurfaceName(Surface::kThinPlate));
  options.set_filler(spec.filler);
  options.set_front_steps(spec.front_steps);
  if (spec.tension) options.set_tension(*spec.tension);
  if (options.thin_plate()) return options;
  const WangOptions wang = WangOptionsOf(spec);
  options.set_longest_loop(wang.longest_loop);
  options.set_fairing_steps(wang.fairing_steps);
  options.set_closure(ClosureName(wang.closure));
  return options;
}

std::vector<ReportedOption> OptionsOf(const JobSpec& spec) {
  ReportedOption tension{"tension", std::string("auto")};
  if (spec.tension) tension.value = *spec.tension;
  std::vector<ReportedOption> options = {{"surface", spec.surface},
                                         {"filler", spec.filler},
                                         {"tension", tension.value},
                                         {"gradation", spec.gradation},
                                         {"size-limit", spec.size_limit},
                                         {"uniform", spec.uniform},
                                         {"water", spec.water},
                                         {"water-profile", spec.water_profile},
                                         {"water-colour", spec.water_colour},
                                         {"textures", spec.textures},
                                         {"clear", spec.clear},
                                         {"area", spec.area},
                                         {"cells", spec.cells}};
  if (!spec.front_steps.empty()) options.push_back({"front-steps", spec.front_steps});
  if (spec.surface == SurfaceName(Surface::kWang)) {
    const WangOptions wang = WangOptionsOf(spec);
    options.push_back({"seam-smoothing", wang.seam_smoothing});
    options.push_back({"seam-buffer", wang.seam_buffer});
    options.push_back({"longest-loop", double{1} * wang.longest_loop});
    options.push_back({"fairing-steps", double{1} * wang.fairing_steps});
    options.push_back({"seam-points", SeamPointsName(wang.seam_points)});
    options.push_back({"closure", ClosureName(wang.closure)});
  }
  return options;
}

std::string JobKey(const JobSpec& spec, const WaterChoice& water, const std::string& area_digest) {
  const WangOptions wang = WangOptionsOf(spec);
  return absl::StrFormat(
      "scene %s\nsurface %s\nfiller %s %s\nuniform %d\ngradation %.17g\nsize_limit %.17g\nwang %.17g %.17g %d %d "
      "%s %s\ntension "
      "%s\n"
      "water %s %s\nwater_profile %s\nwater_colour %s\ntextures %s\nclear %s\narea %s\ncells %s\n",
      spec.scene, spec.surface, spec.filler, spec.front_steps, spec.uniform, spec.gradation, spec.size_limit,
      wang.seam_smoothing, wang.seam_buffer, wang.longest_loop, wang.fairing_steps, SeamPointsName(wang.seam_points),
      ClosureName(wang.closure), spec.tension ? absl::StrFormat("%.17g", *spec.tension) : "auto", spec.water,
      water.digest, spec.water_profile, spec.water_colour, spec.textures, water.clear_digest, area_digest, spec.cells);
}

}  // namespace tilemend
