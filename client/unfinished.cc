#include "client/unfinished.h"

#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"

namespace tilemend {

// A job that overwrites a complete output has its marker there, and leaves the report until its first tile.
bool IsUnfinished(const std::string& output) {
  const std::filesystem::path folder = output;
  std::error_code error;
  return std::filesystem::exists(folder / ".tilemend-job", error) &&
         !std::filesystem::exists(folder / "report.json", error);
}

absl::Status CheckFinished(const std::string& output) {
  if (!IsUnfinished(output)) return absl::OkStatus();
  return absl::NotFoundError(absl::StrCat(
      output, ": report.json is not there yet; the output is not complete. Run the same job again to complete it"));
}

}  // namespace tilemend
