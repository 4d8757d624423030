#include "client/mesh/mesh_options.h"

#include <algorithm>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/records/filler.h"
#include "common/records/surface.h"
#include "common/util/colour.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/report/water_choice.h"
#include "worker/service/fill_options.h"

namespace tilemend {
namespace {

absl::Status InvalidField(const std::string& field, const std::string& why) {
  return WithErrorInfo(absl::InvalidArgumentError(absl::StrCat(field, ": ", why)),
                       {"INVALID_SPEC", {{"field", field}}});
}

bool IsFieldGiven(const IsGiven& is_given, std::string_view field) {
  return std::ranges::any_of(AllOptions(), [&](const Option& option) {
    return (option.commands & kOfFill) != 0 && field == option.field && is_given(option);
  });
}

absl::StatusOr<WaterOptions> WaterOf(const v1::JobSpec& spec) {
  TILEMEND_ASSIGN_OR_RETURN(WaterChoice water, ReadWaterChoice(spec.water(), SceneFrame()));
  TILEMEND_RETURN_IF_ERROR(AddClearFile(spec.clear(), SceneFrame(), water));
  water.options.profile = *WaterProfileNamed(spec.water_profile());
  return water.options;
}

}  // namespace

absl::Status CheckMeshOptions(const v1::JobSpec& spec, const IsGiven& is_given) {
  TILEMEND_RETURN_IF_ERROR(CheckOptions(spec, kOfFill, is_given));
  const Filler filler = FillerNamed(spec.filler()).value_or(Filler::kAuto);
  const bool is_wang = spec.surface() == SurfaceName(Surface::kWang), is_auto = filler == Filler::kAuto;
  if (is_wang && !is_auto) {
    return InvalidField("filler", "the surface wang fills closed holes in its own way; leave one of the two out");
  }
  if (spec.has_tension() && !is_auto) {
    return InvalidField("tension",
                        absl::StrCat("the filler ", spec.filler(), " has none; leave it out, or choose auto"));
  }
  if (spec.allow_creases() && (is_wang || !is_auto)) {
    return InvalidField("allow_creases",
                        "published methods fill with creases as they are published; leave one of the two out");
  }
  for (const char* field : {"gradation", "size_limit"}) {
    if (IsFieldGiven(is_given, field) && HasFront(filler) && spec.water() == kNoWater) {
      return InvalidField(
          field, absl::StrCat("the triangles of ", spec.filler(), " are as large as the boundary's; leave it out"));
    }
  }
  return absl::OkStatus();
}

absl::StatusOr<MeshFillOptions> MeshOptionsOf(const v1::JobSpec& spec) {
  MeshFillOptions options;
  options.fill = FillOptionsOf(spec);
  TILEMEND_ASSIGN_OR_RETURN(options.water, WaterOf(spec));
  if (!spec.water_colour().empty()) options.water_colour = ParseColour(spec.water_colour());
  if (spec.has_weld()) options.weld = spec.weld();
  options.holes.fill_outlines = spec.fill_outlines();
  if (spec.has_largest_hole()) options.holes.largest_hole = spec.largest_hole();
  if (spec.has_dislocation_width()) options.holes.dislocation_width = spec.dislocation_width();
  return options;
}

}  // namespace tilemend
