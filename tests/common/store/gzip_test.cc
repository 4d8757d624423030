#include "common/store/gzip.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

namespace tilemend {
namespace {

TEST(GzipTest, GivesBackItsBytes) {
  const std::string text(100000, 'a');
  const auto zipped = Gzip(text);
  ASSERT_TRUE(zipped.ok());
  EXPECT_LT(zipped->size(), 1000U);
  EXPECT_EQ(*zipped, *Gzip(text));
  std::string back(text.size() + 1, '\0');
  z_stream stream{};
  ASSERT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
  std::string in = *zipped;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(back.data());
  stream.avail_out = static_cast<uInt>(back.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  back.resize(stream.total_out);
  inflateEnd(&stream);
  EXPECT_EQ(back, text);
}

}  // namespace
}  // namespace tilemend
