#include "worker/service/fill_options.h"

#include "common/options/method_options.h"
#include "worker/papers/published_ways.h"

namespace tilemend {

FillOptions FillOptionsOf(const v1::JobSpec& spec) {
  FillOptions options;
  options.published = AllPublishedWays();
  options.surface = SurfaceNamed(spec.surface()).value_or(kDefaultSurface);
  options.filler = FillerNamed(spec.filler()).value_or(Filler::kAuto);
  options.refine.gradation = spec.gradation();
  options.refine.size_limit = spec.size_limit();
  options.refine.uniform = spec.uniform();
  if (spec.has_tension()) options.tension = spec.tension();
  options.wang = WangOptionsOf(spec);
  options.filling = FillerOptionsOf(spec);
  options.allow_creases = spec.allow_creases();
  return options;
}

}  // namespace tilemend
