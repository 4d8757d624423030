#include "common/codec/osgb/osgb_encode.h"

#include <array>
#include <string_view>
#include <vector>

#include "common/codec/osgb/osgb_encoder.h"
#include "common/codec/osgb/osgb_parse.h"
#include "common/util/texture_wrap.h"

namespace tilemend {
namespace {

constexpr uint32_t kGlTriangles = 4;
constexpr uint32_t kGlTexture2d = 0x0de1;
constexpr uint32_t kGlClampToEdge = 0x812f;
constexpr uint32_t kGlRepeat = 0x2901;
constexpr uint32_t kGlLinear = 0x2601;
constexpr uint32_t kGlOff = 0x1603;  // osg::Material::OFF
constexpr uint32_t kGlLessOrEqual = 0x0203;
constexpr uint32_t kGlLuminance = 0x1909;
constexpr uint32_t kOn = 1;
constexpr uint32_t kOverall = 1;
constexpr uint32_t kPerVertex = 4;

using Colour = std::array<float, 4>;
constexpr Colour kBlack = {0, 0, 0, 1};
constexpr Colour kWhite = {1, 1, 1, 1};

// An array of floats: its class, the number that stands for it before kOsgbArrayObjects, its values.
struct FloatArray {
  std::string_view class_name;
  uint32_t type;
  uint32_t components;
  uint32_t binding;
  std::vector<float> values;
};

void EncodeMaterial(const Colour& colour, OsgbEncoder& out) {
  out.BeginObject("osg::Material");
  out.Zeros(2);  // no callbacks
  out.U32(kGlOff);
  for (const Colour& value : {colour, colour, kBlack, kBlack}) {  // ambient, diffuse, specular, emission
    out.Flag(true);
    out.Flag(true);  // front and back
    for (int side = 0; side < 2; ++side) {
      for (const float channel : value) out.F32(channel);
    }
  }
  out.Flag(true);
  out.Flag(true);
  out.Zeros(2 * sizeof(float));  // shininess
  out.End();
}

void EncodeImage(const OsgbPatch& patch, OsgbEncoder& out) {
  constexpr uint32_t kInlineFile = 1;
  if (out.version() >= kOsgbImageClass) out.String("osg::Image");
  out.U32(out.NewObjectId());
  out.String(patch.image_name);
  out.U32(0);  // no preference for writing
  out.U32(kInlineFile);
  out.String(patch.image);
  out.ObjectFields();
}

void EncodeTexture(const OsgbPatch& patch, OsgbEncoder& out) {
  out.BeginObject("osg::Texture2D");
  out.Zeros(2);  // no callbacks
  const uint32_t wrap = RepeatsImage(patch.uv) ? kGlRepeat : kGlClampToEdge;
  for (const uint32_t value : {wrap, wrap, wrap, kGlLinear, kGlLinear}) {
    out.Flag(true);
    out.U32(value);
  }
  out.F32(1);                                                  // anisotropy
  for (const bool b : {true, true, false, true}) out.Flag(b);  // mipmaps, unreference, client storage, resize
  out.Zeros(4 * sizeof(double) + 2 * sizeof(uint32_t));        // border, format of the image
  out.Zeros(3 + 1);                                            // no formats, no shadow
  out.U32(kGlLessOrEqual);
  out.U32(kGlLuminance);
  out.F32(0);
  if (out.version() >= kOsgbImageClass && out.version() < kOsgbDrawableNodes) out.Flag(false);
  if (out.version() >= kOsgbSwizzle) {
    out.Flag(true);
    out.String("RGBA");
  }
  if (out.version() >= kOsgbTextureLevels) {
    for (const float value : {0.0f, -1.0f, 0.0f}) out.F32(value);
  }
  out.Flag(true);
  EncodeImage(patch, out);
  out.Zeros(2 * sizeof(uint32_t));  // size as the image
  out.End();
}

// The lists of texture modes and texture attributes, for unit 0.
void EncodeTextureUnit(const OsgbPatch& patch, OsgbEncoder& out) {
  out.Flag(true);
  out.U32(1);
  out.Begin();
  out.U32(1);
  out.Begin();
  out.U32(kGlTexture2d);
  out.U32(kOn);
  out.End();
  out.End();
  out.Flag(true);
  out.U32(1);
  out.Begin();
  out.U32(1);
  out.Begin();
  EncodeTexture(patch, out);
  out.U32(0);
  out.End();
  out.End();
}

void EncodeStateSet(const OsgbPatch& patch, const Colour& colour, OsgbEncoder& out) {
  out.BeginObject("osg::StateSet");
  out.Flag(false);  // no modes
  out.Flag(true);
  out.U32(1);
  out.Begin();
  EncodeMaterial(colour, out);
  out.U32(kOn);
  out.End();
  if (patch.image.empty()) {
    out.Zeros(2);
  } else {
    EncodeTextureUnit(patch, out);
  }
  out.Zeros(1 + 4 * sizeof(uint32_t));  // no uniforms, the default render bin
  out.Flag(true);                       // nested render bins
  out.Zeros(2);                         // no callbacks
  if (out.version() >= kOsgbDefines) out.Flag(false);
  out.End();
}

void EncodeDrawable(const OsgbPatch& patch, const Colour& colour, OsgbEncoder& out) {
  constexpr uint32_t kAll = UINT32_MAX;
  if (out.version() >= kOsgbDrawableNodes) {
    out.Zeros(5);  // no bound, no callbacks
    out.Flag(true);
    out.U32(kAll);
    out.Flag(true);
    EncodeStateSet(patch, colour, out);
  }
  if (out.version() < kOsgbDrawableNodes) {
    out.Flag(true);
    EncodeStateSet(patch, colour, out);
  } else if (out.version() < kOsgbDrawableNodesOnly) {
    out.Flag(false);
  }
  out.Zeros(3);                                              // no bound, no callback, no shape
  for (const bool b : {true, true, false}) out.Flag(b);      // display lists, no buffer objects
  if (out.version() < kOsgbDrawableNodesOnly) out.Zeros(4);  // no callbacks
  if (out.version() >= kOsgbDrawableMask) out.U32(kAll);
  if (out.version() >= kOsgbDrawableCulling) out.Flag(true);
}

void EncodeTriangles(const std::vector<Triangle>& triangles, OsgbEncoder& out) {
  constexpr uint32_t kElementsUInt = 54;
  const bool is_object = out.version() >= kOsgbArrayObjects;
  out.U32(1);
  if (is_object) {
    out.BeginObject("osg::DrawElementsUInt");
    if (out.version() >= kOsgbBufferData) out.Flag(false);
    out.U32(0);  // instances
    out.U32(kGlTriangles);
  } else {
    out.U32(kElementsUInt);
    out.U32(kGlTriangles);
    if (out.version() >= kOsgbInstances) out.U32(0);
  }
  out.U32(static_cast<uint32_t>(3 * triangles.size()));
  if (!is_object) out.Begin();
  for (const Triangle& triangle : triangles) {
    for (const int32_t corner : triangle) out.U32(static_cast<uint32_t>(corner));
  }
  out.End();
}

void EncodeArray(const FloatArray& array, OsgbEncoder& out) {
  const bool is_object = out.version() >= kOsgbArrayObjects;
  if (is_object) {
    out.BeginObject(array.class_name);
    if (out.version() >= kOsgbBufferData) out.Flag(false);
    out.U32(array.binding);
    out.Zeros(2);  // not normalized, type not kept
  } else {
    out.Begin();
    out.Flag(true);
    out.U32(out.NewArrayId());
    out.U32(array.type);
  }
  out.U32(static_cast<uint32_t>(array.values.size() / array.components));
  if (!is_object) out.Begin();
  for (const float value : array.values) out.F32(value);
  out.End();
  if (is_object) return;
  out.Flag(false);  // no indices
  out.U32(array.binding);
  out.U32(0);  // not normalized
  out.End();
}

FloatArray VerticesOf(const OsgbPatch& patch, const Point3& translation) {
  constexpr uint32_t kVec3Array = 16;
  FloatArray array{"osg::Vec3Array", kVec3Array, 3, kPerVertex, {}};
  array.values.reserve(3 * patch.points.size());
  for (const Point3& point : patch.points) {
    for (int axis = 0; axis < 3; ++axis) array.values.push_back(static_cast<float>(point[axis] - translation[axis]));
  }
  return array;
}

FloatArray UvOf(const OsgbPatch& patch) {
  constexpr uint32_t kVec2Array = 15;
  FloatArray array{"osg::Vec2Array", kVec2Array, 2, kPerVertex, {}};
  array.values.reserve(2 * patch.uv.size());
  for (const auto& uv : patch.uv) array.values.insert(array.values.end(), uv.begin(), uv.end());
  return array;
}

// A viewer without lighting does not use the material, so that a plain colour is an array as well.
void EncodeArrays(const OsgbPatch& patch, const Point3& translation, const Colour& colour, OsgbEncoder& out) {
  constexpr uint32_t kVec4Array = 17;
  const bool is_object = out.version() >= kOsgbArrayObjects;
  const bool has_image = !patch.image.empty();
  out.Flag(true);
  EncodeArray(VerticesOf(patch, translation), out);
  out.Flag(false);  // normals
  out.Flag(!has_image);
  if (!has_image) {
    EncodeArray({"osg::Vec4Array", kVec4Array, 4, kOverall, {colour.begin(), colour.end()}}, out);
  }
  out.Zeros(2);  // secondary colours, fog coordinates
  if (!is_object) out.Flag(has_image);
  if (is_object || has_image) out.U32(has_image ? 1 : 0);
  if (has_image) {
    if (!is_object) out.Begin();
    EncodeArray(UvOf(patch), out);
    if (!is_object) out.End();
  }
  out.Zeros(is_object ? sizeof(uint32_t) : 2);  // no further attributes; no fast path hint
}

}  // namespace

std::string EncodeOsgbGeometry(const OsgbPatch& patch, const Point3& translation, OsgbEncoding& encoding) {
  constexpr float kMaxChannel = 255;
  Colour colour = kWhite;
  if (patch.image.empty()) {
    colour = {patch.colour.r / kMaxChannel, patch.colour.g / kMaxChannel, patch.colour.b / kMaxChannel, 1};
  }
  OsgbEncoder out(encoding);
  out.BeginObject("osg::Geometry");
  EncodeDrawable(patch, colour, out);
  EncodeTriangles(patch.triangles, out);
  EncodeArrays(patch, translation, colour, out);
  out.End();
  return out.Take();
}

}  // namespace tilemend
