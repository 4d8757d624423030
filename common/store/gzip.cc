#include "common/store/gzip.h"

#include <zlib.h>

namespace tilemend {

absl::StatusOr<std::string> Gzip(std::string_view bytes) {
  z_stream stream{};
  constexpr int kLevel = 6;             // 9 takes 4 to 5 times as long for 0.1 % less
  constexpr int kGzipWindow = 15 + 16;  // zlib's way to ask for a gzip header, which has no time in it
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, kGzipWindow, 9, Z_DEFAULT_STRATEGY) != Z_OK) {
    return absl::ResourceExhaustedError("no memory to compress it");
  }
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int end = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (end != Z_STREAM_END) return absl::ResourceExhaustedError("no memory to compress it");
  return out;
}

}  // namespace tilemend
