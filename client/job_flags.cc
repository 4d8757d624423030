#include "client/job_flags.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/filler_flags.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/job_proto.h"

namespace tilemend {
namespace {

std::string AbsolutePath(const std::string& path) {
  if (path.empty() || path.find("://") != std::string::npos) return path;
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  if (error) return path;
  std::string normal = absolute.lexically_normal().string();
  while (normal.size() > 1 && normal.back() == '/') normal.pop_back();
  return normal;
}

// Empty where the flag is not given, whatever its default.
std::string TextIfGiven(const Args& args, const char* flag) { return args.IsGiven(flag) ? args.Text(flag) : ""; }

// What is wrong with a field of a spec, under the name of its flag.
absl::Status NamedAsFlag(const absl::Status& status) {
  const std::string message(status.message());
  const size_t end = message.find(':');
  if (end == std::string::npos || message.starts_with("scene:")) return status;
  std::string flag = message.substr(0, end);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return absl::Status(status.code(), absl::StrCat("--", flag, message.substr(end)));
}

}  // namespace

std::vector<FlagSpec> JobFlags() {
  const JobSpec defaults;
  const WangOptions wang;
  std::vector<FlagSpec> flags = {
      {"out", "DIR", "folder to write to", ""},
      {"overwrite", "", "write to DIR even if it is not empty; files of other names stay", ""}};
  for (FlagSpec& flag : SurfaceFlags()) flags.push_back(std::move(flag));
  flags.push_back(FrontStepsFlag());
  flags.push_back(
      {"seam-smoothing", "X", "of wang: how much seams are smoothed, 0 to 1", absl::StrCat(wang.seam_smoothing)});
  flags.push_back(
      {"seam-buffer", "EDGES", "of wang: how far around seams it smooths, 1 to 100", absl::StrCat(wang.seam_buffer)});
  flags.push_back(
      {"seam-points", "projected|spaced", "of wang: where points lie on grid lines", SeamPointsName(wang.seam_points)});
  flags.push_back(
      {"closure", "buffers|line", "of wang: how holes are closed along grid lines", ClosureName(wang.closure)});
  for (FlagSpec& flag : WaterFlags(defaults.water)) flags.push_back(std::move(flag));
  flags.push_back(ClearFlag());
  flags.push_back(AreaFlag());
  flags.push_back({"cells", "CELLS", "fill and write these alone: \"3,4 0,0-5,9\", column,row (default: all)", ""});
  flags.push_back(WaterColourFlag());
  flags.push_back({"textures", "copy|link|off", "material files and images of OBJ tiles; link: images as hard links",
                   defaults.textures});
  flags.push_back({"link", "", "tiles without a patch as hard links of the originals, where they can be", ""});
  flags.push_back({"dry-run", "", "find and count the holes, write nothing", ""});
  return flags;
}

std::vector<FlagSpec> SurfaceFlags() {
  const JobSpec defaults;
  return {
      {"surface", "thin-plate|wang", "wang is for comparison", defaults.surface},
      {"filler", "NAME", absl::StrCat("of closed holes: ", FillerNames()), FillerName(Filler::kAuto)},
      {"tension", "auto|X", "of thin-plate: how taut it is, 0 to 1000 per m^2; auto: from the rim", "auto"},
      {"gradation", "X", "growth of triangles from edge to edge inward, 1 to 10", absl::StrCat(defaults.gradation)},
      {"size-limit", "X", "longest edge as a multiple of the rim's mean edge, 1 to 1e6",
       absl::StrCat(defaults.size_limit)},
      {"uniform", "", "keep the boundary's triangle size inside, no growth", ""},
      {"longest-loop", "N", "of wang: longer boundaries are cut; of minimum-area (fill): left open; 3 to 2000",
       absl::StrCat(WangOptions().longest_loop)},
      {"fairing-steps", "N", "of wang and minimum-area (fill): 0 to 1000", absl::StrCat(WangOptions().fairing_steps)}};
}

std::vector<FlagSpec> WaterFlags(const std::string& default_value) {
  std::string help = "fill level water flat; FILE: polygons with and without water, as a GIS writes them";
  if (default_value.empty()) help += " (default: auto, for single meshes off)";
  return {{"water", "auto|off|FILE", help, default_value},
          {"water-profile", "city|usgs", "what auto finds: lakes from 1000 m2, rivers from 6 m, or 8000 m2, 30 m",
           JobSpec().water_profile}};
}

FlagSpec ClearFlag() {
  return {"clear", "FILE", "polygons whose surface is taken out and filled anew, a file of a GIS", ""};
}

FlagSpec AreaFlag() {
  return {"area", "FILE", "polygon of what is to be covered, as a GIS writes it (default: the scene's cells)", ""};
}

absl::StatusOr<WaterProfile> WaterProfileFromFlags(const Args& args) {
  const WaterProfile* profile = WaterProfileNamed(args.Text("water-profile"));
  if (profile != nullptr) return *profile;
  return absl::InvalidArgumentError(
      absl::StrCat("--water-profile '", args.Text("water-profile"), "': expected city or usgs"));
}

FlagSpec WaterColourFlag() {
  return {"water-colour", "R,G,B|#rrggbb", "colour of filled water (default: as its shore has it)", ""};
}

FlagSpec OutputFlag() { return {"output", "table|json", "format on stdout", "table", 'o'}; }

absl::StatusOr<std::optional<double>> NumberIfGiven(const Args& args, const char* flag, double low, double high) {
  if (!args.IsGiven(flag)) return std::nullopt;
  return args.Number(flag, low, high);
}

absl::StatusOr<std::optional<int32_t>> WholeNumberIfGiven(const Args& args, const char* flag, int low, int high) {
  if (!args.IsGiven(flag)) return std::nullopt;
  TILEMEND_ASSIGN_OR_RETURN(const int64_t number, args.Integer(flag, low, high));
  return static_cast<int32_t>(number);
}

absl::StatusOr<Filler> FillerFromFlags(const Args& args) {
  if (const std::optional<Filler> filler = FillerNamed(args.Text("filler"))) return *filler;
  return absl::InvalidArgumentError(absl::StrCat("--filler '", args.Text("filler"), "': expected ", FillerNames()));
}

absl::StatusOr<std::optional<double>> TensionFromFlags(const Args& args) {
  if (args.Text("tension") == "auto") return std::nullopt;
  return args.Number("tension", 0, 1000);
}

absl::Status CheckHaveEffect(const Args& args) {
  for (const char* flag : {"gradation", "size-limit"}) {
    if (args.IsGiven(flag) && args.Switch("uniform")) {
      return absl::InvalidArgumentError(
          absl::StrCat("--", flag, ": --uniform triangles do not grow; leave one of the two out"));
    }
  }
  for (const char* flag : {"water-profile", "water-colour"}) {
    if (args.IsGiven(flag) && args.Text("water") == kNoWater) {
      return absl::InvalidArgumentError(
          absl::StrCat("--", flag, ": no water is looked for; leave it out, or give --water auto or a file"));
    }
  }
  return absl::OkStatus();
}

absl::StatusOr<v1::JobSpec> SpecFromFlags(const Args& args) {
  JobSpec spec;
  spec.scene = AbsolutePath(args.arguments().front());
  spec.out = AbsolutePath(args.Text("out"));
  spec.surface = args.Text("surface");
  TILEMEND_ASSIGN_OR_RETURN(const Filler filler, FillerFromFlags(args));
  spec.filler = FillerName(filler);
  spec.front_steps = TextIfGiven(args, "front-steps");
  TILEMEND_RETURN_IF_ERROR(CheckHaveEffect(args));
  spec.uniform = args.Switch("uniform");
  TILEMEND_ASSIGN_OR_RETURN(spec.tension, TensionFromFlags(args));
  TILEMEND_ASSIGN_OR_RETURN(spec.gradation, args.Number("gradation", 1, 10));
  TILEMEND_ASSIGN_OR_RETURN(spec.size_limit, args.Number("size-limit", 1, 1e6));
  TILEMEND_ASSIGN_OR_RETURN(spec.seam_smoothing, NumberIfGiven(args, "seam-smoothing", 0, 1));
  TILEMEND_ASSIGN_OR_RETURN(spec.seam_buffer, NumberIfGiven(args, "seam-buffer", 1, 100));
  TILEMEND_ASSIGN_OR_RETURN(spec.longest_loop, WholeNumberIfGiven(args, "longest-loop", 3, 2000));
  TILEMEND_ASSIGN_OR_RETURN(spec.fairing_steps, WholeNumberIfGiven(args, "fairing-steps", 0, 1000));
  spec.seam_points = TextIfGiven(args, "seam-points");
  spec.closure = TextIfGiven(args, "closure");
  spec.water = args.Text("water");
  if (spec.water != kFindWater && spec.water != kNoWater) spec.water = AbsolutePath(spec.water);
  spec.clear = AbsolutePath(args.Text("clear"));
  spec.area = AbsolutePath(args.Text("area"));
  TILEMEND_ASSIGN_OR_RETURN(const WaterProfile profile, WaterProfileFromFlags(args));
  spec.water_profile = profile.name;
  spec.water_colour = args.Text("water-colour");
  spec.textures = args.Text("textures");
  spec.cells = args.Text("cells");
  if (spec.cells.empty() && args.IsGiven("cells")) {
    return absl::InvalidArgumentError("--cells '': names no cell; all cells are chosen by leaving it out");
  }
  spec.link = args.Switch("link");
  spec.overwrite = args.Switch("overwrite");
  spec.dry_run = args.Switch("dry-run");
  if (spec.out.empty() && !spec.dry_run) return absl::InvalidArgumentError("--out DIR is needed");
  if (const absl::Status status = spec.Check(); !status.ok()) return NamedAsFlag(status);
  return SpecToProto(spec);
}

absl::StatusOr<OutputFormat> FormatFromFlags(const Args& args) {
  const std::string format = args.Text("output");
  if (format == "table") return OutputFormat::kTable;
  if (format == "json") return OutputFormat::kJson;
  return absl::InvalidArgumentError(absl::StrCat("-o '", format, "': expected table or json"));
}

int PrintUsageError(const absl::Status& status) {
  PrintError(status);
  return kExitUsage;
}

}  // namespace tilemend
