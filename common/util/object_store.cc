#include "common/util/object_store.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/roots.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

std::unique_ptr<ObjectStore>& UsedObjects() {
  static std::unique_ptr<ObjectStore> store;
  return store;
}

}  // namespace

bool IsObjectPath(std::string_view path) { return path.starts_with("s3://"); }

bool IsStoreError(std::string_view path, const absl::Status& status) {
  return IsObjectPath(path) && (absl::IsUnavailable(status) || absl::IsPermissionDenied(status));
}

void UseObjects(std::unique_ptr<ObjectStore> store) { UsedObjects() = std::move(store); }

absl::StatusOr<ObjectStore*> ObjectsFor(const std::string& path) {
  if (FilesRoots() != nullptr) TILEMEND_RETURN_IF_ERROR(FilesRoots()->Check(path));
  if (UsedObjects() != nullptr) return UsedObjects().get();
  return absl::UnimplementedError(absl::StrCat(path, ": this program reads no object store"));
}

}  // namespace tilemend
