// Whether the material files and images of tiles are in an output as they were.
#ifndef TILEMEND_CLIENT_CARRIED_FILES_H_
#define TILEMEND_CLIENT_CARRIED_FILES_H_

#include <set>
#include <string>
#include <vector>

#include "common/records/tile_files.h"

namespace tilemend {

// Whether a material file `after` defines a material again that it had `before`: programs differ in which they take.
bool DefinesAgain(const std::string& before, const std::string& after);

// Remembers which files were compared.
class CarriedFiles {
 public:
  CarriedFiles(std::string in, std::string out) : in_(std::move(in)), out_(std::move(out)) {}

  // Compares the files of one more tile that were not compared yet: images byte by byte, material files as beginnings,
  // after which none of their materials is defined again. Files that cannot be read are missing. Linear.
  void Compare(const TileFiles& files);

  // The same of one file of the output, which should have these bytes.
  void Compare(const std::string& path, const std::string& bytes, bool is_library);

  const std::vector<std::string>& missing() const { return missing_; }
  const std::vector<std::string>& changed() const { return changed_; }
  size_t compared() const { return seen_.size(); }

 private:
  const std::string in_, out_;
  std::set<std::string> seen_;
  std::vector<std::string> missing_, changed_;
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_CARRIED_FILES_H_
