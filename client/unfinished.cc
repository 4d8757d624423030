#include "client/unfinished.h"

#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"

namespace tilemend {

namespace {

bool HasFile(const std::string& folder, const char* name) {
  std::error_code error;
  return std::filesystem::exists(std::filesystem::path(folder) / name, error);
}

}  // namespace

// A job that overwrites a complete output has its marker there, and leaves the report until its first tile.
bool IsUnfinished(const std::string& output) {
  return (HasFile(output, ".tilemend-job") || IsOutput(output)) && !HasFile(output, "report.json");
}

bool IsOutput(const std::string& folder) { return HasFile(folder, ".tilemend-results"); }

absl::Status CheckFinished(const std::string& output) {
  if (!IsUnfinished(output)) return absl::OkStatus();
  return absl::NotFoundError(absl::StrCat(
      output, ": report.json is not there yet; the output is not complete. Run the same job again to complete it"));
}

absl::Status CheckIsOutput(const std::string& scene, const std::string& output) {
  if (HasFile(output, "report.json")) return absl::OkStatus();
  return absl::NotFoundError(absl::StrCat(output, ": is no output of tilemend: it has no report.json",
                                          HasFile(scene, "report.json") ? "; are SCENE and OUT swapped?" : ""));
}

}  // namespace tilemend
