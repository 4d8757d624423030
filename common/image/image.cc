#include "common/image/image.h"

#include <png.h>
#include <turbojpeg.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr int64_t kMostPixels = int64_t{1} << 28;
constexpr int64_t kMostBufferedPixels = int64_t{1} << 26;
// A block of 8 x 8 pixels takes at least a bit of a JPEG, and deflate makes at most 1032 bytes of one.
constexpr int64_t kMostJpegPixelsPerByte = 512;
// Each scan goes over all blocks of the image, even if it says nothing of them. Programs write about ten.
constexpr int kMostScans = 100;
constexpr int64_t kMostPngPixelsPerByte = 8 * 1032;

absl::Status Problem(const std::string& name, std::string_view what) {
  return absl::InvalidArgumentError(absl::StrCat(name, ": ", std::string(what)));
}

absl::Status CheckSize(int64_t width, int64_t height, int64_t most, int64_t bytes, int64_t per_byte,
                       const std::string& name) {
  if (width < 1 || height < 1) return Problem(name, "an image without pixels");
  if (width * height > most)
    return Problem(name, absl::StrCat("an image of ", width, " x ", height, " pixels is too large"));
  if (width * height / per_byte <= bytes) return absl::OkStatus();
  return Problem(name, absl::StrCat("an image of ", width, " x ", height, " pixels does not fit in ", bytes, " bytes"));
}

uint8_t ByteAt(std::string_view bytes, size_t at) { return static_cast<uint8_t>(bytes[at]); }

// The next marker at `at` or behind it, as its place; the size if there is none. Entropy-coded data has 0xff only
// before 0 and restart markers; padding is 0xff.
size_t NextMarker(std::string_view bytes, size_t at) {
  constexpr uint8_t kTemporary = 0x01, kFirstRestart = 0xd0, kImageStart = 0xd8;
  const size_t end = std::max<size_t>(bytes.size(), 1) - 1;  // npos is beyond it
  for (at = bytes.find('\xff', at); at < end; at = bytes.find('\xff', at + 1)) {
    const uint8_t next = ByteAt(bytes, at + 1);
    const bool is_alone = next <= kTemporary || (next >= kFirstRestart && next <= kImageStart);
    if (!is_alone && next != 0xff) return at;
  }
  return bytes.size();
}

// The scans of a JPEG, without decoding them.
struct JpegScans {
  int count = 0;
  // All components are in one sequential scan: it is decoded row by row, else the decoder keeps the coefficients of the
  // whole image.
  bool is_one = false;
  bool has_end = false;  // the marker of the end is there
};

// Cost O(bytes).
JpegScans ScansOf(std::string_view bytes) {
  constexpr uint8_t kBaseline = 0xc0, kExtended = 0xc1, kImageEnd = 0xd9, kScan = 0xda;
  constexpr size_t kComponentsAt = 9;  // of a frame header, from its marker
  JpegScans scans;
  int components = -1;
  for (size_t at = NextMarker(bytes, 2); at < bytes.size();) {
    const uint8_t marker = ByteAt(bytes, at + 1);
    scans.has_end = marker == kImageEnd;
    if (scans.has_end || at + 4 >= bytes.size()) break;
    if ((marker == kBaseline || marker == kExtended) && at + kComponentsAt < bytes.size()) {
      components = ByteAt(bytes, at + kComponentsAt);
    }
    if (marker == kScan && ++scans.count == 1) scans.is_one = ByteAt(bytes, at + 4) == components;
    const size_t length = static_cast<size_t>(ByteAt(bytes, at + 2)) << 8 | ByteAt(bytes, at + 3);
    at = NextMarker(bytes, at + 2 + length);
  }
  return scans;
}

// Whether the decoder's last message is about bytes that it leaves out, and not about the pixels. It keeps only the
// first warning, and an error after that.
bool IsHarmless(std::string_view message) {
  constexpr std::string_view kHarmless[] = {"extraneous bytes before marker", "Unknown Adobe color transform code",
                                            "Invalid SOS parameters for sequential JPEG"};
  return std::any_of(std::begin(kHarmless), std::end(kHarmless),
                     [&](std::string_view text) { return message.find(text) != std::string_view::npos; });
}

// Turns cyan, magenta, yellow and black into red, green and blue; the fourth channel stays. Files have 255 for no ink,
// as Adobe's programs write them; browsers and Pillow take them so, too.
void MixInks(Image& image) {
  for (size_t at = 0; at + 3 < image.pixels.size(); at += 4) {
    const int black = image.pixels[at + 3];
    for (size_t c = 0; c < 3; ++c) {
      image.pixels[at + c] = static_cast<uint8_t>((image.pixels[at + c] * black + 127) / 255);
    }
  }
}

