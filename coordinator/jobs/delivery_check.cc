#include "coordinator/jobs/delivery_check.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/checked_files.h"
#include "coordinator/jobs/wrong_result.h"

namespace tilemend {

bool IsOfDelivery(std::string_view output, std::string_view path) {
  constexpr std::string_view kEndings[] = {"json", "glb", "osgb", "obj", "mtl", "ply", "jpg", "png", "webp", "ktx2"};
  if (path == output) return true;
  const std::string_view stem = output.substr(0, output.rfind('.'));
  if (!path.starts_with(stem)) return false;
  const std::string_view rest = path.substr(stem.size());
  const size_t dot = rest.rfind('.');
  if (dot == std::string_view::npos || (dot > 0 && rest[0] != '_')) return false;
  if (rest.find('/') != std::string_view::npos) return false;
  return std::find(std::begin(kEndings), std::end(kEndings), rest.substr(dot + 1)) != std::end(kEndings);
}

absl::Status CheckDelivery(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileCheck how) {
  if (output.files_size() == 0 || output.files(0).path() != input.output()) return Wrong("another tile");
  std::set<std::string> paths;
  for (const v1::WrittenFile& file : output.files()) {
    if (!IsOfDelivery(input.output(), file.path()) || !paths.insert(file.path()).second) {
      return Wrong("a file that is not asked for");
    }
    if (!IsFileDigest(file.digest())) return Wrong("a digest that is none");
    if (how != TileCheck::kContent) continue;
    TILEMEND_RETURN_IF_ERROR(CheckFile(absl::StrCat(input.attempts(), "/", file.attempt()), file.digest(),
                                       Wrong("a file that is not as it was written")));
  }
  return absl::OkStatus();
}

}  // namespace tilemend
