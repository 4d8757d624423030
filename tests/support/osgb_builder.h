// OSGB files for tests, written field by field as OpenSceneGraph 3.6.5 does; shares nothing with the codec.
#ifndef TILEMEND_TESTS_SUPPORT_OSGB_BUILDER_H_
#define TILEMEND_TESTS_SUPPORT_OSGB_BUILDER_H_

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tilemend {

// The versions at which the format changes, and those of OpenSceneGraph 3.0, 3.2, 3.4 and 3.6.
inline constexpr uint32_t kOsgbVersions[] = {80,  91,  95,  97,  98,  99,  100, 112, 130,
                                             142, 145, 147, 149, 151, 154, 155, 156, 161};

struct BuiltGeometry {
  std::vector<std::array<float, 3>> points = {{0, 0, 1}, {2, 0, 1}, {2, 2, 1.5F}, {0, 2, 1}};
  std::vector<std::array<float, 2>> uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<uint32_t> indices = {0, 1, 2, 0, 2, 3};  // of DrawArrays: the first vertex and the number of vertices
  uint32_t type = 54;                                  // 50 DrawArrays, 52 to 54 DrawElementsUByte, UShort and UInt
  uint32_t mode = 4;                                   // GL_TRIANGLES
  int32_t binding = 4;                                 // BIND_PER_VERTEX
  bool has_normals = false;
  std::string vertex_class = "Vec3Array";
  std::string image = "\xff\xd8\xff jpeg \xff\xd9";  // empty: no state set
  std::string image_name = "tile_0.jpg";
};

// Numbers, texts, brackets and objects.
class OsgbBytes {
 public:
  using Body = std::function<void()>;

  explicit OsgbBytes(uint32_t file_version = 80) : version(file_version), has_brackets(file_version >= 99) {}

  uint32_t version;
  bool has_brackets;
  std::string compressor = "0";
  uint32_t attributes = 0;  // besides that for brackets
  uint32_t next_id = 1;
  uint32_t next_array_id = 1;
  std::string out;

  void Flag(bool value) { out += static_cast<char>(value); }
  void U32(uint32_t value) { Number(value, 4); }
  void F32(float value) { Number(std::bit_cast<uint32_t>(value), 4); }
  void F64(double value) { Number(std::bit_cast<uint64_t>(value), 8); }
  void Zeros(size_t count) { out.append(count, '\0'); }
  void String(std::string_view text) {
    U32(static_cast<uint32_t>(text.size()));
    out += text;
  }
  void Bracket(const Body& body) {
    const size_t at = out.size();
    const size_t size_bytes = !has_brackets ? 0 : version >= 149 ? 8 : 4;
    Zeros(size_bytes);
    body();
    uint64_t size = out.size() - at;
    for (size_t i = 0; i < size_bytes; ++i, size >>= 8) out[at + i] = static_cast<char>(size & 0xff);
  }

  // The whole file: the header, and the root that `body` writes.
  std::string Scene(const Body& body) {
    out = std::string("\xa1\x0e\x91\x6c\x45\x45\xfb\x1a\x01\0\0\0", 12);
    U32(version);
    U32(attributes | (has_brackets ? 4 : 0));
    String(compressor);
    body();
    return out;
  }

  void ObjectFields() {
    String("");
    U32(2);
    Flag(false);
  }
  void Reference(std::string_view class_name, uint32_t id) {
    String(class_name);
    Bracket([&] { U32(id); });
  }
  uint32_t Object(std::string_view class_name, const Body& body) {
    const uint32_t id = next_id++;
    String(class_name);
    Bracket([&] {
      U32(id);
      ObjectFields();
      body();
    });
    return id;
  }

 protected:
  void Number(uint64_t value, size_t bytes) {
    for (size_t i = 0; i < bytes; ++i, value >>= 8) out += static_cast<char>(value & 0xff);
  }
};

// State sets, textures and images.
class OsgbStateBuilder : public OsgbBytes {
 public:
  using OsgbBytes::OsgbBytes;

  uint32_t StateSet(const BuiltGeometry& built) {
    return StateSet({}, [&] { Texture([&] { Image(built.image_name, built.image); }); });
  }
  // `attribute` and `texture` write an object each.
  uint32_t StateSet(const Body& attribute, const Body& texture, size_t unit = 0) {
    return Object("osg::StateSet", [&] {
      Flag(true);
      U32(0);  // an empty list of modes
      Flag(static_cast<bool>(attribute));
      if (attribute) Attributes(attribute);
      Flag(false);
      Flag(static_cast<bool>(texture));
      if (texture) {
        U32(static_cast<uint32_t>(unit + 1));
        Bracket([&] {
          for (size_t i = 0; i < unit; ++i) U32(0);
          Attributes(texture);
        });
      }
      StateSetEnd();
    });
  }
  void StateSetEnd() {
    Zeros(1 + 4 * 4);  // no uniforms, render bin
    Flag(true);
    Zeros(2);  // no callbacks
    if (version >= 151) Flag(false);
  }

  uint32_t Texture(const Body& image) {
    return Object("osg::Texture2D", [&] {
      Zeros(2);
      for (int i = 0; i < 5; ++i) {
        Flag(true);
        U32(0x2601);
      }
      F32(1);
      Zeros(4 + 32 + 4 + 4 + 3 + 1);
      U32(0x203);
      U32(0x1909);
      F32(0);
      if (version >= 95 && version < 154) Flag(false);
      if (version >= 98) {
        Flag(true);
        String("RGBA");
      }
      if (version >= 155) Zeros(12);
      Flag(true);
      image();
      Zeros(8);
    });
  }
  // Class and id of an image: all of one that was written before.
  void ImageReference(uint32_t id) {
    if (version >= 95) String("osg::Image");
    U32(id);
  }
  uint32_t Image(const std::string& name, const std::string& bytes, uint32_t storage = 1) {
    const uint32_t id = next_id++;
    ImageReference(id);
    String(name);
    U32(0);
    U32(storage);
    if (storage == 0) Zeros(9 * 4);
    if (storage < 2) String(bytes);
    if (storage == 0) U32(0);
    ObjectFields();
    return id;
  }

 private:
  void Attributes(const Body& attribute) {
    U32(1);
    Bracket([&] {
      attribute();
      U32(1);
    });
  }
};

// Nodes and geometries.
class OsgbBuilder : public OsgbStateBuilder {
 public:
  using OsgbStateBuilder::OsgbStateBuilder;

  void NodeFields(const Body& state_set = {}) {
    Zeros(5);  // bound, callbacks
    Flag(true);
    U32(0xffffffff);
    Flag(static_cast<bool>(state_set));
    if (state_set) state_set();
  }
  void List(const std::vector<Body>& items) {
    Flag(!items.empty());
    if (items.empty()) return;
    U32(static_cast<uint32_t>(items.size()));
    Bracket([&] {
      for (const Body& item : items) item();
    });
  }

  // A group or a geode, by class: both have a list.
  void Node(std::string_view class_name, const std::vector<Body>& items, const Body& state_set = {}) {
    Object(class_name, [&] {
      NodeFields(state_set);
      List(items);
    });
  }
  void Geode(const std::vector<Body>& geometries) { Node("osg::Geode", geometries); }
  void Group(const std::vector<Body>& children) { Node("osg::Group", children); }

  // Child 0 in this file, child 1 in `file`.
  void PagedLod(const std::string& file, const Body& child) {
    Object("osg::PagedLOD", [&] {
      NodeFields();
      LodFields();
      Flag(true);
      Flag(false);  // no folder
      U32(0);
      Flag(false);
      FileNames(file);
      List({child});
    });
  }

  void Transform(const std::array<double, 16>& matrix, const std::vector<Body>& children, uint32_t frame = 0) {
    Object("osg::MatrixTransform", [&] {
      NodeFields();
      List(children);
      U32(frame);
      Bracket([&] {
        for (const double value : matrix) F64(value);
      });
    });
  }
  void Translation(double x, double y, double z, const std::vector<Body>& children) {
    Transform({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}, children);
  }

  uint32_t Geometry(const BuiltGeometry& built) {
    return Geometry(
        built, built.image.empty() ? Body() : [&] { StateSet(built); });
  }
  uint32_t Geometry(const BuiltGeometry& built, const Body& state_set) {
    return Object("osg::Geometry", [&] {
      DrawableFields(state_set);
      U32(1);
      Primitives(built);
      if (version < 112) {
        OldArrays(built);
      } else {
        NewArrays(built);
      }
    });
  }

 private:
  void LodFields() {
    U32(1);
    Flag(true);
    for (const double value : {1.0, 1.5, 2.0, 8.0}) F64(value);  // centre, radius
    U32(1);
    Flag(true);
    U32(2);
    Bracket([&] {
      for (const float value : {0.0F, 16.0F, 16.0F, 1e30F}) F32(value);
    });
  }

  void FileNames(const std::string& file) {
    Flag(true);
    U32(2);
    Bracket([&] {
      String("");
      String(file);
    });
    U32(2);
    Bracket([&] { Zeros(16); });
  }

  void DrawableFields(const Body& state_set) {
    if (version >= 154) NodeFields(state_set);
    if (version < 154) Flag(static_cast<bool>(state_set));
    if (version < 154 && state_set) state_set();
    if (version == 154 || version == 155) Flag(false);
    Zeros(3);
    for (const bool value : {true, true, false}) Flag(value);
    if (version < 156) Zeros(4);
    if (version >= 142) U32(0xffffffff);
    if (version >= 145) Flag(true);
  }

  void Indices(const BuiltGeometry& built) {
    if (built.type <= 51) {
      U32(built.indices.at(0));
      U32(built.indices.at(1));
      return;
    }
    U32(static_cast<uint32_t>(built.indices.size()));
    const auto values = [&] {
      for (const uint32_t index : built.indices) Number(index, size_t{1} << (built.type - 52));
    };
    if (version < 112) {
      Bracket(values);
    } else {
      values();
    }
  }

  void Primitives(const BuiltGeometry& built) {
    static constexpr const char* kClasses[] = {"osg::DrawArrays", "osg::DrawArrayLengths", "osg::DrawElementsUByte",
                                               "osg::DrawElementsUShort", "osg::DrawElementsUInt"};
    if (version < 112) {
      U32(built.type);
      U32(built.mode);
      if (version >= 97) U32(0);
      return Indices(built);
    }
    Object(kClasses[built.type - 50], [&] {
      Buffer("osg::ElementBufferObject");
      U32(0);
      U32(built.mode);
      Indices(built);
    });
  }

  void Buffer(std::string_view class_name) {
    if (version < 147) return;
    Flag(true);
    Object(class_name, [&] { Zeros(9); });
  }

  void OldArray(uint32_t type, uint32_t binding, size_t count, const Body& values) {
    Bracket([&] {
      Flag(true);
      U32(next_array_id++);
      U32(type);
      U32(static_cast<uint32_t>(count));
      Bracket(values);
      Flag(false);
      U32(binding);
      U32(0);
    });
  }

  void OldArrays(const BuiltGeometry& built) {
    const uint32_t vertex_type = built.vertex_class == "Vec3Array" ? 16 : 19;
    Flag(true);
    OldArray(vertex_type, static_cast<uint32_t>(built.binding), built.points.size(), [&] { Vertices(built); });
    Flag(built.has_normals);
    if (built.has_normals) OldArray(16, 1, 1, [&] { Zeros(12); });
    Zeros(3);
    List(built.uv.empty() ? std::vector<Body>() : std::vector<Body>{[&] {
      OldArray(15, 4, built.uv.size(), [&] { TextureCoordinates(built); });
    }});
    Zeros(2);
  }

  void NewArray(const std::string& class_name, uint32_t binding, size_t count, const Body& values) {
    Object("osg::" + class_name, [&] {
      Buffer("osg::VertexBufferObject");
      U32(binding);
      Zeros(2);
      U32(static_cast<uint32_t>(count));
      values();
    });
  }

  void NewArrays(const BuiltGeometry& built) {
    Flag(true);
    NewArray(built.vertex_class, static_cast<uint32_t>(built.binding), built.points.size(), [&] { Vertices(built); });
    Flag(built.has_normals);
    if (built.has_normals) NewArray("Vec3Array", 1, 1, [&] { Zeros(12); });
    Zeros(3);
    U32(built.uv.empty() ? 0 : 1);
    if (!built.uv.empty()) NewArray("Vec2Array", 4, built.uv.size(), [&] { TextureCoordinates(built); });
    U32(0);
  }

  void Vertices(const BuiltGeometry& built) {
    const bool is_double = built.vertex_class == "Vec3dArray";
    for (const auto& point : built.points) {
      for (const float value : point) {
        if (is_double) {
          F64(double{value});
        } else {
          F32(value);
        }
      }
    }
  }
  void TextureCoordinates(const BuiltGeometry& built) {
    for (const auto& uv : built.uv) {
      for (const float value : uv) F32(value);
    }
  }
};

// Group { PagedLOD { Geode { square, strip } }, PagedLOD { Geode { square } } } with three images.
inline std::string BuiltOsgbScene(uint32_t version) {
  OsgbBuilder builder(version);
  BuiltGeometry strip;
  strip.mode = 5;
  strip.indices = {0, 1, 3, 2};
  strip.type = 53;
  strip.has_normals = true;
  return builder.Scene([&] {
    builder.Group(
        {[&] {
           builder.PagedLod("tile_L20_00.osgb", [&] {
             builder.Geode({[&] { builder.Geometry({}); }, [&] { builder.Geometry(strip); }});
           });
         },
         [&] { builder.PagedLod("tile_L20_01.osgb", [&] { builder.Geode({[&] { builder.Geometry({}); }}); }); }});
  });
}

// Geode { geometry }.
inline std::string BuiltOsgbGeometry(const BuiltGeometry& geometry, uint32_t version = 80) {
  OsgbBuilder builder(version);
  return builder.Scene([&] { builder.Geode({[&] { builder.Geometry(geometry); }}); });
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_OSGB_BUILDER_H_
