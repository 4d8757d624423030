// OpenSceneGraph reads what the codec wrote.
#include <gtest/gtest.h>

#include <algorithm>

#include "common/codec/osgb/osgb_new.h"
#include "common/util/files.h"
#include "tests/common/codec/osgb/osgb_checks.h"
#include "tests/fuzz/osgb_property.h"
#include "tests/support/osgb_builder.h"
#include "tests/support/temporary_folder.h"

#ifdef TILEMEND_OSG
#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/LightModel>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/NodeVisitor>
#include <osg/PagedLOD>
#include <osg/ShadeModel>
#include <osg/TexEnv>
#include <osg/Texture2D>
#include <osg/TriangleIndexFunctor>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

namespace tilemend {
namespace {

class GeometryList : public osg::NodeVisitor {
 public:
  GeometryList() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
  void apply(osg::Geode& geode) override {
    for (unsigned i = 0; i < geode.getNumDrawables(); ++i) {
      if (osg::Geometry* const geometry = geode.getDrawable(i)->asGeometry()) geometries.push_back(geometry);
    }
  }
  std::vector<osg::Geometry*> geometries;
};

struct OsgScene {
  osg::ref_ptr<osg::Node> root;
  std::vector<osg::Geometry*> geometries;
};

OsgScene ReadWithOsg(const std::string& bytes) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.osgb";
  EXPECT_TRUE(WriteFileAtomically(path, bytes, Sync::kNo).ok());
  OsgScene scene{osgDB::readRefNodeFile(path), {}};
  GeometryList list;
  if (scene.root) scene.root->accept(list);
  scene.geometries = std::move(list.geometries);
  return scene;
}

// Whether OpenSceneGraph has the vertices and texture coordinates of geometry `index` of `file`, bit for bit.
void ExpectSameVertices(const OsgbFile& file, size_t index, const osg::Geometry& geometry) {
  const OsgbGeometry& own = file.geometries[index];
  const auto* const vertices = dynamic_cast<const osg::Vec3Array*>(geometry.getVertexArray());
  const auto* const uv = dynamic_cast<const osg::Vec2Array*>(geometry.getTexCoordArray(0));
  ASSERT_NE(vertices, nullptr);
  ASSERT_EQ(vertices->size(), static_cast<size_t>(own.vertex_count));
  for (size_t i = 0; i < vertices->size(); ++i) {
    const auto at = static_cast<size_t>(own.first_vertex) + i;
    const osg::Vec3f& v = (*vertices)[i];
    ASSERT_EQ(Point3(v.x(), v.y(), v.z()), file.points[at]) << index << " " << i;
    if (uv != nullptr) {
      ASSERT_EQ((std::array<float, 2>{(*uv)[i].x(), (*uv)[i].y()}), file.uv[at]) << index << " " << i;
    }
  }
}

Triangle SmallestFirst(Triangle triangle) {
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

struct TriangleList {
  void operator()(unsigned a, unsigned b, unsigned c) {
    triangles.push_back(SmallestFirst({static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(c)}));
  }
  std::vector<Triangle> triangles;
};

std::vector<Triangle> TrianglesOf(const osg::Geometry& geometry) {
  osg::TriangleIndexFunctor<TriangleList> list;
  geometry.accept(list);
  return list.triangles;
}

std::vector<Triangle> TrianglesOf(const OsgbFile& file, const OsgbGeometry& geometry) {
  std::vector<Triangle> triangles;
  for (int32_t k = 0; k < geometry.triangle_count; ++k) {
    Triangle triangle = file.triangles[static_cast<size_t>(geometry.first_triangle) + static_cast<size_t>(k)];
    for (int32_t& corner : triangle) corner -= geometry.first_vertex;
    triangles.push_back(SmallestFirst(triangle));
  }
  return triangles;
}

void ExpectSameGeometries(const std::string& bytes, const OsgScene& scene) {
  const absl::StatusOr<OsgbFile> file = ReadOsgb(bytes, "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_EQ(scene.geometries.size(), file->geometries.size());
  for (size_t i = 0; i < scene.geometries.size(); ++i) {
    ExpectSameVertices(*file, i, *scene.geometries[i]);
    EXPECT_EQ(TrianglesOf(*scene.geometries[i]), TrianglesOf(*file, file->geometries[i])) << i;
  }
}

const osg::Texture2D* TextureOf(const osg::Geometry& geometry) {
  if (geometry.getStateSet() == nullptr) return nullptr;
  return dynamic_cast<const osg::Texture2D*>(
      geometry.getStateSet()->getTextureAttribute(0, osg::StateAttribute::TEXTURE));
}

class OsgbOracleTest : public ::testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Versions, OsgbOracleTest, ::testing::ValuesIn(kOsgbVersions));

osg::ref_ptr<osg::Geometry> MakeGeometry() {
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  for (const osg::Vec3& v : {osg::Vec3(0, 0, 0), osg::Vec3(1, 0, 0), osg::Vec3(1, 1, 0.5F), osg::Vec3(0, 1, 0)}) {
    vertices->push_back(v);
  }
  osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array(4);
  osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array(1);
  geometry->setVertexArray(vertices);
  geometry->setTexCoordArray(0, new osg::Vec2Array(4));
  geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
  geometry->setColorArray(colours, osg::Array::BIND_OVERALL);
  const GLushort indices[] = {0, 1, 3, 2};
  geometry->addPrimitiveSet(new osg::DrawElementsUShort(GL_TRIANGLE_STRIP, 4, indices));
  geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
  osg::StateSet& state = *geometry->getOrCreateStateSet();
  state.setAttributeAndModes(new osg::Material);
  state.setAttributeAndModes(new osg::ShadeModel);
  state.setAttributeAndModes(new osg::CullFace);
  state.setAttributeAndModes(new osg::BlendFunc);
  state.setAttributeAndModes(new osg::LightModel);
  state.setTextureAttributeAndModes(0, new osg::TexEnv);
  osg::ref_ptr<osg::Image> image = new osg::Image;
  image->allocateImage(4, 4, 1, GL_RGB, GL_UNSIGNED_BYTE);
  state.setTextureAttributeAndModes(0, new osg::Texture2D(image));
  return geometry;
}

// A group with a translated PagedLOD, as OpenSceneGraph writes it.
std::string WriteWithOsg(uint32_t version) {
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->setName("a geode");
  geode->addDescription("a description");
  geode->setInitialBound(osg::BoundingSphere({0, 0, 0}, 5));
  geode->addDrawable(MakeGeometry());
  geode->addDrawable(MakeGeometry());
  osg::ref_ptr<osg::PagedLOD> lod = new osg::PagedLOD;
  lod->setCenter({1, 2, 3});
  lod->setRadius(7);
  lod->addChild(geode, 0, 100);
  lod->setFileName(1, "finer.osgb");
  lod->setRange(1, 100, 1e30F);
  lod->setDatabasePath("some/folder/");
  osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(osg::Matrix::translate(1000, 0, 0));
  transform->addChild(lod);
  osg::ref_ptr<osg::Group> root = new osg::Group;
  root->addChild(transform);
  osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
  options->setPluginStringData("TargetFileVersion", std::to_string(version));
  options->setPluginStringData("WriteImageHint", "IncludeData");
  const TemporaryFolder folder;
  EXPECT_TRUE(osgDB::writeNodeFile(*root, folder / "a.osgb", options));
  return *ReadFile(folder / "a.osgb");
}

TEST_P(OsgbOracleTest, IsReadByTheCodec) {
  const std::string bytes = WriteWithOsg(GetParam());
  const absl::StatusOr<OsgbFile> file = ReadOsgb(bytes, "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->version, GetParam());
  ASSERT_EQ(file->geometries.size(), 2u);
  EXPECT_EQ(file->points[6], Point3(1001, 1, 0.5));
  EXPECT_EQ(file->geometries[1].triangle_count, 3);
  EXPECT_EQ(file->geometries[1].texture, 1);
  EXPECT_EQ(file->images[1].size, 48u);
  ASSERT_EQ(file->paged_lods.size(), 1u);
  EXPECT_EQ(file->paged_lods[0].center, Point3(1001, 2, 3));
  EXPECT_EQ(file->paged_lods[0].children.at(1).file, "finer.osgb");
  EXPECT_EQ(OsgbPropertyViolation(bytes), "");
}

TEST_P(OsgbOracleTest, ReadsTheSameOfTestFiles) {
  const std::string bytes = BuiltOsgbScene(GetParam());
  ExpectSameGeometries(bytes, ReadWithOsg(bytes));
}

TEST_P(OsgbOracleTest, ReadsAppendedGeometry) {
  OsgbPatch plain = OsgbTriangle(1);
  plain.image.clear();
  plain.colour = {255, 51, 0};
  const std::vector<OsgbPatch> patches = {OsgbTriangle(0), plain};
  const absl::StatusOr<std::string> bytes = AppendOsgb(BuiltOsgbScene(GetParam()), patches, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const OsgScene scene = ReadWithOsg(*bytes);
  ASSERT_EQ(scene.geometries.size(), 5u);
  ExpectSameGeometries(*bytes, scene);
  EXPECT_EQ(TextureOf(*scene.geometries[4]), nullptr);
  const auto* const material = dynamic_cast<const osg::Material*>(
      scene.geometries[4]->getStateSet()->getAttribute(osg::StateAttribute::MATERIAL));
  ASSERT_NE(material, nullptr);
  EXPECT_EQ(material->getDiffuse(osg::Material::FRONT), osg::Vec4(1, 0.2F, 0, 1));
  const auto* const colours = dynamic_cast<const osg::Vec4Array*>(scene.geometries[4]->getColorArray());
  ASSERT_NE(colours, nullptr);
  EXPECT_EQ(colours->getBinding(), osg::Array::BIND_OVERALL);
  EXPECT_EQ(colours->at(0), osg::Vec4(1, 0.2F, 0, 1));
  ASSERT_NE(TextureOf(*scene.geometries[2]), nullptr);
  EXPECT_EQ(TextureOf(*scene.geometries[2])->getWrap(osg::Texture::WRAP_S), osg::Texture::CLAMP_TO_EDGE);
}

TEST(OsgbOracleNewTest, ReadsANewFile) {
  OsgbNode coarse{{OsgbTriangle()}, "a_L1_0.osgb", {1, 2, 3}, 7, 300};
  OsgbPatch plain = OsgbTriangle();
  plain.image.clear();
  plain.colour = {255, 51, 0};
  const std::vector<OsgbNode> nodes = {coarse, {{plain, OsgbTriangle()}, "", Point3::Zero(), 0, 0}};
  const absl::StatusOr<std::string> bytes = NewOsgb(nodes, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const OsgScene scene = ReadWithOsg(*bytes);
  ASSERT_EQ(scene.geometries.size(), 3u);
  ExpectSameGeometries(*bytes, scene);
  EXPECT_NE(TextureOf(*scene.geometries[0]), nullptr);
  EXPECT_EQ(TextureOf(*scene.geometries[1]), nullptr);
  const auto* const group = dynamic_cast<const osg::Group*>(scene.root.get());
  ASSERT_NE(group, nullptr);
  ASSERT_EQ(group->getNumChildren(), 2u);
  const auto* const lod = dynamic_cast<const osg::PagedLOD*>(group->getChild(0));
  ASSERT_NE(lod, nullptr);
  EXPECT_EQ(lod->getFileName(1), "a_L1_0.osgb");
  EXPECT_EQ(lod->getRangeMode(), osg::LOD::PIXEL_SIZE_ON_SCREEN);
  EXPECT_EQ(lod->getCenter(), osg::Vec3(1, 2, 3));
  EXPECT_EQ(lod->getRadius(), 7);
  EXPECT_EQ(lod->getMaxRange(0), 300);
  EXPECT_EQ(lod->getMinRange(1), 300);
  const absl::StatusOr<OsgbFile> file = ReadOsgb(*bytes, "a.osgb");
  EXPECT_EQ(bytes->substr(file->images.at(0).offset, file->images[0].size), OsgbTriangle().image);
  EXPECT_EQ(OsgbPropertyViolation(*bytes), "");
}

TEST_P(OsgbOracleTest, ReadsAFileWithoutSomeTriangles) {
  const absl::StatusOr<std::string> bytes =
      DropOsgbTriangles(BuiltOsgbScene(GetParam()), {true, false, true, true, false, false}, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const OsgScene scene = ReadWithOsg(*bytes);
  ASSERT_EQ(scene.geometries.size(), 3u);
  EXPECT_EQ(TrianglesOf(*scene.geometries[0]).size(), 1u);
  EXPECT_TRUE(TrianglesOf(*scene.geometries[1]).empty());
  ExpectSameGeometries(*bytes, scene);
}

// The geometries of a file as those of a new one.
OsgbNode NodeOf(const OsgbFile& file, const std::string& bytes) {
  OsgbNode node;
  for (const OsgbGeometry& geometry : file.geometries) {
    OsgbPatch& patch = node.geometries.emplace_back();
    const auto points = file.points.begin() + geometry.first_vertex;
    const auto uv = file.uv.begin() + geometry.first_vertex;
    patch.points.assign(points, points + geometry.vertex_count);
    patch.uv.assign(uv, uv + geometry.vertex_count);
    for (int32_t k = 0; k < geometry.triangle_count; ++k) {
      Triangle triangle = file.triangles[static_cast<size_t>(geometry.first_triangle + k)];
      for (int32_t& corner : triangle) corner -= geometry.first_vertex;
      patch.triangles.push_back(triangle);
    }
    const OsgbImage& image = file.images.at(static_cast<size_t>(geometry.texture));
    patch.image = bytes.substr(image.offset, image.size);
    patch.image_name = "a.jpg";
  }
  return node;
}

TEST(OsgbOracleExportTest, ReadsAnExportWrittenAnew) {
  if (SharedOsgbFiles().empty()) GTEST_SKIP() << kNoSharedOsgb;
  const absl::StatusOr<std::string> original = ReadFile(SharedOsgbFiles().back().string());
  ASSERT_TRUE(original.ok()) << original.status();
  const OsgbFile was = *ReadOsgb(*original, "a.osgb");
  const OsgbNode node = NodeOf(was, *original);
  const absl::StatusOr<std::string> bytes = NewOsgb({&node, 1}, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const OsgbFile is = *ReadOsgb(*bytes, "a.osgb");
  EXPECT_EQ(is.points, was.points);
  EXPECT_EQ(is.uv, was.uv);
  EXPECT_EQ(is.triangles, was.triangles);
  const OsgScene scene = ReadWithOsg(*bytes);
  ExpectSameGeometries(*bytes, scene);
  for (size_t g = 0; g < scene.geometries.size(); ++g) {
    const OsgbImage& image = is.images.at(static_cast<size_t>(is.geometries[g].texture));
    EXPECT_EQ(bytes->substr(image.offset, image.size), node.geometries[g].image);
    ASSERT_NE(TextureOf(*scene.geometries[g]), nullptr);
    EXPECT_GT(TextureOf(*scene.geometries[g])->getImage()->s(), 0);
  }
}

// The image of the file's first texture, as new geometry's: OpenSceneGraph decodes both.
TEST(OsgbOracleExportTest, DecodesTheImagesOfAnEditedExport) {
  if (SharedOsgbFiles().empty()) GTEST_SKIP() << kNoSharedOsgb;
  const absl::StatusOr<std::string> original = ReadFile(SharedOsgbFiles().front().string());
  ASSERT_TRUE(original.ok()) << original.status();
  const absl::StatusOr<OsgbFile> file = ReadOsgb(*original, "a.osgb");
  ASSERT_TRUE(file.ok()) << file.status();
  OsgbPatch patch = OsgbTriangle();
  patch.image = original->substr(file->images.at(0).offset, file->images[0].size);
  const absl::StatusOr<std::string> bytes = AppendOsgb(*original, std::vector{patch}, "a.osgb");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const OsgScene scene = ReadWithOsg(*bytes);
  ASSERT_EQ(scene.geometries.size(), 2u);
  ExpectSameGeometries(*bytes, scene);
  for (const osg::Geometry* const geometry : scene.geometries) {
    ASSERT_NE(TextureOf(*geometry), nullptr);
    ASSERT_NE(TextureOf(*geometry)->getImage(), nullptr);
    EXPECT_EQ(TextureOf(*geometry)->getImage()->s(), 1024);
  }
}

}  // namespace
}  // namespace tilemend
#else
TEST(OsgbOracleTest, IsThere) {
  GTEST_SKIP() << "NO OPENSCENEGRAPH: what the codec writes is not read by it; install libopenscenegraph-dev";
}
#endif
