// The fields that all objects and nodes have.
#include <algorithm>

#include "absl/strings/str_cat.h"
#include "common/codec/osgb/osgb_parse.h"

namespace tilemend {
namespace {

constexpr int kMaxDepth = 64;
constexpr size_t kMinStringBytes = 4;

// osg::DefaultUserDataContainer: texts only.
void ReadUserData(OsgbParse& parse) {
  OsgbCursor& cursor = parse.cursor;
  const OsgbHead head = BeginOsgbObject(parse);
  if (head.is_done) return;
  if (head.class_name != "osg::DefaultUserDataContainer") return RefuseOsgbClass(parse, head.class_name);
  ReadOsgbObjectFields(parse);
  if (cursor.Flag("user data")) return cursor.Fail("user data is not supported");
  if (cursor.Flag("descriptions")) {
    const uint32_t count = cursor.Count(kMinStringBytes, "descriptions");
    cursor.Begin("descriptions");
    for (uint32_t i = 0; i < count && cursor.ok(); ++i) cursor.String("a description");
    cursor.End("descriptions");
  }
  if (cursor.Flag("user objects")) return cursor.Fail("user objects are not supported");
  EndOsgbObject(parse, head, -1);
}

}  // namespace

void RefuseOsgbClass(OsgbParse& parse, std::string_view class_name) {
  parse.cursor.Fail(absl::StrCat("an object of class ", std::string(class_name), " is not supported here"));
}

OsgbHead RegisterOsgbObject(OsgbParse& parse, std::string_view class_name, uint32_t id) {
  OsgbHead head{.class_name = class_name, .id = id, .is_done = !parse.cursor.ok()};
  if (head.is_done) return head;
  const auto [it, is_new] = parse.objects.emplace(id, OsgbObject{.class_name = class_name});
  parse.layout.max_object_id = std::max(parse.layout.max_object_id, id);
  if (is_new) return head;
  if (it->second.class_name != class_name || !it->second.is_complete) {
    parse.cursor.Fail(absl::StrCat("the id ", id, " stands for an object of class ", std::string(it->second.class_name),
                                   it->second.is_complete ? "" : " that is not complete"));
  }
  head.is_done = true;
  head.value = it->second.value;
  return head;
}

void CompleteOsgbObject(OsgbParse& parse, const OsgbHead& head, int32_t value) {
  if (!parse.cursor.ok()) return;
  OsgbObject& object = parse.objects.at(head.id);
  object.value = value;
  object.is_complete = true;
}

OsgbHead BeginOsgbObject(OsgbParse& parse) {
  OsgbCursor& cursor = parse.cursor;
  const std::string_view class_name = cursor.String("the class of an object");
  if (!cursor.ok() || class_name == "NULL") return {.class_name = "NULL", .is_done = true};
  cursor.Begin(class_name);
  const OsgbHead head = RegisterOsgbObject(parse, class_name, cursor.U32("the id of an object"));
  if (head.is_done) {
    cursor.End(class_name);
  } else if (++parse.depth > kMaxDepth) {
    cursor.Fail(absl::StrCat("objects are nested more than ", kMaxDepth, " deep"));
  }
  return head;
}

void EndOsgbObject(OsgbParse& parse, const OsgbHead& head, int32_t value) {
  parse.cursor.End(head.class_name);
  CompleteOsgbObject(parse, head, value);
  --parse.depth;
}

void ExpectNoOsgbObject(OsgbParse& parse, std::string_view what) {
  if (parse.cursor.Flag(what)) RefuseOsgbClass(parse, parse.cursor.String(what));
}

void ReadOsgbObjectFields(OsgbParse& parse) {
  parse.cursor.String("the name of an object");
  parse.cursor.U32("the data variance");
  if (parse.cursor.Flag("user data")) ReadUserData(parse);
}

OsgbLook OsgbLookOver(const OsgbParse& parse, int32_t state_set, const OsgbLook& inherited) {
  if (state_set < 0) return inherited;
  OsgbLook look = parse.looks[static_cast<size_t>(state_set)];
  if (look.image < 0) look.image = inherited.image;
  if (!look.colour) look.colour = inherited.colour;
  return look;
}

OsgbLook ReadOsgbNodeFields(OsgbParse& parse, const OsgbLook& inherited) {
  OsgbCursor& cursor = parse.cursor;
  if (cursor.Flag("the initial bound")) {
    cursor.Begin("the initial bound");
    cursor.Take(4 * sizeof(double), "the initial bound");
    cursor.End("the initial bound");
  }
  for (const char* const what :
       {"the callback for the bound", "the update callback", "the event callback", "the cull callback"}) {
    ExpectNoOsgbObject(parse, what);
  }
  cursor.Flag("the culling flag");
  cursor.U32("the node mask");
  return OsgbLookOver(parse, cursor.Flag("the state set") ? ReadOsgbStateSet(parse) : -1, inherited);
}

}  // namespace tilemend
