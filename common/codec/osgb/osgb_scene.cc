// The header of a file and its tree of nodes.
#include <Eigen/Core>
#include <limits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/osgb/osgb_parse.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr size_t kMinObjectBytes = 8;  // "NULL"
constexpr int kMaxNodeDepth = 56;      // leaves room for the objects in a new geometry

// What a node takes from those above it.
struct Inherited {
  OsgbLook look = {};
  int32_t paged_lod = -1;
};

// Adds a geode, whose drawables are at no known place yet.
int32_t AddGeode(OsgbLayout& layout, const Inherited& inherited) {
  layout.file.geodes.push_back({.paged_lod = inherited.paged_lod});
  layout.geodes.emplace_back();
  return static_cast<int32_t>(layout.geodes.size()) - 1;
}

// `geode`: that of the geometries among the children of one node, -1 as long as there is none.
void ReadNode(OsgbParse& parse, Inherited inherited, int32_t& geode);

enum class Growth { kNone, kAtTheEnd };

// Since version 154 a geometry may be a child like any other. Those of one node count as a geode, which takes new ones
// at the end of the children. Those of a PagedLOD take none: each child there has a range and a file.
void ReadChildren(OsgbParse& parse, const Inherited& inherited, Growth growth = Growth::kAtTheEnd) {
  OsgbCursor& cursor = parse.cursor;
  if (!cursor.Flag("children")) return;
  OsgbGeodeSite site{.has_list = true, .count_offset = cursor.offset()};
  const uint32_t count = cursor.Count(kMinObjectBytes, "children");
  if (count == 0) return;
  cursor.Begin("children");
  int32_t geode = -1;
  for (uint32_t i = 0; i < count && cursor.ok(); ++i) ReadNode(parse, inherited, geode);
  site.bracket = cursor.bracket();
  site.end_offset = cursor.offset();
  cursor.End("children");
  if (geode >= 0 && growth == Growth::kAtTheEnd) parse.layout.geodes[static_cast<size_t>(geode)] = site;
}

void ReadGeode(OsgbParse& parse, const Inherited& inherited) {
  OsgbCursor& cursor = parse.cursor;
  OsgbLayout& layout = parse.layout;
  const int32_t index = AddGeode(layout, inherited);
  OsgbGeodeSite site{.has_list = cursor.Flag("drawables"), .count_offset = cursor.offset()};
  if (!site.has_list) return;
  const uint32_t count = cursor.Count(kMinObjectBytes, "drawables");
  cursor.Begin("drawables");
  for (uint32_t i = 0; i < count && cursor.ok(); ++i) {
    const OsgbHead head = BeginOsgbObject(parse);
    if (!cursor.ok() || head.class_name == "NULL") continue;
    if (head.class_name != "osg::Geometry") return RefuseOsgbClass(parse, head.class_name);
    if (head.is_done) return cursor.Fail("a geometry in several geodes is not supported");
    ReadOsgbGeometry(parse, index, inherited.look);
    EndOsgbObject(parse, head, -1);
  }
  site.bracket = cursor.bracket();
  site.end_offset = cursor.offset();
  cursor.End("drawables");
  layout.geodes[static_cast<size_t>(index)] = site;
}

// The fields of osg::LOD, with one child for each range.
OsgbPagedLod ReadLodFields(OsgbCursor& cursor) {
  constexpr size_t kRangeBytes = 2 * sizeof(float);
  OsgbPagedLod lod;
  cursor.U32("the mode of the centre");
  lod.has_center = cursor.Flag("the centre");
  if (lod.has_center) {
    for (int axis = 0; axis < 3; ++axis) lod.center[axis] = cursor.F64("the centre");
    lod.radius = cursor.F64("the radius");
  }
  lod.range_is_pixels = cursor.U32("the mode of the ranges") != 0;
  if (!cursor.Flag("the ranges")) return lod;
  const uint32_t count = cursor.Count(kRangeBytes, "the ranges");
  cursor.Begin("the ranges");
  for (uint32_t i = 0; i < count && cursor.ok(); ++i) {
    OsgbChild& child = lod.children.emplace_back();
    child.range_lo = cursor.F32("a range");
    child.range_hi = cursor.F32("a range");
  }
  cursor.End("the ranges");
  return lod;
}

void ReadFileNames(OsgbCursor& cursor, OsgbPagedLod& lod) {
  constexpr size_t kNameBytes = 4;  // at least
  constexpr size_t kPriorityBytes = 2 * sizeof(float);
  const uint32_t count = cursor.Count(kNameBytes, "file names");
  cursor.Begin("file names");
  if (count > lod.children.size()) lod.children.resize(count);
  for (uint32_t i = 0; i < count && cursor.ok(); ++i) lod.children[i].file = std::string(cursor.String("a file name"));
  cursor.End("file names");
  const uint32_t priorities = cursor.Count(kPriorityBytes, "priorities");
  cursor.Begin("priorities");
  cursor.Take(priorities * kPriorityBytes, "priorities");
  cursor.End("priorities");
}

void ReadPagedLod(OsgbParse& parse, Inherited inherited) {
  OsgbCursor& cursor = parse.cursor;
  OsgbPagedLod lod = ReadLodFields(cursor);
  if (cursor.Flag("the folder") && cursor.Flag("the folder")) cursor.String("the folder");
  cursor.U32("the number of children that stay");
  cursor.Flag("the flag against paging");
  if (cursor.Flag("file names")) ReadFileNames(cursor, lod);
  inherited.paged_lod = static_cast<int32_t>(parse.layout.file.paged_lods.size());
  parse.layout.file.paged_lods.push_back(std::move(lod));
  ReadChildren(parse, inherited, Growth::kNone);
}

