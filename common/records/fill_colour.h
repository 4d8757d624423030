// The colours of filled faces.
#ifndef TILEMEND_COMMON_RECORDS_FILL_COLOUR_H_
#define TILEMEND_COMMON_RECORDS_FILL_COLOUR_H_

#include <cstdint>
#include <map>
#include <string>

#include "common/util/colour.h"

namespace tilemend {

// The colour of a hole, which it shares with the other holes of its group: a body of water, or a cluster.
struct FillColour {
  int32_t group = 0;  // the lowest of its holes
  Rgb colour;
  bool known = false;  // seen along the rim, or chosen by the user; else what stands for "not known"
  bool is_water = false;
};

// How materials of filled faces are called, in every tile. The colour is part of the name. So if an output is filled
// once more, its materials do not get in the way of the new ones.
inline std::string MaterialName(const FillColour& colour) {
  return "tilemend_fill_" + std::to_string(colour.group) + "_" + ColourText(colour.colour).substr(1);
}

struct FillColours {
  std::map<int32_t, FillColour> of_holes;  // by the hole's number in the plan
  bool on_vertices = false;                // the scene has colours that are known: vertices get them, too
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_FILL_COLOUR_H_
