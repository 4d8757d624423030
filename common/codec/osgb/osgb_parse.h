// What the parts of the OSGB reader share: the state of a reading, and the fields that all objects have.
#ifndef TILEMEND_COMMON_CODEC_OSGB_OSGB_PARSE_H_
#define TILEMEND_COMMON_CODEC_OSGB_OSGB_PARSE_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/osgb/osgb_cursor.h"
#include "common/codec/osgb/osgb_file.h"

namespace tilemend {

// Versions at which OpenSceneGraph changed what this codec reads. Each is the first with the change.
inline constexpr uint32_t kOsgbMinVersion = 80;
inline constexpr uint32_t kOsgbImageClass = 95;          // images name their class; textures have image attachments
inline constexpr uint32_t kOsgbInstances = 97;           // primitive sets have a number of instances
inline constexpr uint32_t kOsgbSwizzle = 98;             // textures have a swizzle
inline constexpr uint32_t kOsgbArrayObjects = 112;       // arrays and primitive sets are objects
inline constexpr uint32_t kOsgbDrawableMask = 142;       // drawables have a node mask
inline constexpr uint32_t kOsgbDrawableCulling = 145;    // drawables have a culling flag
inline constexpr uint32_t kOsgbBufferData = 147;         // arrays and primitive sets have buffer objects
inline constexpr uint32_t kOsgbLongBrackets = 149;       // sizes of brackets have 8 bytes
inline constexpr uint32_t kOsgbDefines = 151;            // state sets have defines
inline constexpr uint32_t kOsgbDrawableNodes = 154;      // drawables are nodes; no image attachments any more
inline constexpr uint32_t kOsgbTextureLevels = 155;      // textures have bounds of their levels
inline constexpr uint32_t kOsgbDrawableNodesOnly = 156;  // drawables do not repeat the fields of nodes
inline constexpr uint32_t kOsgbMaxVersion = 161;

// Where a geode's list of drawables stands.
struct OsgbGeodeSite {
  bool has_list = false;
  size_t count_offset = 0;
  size_t end_offset = 0;
  int32_t bracket = -1;  // that encloses the list's items
};

// Where the indices of a primitive set stand.
struct OsgbPrimitiveSite {
  uint32_t mode = 0;         // GL_TRIANGLES, GL_TRIANGLE_STRIP or GL_TRIANGLE_FAN
  uint32_t index_bytes = 0;  // 0: consecutive vertices from `first`
  uint32_t first = 0;
  uint32_t count = 0;  // of the indices
  size_t count_offset = 0;
  size_t data_offset = 0;
  int32_t bracket = -1;  // the innermost that encloses the indices
  int32_t first_triangle = 0;
  int32_t triangle_count = 0;
};

// Values of an osg::Array in the file.
struct OsgbArray {
  std::string_view type;  // without osg::
  size_t offset = 0;
  uint32_t count = 0;
  int32_t binding = 0;  // as osg::Array::Binding
};

// What a file holds, and where an insertion or a removal has to change it.
struct OsgbLayout {
  OsgbFile file;
  std::vector<OsgbGeodeSite> geodes;  // as OsgbFile::geodes
  std::vector<OsgbPrimitiveSite> primitives;
  std::vector<OsgbBracket> brackets;
  size_t bracket_bytes = 0;
  uint32_t max_object_id = 0;
  uint32_t max_array_id = 0;
};

struct OsgbObject {
  std::string_view class_name;
  int32_t value = -1;        // what the object's reader returned
  bool is_complete = false;  // its last byte was read
};

// What a state set says of the surface.
struct OsgbLook {
  int32_t image = -1;  // at texture unit 0; -1: none
  std::optional<Rgb> colour;
};

struct OsgbParse {
  OsgbParse(std::string_view bytes, const std::string& name) : cursor(bytes, name) {}

  OsgbCursor cursor;
  OsgbLayout layout;
  std::map<uint32_t, OsgbObject> objects;  // by id
  std::map<uint32_t, int32_t> array_ids;   // before kOsgbArrayObjects: index into `arrays`
  std::vector<OsgbArray> arrays;
  std::vector<OsgbLook> looks;  // of state sets
  int depth = 0;                // of objects in objects

  uint32_t version() const { return layout.file.version; }
};

// The beginning of an object. If `is_done`, nothing follows: there is no object, or it is one that was read before.
struct OsgbHead {
  std::string_view class_name;
  uint32_t id = 0;
  bool is_done = false;
  int32_t value = -1;  // of the object that was read before
};

// Reads class, bracket and id. Fails if objects are nested too deeply, if an object contains itself, or if an id stands
// for objects of two classes.
OsgbHead BeginOsgbObject(OsgbParse& parse);

// Reads the end of the object; later objects with its id have `value`.
void EndOsgbObject(OsgbParse& parse, const OsgbHead& head, int32_t value);

// As BeginOsgbObject, from the id on: images have no bracket and no class before kOsgbImageClass.
OsgbHead RegisterOsgbObject(OsgbParse& parse, std::string_view class_name, uint32_t id);
void CompleteOsgbObject(OsgbParse& parse, const OsgbHead& head, int32_t value);

void RefuseOsgbClass(OsgbParse& parse, std::string_view class_name);

// Reads the flag of an optional object and fails if it is there.
void ExpectNoOsgbObject(OsgbParse& parse, std::string_view what);

// The fields of osg::Object.
void ReadOsgbObjectFields(OsgbParse& parse);

// An osg::StateSet. Returns its index in OsgbParse::looks, -1 after a failure.
int32_t ReadOsgbStateSet(OsgbParse& parse);

// The fields of osg::Node. Returns the look of its state set; what this does not say is as in `inherited`.
OsgbLook ReadOsgbNodeFields(OsgbParse& parse, const OsgbLook& inherited);

// The look of a state set over `inherited`.
OsgbLook OsgbLookOver(const OsgbParse& parse, int32_t state_set, const OsgbLook& inherited);

// The fields of an osg::Geometry behind its head, appended to the layout. `look` is inherited.
void ReadOsgbGeometry(OsgbParse& parse, int32_t geode, OsgbLook look);

// Reads a file. `bytes` must outlive the result of the cursor only.
absl::StatusOr<OsgbLayout> ParseOsgb(std::string_view bytes, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OSGB_OSGB_PARSE_H_
