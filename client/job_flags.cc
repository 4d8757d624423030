#include "client/job_flags.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "coordinator/report/water_choice.h"

namespace tilemend {
namespace {

std::string AbsolutePath(const std::string& path) {
  if (path.find("://") != std::string::npos) return path.substr(0, path.find_last_not_of('/') + 1);
  if (path.empty()) return path;
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  if (error) return path;
  // "link/.." is the folder above the one that the link leads to.
  const bool goes_up = std::ranges::find(absolute, "..") != absolute.end();
  const std::filesystem::path real = goes_up ? std::filesystem::weakly_canonical(absolute, error) : absolute;
  if (error) return path;
  std::string normal = real.lexically_normal().string();
  while (normal.size() > 1 && normal.back() == '/') normal.pop_back();
  return normal;
}

// The spec with absolute paths: another process has another working directory.
void MakePathsAbsolute(v1::JobSpec& spec) {
  spec.set_scene(AbsolutePath(spec.scene()));
  spec.set_out(AbsolutePath(spec.out()));
  if (spec.water() != kFindWater && spec.water() != kNoWater) spec.set_water(AbsolutePath(spec.water()));
  spec.set_clear(AbsolutePath(spec.clear()));
  spec.set_decisions(AbsolutePath(spec.decisions()));
  spec.set_area(AbsolutePath(spec.area()));
}

}  // namespace

FlagSpec OutputFlag() { return {"output", "table|json", "format on stdout", "table", 'o'}; }

IsGiven GivenBy(const Args& args) {
  return [&args](const Option& option) { return args.IsGiven(FlagOf(option)); };
}

absl::StatusOr<v1::JobSpec> JobFromFlags(const Args& args) {
  TILEMEND_ASSIGN_OR_RETURN(v1::JobSpec spec, SpecFromFlags(args, kOfJobs));
  spec.set_scene(args.arguments().front());
  MakePathsAbsolute(spec);
  if (spec.out().empty() && !spec.dry_run()) return absl::InvalidArgumentError("--out DIR is needed");
  TILEMEND_RETURN_IF_ERROR(NamedAsFlag(CheckJob(spec, GivenBy(args))));
  return spec;
}

absl::StatusOr<std::optional<int32_t>> WholeNumberIfGiven(const Args& args, const char* flag, int low, int high) {
  if (!args.IsGiven(flag)) return std::nullopt;
  TILEMEND_ASSIGN_OR_RETURN(const int64_t number, args.Integer(flag, low, high));
  return static_cast<int32_t>(number);
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
