// State sets, textures and images.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include "common/codec/osgb/osgb_parse.h"

namespace tilemend {
namespace {

constexpr char kImageClass[] = "osg::Image";
constexpr char kTextureClass[] = "osg::Texture2D";
constexpr char kMaterialClass[] = "osg::Material";

// The fields of an attribute behind those of osg::StateAttribute, a letter each:
//   b flag, i 32-bit number, v vector of four floats, d vector of four doubles;
//   o 32-bit number that is optional (a flag comes first).
// A material is read by ReadMaterial.
struct AttributeFields {
  std::string_view class_name;
  std::string_view fields;
};
constexpr AttributeFields kAttributes[] = {
    {kTextureClass, "oooooibbbbdiiooobiii"},
    {kMaterialClass, ""},
    {"osg::ShadeModel", "i"},
    {"osg::CullFace", "i"},
    {"osg::TexEnv", "iv"},
    {"osg::BlendFunc", "iiii"},
    {"osg::LightModel", "vibb"},
};

size_t BytesOfField(char field) {
  switch (field) {
    case 'b':
      return 1;
    case 'v':
      return 4 * sizeof(float);
    case 'd':
      return 4 * sizeof(double);
    default:
      return sizeof(uint32_t);
  }
}

uint8_t ChannelAt(std::string_view bytes, size_t index) {
  const auto bits = static_cast<uint32_t>(LoadOsgbNumber(bytes.data() + index * sizeof(float), sizeof(float)));
  const float value = std::bit_cast<float>(bits);
  return value > 0 ? static_cast<uint8_t>(std::lround(255 * std::min(value, 1.0f))) : 0;
}

// The fields of a material: its diffuse colour is the second of its colours.
std::optional<Rgb> ReadMaterial(OsgbCursor& cursor) {
  cursor.U32("the colour mode of a material");
  std::optional<Rgb> diffuse;
  for (int colour = 0; colour < 4; ++colour) {
    if (!cursor.Flag("the flag of a material's colour")) continue;
    cursor.Flag("whether front and back are alike");
    const std::string_view front_and_back = cursor.Take(8 * sizeof(float), "a material's colour");
    if (colour != 1 || front_and_back.empty()) continue;
    diffuse = {ChannelAt(front_and_back, 0), ChannelAt(front_and_back, 1), ChannelAt(front_and_back, 2)};
  }
  if (cursor.Flag("the flag of a material's shininess")) cursor.Take(1 + 2 * sizeof(float), "a material's shininess");
  return diffuse;
}

void SkipFields(std::string_view fields, OsgbCursor& cursor) {
  for (const char field : fields) {
    if (field == 'o' && !cursor.Flag("the flag of a state attribute's field")) continue;
    cursor.Take(BytesOfField(field), "a field of a state attribute");
  }
}

void ReadPixels(OsgbCursor& cursor, OsgbImage& image) {
  constexpr size_t kHeaderNumbers = 9;  // origin, sizes, formats, type, packing, allocation mode
  image.storage = OsgbImage::Storage::kPixels;
  cursor.Take(kHeaderNumbers * sizeof(uint32_t), "the header of an image");
  image.size = cursor.Count(1, "the pixels of an image");
  image.offset = cursor.offset();
  cursor.Take(image.size, "the pixels of an image");
  cursor.Take(sizeof(uint32_t) * cursor.Count(sizeof(uint32_t), "mipmap levels"), "mipmap levels");
}

void ReadStoredImage(OsgbCursor& cursor, OsgbImage& image) {
  enum Storage : uint32_t { kInlineData = 0, kInlineFile = 1, kExternal = 2, kWriteOut = 3 };
  const size_t at = cursor.offset();
  switch (cursor.U32("the storage of an image")) {
    case kInlineData:
      return ReadPixels(cursor, image);
    case kInlineFile:
      image.size = cursor.Count(1, "the bytes of an image");
      image.offset = cursor.offset();
      cursor.Take(image.size, "the bytes of an image");
      return;
    case kExternal:
    case kWriteOut:
      image.storage = OsgbImage::Storage::kExternal;
      return;
    default:
      cursor.Fail(at, "expected 0 to 3 as the storage of an image");
  }
}

int32_t ReadImage(OsgbParse& parse) {
  OsgbCursor& cursor = parse.cursor;
  const std::string_view class_name =
      parse.version() >= kOsgbImageClass ? cursor.String("the class of an image") : kImageClass;
  if (cursor.ok() && class_name != kImageClass) RefuseOsgbClass(parse, class_name);
  const OsgbHead head = RegisterOsgbObject(parse, kImageClass, cursor.U32("the id of an image"));
  if (head.is_done) return head.value;
  OsgbImage image;
  image.name = std::string(cursor.String("the name of an image"));
  cursor.U32("the write hint of an image");
  ReadStoredImage(cursor, image);
  ReadOsgbObjectFields(parse);
  parse.layout.file.images.push_back(std::move(image));
  const auto index = static_cast<int32_t>(parse.layout.file.images.size()) - 1;
  CompleteOsgbObject(parse, head, index);
  return index;
}

// What follows the fields in kAttributes. Returns the index of the image.
int32_t ReadTextureEnd(OsgbParse& parse) {
  OsgbCursor& cursor = parse.cursor;
  if (parse.version() >= kOsgbImageClass && parse.version() < kOsgbDrawableNodes &&
      cursor.Flag("the image attachment")) {
    cursor.Fail("image attachments are not supported");
  }
  if (parse.version() >= kOsgbSwizzle && cursor.Flag("the swizzle")) cursor.String("the swizzle");
  if (parse.version() >= kOsgbTextureLevels) cursor.Take(3 * sizeof(float), "the bounds of the levels");
  const int32_t image = cursor.Flag("the image of a texture") ? ReadImage(parse) : -1;
  cursor.Take(2 * sizeof(uint32_t), "the size of a texture");
  return image;
}

int32_t AddLook(OsgbParse& parse, const OsgbLook& look) {
  parse.looks.push_back(look);
  return static_cast<int32_t>(parse.looks.size()) - 1;
}

// The index in OsgbParse::looks if the attribute is a texture or a material, else -1.
int32_t ReadAttribute(OsgbParse& parse) {
  const OsgbHead head = BeginOsgbObject(parse);
  if (head.is_done) return head.value;
  ReadOsgbObjectFields(parse);
  ExpectNoOsgbObject(parse, "the update callback");
  ExpectNoOsgbObject(parse, "the event callback");
  for (const AttributeFields& attribute : kAttributes) {
    if (attribute.class_name != head.class_name) continue;
    int32_t look = -1;
    if (head.class_name == kMaterialClass) {
      look = AddLook(parse, {-1, ReadMaterial(parse.cursor)});
    } else {
      SkipFields(attribute.fields, parse.cursor);
      if (head.class_name == kTextureClass) look = AddLook(parse, {ReadTextureEnd(parse), std::nullopt});
    }
    EndOsgbObject(parse, head, look);
    return look;
  }
  RefuseOsgbClass(parse, head.class_name);
  return -1;
}

void ReadModes(OsgbCursor& cursor) {
  constexpr size_t kModeBytes = 2 * sizeof(uint32_t);
  const uint32_t count = cursor.Count(kModeBytes, "modes");
  if (count == 0) return;
  cursor.Begin("modes");
  cursor.Take(count * kModeBytes, "modes");
  cursor.End("modes");
}

// What the attributes say together: the image of the highest number, the last colour.
OsgbLook ReadAttributes(OsgbParse& parse) {
  constexpr size_t kMinAttributeBytes = 8;
  OsgbCursor& cursor = parse.cursor;
  const uint32_t count = cursor.Count(kMinAttributeBytes, "attributes");
  OsgbLook look;
  if (count == 0) return look;
  cursor.Begin("attributes");
  for (uint32_t i = 0; i < count && cursor.ok(); ++i) {
    const int32_t index = ReadAttribute(parse);
    cursor.U32("the value of an attribute");
    if (index < 0 || !cursor.ok()) continue;
    const OsgbLook& attribute = parse.looks[static_cast<size_t>(index)];
    look.image = std::max(look.image, attribute.image);
    if (attribute.colour) look.colour = attribute.colour;
  }
  cursor.End("attributes");
  return look;
}

void ReadTextureModes(OsgbCursor& cursor) {
  if (!cursor.Flag("texture modes")) return;
  const uint32_t units = cursor.Count(sizeof(uint32_t), "texture units");
  cursor.Begin("texture modes");
  for (uint32_t i = 0; i < units && cursor.ok(); ++i) ReadModes(cursor);
  cursor.End("texture modes");
}

int32_t ReadTextures(OsgbParse& parse) {
  OsgbCursor& cursor = parse.cursor;
  if (!cursor.Flag("textures")) return -1;
  int32_t image = -1;
  const uint32_t units = cursor.Count(sizeof(uint32_t), "texture units");
  cursor.Begin("textures");
  for (uint32_t i = 0; i < units && cursor.ok(); ++i) {
    const OsgbLook of_unit = ReadAttributes(parse);
    if (i == 0) image = of_unit.image;
  }
  cursor.End("textures");
  return image;
}

void ReadDefines(OsgbCursor& cursor) {
  constexpr size_t kMinDefineBytes = 12;
  if (!cursor.Flag("defines")) return;
  const uint32_t count = cursor.Count(kMinDefineBytes, "defines");
  cursor.Begin("defines");
  for (uint32_t i = 0; i < count && cursor.ok(); ++i) {
    cursor.String("the name of a define");
    cursor.String("the value of a define");
    cursor.U32("the mode of a define");
  }
  cursor.End("defines");
}

}  // namespace

int32_t ReadOsgbStateSet(OsgbParse& parse) {
  OsgbCursor& cursor = parse.cursor;
  const OsgbHead head = BeginOsgbObject(parse);
  if (!head.is_done && head.class_name != "osg::StateSet") RefuseOsgbClass(parse, head.class_name);
  if (head.is_done || !cursor.ok()) return head.value;
  ReadOsgbObjectFields(parse);
  if (cursor.Flag("modes")) ReadModes(cursor);
  OsgbLook look;
  if (cursor.Flag("attributes")) look.colour = ReadAttributes(parse).colour;
  ReadTextureModes(cursor);
  look.image = ReadTextures(parse);
  if (cursor.Flag("uniforms")) cursor.Fail("uniforms are not supported");
  cursor.Take(3 * sizeof(uint32_t), "the render bin");
  cursor.String("the name of the render bin");
  cursor.Flag("the nesting of render bins");
  ExpectNoOsgbObject(parse, "the update callback");
  ExpectNoOsgbObject(parse, "the event callback");
  if (parse.version() >= kOsgbDefines) ReadDefines(cursor);
  const int32_t index = AddLook(parse, look);
  EndOsgbObject(parse, head, index);
  return index;
}

}  // namespace tilemend
