// Images for tests, encoded in memory.
#ifndef TILEMEND_TESTS_SUPPORT_IMAGE_BUILDERS_H_
#define TILEMEND_TESTS_SUPPORT_IMAGE_BUILDERS_H_

#include <png.h>
#include <turbojpeg.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "common/util/colour.h"

namespace tilemend {

using PixelColour = std::function<Rgb(int32_t column, int32_t row)>;

inline std::vector<uint8_t> PixelsOf(int32_t width, int32_t height, const PixelColour& colour) {
  std::vector<uint8_t> pixels;
  for (int32_t row = 0; row < height; ++row) {
    for (int32_t column = 0; column < width; ++column) {
      const Rgb c = colour(column, row);
      pixels.insert(pixels.end(), {c.r, c.g, c.b});
    }
  }
  return pixels;
}

inline std::string PngImage(int32_t width, int32_t height, const PixelColour& colour) {
  const std::vector<uint8_t> pixels = PixelsOf(width, height, colour);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<uint32_t>(width);
  png.height = static_cast<uint32_t>(height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&png, nullptr, &size, 0, pixels.data(), 0, nullptr);
  std::string bytes(size, '\0');
  png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
  bytes.resize(size);
  return bytes;
}

// The same with 16 bits a sample, and nothing that says how light they are.
inline std::string WidePngImage(int32_t width, int32_t height, const PixelColour& colour) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto append = [](png_structp to, png_bytep data, size_t size) {
    static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<const char*>(data), size);
  };
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, info, static_cast<uint32_t>(width), static_cast<uint32_t>(height), 16, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  std::vector<uint8_t> wide;
  for (const uint8_t sample : PixelsOf(width, height, colour)) wide.insert(wide.end(), {sample, sample});
  for (int32_t row = 0; row < height; ++row) png_write_row(png, &wide[static_cast<size_t>(row) * 6 * width]);
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

// `flags`: of TurboJPEG, such as TJFLAG_PROGRESSIVE.
inline std::string JpegImage(int32_t width, int32_t height, const PixelColour& colour, int flags = 0) {
  const std::vector<uint8_t> pixels = PixelsOf(width, height, colour);
  const tjhandle encoder = tjInitCompress();
  unsigned char* out = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): the type that TurboJPEG asks for
  tjCompress2(encoder, pixels.data(), width, 0, height, TJPF_RGB, &out, &size, TJSAMP_444, 95, flags);
  std::string bytes(reinterpret_cast<const char*>(out), size);
  tjFree(out);
  tjDestroy(encoder);
  return bytes;
}

// A JPEG of inks (YCCK). As in Adobe's files, 255 is no ink: `colour` is what `black` = 255 leaves as it is.
inline std::string InkJpegImage(int32_t width, int32_t height, const PixelColour& colour, uint8_t black) {
  std::vector<uint8_t> pixels;
  for (int32_t row = 0; row < height; ++row) {
    for (int32_t column = 0; column < width; ++column) {
      const Rgb c = colour(column, row);
      pixels.insert(pixels.end(), {c.r, c.g, c.b, black});
    }
  }
  const tjhandle encoder = tjInitCompress();
  unsigned char* out = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): the type that TurboJPEG asks for
  tjCompress2(encoder, pixels.data(), width, 0, height, TJPF_CMYK, &out, &size, TJSAMP_444, 95, 0);
  std::string bytes(reinterpret_cast<const char*>(out), size);
  tjFree(out);
  tjDestroy(encoder);
  return bytes;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_IMAGE_BUILDERS_H_
