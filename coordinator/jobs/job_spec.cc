#include <cmath>

#include "absl/strings/str_cat.h"
#include "common/grid/cell_choice.h"
#include "common/grid/water_profile.h"
#include "common/util/colour.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/jobs/job_pipeline.h"

namespace tilemend {
namespace {

absl::Status InvalidSpec(const std::string& field, const std::string& what) {
  return WithErrorInfo(absl::InvalidArgumentError(absl::StrCat(field, ": ", what)),
                       {"INVALID_SPEC", {{"field", field}}});
}

absl::Status CheckRange(const std::string& field, double value, double low, double high) {
  if (std::isfinite(value) && value >= low && value <= high) return absl::OkStatus();
  return InvalidSpec(field, absl::StrCat(value, " is not between ", low, " and ", high));
}

constexpr size_t kMostPathBytes = 4096;
constexpr size_t kMostCellsBytes = size_t{64} << 10;  // kept with the job, and shown with it

absl::Status CheckCells(const std::string& cells) {
  if (cells.size() > kMostCellsBytes) return InvalidSpec("cells", "more than 64 KiB");
  const absl::Status status = ParseCells(cells).status();
  return status.ok() ? status : InvalidSpec("cells", std::string(status.message()));
}

// Another process has another working directory, and the system takes a path up to its first NUL.
absl::Status CheckAbsolute(const std::string& field, const std::string& path) {
  if (path.size() > kMostPathBytes) return InvalidSpec(field, "a path of more than 4096 bytes");
  if (path.find('\0') != std::string::npos)
    return InvalidSpec(field, absl::StrCat("'", Printable(path), "': a path with a NUL"));
  if (path.empty() || path.front() == '/' || path.find("://") != std::string::npos) return absl::OkStatus();
  return InvalidSpec(field, absl::StrCat("'", Printable(path), "': a relative path; give one that begins with /"));
}

constexpr char kNotBesideUniform[] = "uniform triangles do not grow; leave one of the two out";
constexpr char kNotWithoutWater[] = "of water, for which water off does not look; leave one of the two out";
constexpr char kOnlyOfWang[] = "only the surface wang has this option; leave it out, or choose that surface";

// Options of Wang's surface are for no other.
absl::Status CheckOfWang(const JobSpec& spec, Surface surface) {
  struct Option {
    const char* name;
    std::optional<double> value;
    double low, high;
  };
  for (const Option& option :
       {Option{"seam_smoothing", spec.seam_smoothing, 0, 1}, Option{"seam_buffer", spec.seam_buffer, 1, 100},
        Option{"longest_loop", spec.longest_loop, kShortestLongestLoop, kLongestLongestLoop},
        Option{"fairing_steps", spec.fairing_steps, 0, kMostFairingSteps}}) {
    if (!option.value) continue;
    if (surface != Surface::kWang) return InvalidSpec(option.name, kOnlyOfWang);
    TILEMEND_RETURN_IF_ERROR(CheckRange(option.name, *option.value, option.low, option.high));
  }
  struct Choice {
    const char* name;
    const std::string& value;
    bool is_known;
    const char* expected;
  };
  for (const Choice& choice :
       {Choice{"seam_points", spec.seam_points, SeamPointsNamed(spec.seam_points).has_value(), "projected or spaced"},
        Choice{"closure", spec.closure, ClosureNamed(spec.closure).has_value(), "buffers or line"}}) {
    if (choice.value.empty()) continue;
    if (surface != Surface::kWang) return InvalidSpec(choice.name, kOnlyOfWang);
    if (choice.is_known) continue;
    return InvalidSpec(choice.name, absl::StrCat("'", Printable(choice.value), "': expected ", choice.expected));
  }
  return absl::OkStatus();
}

// The filler of closed holes, and what it has.
absl::Status CheckFiller(const JobSpec& spec) {
  const std::optional<Filler> filler = FillerNamed(spec.filler);
  if (!filler) {
    return InvalidSpec("filler", absl::StrCat("'", Printable(spec.filler), "': expected ", FillerNames()));
  }
  if (spec.front_steps.empty()) return absl::OkStatus();
  if (!HasFront(*filler)) return InvalidSpec("front_steps", NoSuchOption(*filler, kFrontFillers));
  if (FrontStepsNamed(spec.front_steps)) return absl::OkStatus();
  return InvalidSpec("front_steps", absl::StrCat("'", Printable(spec.front_steps), "': expected ", kFrontStepsNames));
}

// What says how water is found is nothing to choose where none is looked for.
absl::Status CheckWater(const JobSpec& spec) {
  const std::string& water = spec.water;
  if (water.empty() || !IsUtf8(water)) {
    return InvalidSpec("water", absl::StrCat("'", Printable(water), "' is neither auto, off nor a path in UTF-8"));
  }
  if (water != "auto" && water != "off") TILEMEND_RETURN_IF_ERROR(CheckAbsolute("water", water));
  if (WaterProfileNamed(spec.water_profile) == nullptr) {
    return InvalidSpec("water_profile", absl::StrCat("'", Printable(spec.water_profile), "': expected city or usgs"));
  }
  if (!spec.water_colour.empty() && !ParseColour(spec.water_colour)) {
    return InvalidSpec("water_colour", absl::StrCat("'", Printable(spec.water_colour), "': expected ", kColourForm));
  }
  if (water != "off") return absl::OkStatus();
  const JobSpec defaults;
  if (spec.water_profile != defaults.water_profile) return InvalidSpec("water_profile", kNotWithoutWater);
  return spec.water_colour.empty() ? absl::OkStatus() : InvalidSpec("water_colour", kNotWithoutWater);
}

// How large triangles become is nothing to choose where they do not grow.
absl::Status CheckGrowth(const JobSpec& spec) {
  TILEMEND_RETURN_IF_ERROR(CheckRange("gradation", spec.gradation, 1, 10));
  TILEMEND_RETURN_IF_ERROR(CheckRange("size_limit", spec.size_limit, 1, 1e6));
  const JobSpec defaults;
  if (spec.uniform && spec.gradation != defaults.gradation) return InvalidSpec("gradation", kNotBesideUniform);
  if (spec.uniform && spec.size_limit != defaults.size_limit) return InvalidSpec("size_limit", kNotBesideUniform);
  return absl::OkStatus();
}

}  // namespace

absl::Status JobSpec::Check() const {
  if (scene.empty()) return InvalidSpec("scene", "no path is given");
  if (out.empty() && !dry_run) return InvalidSpec("out", "no folder is given to write to");
  if (!IsUtf8(scene)) return InvalidSpec("scene", absl::StrCat(Printable(scene), ": a path that is not UTF-8"));
  if (!IsUtf8(out)) return InvalidSpec("out", absl::StrCat(Printable(out), ": a path that is not UTF-8"));
  TILEMEND_RETURN_IF_ERROR(CheckAbsolute("scene", scene));
  TILEMEND_RETURN_IF_ERROR(CheckAbsolute("out", out));
  const std::optional<Surface> named = SurfaceNamed(surface);
  if (!named) {
    return InvalidSpec("surface", absl::StrCat("'", Printable(surface), "': expected thin-plate or wang"));
  }
  TILEMEND_RETURN_IF_ERROR(CheckFiller(*this));
  TILEMEND_RETURN_IF_ERROR(CheckWater(*this));
  TILEMEND_RETURN_IF_ERROR(CheckAbsolute("clear", clear));
  if (!IsUtf8(clear)) return InvalidSpec("clear", absl::StrCat("'", Printable(clear), "' is no path in UTF-8"));
  TILEMEND_RETURN_IF_ERROR(CheckAbsolute("area", area));
  if (!IsUtf8(area)) return InvalidSpec("area", absl::StrCat("'", Printable(area), "' is no path in UTF-8"));
  if (textures != "copy" && textures != "link" && textures != "off") {
    return InvalidSpec("textures", absl::StrCat("'", Printable(textures), "': expected copy, link or off"));
  }
  TILEMEND_RETURN_IF_ERROR(CheckCells(cells));
  if (tension) TILEMEND_RETURN_IF_ERROR(CheckRange("tension", *tension, 0, 1000));
  if (tension && named != Surface::kThinPlate)
    return InvalidSpec("tension", "only the surface thin-plate has a tension; leave it out, or choose that surface");
  TILEMEND_RETURN_IF_ERROR(CheckGrowth(*this));
  return CheckOfWang(*this, *named);
}

}  // namespace tilemend
