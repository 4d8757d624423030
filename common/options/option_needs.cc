#include "common/options/option_needs.h"

#include <algorithm>
#include <array>
#include <span>

#include "common/records/filler.h"
#include "common/records/surface.h"

namespace tilemend {
namespace {

std::string UnlessOneOf(Filler filler, std::span<const Filler> having) {
  return std::ranges::count(having, filler) > 0 ? "" : NoSuchOption(filler, having);
}

}  // namespace

std::string WhyWithoutEffect(OptionNeeds needs, const v1::JobSpec& spec) {
  const Surface surface = SurfaceNamed(spec.surface()).value_or(kDefaultSurface);
  const Filler filler = FillerNamed(spec.filler()).value_or(Filler::kAuto);
  const bool is_wang = surface == Surface::kWang;
  switch (needs) {
    case OptionNeeds::kNothing:
      return "";
    case OptionNeeds::kGrowth:
      return spec.uniform() ? "uniform triangles do not grow; leave one of the two out" : "";
    case OptionNeeds::kWater:
      return spec.water() == "off" ? "water is off; leave it out, or choose auto or a file for water" : "";
    case OptionNeeds::kThinPlate:
      return is_wang ? "only the surface thin-plate has this option; leave it out, or choose that surface" : "";
    case OptionNeeds::kWang:
      return is_wang ? "" : "only the surface wang has this option; leave it out, or choose that surface";
    case OptionNeeds::kWangOrMinimumArea:
      if (is_wang || filler == Filler::kMinimumArea) return "";
      return "only the surface wang and the filler minimum-area have this option; leave it out, or choose one of them";
    case OptionNeeds::kFront:
      return UnlessOneOf(filler, kFrontFillers);
    case OptionNeeds::kFrontNormal:
      return UnlessOneOf(filler, std::array{Filler::kAdvancingFrontNormal});
    case OptionNeeds::kFrontCurvature:
      return UnlessOneOf(filler, std::array{Filler::kAdvancingFrontCurvature});
    case OptionNeeds::kSvm:
      return UnlessOneOf(filler, std::array{Filler::kSvmLaplacian});
  }
  return "";
}

}  // namespace tilemend
