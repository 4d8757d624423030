// Colours of surfaces: 8 bits a channel, as images and viewers have them (sRGB).
#ifndef TILEMEND_COMMON_UTIL_COLOUR_H_
#define TILEMEND_COMMON_UTIL_COLOUR_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tilemend {

struct Rgb {
  uint8_t r = 0;
  uint8_t g = 0;
  uint8_t b = 0;
  bool operator==(const Rgb&) const = default;
};

// What ParseColour reads, for people.
inline constexpr char kColourForm[] = "R,G,B, each 0 to 255, or #rrggbb";

// "R,G,B" with 0 to 255 each, with or without blanks after the commas, or "#rrggbb"; nothing for any other text.
std::optional<Rgb> ParseColour(std::string_view text);

// "#rrggbb", in small letters.
std::string ColourText(Rgb colour);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_COLOUR_H_
