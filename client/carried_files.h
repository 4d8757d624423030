// Whether the material files and images of tiles are in an output as they were.
#ifndef TILEMEND_CLIENT_CARRIED_FILES_H_
#define TILEMEND_CLIENT_CARRIED_FILES_H_

#include <set>
#include <string>
#include <vector>

#include "common/records/tile_files.h"

namespace tilemend {

enum class CarriedState { kSame, kMissing, kChanged };

// Whether `out` has the bytes of `in`: all of them, and no more unless `may_be_longer`. Unreadable files are missing.
// Memory and time linear in the files.
CarriedState CompareFiles(const std::string& in, const std::string& out, bool may_be_longer);

// Whether a material file `after` defines a material again that it had `before`: programs differ in which they take.
bool DefinesAgain(const std::string& before, const std::string& after);

// Remembers which files were compared.
class CarriedFiles {
 public:
  CarriedFiles(std::string in, std::string out) : in_(std::move(in)), out_(std::move(out)) {}

  // Compares the files of one more tile that were not compared yet: images byte by byte, material files as beginnings,
  // after which none of their materials is defined again.
  void Compare(const TileFiles& files);

  const std::vector<std::string>& missing() const { return missing_; }
  const std::vector<std::string>& changed() const { return changed_; }
  size_t compared() const { return seen_.size(); }

 private:
  void CompareOne(const std::string& path, bool is_library);

  const std::string in_, out_;
  std::set<std::string> seen_;
  std::vector<std::string> missing_, changed_;
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_CARRIED_FILES_H_
