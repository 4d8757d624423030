// Several files as one string, for a tile that consists of a tree of files.
#ifndef TILEMEND_COMMON_UTIL_FILE_PACK_H_
#define TILEMEND_COMMON_UTIL_FILE_PACK_H_

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace tilemend {

// A file of a pack. `bytes` points into what it was unpacked from.
struct PackedFile {
  std::string name;
  std::string_view bytes;
};

// The files one after the other, each with its name and size. Linear.
std::string PackFiles(const std::vector<PackedFile>& files);

// Whether `bytes` begin as a pack does. No mesh file begins so.
bool IsFilePack(std::string_view bytes);

// The files of a pack, which has to outlive them. kInvalidArgument with `name` for what PackFiles did not make. Linear
// in the number of files.
absl::StatusOr<std::vector<PackedFile>> UnpackFiles(std::string_view bytes, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_FILE_PACK_H_
