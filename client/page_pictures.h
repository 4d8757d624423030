// Pictures of the largest fills of an output, before and after.
#ifndef TILEMEND_CLIENT_PAGE_PICTURES_H_
#define TILEMEND_CLIENT_PAGE_PICTURES_H_

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/grid/scene.h"

namespace tilemend {

inline constexpr size_t kMostPictures = 20;

struct PagePicture {
  int64_t hole = 0;       // its id in the report
  int64_t triangles = 0;  // in the picture
  bool coarser = false;   // small triangles were left out
  std::string bytes;      // CropBytes, as gzip
};

struct PagePictures {
  std::vector<PagePicture> pictures;  // the largest fill first
  std::vector<std::string> problems;  // tiles that could not be read
};

// The largest fills of the report: at most kMostPictures, none below half a square metre; of a cluster the largest fill
// in each of up to three cells. The output `out` was made from `scene`. Reads the tiles of these fills, one after
// another. Cost: linear in these tiles.
PagePictures MakePagePictures(const nlohmann::ordered_json& report, const Scene& scene, const std::string& out);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_PAGE_PICTURES_H_
