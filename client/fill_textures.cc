#include "client/fill_textures.h"

#include <algorithm>
#include <cstdint>

#include "absl/strings/str_cat.h"
#include "common/image/image.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

bool IsKnown(const ComparedTile& pair, const std::string& image) {
  return std::ranges::find(pair.before.files.images, image) != pair.before.files.images.end() ||
         std::ranges::any_of(pair.beside, [&](const DeliveryFile& file) { return file.name == image; });
}

std::string ProblemOf(const std::string& out, const std::string& image) {
  const auto bytes = ReadFile(absl::StrCat(out, "/", image));
  if (!bytes.ok()) return std::string(bytes.status().message());
  return std::string(DecodeImage(*bytes, image).status().message());
}

}  // namespace

std::vector<std::string> FillTextureFaults(const std::string& out, const std::string& path, const ComparedTile& pair,
                                           const std::vector<bool>& added) {
  const CheckedTile& after = *pair.after;
  std::vector<std::string> faults;
  for (const std::string& material : after.undefined) {
    if (!pair.before.undefined.contains(material)) {
      faults.push_back(absl::StrCat(path, ": material ", material, " is not defined"));
    }
  }
  for (const std::string& image : after.files.images) {
    if (IsKnown(pair, image)) continue;
    if (const std::string problem = ProblemOf(out, image); !problem.empty()) {
      faults.push_back(absl::StrCat(path, ": ", problem));
    }
  }
  int64_t off = 0;
  for (size_t t = 0; t < after.off_image.size(); ++t) off += added[t] && after.off_image[t] ? 1 : 0;
  if (off > 0)
    faults.push_back(absl::StrCat(path, ": texture coordinates of ", off, " new triangles are off the image"));
  return faults;
}

}  // namespace tilemend
