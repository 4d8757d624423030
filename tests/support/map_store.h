// An object store in memory.
#ifndef TILEMEND_TESTS_SUPPORT_MAP_STORE_H_
#define TILEMEND_TESTS_SUPPORT_MAP_STORE_H_

#include <stdlib.h>
#include <unistd.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/util/object_store.h"

namespace tilemend {

class MapStore : public ObjectStore {
 public:
  absl::StatusOr<ObjectLook> Look(const std::string& path) override {
    if (unreachable) return absl::UnavailableError(path + ": unreachable");
    const auto found = objects.find(path);
    if (found == objects.end()) return absl::NotFoundError(path + ": no such object");
    return ObjectLook{static_cast<int64_t>(found->second.size()), "etag of " + found->second};
  }
  absl::StatusOr<int> Open(const std::string& path) override {
    if (const auto look = Look(path); !look.ok()) return look.status();
    std::string name = "/tmp/map-store-XXXXXX";
    const int file = ::mkstemp(name.data());
    ::unlink(name.c_str());
    const std::string& bytes = objects[path];
    return ::write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size())
               ? absl::StatusOr<int>(file)
               : absl::InternalError("no room");
  }
  absl::Status Put(const std::string& path, std::string_view bytes) override {
    objects[path] = std::string(bytes);
    return absl::OkStatus();
  }
  absl::Status Copy(const std::string& from, const ObjectLook&, const std::string& to) override {
    ++copies;
    objects[to] = objects[from];
    return absl::OkStatus();
  }
  absl::Status Remove(const std::string& path) override {
    objects.erase(path);
    return absl::OkStatus();
  }
  absl::StatusOr<std::vector<ObjectEntry>> List(const std::string& folder) override {
    if (unreachable) return absl::UnavailableError(folder + ": unreachable");
    std::map<std::string, bool> found;
    for (const auto& [path, bytes] : objects) {
      if (!path.starts_with(folder + "/")) continue;
      const std::string below = path.substr(folder.size() + 1);
      found[below.substr(0, below.find('/'))] = below.find('/') != std::string::npos;
    }
    if (found.empty()) return absl::NotFoundError(folder + ": nothing there");
    std::vector<ObjectEntry> entries;
    for (const auto& [name, is_folder] : found) entries.push_back({name, is_folder});
    return entries;
  }

  std::map<std::string, std::string> objects;  // by path
  int copies = 0;
  bool unreachable = false;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_MAP_STORE_H_
