// Whether a surface repeats its image.
#ifndef TILEMEND_COMMON_UTIL_TEXTURE_WRAP_H_
#define TILEMEND_COMMON_UTIL_TEXTURE_WRAP_H_

#include <algorithm>
#include <array>
#include <span>

namespace tilemend {

// Whether texture coordinates go beyond the image by more than what exports round to. Then it is to be repeated, else
// its last pixels go on at its edge. O(n).
inline bool RepeatsImage(std::span<const std::array<float, 2>> uv) {
  constexpr float kRounding = 1e-3F;
  return std::any_of(uv.begin(), uv.end(), [](const std::array<float, 2>& at) {
    return std::min(at[0], at[1]) < -kRounding || std::max(at[0], at[1]) > 1 + kRounding;
  });
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_TEXTURE_WRAP_H_
