// Objects of a store, s3://BUCKET/KEY, in place of files. files.h and folders.h use it for such paths; a folder is the
// beginning of keys up to a slash, and there as long as a key begins so.
#ifndef TILEMEND_COMMON_UTIL_OBJECT_STORE_H_
#define TILEMEND_COMMON_UTIL_OBJECT_STORE_H_

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

struct ObjectLook {
  int64_t size = 0;  // bytes
  std::string etag;  // what the store names this content; another content has another
};

// One level below a folder.
struct ObjectEntry {
  std::string name;
  bool is_folder = false;
};

// Thread-safe. All paths are s3://BUCKET/KEY. Errors name the path and the reason: kNotFound (no such object or
// bucket), kPermissionDenied (OBJECT_STORE_REFUSED), kUnavailable (OBJECT_STORE_UNREACHABLE, after retries),
// kInvalidArgument (no such path, too large).
class ObjectStore {
 public:
  virtual ~ObjectStore() = default;
  virtual absl::StatusOr<ObjectLook> Look(const std::string& path) = 0;
  // The content as it is now, as a descriptor of a local file that has no name. The caller closes it.
  virtual absl::StatusOr<int> Open(const std::string& path) = 0;
  // At once or not at all, in place of what is there.
  virtual absl::Status Put(const std::string& path, std::string_view bytes) = 0;
  // Within the store; `look` is of `from`.
  virtual absl::Status Copy(const std::string& from, const ObjectLook& look, const std::string& to) = 0;
  // What is not there is no error.
  virtual absl::Status Remove(const std::string& path) = 0;
  // Sorted by name. kNotFound if no key begins so; for a whole bucket, if there is none.
  virtual absl::StatusOr<std::vector<ObjectEntry>> List(const std::string& folder) = 0;
};

bool IsObjectPath(std::string_view path);

// Whether `status` says that the store of `path` cannot be reached, or refuses. Then nobody knows what is there. False
// for files, and if the object is missing or its content is wrong.
bool IsStoreError(std::string_view path, const absl::Status& status);

// From now on paths of objects lead there. For the start of main, once.
void UseObjects(std::unique_ptr<ObjectStore> store);

// What UseObjects was told, if `path` is below the roots of the process (roots.h). kPermissionDenied, kUnimplemented.
absl::StatusOr<ObjectStore*> ObjectsFor(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_OBJECT_STORE_H_
