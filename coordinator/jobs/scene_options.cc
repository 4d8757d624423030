#include "coordinator/jobs/scene_options.h"

#include <utility>

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

}  // namespace tilemend
