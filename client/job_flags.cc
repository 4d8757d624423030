#include "client/job_flags.h"

#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "coordinator/report/water_choice.h"
#include "coordinator/service/job_pipeline.h"
#include "coordinator/service/job_proto.h"

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

}  // namespace

std::vector<FlagSpec> JobFlags() {
  const JobSpec defaults;
  std::vector<FlagSpec> flags = {
      {"out", "DIR", "folder to write to", ""},
      {"surface", "NAME", "thin-plate or wang", defaults.surface},
      {"uniform", "", "triangles as large as the rim's throughout", ""},
      TensionFlag(),
      GradationFlag(),
      SizeLimitFlag(),
      {"seam-smoothing", "X", "smoothing of the seams, 0 to 1", absl::StrCat(defaults.seam_smoothing)},
      {"overwrite", "", "write into a folder that is not empty; files of other names stay", ""},
      {"dry-run", "", "survey and plan only, write nothing", ""},
      OutputFlag(),
  };
  for (FlagSpec& flag : WaterFlags(defaults.water)) flags.push_back(std::move(flag));
  return flags;
}

std::vector<FlagSpec> WaterFlags(const std::string& default_value) {
  return {{"water", "auto|off|FILE", "fill level water flat; FILE: GeoJSON of where it is and is not", default_value},
          {"water-tolerance", "METRES", "how far the rim of water may be off its level, 0.001 to 10",
           absl::StrCat(JobSpec().water_tolerance)}};
}

absl::StatusOr<double> WaterToleranceFromFlags(const Args& args) { return args.Number("water-tolerance", 0.001, 10); }

FlagSpec OutputFlag() { return {"output", "FORMAT", "table or json", "table", 'o'}; }

FlagSpec TensionFlag() {
  return {"tension", "auto|X",
          "tautness of the thin-plate surface, 1/m^2, 0 to 1000; auto: chosen from the surface around each hole",
          "auto"};
}

FlagSpec GradationFlag() {
  return {"gradation", "X", "growth of the triangles inward, 1 to 10", absl::StrCat(JobSpec().gradation)};
}

FlagSpec SizeLimitFlag() {
  return {"size-limit", "X", "largest edge over the rim's mean edge, 1 to 1e6", absl::StrCat(JobSpec().size_limit)};
}

absl::StatusOr<std::optional<double>> TensionFromFlags(const Args& args) {
  if (args.Text("tension") == "auto") return std::nullopt;
  return args.Number("tension", 0, 1000);
}

absl::StatusOr<v1::JobSpec> SpecFromFlags(const Args& args) {
  JobSpec spec;
  spec.scene = AbsolutePath(args.arguments().front());
  spec.out = AbsolutePath(args.Text("out"));
  spec.surface = args.Text("surface");
  spec.uniform = args.Switch("uniform");
  TILEMEND_ASSIGN_OR_RETURN(spec.tension, TensionFromFlags(args));
  TILEMEND_ASSIGN_OR_RETURN(spec.gradation, args.Number("gradation", 1, 10));
  TILEMEND_ASSIGN_OR_RETURN(spec.size_limit, args.Number("size-limit", 1, 1e6));
  TILEMEND_ASSIGN_OR_RETURN(spec.seam_smoothing, args.Number("seam-smoothing", 0, 1));
  spec.water = args.Text("water");
  if (spec.water != kFindWater && spec.water != kNoWater) spec.water = AbsolutePath(spec.water);
  TILEMEND_ASSIGN_OR_RETURN(spec.water_tolerance, WaterToleranceFromFlags(args));
  spec.overwrite = args.Switch("overwrite");
  spec.dry_run = args.Switch("dry-run");
  if (spec.out.empty() && !spec.dry_run) return absl::InvalidArgumentError("--out DIR is needed");
  TILEMEND_RETURN_IF_ERROR(spec.Check());
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