absl::StatusOr<Image> DecodeJpeg(std::string_view bytes, const std::string& name, JpegSize largest) {
  const std::unique_ptr<void, int (*)(tjhandle)> decoder(tjInitDecompress(), tjDestroy);
  if (decoder == nullptr) return absl::ResourceExhaustedError("no memory to decode an image");
  const JpegScans scans = ScansOf(bytes);
  const auto check = [&](int result) {
    if (result == 0) return absl::OkStatus();
    const bool is_warning = tjGetErrorCode(decoder.get()) == TJERR_WARNING;
    const std::string message = tjGetErrorStr2(decoder.get());
    if (is_warning && scans.has_end && IsHarmless(message)) return absl::OkStatus();
    return Problem(name, absl::StrCat("a damaged JPEG image: ", message));
  };
  const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0, height = 0, subsampling = 0, space = 0;
  TILEMEND_RETURN_IF_ERROR(
      check(tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height, &subsampling, &space)));
  if (scans.count > kMostScans) {
    return Problem(name, absl::StrCat("a JPEG image of ", scans.count, " scans; at most ", kMostScans, " are read"));
  }
  const absl::Status size = CheckSize(width, height, scans.is_one ? kMostPixels : kMostBufferedPixels,
                                      static_cast<int64_t>(bytes.size()), kMostJpegPixelsPerByte, name);
  if (!size.ok()) return size;
  const bool has_inks = space == TJCS_CMYK || space == TJCS_YCCK;
  const bool is_large = largest == JpegSize::kLarge && scans.is_one;
  tjscalingfactor scale{1, 1};
  const auto is_too_large = [&] {
    const int64_t columns = TJSCALED(width, scale), rows = TJSCALED(height, scale);
    return is_large ? columns * rows > kFullPixels : std::max(columns, rows) > kFullSide;
  };
  while (scale.denom < 8 && is_too_large()) scale.denom *= 2;
  Image image{TJSCALED(width, scale), TJSCALED(height, scale), has_inks ? 4 : 3, {}};
  image.pixels.resize(static_cast<size_t>(image.channels) * static_cast<size_t>(image.width) *
                      static_cast<size_t>(image.height));
  TILEMEND_RETURN_IF_ERROR(check(tjDecompress2(decoder.get(), data, bytes.size(), image.pixels.data(), image.width, 0,
                                               image.height, has_inks ? TJPF_CMYK : TJPF_RGB, TJFLAG_LIMITSCANS)));
  if (has_inks) MixInks(image);
  return image;
}

absl::StatusOr<Image> DecodePng(std::string_view bytes, const std::string& name) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> release(&png, png_image_free);
  const auto problem = [&] { return Problem(name, absl::StrCat("a damaged PNG image: ", png.message)); };
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return problem();
  const absl::Status size = CheckSize(png.width, png.height, kMostBufferedPixels, static_cast<int64_t>(bytes.size()),
                                      kMostPngPixelsPerByte, name);
  if (!size.ok()) return size;
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16 bits a sample are no linear light unless the image says so
  png.format = PNG_FORMAT_RGBA;            // not RGB: that would mix a background into colours
  Image image{static_cast<int32_t>(png.width), static_cast<int32_t>(png.height), 4, {}};
  image.pixels.resize(PNG_IMAGE_SIZE(png));
  if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0) return problem();
  return image;
}

// The pixel of `count` that holds the texture coordinate `t` in [0, 1).
int64_t PixelAt(double t, int32_t count) {
  const double fraction = t - std::floor(t);
  return std::min<int64_t>(static_cast<int64_t>(fraction * count), count - 1);
}

}  // namespace

absl::StatusOr<Image> DecodeImage(std::string_view bytes, const std::string& name, JpegSize jpegs) {
  if (bytes.empty()) return Problem(name, "an empty file, no image");
  if (bytes.substr(0, 2) == "\xff\xd8") return DecodeJpeg(bytes, name, jpegs);
  if (bytes.substr(0, 4) == "\x89PNG") return DecodePng(bytes, name);
  return Problem(name, "neither a JPEG nor a PNG image");
}

absl::StatusOr<std::string> EncodeJpeg(const Image& image, int quality) {
  const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), tjDestroy);
  if (encoder == nullptr) return absl::ResourceExhaustedError("no memory to encode an image");
  unsigned char* data = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): the type that the library wants
  const int format = image.channels == 4 ? TJPF_RGBX : TJPF_RGB;
  const int problem = tjCompress2(encoder.get(), image.pixels.data(), image.width, 0, image.height, format, &data,
                                  &size, TJSAMP_444, quality, TJFLAG_ACCURATEDCT);
  const std::unique_ptr<unsigned char, void (*)(unsigned char*)> release(data, tjFree);
  if (problem == 0) return std::string(reinterpret_cast<const char*>(data), size);
  return absl::ResourceExhaustedError(absl::StrCat("cannot encode an image: ", tjGetErrorStr2(encoder.get())));
}

Rgb TexelAt(const Image& image, double u, double v) {
  const int64_t column = PixelAt(u, image.width);
  const int64_t row = image.height - 1 - PixelAt(v, image.height);
  const uint8_t* const pixel = &image.pixels[static_cast<size_t>((row * image.width + column) * image.channels)];
  return {pixel[0], pixel[1], pixel[2]};
}

}  // namespace tilemend