// The translation of a MatrixTransform; fails for any other transform.
Point3 ReadTranslation(OsgbCursor& cursor) {
  const size_t at = cursor.offset();
  const uint32_t frame = cursor.U32("the frame of a transform");
  Eigen::Matrix4d matrix;  // of row vectors, as the file has it
  cursor.Begin("the matrix of a transform");
  for (int i = 0; i < 16; ++i) matrix(i / 4, i % 4) = cursor.F64("the matrix of a transform");
  cursor.End("the matrix of a transform");
  Point3 translation = matrix.row(3).head<3>();
  matrix.row(3).head<3>().setZero();
  if (frame != 0 || !matrix.isIdentity(0) || !translation.allFinite()) {
    cursor.Fail(at, "an osg::MatrixTransform that does more than translate is not supported");
  }
  return translation;
}

// Children come before the matrix: moves what they added.
void ReadMatrixTransform(OsgbParse& parse, const Inherited& inherited) {
  OsgbFile& file = parse.layout.file;
  const size_t points = file.points.size();
  const size_t geodes = file.geodes.size();
  const size_t lods = file.paged_lods.size();
  ReadChildren(parse, inherited);
  const Point3 translation = ReadTranslation(parse.cursor);
  if (!parse.cursor.ok() || translation.isZero(0)) return;
  for (size_t i = points; i < file.points.size(); ++i) file.points[i] += translation;
  for (size_t i = geodes; i < file.geodes.size(); ++i) file.geodes[i].translation += translation;
  for (size_t i = lods; i < file.paged_lods.size(); ++i) file.paged_lods[i].center += translation;
}

void ReadNode(OsgbParse& parse, Inherited inherited, int32_t& geode) {
  OsgbCursor& cursor = parse.cursor;
  const OsgbHead head = BeginOsgbObject(parse);
  if (!cursor.ok() || head.class_name == "NULL") return;
  if (parse.depth > kMaxNodeDepth) return cursor.Fail(absl::StrCat("nodes are nested over ", kMaxNodeDepth, " deep"));
  if (head.is_done) {
    return cursor.Fail(absl::StrCat("an ", std::string(head.class_name), " with several parents is not supported"));
  }
  if (head.class_name == "osg::Geometry") {
    if (geode < 0) geode = AddGeode(parse.layout, inherited);
    ReadOsgbGeometry(parse, geode, inherited.look);
    return EndOsgbObject(parse, head, -1);
  }
  ReadOsgbObjectFields(parse);
  inherited.look = ReadOsgbNodeFields(parse, inherited.look);
  if (head.class_name == "osg::Geode") {
    ReadGeode(parse, inherited);
  } else if (head.class_name == "osg::Group") {
    ReadChildren(parse, inherited);
  } else if (head.class_name == "osg::PagedLOD") {
    ReadPagedLod(parse, inherited);
  } else if (head.class_name == "osg::MatrixTransform") {
    ReadMatrixTransform(parse, inherited);
  } else {
    return RefuseOsgbClass(parse, head.class_name);
  }
  EndOsgbObject(parse, head, -1);
}

void ReadHeader(OsgbParse& parse) {
  constexpr std::string_view kMagic("\xa1\x0e\x91\x6c\x45\x45\xfb\x1a", 8);
  constexpr uint32_t kScene = 1;
  constexpr uint32_t kBrackets = 4;
  OsgbCursor& cursor = parse.cursor;
  OsgbFile& file = parse.layout.file;
  if (cursor.bytes().size() > std::numeric_limits<int32_t>::max()) cursor.Fail("files over 2 GiB are not supported");
  if (cursor.Take(kMagic.size(), "the signature") != kMagic) {
    cursor.Fail(0, "expected the signature of a little-endian OSGB file");
  }
  if (cursor.U32("the kind of file") != kScene) cursor.Fail("expected a scene");
  file.version = cursor.U32("the version");
  if (file.version < kOsgbMinVersion || file.version > kOsgbMaxVersion) {
    cursor.Fail(absl::StrCat("version ", file.version, " is not supported; versions ", kOsgbMinVersion, " to ",
                             kOsgbMaxVersion, " are"));
  }
  const uint32_t attributes = cursor.U32("the attributes");
  if ((attributes & 1) != 0) cursor.Fail("versions of further libraries are not supported");
  if ((attributes & 2) != 0) cursor.Fail("schema data is not supported");
  if ((attributes & ~7u) != 0) cursor.Fail(absl::StrCat("the attributes ", attributes, " are not supported"));
  const std::string_view compressor = cursor.String("the compressor");
  if (compressor != "0") {
    cursor.Fail(absl::StrCat("the compressor ", std::string(compressor), " is not supported"));
  }
  file.has_brackets = (attributes & kBrackets) != 0;
  if (file.has_brackets) cursor.SetBracketBytes(file.version >= kOsgbLongBrackets ? 8 : 4);
}

}  // namespace

absl::StatusOr<OsgbLayout> ParseOsgb(std::string_view bytes, const std::string& name) {
  OsgbParse parse(bytes, name);
  ReadHeader(parse);
  int32_t geode = -1;
  ReadNode(parse, {}, geode);
  if (parse.cursor.remaining() != 0) {
    parse.cursor.Fail(absl::StrCat(parse.cursor.remaining(), " bytes follow the end of the scene"));
  }
  TILEMEND_RETURN_IF_ERROR(parse.cursor.status());
  parse.layout.brackets = parse.cursor.brackets();
  parse.layout.bracket_bytes = parse.cursor.bracket_bytes();
  return std::move(parse.layout);
}

absl::StatusOr<OsgbFile> ReadOsgb(std::string_view bytes, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(OsgbLayout layout, ParseOsgb(bytes, name));
  return std::move(layout.file);
}

}  // namespace tilemend
