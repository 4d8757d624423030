#include "common/codec/gltf/gltf_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/gltf_samples.h"

namespace tilemend {
namespace {

using testing::HasSubstr;
using Json = OrderedJson;

// A document whose data is read.
class GltfDataTest : public testing::Test {
 protected:
  absl::StatusOr<GltfValues> Accessor(const GltfSample& sample, int64_t index) {
    bytes_ = sample.Glb();
    container_ = ParseGltfContainer(bytes_, "a.glb").value();
    data_ = std::make_unique<GltfData>(container_, JsonView(container_.json, name_));
    return data_->Accessor(index);
  }
  std::string Message(const GltfSample& sample, int64_t index) {
    return std::string(Accessor(sample, index).status().message());
  }

  const std::string name_ = "a.glb";
  std::string bytes_;
  GltfContainer container_;
  std::unique_ptr<GltfData> data_;
};

TEST_F(GltfDataTest, ReadsFloats) {
  const absl::StatusOr<GltfValues> values = Accessor(SquareSample(), 0);
  ASSERT_TRUE(values.ok()) << values.status();
  EXPECT_EQ(values->count, 4u);
  EXPECT_EQ(values->components, 3u);
  EXPECT_EQ(values->At(2, 0), 2);
  EXPECT_EQ(values->At(2, 1), 1);
  EXPECT_EQ(values->At(2, 2), -2);
}

TEST_F(GltfDataTest, ReadsIndices) {
  const absl::StatusOr<GltfValues> values = Accessor(SquareSample(), 2);
  ASSERT_TRUE(values.ok()) << values.status();
  EXPECT_EQ(values->IndexAt(4), 2u);
  EXPECT_EQ(values->IndexAt(5), 3u);
}

TEST_F(GltfDataTest, ReadsNormalizedIntegersAndStrides) {
  EXPECT_EQ(Accessor(QuantizedSample(), 0)->At(2, 2), -1000);
  EXPECT_EQ(Accessor(QuantizedSample(), 1)->At(1, 0), 1);
  EXPECT_EQ(Accessor(QuantizedSample(), 2)->IndexAt(5), 3u);
}

TEST_F(GltfDataTest, MapsSignedIntegersToPlusMinusOne) {
  const std::string bytes("\x80\x81\x7f\x00", 4);
  GltfValues values{
      .bytes = bytes, .stride = 1, .component_type = 5120, .normalized = true, .components = 1, .count = 4};
  EXPECT_EQ(values.At(0, 0), -1);
  EXPECT_EQ(values.At(1, 0), -1);
  EXPECT_EQ(values.At(2, 0), 1);
  EXPECT_EQ(values.At(3, 0), 0);
}

TEST_F(GltfDataTest, DecodesMeshoptimizerViews) {
  const GltfSample plain = GridSample();
  std::vector<double> numbers;
  for (int64_t accessor = 0; accessor < 2; ++accessor) {
    const GltfValues values = Accessor(plain, accessor).value();
    for (size_t i = 0; i < 25; ++i) numbers.push_back(values.At(i, 1));
  }
  const GltfSample compressed = MeshoptSample();
  for (int64_t accessor = 0; accessor < 2; ++accessor) {
    const GltfValues values = Accessor(compressed, accessor).value();
    for (size_t i = 0; i < 25; ++i) EXPECT_EQ(numbers[static_cast<size_t>(accessor) * 25 + i], values.At(i, 1));
  }
  EXPECT_EQ(Accessor(compressed, 2)->count, 96u);
}

// What meshoptimizer's decoders only assert.
TEST_F(GltfDataTest, RefusesMeshoptimizerViewsThatDoNotFit) {
  const auto with = [this](const char* key, const Json& value, int64_t accessor = 0) {
    GltfSample sample = MeshoptSample();
    const auto view = static_cast<size_t>(accessor) + 1;
    sample.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"][key] = value;
    return Message(sample, accessor);
  };
  EXPECT_THAT(with("byteStride", 10), HasSubstr("a stride of 10 bytes is not allowed"));
  EXPECT_THAT(with("byteStride", 0), HasSubstr("expected an integer"));
  EXPECT_THAT(with("byteStride", 3, 2), HasSubstr("a stride of 3 bytes is not allowed"));
  EXPECT_THAT(with("count", 95, 2), HasSubstr("no multiple of 3"));
  EXPECT_THAT(with("count", 1 << 30), HasSubstr("too many"));
  EXPECT_THAT(with("mode", "OTHER"), HasSubstr("unknown mode"));
  EXPECT_THAT(with("filter", "OCTAHEDRAL"), HasSubstr("the filter does not fit"));
  EXPECT_THAT(with("filter", "QUATERNION"), HasSubstr("the filter does not fit"));
  EXPECT_THAT(with("filter", "EXPONENTIAL", 2), HasSubstr("the filter does not fit"));
  EXPECT_THAT(with("count", 24), HasSubstr("25 elements of 12 bytes do not fit into a view of 288 bytes"));
  EXPECT_THAT(with("byteLength", 20), HasSubstr("the meshoptimizer stream is damaged"));
  EXPECT_EQ(with("filter", "EXPONENTIAL"), "");
}

TEST_F(GltfDataTest, RefusesWhatLiesOutside) {
  const auto with = [this](const char* path, const Json& value) {
    GltfSample sample = SquareSample();
    sample.json[Json::json_pointer(path)] = value;
    return Message(sample, 0);
  };
  EXPECT_THAT(with("/accessors/0/count", 5), HasSubstr("5 elements of 12 bytes do not fit into a view of 48 bytes"));
  EXPECT_THAT(with("/accessors/0/count", int64_t{1} << 39), HasSubstr("do not fit"));
  EXPECT_THAT(with("/accessors/0/byteOffset", 4), HasSubstr("do not fit"));
  EXPECT_THAT(with("/accessors/0/bufferView", 99), HasSubstr("JSON /bufferViews: no element 99"));
  EXPECT_THAT(with("/bufferViews/1/byteLength", 1000), HasSubstr("1000 bytes, but the buffer has"));
  EXPECT_THAT(with("/bufferViews/1/byteStride", 8), HasSubstr("do not fit"));
  EXPECT_THAT(with("/buffers/0/byteLength", 100000), HasSubstr("but the binary chunk has"));
  EXPECT_THAT(with("/buffers/0/uri", "../secret.bin"), HasSubstr("files and data URIs are not read"));
  EXPECT_THAT(with("/accessors/0/sparse", Json::object()), HasSubstr("sparse accessors are not read"));
  EXPECT_THAT(with("/accessors/0/type", "MAT4"), HasSubstr("numbers of this type are not read"));
  EXPECT_THAT(with("/accessors/0/componentType", 5124), HasSubstr("numbers of this type are not read"));
}

TEST_F(GltfDataTest, NamesTheStreamThatDracoRefuses) {
  GltfSample sample = DracoSample(true);
  ASSERT_FALSE(Accessor(sample, 0).ok());
  EXPECT_TRUE(data_->Draco(1).ok());
  const absl::Status status = data_->Draco(0).status();
  EXPECT_THAT(std::string(status.message()), HasSubstr("a.glb: JSON /: byte "));
  EXPECT_THAT(std::string(status.message()), HasSubstr("Draco stream: expected a mesh of version 2.2"));
}

}  // namespace
}  // namespace tilemend
