#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/codec/osgb/osgb_checks.h"
#include "tests/support/osgb_builder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using Body = OsgbBuilder::Body;

// A geode with geometries that have these state sets.
std::string SceneWith(OsgbBuilder& builder, const std::vector<Body>& state_sets) {
  return builder.Scene([&] {
    std::vector<Body> geometries;
    for (const Body& state_set : state_sets)
      geometries.emplace_back([&builder, state_set] { builder.Geometry({}, state_set); });
    builder.Geode(geometries);
  });
}

class OsgbStateTest : public ::testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Versions, OsgbStateTest, ::testing::Values(80u, 95u, 130u, 151u, 154u, 161u));

TEST_P(OsgbStateTest, SharesImagesTexturesAndStateSets) {
  OsgbBuilder builder(GetParam());
  uint32_t image = 0;
  uint32_t texture = 0;
  uint32_t state_set = 0;
  const absl::StatusOr<OsgbFile> file = ReadOsgb(
      SceneWith(builder,
                {[&] {
                   state_set = builder.StateSet(
                       {}, [&] { texture = builder.Texture([&] { image = builder.Image("shared.jpg", "jpeg"); }); });
                 },
                 [&] { builder.StateSet({}, [&] { builder.Texture([&] { builder.Image("other.jpg", "jpeg"); }); }); },
                 [&] { builder.StateSet({}, [&] { builder.Texture([&] { builder.ImageReference(image); }); }); },
                 [&] { builder.StateSet({}, [&] { builder.Reference("osg::Texture2D", texture); }); },
                 [&] { builder.Reference("osg::StateSet", state_set); }}),
      "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_EQ(file->images.size(), 2u);
  const int32_t expected[] = {0, 1, 0, 0, 0};
  for (size_t i = 0; i < 5; ++i) EXPECT_EQ(file->geometries[i].texture, expected[i]) << i;
}

TEST_P(OsgbStateTest, TellsHowImagesAreStored) {
  OsgbBuilder builder(GetParam());
  std::vector<Body> state_sets;
  for (const uint32_t storage : {0u, 1u, 2u, 3u}) {
    state_sets.emplace_back([&builder, storage] {
      builder.StateSet({}, [&] { builder.Texture([&] { builder.Image("a.png", "bytes", storage); }); });
    });
  }
  const std::string bytes = SceneWith(builder, state_sets);
  const absl::StatusOr<OsgbFile> file = ReadOsgb(bytes, "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_EQ(file->images.size(), 4u);
  EXPECT_EQ(file->images[0].storage, OsgbImage::Storage::kPixels);
  EXPECT_EQ(file->images[1].storage, OsgbImage::Storage::kEncoded);
  EXPECT_EQ(file->images[2].storage, OsgbImage::Storage::kExternal);
  EXPECT_EQ(file->images[3].storage, OsgbImage::Storage::kExternal);
  EXPECT_EQ(bytes.substr(file->images[0].offset, file->images[0].size), "bytes");
  EXPECT_EQ(bytes.substr(file->images[1].offset, file->images[1].size), "bytes");
  EXPECT_EQ(file->images[3].size, 0u);
}

TEST(OsgbStateSetTest, RefusesAnotherStorageOfAnImage) {
  OsgbBuilder builder;
  EXPECT_THAT(
      OsgbRefusal(SceneWith(
          builder, {[&] { builder.StateSet({}, [&] { builder.Texture([&] { builder.Image("a", "", 4); }); }); }})),
      HasSubstr("expected 0 to 3 as the storage of an image"));
}

TEST(OsgbStateSetTest, OnlyTextureUnit0Counts) {
  OsgbBuilder builder;
  const absl::StatusOr<OsgbFile> file =
      ReadOsgb(SceneWith(builder, {[&] {
                           builder.StateSet(
                               {}, [&] { builder.Texture([&] { builder.Image("a.jpg", "a"); }); }, 1);
                         }}),
               "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->images.size(), 1u);
  EXPECT_EQ(file->geometries[0].texture, -1);
}

TEST(OsgbStateSetTest, GeometriesInheritTheTextureOfTheNodesAbove) {
  for (const uint32_t version : {80u, 161u}) {
    OsgbBuilder builder(version);
    BuiltGeometry plain;
    plain.image.clear();
    const absl::StatusOr<OsgbFile> file = ReadOsgb(builder.Scene([&] {
      builder.Node("osg::Group", {[&] {
                     builder.Geode({[&] { builder.Geometry(plain); }, [&] { builder.Geometry({}); }});
                   }},
                   [&] { builder.StateSet(BuiltGeometry()); });
    }),
                                                   "a.osgb");
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_EQ(file->geometries[0].texture, 0);
    EXPECT_EQ(file->geometries[1].texture, 1);
  }
}

TEST(OsgbStateSetTest, ReadsTheAttributesThatExportersWrite) {
  for (const uint32_t version : {80u, 161u}) {
    OsgbBuilder builder(version);
    const auto attribute = [&](const char* class_name, size_t zeros) {
      return [&builder, class_name, zeros] {
        builder.StateSet([&] { builder.Object(class_name, [&] { builder.Zeros(2 + zeros); }); }, {});
      };
    };
    EXPECT_EQ(OsgbRefusal(SceneWith(builder, {attribute("osg::ShadeModel", 4), attribute("osg::CullFace", 4),
                                              attribute("osg::TexEnv", 20), attribute("osg::BlendFunc", 16),
                                              attribute("osg::LightModel", 22), attribute("osg::Material", 9)})),
              "");
    OsgbBuilder other(version);
    EXPECT_THAT(OsgbRefusal(SceneWith(
                    other, {[&] { other.StateSet([&] { other.Object("osg::Fog", [&] { other.Zeros(2); }); }, {}); }})),
                HasSubstr("an object of class osg::Fog is not supported here"));
  }
}

// A state set whose fields behind the textures `end` writes.
std::string SceneWithEnd(OsgbBuilder& builder, const Body& end) {
  return SceneWith(builder, {[&] {
                     builder.Object("osg::StateSet", [&] {
                       builder.Zeros(4);
                       end();
                     });
                   }});
}

TEST(OsgbStateSetTest, ReadsDefinesAndRefusesUniforms) {
  OsgbBuilder defines(161);
  EXPECT_EQ(OsgbRefusal(SceneWithEnd(defines,
                                     [&] {
                                       defines.Zeros(1 + 16 + 1 + 2);
                                       defines.List({[&] {
                                         defines.String("NAME");
                                         defines.String("1");
                                         defines.U32(1);
                                       }});
                                     })),
            "");
  OsgbBuilder uniforms;
  EXPECT_THAT(OsgbRefusal(SceneWithEnd(uniforms, [&] { uniforms.Flag(true); })),
              HasSubstr("uniforms are not supported"));
}

TEST(OsgbStateSetTest, RefusesAnotherClassInItsPlace) {
  OsgbBuilder builder;
  EXPECT_THAT(OsgbRefusal(SceneWith(builder, {[&] { builder.Object("osg::Program", [] {}); }})),
              HasSubstr("an object of class osg::Program is not supported here"));
}

}  // namespace
}  // namespace tilemend
