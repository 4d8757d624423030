#include "worker/materials/write_materials.h"

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {

absl::StatusOr<std::string> MaterialsAfter(const std::string& from, const std::vector<FillMaterial>& materials,
                                           const std::string& digest) {
  std::string text;
  if (!from.empty()) {
    TILEMEND_ASSIGN_OR_RETURN(text, ReadFile(from));
    if (!digest.empty() && !HasFileDigest(text, digest)) return ChangedInJob(from);
  }
  return AppendToMtl(text, materials);
}

absl::Status WriteMaterials(const std::string& from, const std::string& to,
                            const std::vector<FillMaterial>& materials) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, MaterialsAfter(from, materials));
  return WriteFileAtomically(to, text);
}

absl::StatusOr<std::vector<std::string>> CarryFiles(const std::string& root, const std::string& output,
                                                    const std::vector<std::string>& files, bool link_images) {
  return CarryFiles(root, files, link_images, [&](const std::string& from, const std::string& path, Carry how) {
    return CarryFile(from, absl::StrCat(output, "/", path), how);
  });
}

absl::StatusOr<std::vector<std::string>> CarryFiles(const std::string& root, const std::vector<std::string>& files,
                                                    bool link_images, const CarryOne& carry) {
  std::vector<std::string> warnings;
  for (const std::string& file : files) {
    const Carry how = link_images && !absl::EndsWithIgnoreCase(file, ".mtl") ? Carry::kLink : Carry::kCopy;
    const absl::Status status = carry(absl::StrCat(root, "/", file), file, how);
    if (absl::IsResourceExhausted(status) || absl::IsUnavailable(status) || absl::IsAborted(status)) return status;
    if (!status.ok())
      warnings.push_back(absl::StrCat(Printable(std::string(status.message())), ": it is not in the output"));
  }
  return warnings;
}

}  // namespace tilemend
