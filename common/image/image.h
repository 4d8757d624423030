// Images that lie on surfaces: JPEG and PNG, decoded to be looked at in a few places.
#ifndef TILEMEND_COMMON_IMAGE_IMAGE_H_
#define TILEMEND_COMMON_IMAGE_IMAGE_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/util/colour.h"

namespace tilemend {

struct Image {
  int32_t width = 0;
  int32_t height = 0;
  int32_t channels = 3;         // bytes a pixel: red, green, blue and what else there may be
  std::vector<uint8_t> pixels;  // by rows from the top
};

// Large JPEGs are decoded at a half, a quarter or an eighth of their size.
enum class JpegSize {
  kSmall,  // if a side has more than kFullSide pixels
  kLarge,  // if the image has more than kFullPixels pixels; one of several scans (progressive) as kSmall
};
inline constexpr int32_t kFullSide = 4096;
inline constexpr int64_t kFullPixels = int64_t{1} << 26;

// Decodes a JPEG or PNG image, told by its first bytes. Inks (CMYK) are mixed without a colour profile. Returns
// kInvalidArgument "NAME: ..." for any other format, and for an image that is cut off or damaged. Bytes between the
// markers of a JPEG that belong to none are no damage. The same error if it claims more pixels than its bytes can hold
// or than can be decoded. The latter are 2^28 in a JPEG that is stored in one scan, else 2^26. Memory: the pixels that
// are returned; of a progressive JPEG also its coefficients, 2 bytes a sample. Any thread.
absl::StatusOr<Image> DecodeImage(std::string_view bytes, const std::string& name, JpegSize jpegs = JpegSize::kSmall);

// A baseline JPEG of the image's red, green and blue, 4:4:4, of `quality` 1 to 100. It has the same bytes for the same
// pixels. Returns kResourceExhausted if there is no memory for it. Precondition: the image has pixels, 65535 along a
// side at most.
absl::StatusOr<std::string> EncodeJpeg(const Image& image, int quality);

// The pixel at the texture coordinates (u to the right, v upward, the image repeated outside [0, 1)). Precondition: the
// image has pixels, u and v are finite.
Rgb TexelAt(const Image& image, double u, double v);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_IMAGE_IMAGE_H_
