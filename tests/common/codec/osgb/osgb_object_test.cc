#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/codec/osgb/osgb_checks.h"
#include "tests/support/osgb_builder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

// A geode whose fields of osg::Object and osg::Node are written by `fields`.
std::string GeodeWith(OsgbBuilder& builder, const std::function<void()>& object, const std::function<void()>& node) {
  return builder.Scene([&] {
    builder.String("osg::Geode");
    builder.Bracket([&] {
      builder.U32(builder.next_id++);
      object();
      node();
      builder.Flag(false);  // no drawables
    });
  });
}

TEST(OsgbObjectTest, ReadsNamesAndDescriptions) {
  for (const uint32_t version : {80u, 161u}) {
    OsgbBuilder builder(version);
    const auto object = [&] {
      builder.String("a name");
      builder.U32(0);
      builder.Flag(true);
      builder.Object("osg::DefaultUserDataContainer", [&] {
        builder.Flag(false);
        builder.List({[&] { builder.String("first"); }, [&] { builder.String("second"); }});
        builder.Flag(false);
      });
    };
    EXPECT_EQ(OsgbRefusal(GeodeWith(builder, object, [&] { builder.NodeFields(); })), "") << version;
  }
}

TEST(OsgbObjectTest, RefusesUserObjects) {
  const auto refusal = [](int user_data, int user_objects, const std::string& class_name) {
    OsgbBuilder builder;
    return OsgbRefusal(GeodeWith(
        builder,
        [&] {
          builder.String("");
          builder.U32(2);
          builder.Flag(true);
          builder.Object(class_name, [&] {
            builder.Flag(user_data != 0);
            builder.Flag(false);
            builder.Flag(user_objects != 0);
          });
        },
        [&] { builder.NodeFields(); }));
  };
  EXPECT_EQ(refusal(0, 0, "osg::DefaultUserDataContainer"), "");
  EXPECT_THAT(refusal(1, 0, "osg::DefaultUserDataContainer"), HasSubstr("user data is not supported"));
  EXPECT_THAT(refusal(0, 1, "osg::DefaultUserDataContainer"), HasSubstr("user objects are not supported"));
  EXPECT_THAT(refusal(0, 0, "my::Container"), HasSubstr("an object of class my::Container is not supported here"));
}

TEST(OsgbObjectTest, ReadsBoundsOfNodes) {
  OsgbBuilder builder(161);
  const auto node = [&] {
    builder.Flag(true);
    builder.Bracket([&] { builder.Zeros(32); });
    builder.Zeros(4);
    builder.Flag(true);
    builder.U32(1);
    builder.Flag(false);
  };
  EXPECT_EQ(OsgbRefusal(GeodeWith(
                builder, [&] { builder.ObjectFields(); }, node)),
            "");
}

TEST(OsgbObjectTest, RefusesCallbacksByName) {
  OsgbBuilder builder;
  const auto node = [&] {
    builder.Zeros(2);
    builder.Flag(true);
    builder.String("osg::AnimationPathCallback");
  };
  EXPECT_THAT(OsgbRefusal(GeodeWith(
                  builder, [&] { builder.ObjectFields(); }, node)),
              HasSubstr("an object of class osg::AnimationPathCallback is not supported here"));
}

TEST(OsgbObjectTest, ReadsAbsentObjectsInLists) {
  OsgbBuilder builder(161);
  EXPECT_EQ(
      OsgbRefusal(builder.Scene([&] {
        builder.Group({[&] { builder.String("NULL"); }, [&] { builder.Geode({[&] { builder.String("NULL"); }}); }});
      })),
      "");
}

TEST(OsgbObjectTest, RefusesAnIdOfTwoClasses) {
  OsgbBuilder builder;
  EXPECT_THAT(OsgbRefusal(builder.Scene([&] {
                builder.Group({[&] { builder.Geode({}); }, [&] { builder.Reference("osg::Group", 2); }});
              })),
              HasSubstr("the id 2 stands for an object of class osg::Geode"));
}

TEST(OsgbObjectTest, RefusesAnObjectInItself) {
  OsgbBuilder builder;
  EXPECT_THAT(OsgbRefusal(builder.Scene([&] { builder.Group({[&] { builder.Reference("osg::Group", 1); }}); })),
              HasSubstr("the id 1 stands for an object of class osg::Group that is not complete"));
}

TEST(OsgbObjectTest, LimitsTheDepthOfObjects) {
  OsgbBuilder builder;
  std::string fields;  // of an object in whose user data is an object in whose user data ...
  for (uint32_t id = 2; id < 100; ++id) {
    OsgbBuilder object;
    object.String("");
    object.U32(2);
    object.Flag(true);
    object.String("osg::DefaultUserDataContainer");
    object.U32(id);
    fields += object.out;
  }
  EXPECT_THAT(OsgbRefusal(builder.Scene([&] {
                builder.String("osg::Geode");
                builder.U32(1);
                builder.out += fields;
              })),
              HasSubstr("objects are nested more than 64 deep"));
}

}  // namespace
}  // namespace tilemend
