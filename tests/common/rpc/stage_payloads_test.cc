// What the stages send: bit for bit there and back, and nothing accepted that would be read out of bounds.
#include "common/rpc/stage_payloads.h"

#include <gmock/gmock.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/stubs/logging.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace tilemend {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

// Three boundary vertices far from the origin, the third doubled by nothing, and a band with two more points.
SurveyRecord SomeRecord() {
  SurveyRecord record;
  record.vertex_count = 90;
  record.triangle_count = 170;
  record.doubled_vertices = 2;
  record.degenerate_triangles = 3;
  record.nonmanifold_edges = 4;
  record.float32 = false;
  record.lo = {100.1, -2000.7, 0.3};
  record.hi = {350.9, -1750.2, 77.123456789012345};
  const std::vector<Point3> positions = {{100.1, -2000.7, 1.0 / 3}, {110.25, -1999.9, 5e-324}, {120.7, -1990.3, -0.0}};
  for (int i = 0; i < 3; ++i) {
    BoundaryVertex v;
    v.index = 30 * i;
    v.position = positions[i];
    v.normal = {0, 0.6F, 0.8F};
    v.centroid_height = 0.1 * i;
    record.vertices.push_back(v);
    record.edges.push_back({i, (i + 1) % 3});
    record.band.points.push_back(v.position);
  }
  record.band.points.emplace_back(105.5, -1995.25, 2.0009765625);  // on the lattice of 2^-10
  record.band.points.emplace_back(111.1, -1994.4, 3.3);            // not on it
  record.band.triangles = {{0, 1, 3}, {1, 2, 4}, {3, 4, 0}};
  record.colours = {Rgb{0, 0, 0}, std::nullopt, Rgb{255, 128, 1}};
  return record;
}

CellHoles SomeHoles() {
  CellHoles holes;
  holes.cell = {3, -2};
  holes.float32 = true;
  holes.lattice_step = 0x1p-8;
  for (int i = 0; i < 4; ++i) {
    RimVertex v;
    v.tile = {3 - i % 2, -2};
    v.index = i < 2 ? i : -1;
    v.seam_vertex = i < 2 ? -1 : i;
    v.lines = static_cast<uint8_t>(i);
    v.position = {1.1 * i, 2.2 + 0.1 * (i % 2), 1.0 / (3 + i)};
    v.height_known = i != 3;
    v.centroid_height = 0.7 * i;
    v.size = 1.3 + i;
    holes.vertices.push_back(v);
    holes.band.points.push_back(v.position);
  }
  holes.holes = {{.id = 7,
                  .open = true,
                  .segments = {{0, 1, false}, {1, 2, true}, {2, 0, true}},
                  .slope = {0.7, -0.2},
                  .tension = 0.1},
                 {.id = 9, .segments = {{3, 2, false}}, .level = 12.25}};
  holes.holes[0].inner_edges = {{2, 3, true}, {3, 1, true}};
  holes.band.points.emplace_back(-1, -1, -1);
  holes.band.triangles = {{0, 1, 4}, {2, 3, 4}};
  return holes;
}

std::vector<HolePatch> SomePatches() {
  HolePatch filled{.hole = 7,
                   .new_points = {{0.5, 0.25, 0.125}, {0.1, 0.2, 0.3}, {1e-9, 2, 3}},
                   .triangles = {{0, 1, -1}, {-1, -2, -3}, {2, 0, -3}},
                   .hold_out = HoldOut{0.1, 0.2, 0.3, 4}};
  HolePatch left{.hole = 8, .failure = "too wild"};
  HolePatch other{.hole = 9, .new_points = {{3.5, 1.0 / 3, 7}}, .triangles = {{3, 2, -1}}};
  return {filled, left, other};
}

std::string Bits(const Point3& p) { return std::string(reinterpret_cast<const char*>(p.data()), 3 * sizeof(double)); }

TEST(StagePayloadsTest, SurveyRecordsComeBackBitForBit) {
  const SurveyRecord record = SomeRecord();
  const auto back = FromProto(ToProto(record));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->vertex_count, record.vertex_count);
  EXPECT_EQ(back->triangle_count, record.triangle_count);
  EXPECT_EQ(back->doubled_vertices, record.doubled_vertices);
  EXPECT_EQ(back->degenerate_triangles, record.degenerate_triangles);
  EXPECT_EQ(back->nonmanifold_edges, record.nonmanifold_edges);
  EXPECT_EQ(back->float32, record.float32);
  EXPECT_EQ(Bits(back->lo), Bits(record.lo));
  EXPECT_EQ(Bits(back->hi), Bits(record.hi));
  ASSERT_EQ(back->vertices.size(), record.vertices.size());
  for (size_t i = 0; i < record.vertices.size(); ++i) {
    EXPECT_EQ(back->vertices[i].index, record.vertices[i].index);
    EXPECT_EQ(Bits(back->vertices[i].position), Bits(record.vertices[i].position));
    EXPECT_EQ(Bits(back->vertices[i].normal), Bits(record.vertices[i].normal));  // they are float32 here
    EXPECT_EQ(back->vertices[i].centroid_height, record.vertices[i].centroid_height);
    EXPECT_EQ(back->edges[i].from, record.edges[i].from);
    EXPECT_EQ(back->edges[i].to, record.edges[i].to);
  }
}

TEST(StagePayloadsTest, TheBandKeepsItsTrianglesAndRoundsOnlyInnerPoints) {
  const SurveyRecord record = SomeRecord();
  const auto back = FromProto(ToProto(record));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->band.triangles, record.band.triangles);
  ASSERT_EQ(back->band.points.size(), 5U);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(Bits(back->band.points[i]), Bits(record.band.points[i])) << i;
  EXPECT_LE((back->band.points[4] - record.band.points[4]).cwiseAbs().maxCoeff(), 0x1p-11);
}

TEST(StagePayloadsTest, ARecordWithoutVerticesComesBackEmpty) {
  SurveyRecord record;
  record.lo = Point3::Constant(std::numeric_limits<double>::infinity());
  record.hi = -record.lo;
  const auto back = FromProto(ToProto(record));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_GT(back->lo.x(), back->hi.x());
  EXPECT_TRUE(back->band.points.empty());
}

TEST(StagePayloadsTest, CellHolesComeBackBitForBit) {
  const CellHoles holes = SomeHoles();
  const auto back = FromProto(ToProto(holes));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->cell, holes.cell);
  EXPECT_EQ(back->float32, holes.float32);
  EXPECT_EQ(back->lattice_step, holes.lattice_step);
  ASSERT_EQ(back->vertices.size(), holes.vertices.size());
  for (size_t i = 0; i < holes.vertices.size(); ++i) {
    const RimVertex &a = back->vertices[i], &b = holes.vertices[i];
    EXPECT_EQ(a.tile, b.tile);
    EXPECT_EQ(a.index, b.index);
    EXPECT_EQ(a.seam_vertex, b.seam_vertex);
    EXPECT_EQ(a.lines, b.lines);
    EXPECT_EQ(Bits(a.position), Bits(b.position));
    EXPECT_EQ(a.height_known, b.height_known);
    EXPECT_EQ(a.centroid_height, b.centroid_height);
    EXPECT_EQ(a.size, b.size);
    EXPECT_EQ(Bits(back->band.points[i]), Bits(b.position));
  }
  ASSERT_EQ(back->holes.size(), 2U);
  EXPECT_EQ(back->holes[0].id, 7);
  EXPECT_EQ(back->holes[0].level, std::nullopt);
  EXPECT_EQ(back->holes[1].level, 12.25);
  EXPECT_TRUE(back->holes[0].open);
  ASSERT_EQ(back->holes[0].segments.size(), 3U);
  EXPECT_EQ(back->holes[0].segments[2].to, 0);
  EXPECT_TRUE(back->holes[0].segments[2].seam);
  ASSERT_EQ(back->holes[0].inner_edges.size(), 2U);
  EXPECT_EQ(back->holes[0].inner_edges[1].from, 3);
  EXPECT_EQ(back->holes[0].inner_edges[1].to, 1);
  EXPECT_TRUE(back->holes[1].inner_edges.empty());
  EXPECT_EQ(back->holes[0].slope, Point2(0.7, -0.2));
  EXPECT_EQ(back->holes[1].slope, Point2(0, 0));
  EXPECT_EQ(back->holes[0].tension, 0.1);
  EXPECT_EQ(back->holes[1].tension, std::nullopt);
  EXPECT_EQ(back->band.triangles, holes.band.triangles);
}

TEST(StagePayloadsTest, TensionsAndSlopesThatNobodyChoseAreMalformed) {
  v1::CellHolesBlob holes = ToProto(SomeHoles());
  holes.mutable_holes(0)->set_tension(-1);
  EXPECT_EQ(FromProto(holes).status().code(), absl::StatusCode::kInvalidArgument);
  holes.mutable_holes(0)->set_tension(0);
  EXPECT_TRUE(FromProto(holes).ok());
  holes.mutable_holes(0)->set_slope_y(std::nan(""));
  EXPECT_EQ(FromProto(holes).status().code(), absl::StatusCode::kInvalidArgument);
}

TEST(StagePayloadsTest, AQualityTallyComesBackTheSame) {
  QualityTally tally;
  tally.Add(0.125, true);
  tally.Add(0.875, false);
  const auto back = FromProto(ToProto(tally));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->triangles, 2);
  EXPECT_EQ(back->sum_millionths, tally.sum_millionths);
  EXPECT_EQ(back->least, 0.125);
  EXPECT_EQ(back->histogram, tally.histogram);
  EXPECT_EQ(back->poor, 1);
  EXPECT_EQ(back->poor_forced, 1);
}

TEST(StagePayloadsTest, AQualityTallyOfOtherBinsIsRefused) {
  v1::QualityTally proto = ToProto(QualityTally());
  proto.add_histogram(1);
  EXPECT_EQ(FromProto(proto).status().code(), absl::StatusCode::kInvalidArgument);
}

TEST(StagePayloadsTest, PatchesComeBackBitForBitAlsoOffTheLattice) {
  const std::vector<RimVertex> rim = SomeHoles().vertices;
  const std::vector<HolePatch> patches = SomePatches();
  const v1::FillOutput proto = ToProto(patches, rim, 0x1p-8);
  EXPECT_GT(proto.off_lattice_size(), 0);
  const auto back = FromProto(proto, rim.size());
  ASSERT_TRUE(back.ok()) << back.status();
  ASSERT_EQ(back->size(), patches.size());
  for (size_t i = 0; i < patches.size(); ++i) {
    EXPECT_EQ((*back)[i].hole, patches[i].hole);
    EXPECT_EQ((*back)[i].failure, patches[i].failure);
    EXPECT_EQ((*back)[i].triangles, patches[i].triangles);
    ASSERT_EQ((*back)[i].new_points.size(), patches[i].new_points.size());
    for (size_t k = 0; k < patches[i].new_points.size(); ++k)
      EXPECT_EQ(Bits((*back)[i].new_points[k]), Bits(patches[i].new_points[k])) << i << " " << k;
  }
}

TEST(StagePayloadsTest, NoPatchesAreAPayload) {
  const auto back = FromProto(ToProto(std::vector<HolePatch>(), {}, 1), 0);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_TRUE(back->empty());
}

// Calls `check` with each copy of `message` in which one repeated field, at any depth, has lost its last entry.
void ForEachTruncation(const Message& message,
                       const std::function<void(const Message& damaged, const std::string& field)>& check) {
  const auto* reflection = message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection->ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (field->is_repeated()) {
      const std::unique_ptr<Message> copy(message.New());
      copy->CopyFrom(message);
      reflection->RemoveLast(copy.get(), field);
      check(*copy, field->full_name());
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      ForEachTruncation(reflection->GetMessage(message, field), [&](const Message& part, const std::string& name) {
        const std::unique_ptr<Message> copy(message.New());
        copy->CopyFrom(message);
        reflection->MutableMessage(copy.get(), field)->CopyFrom(part);
        check(*copy, name);
      });
    }
  }
}

template <typename Proto, typename Decode>
int CountTruncations(const Proto& proto, const std::vector<std::string>& harmless, const Decode& decode) {
  int count = 0;
  ForEachTruncation(proto, [&](const Message& damaged, const std::string& name) {
    ++count;
    const bool accepted = decode(static_cast<const Proto&>(damaged));
    EXPECT_EQ(accepted, std::find(harmless.begin(), harmless.end(), name) != harmless.end()) << name;
  });
  return count;
}

TEST(StagePayloadsTest, ATruncatedColumnIsRefused) {
  const auto decode = [](const auto& proto) { return FromProto(proto).ok(); };
  EXPECT_EQ(CountTruncations(ToProto(SomeRecord()), {}, decode), 9);
  // One hole less is a message as well; so is one segment less, which takes an entry of every column.
  EXPECT_EQ(CountTruncations(ToProto(SomeHoles()), {"tilemend.v1.CellHolesBlob.holes"}, decode), 13);
  const v1::FillOutput patches = ToProto(SomePatches(), SomeHoles().vertices, 0x1p-8);
  EXPECT_EQ(CountTruncations(patches, {}, [](const auto& proto) { return FromProto(proto, 4).ok(); }), 4);
}

// Found by fuzzing: a lattice of finite numbers whose points are none.
TEST(StagePayloadsTest, PointsBeyondAllNumbersAreRefused) {
  for (const double step : {1e308, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    v1::SurveyOutput survey = ToProto(SomeRecord());
    survey.mutable_band()->set_step(step);
    EXPECT_FALSE(FromProto(survey).ok()) << step;
  }
  v1::SurveyOutput survey = ToProto(SomeRecord());
  survey.mutable_band()->set_origin(1, 1e308);
  EXPECT_FALSE(FromProto(survey).ok());
  survey = ToProto(SomeRecord());
  survey.mutable_vertices()->set_position(2, 1e300);
  EXPECT_FALSE(FromProto(survey).ok());
}

TEST(StagePayloadsTest, TruncatedSegmentsAreRefused) {
  for (const char* column : {"from", "to", "seam", "inner_from", "inner_to"}) {
    v1::CellHolesBlob proto = ToProto(SomeHoles());
    v1::HoleBoundary* hole = proto.mutable_holes(0);
    v1::HoleBoundary::GetReflection()->RemoveLast(hole, v1::HoleBoundary::GetDescriptor()->FindFieldByName(column));
    EXPECT_FALSE(FromProto(proto).ok()) << column;
  }
  v1::CellHolesBlob proto = ToProto(SomeHoles());
  proto.mutable_holes(0)->clear_from();
  proto.mutable_holes(0)->clear_to();
  proto.mutable_holes(0)->clear_seam();
  EXPECT_FALSE(FromProto(proto).ok());
}

TEST(StagePayloadsTest, IndicesOutOfRangeAreRefused) {
  for (const int32_t bad : {-1, 3, 1 << 30}) {
    v1::SurveyOutput record = ToProto(SomeRecord());
    record.set_edges(2, bad);
    EXPECT_FALSE(FromProto(record).ok()) << bad;
  }
  for (const int32_t bad : {-1, 90, 1 << 30}) {
    v1::SurveyOutput record = ToProto(SomeRecord());
    record.mutable_vertices()->set_index(1, bad);
    EXPECT_FALSE(FromProto(record).ok()) << bad;
  }
  for (const int32_t bad : {-1, 4}) {
    v1::CellHolesBlob holes = ToProto(SomeHoles());
    holes.mutable_holes(0)->set_to(0, bad);
    EXPECT_FALSE(FromProto(holes).ok()) << bad;
    holes = ToProto(SomeHoles());
    holes.mutable_holes(0)->set_inner_from(1, bad);
    EXPECT_FALSE(FromProto(holes).ok()) << bad;
  }
  for (const int64_t bad : {int64_t{-1}, int64_t{4}, int64_t{1} << 40}) {
    v1::FillOutput patches = ToProto(SomePatches(), SomeHoles().vertices, 0x1p-8);
    patches.set_off_lattice(0, bad);
    EXPECT_FALSE(FromProto(patches, 4).ok()) << bad;
  }
}

TEST(StagePayloadsTest, AnotherNumberOfRimVerticesIsRefused) {
  const v1::FillOutput patches = ToProto(SomePatches(), SomeHoles().vertices, 0x1p-8);
  for (const size_t count : {size_t{0}, size_t{3}, size_t{5}, size_t{1} << 40})
    EXPECT_FALSE(FromProto(patches, count).ok()) << count;
}

TEST(StagePayloadsTest, PatchesThatReachIntoAnotherAreRefused) {
  v1::FillOutput patches = ToProto(SomePatches(), SomeHoles().vertices, 0x1p-8);
  patches.mutable_patches(0)->set_new_points(2);
  patches.mutable_patches(2)->set_new_points(2);
  EXPECT_FALSE(FromProto(patches, 4).ok());
  patches.mutable_patches(0)->set_new_points(-1);
  patches.mutable_patches(2)->set_new_points(5);
  EXPECT_FALSE(FromProto(patches, 4).ok());
}

TEST(StagePayloadsTest, PositionsThatAreNotFiniteAreRefused) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    v1::SurveyOutput record = ToProto(SomeRecord());
    record.mutable_vertices()->set_position(4, bad);
    EXPECT_FALSE(FromProto(record).ok());
    record = ToProto(SomeRecord());
    record.mutable_band()->set_origin(0, bad);
    EXPECT_FALSE(FromProto(record).ok());
    v1::CellHolesBlob holes = ToProto(SomeHoles());
    holes.mutable_vertices()->set_position(0, bad);
    EXPECT_FALSE(FromProto(holes).ok());
    holes = ToProto(SomeHoles());
    holes.set_lattice_step(bad);
    EXPECT_FALSE(FromProto(holes).ok());
    v1::FillOutput patches = ToProto(SomePatches(), SomeHoles().vertices, 0x1p-8);
    patches.set_off_lattice_position(0, bad);
    EXPECT_FALSE(FromProto(patches, 4).ok());
  }
}

// Every value of an accepted message can be used: the indices are in range.
void ExpectUsable(const CellHoles& holes) {
  for (const CellHole& hole : holes.holes) {
    for (const RimSegment& s : hole.segments) {
      EXPECT_LT(static_cast<size_t>(s.from), holes.vertices.size());
      EXPECT_LT(static_cast<size_t>(s.to), holes.vertices.size());
    }
  }
  for (const Triangle& t : holes.band.triangles) {
    for (const int32_t corner : t) EXPECT_LT(static_cast<size_t>(corner), holes.band.points.size());
  }
}

void ExpectUsable(const SurveyRecord& record) {
  EXPECT_GE(record.band.points.size(), record.vertices.size());
  for (const BoundaryEdge& e : record.edges) {
    EXPECT_LT(static_cast<size_t>(e.from), record.vertices.size());
    EXPECT_LT(static_cast<size_t>(e.to), record.vertices.size());
  }
}

void ExpectUsable(const std::vector<HolePatch>& patches) {
  for (const HolePatch& patch : patches) {
    for (const Triangle& t : patch.triangles) {
      for (const int32_t corner : t) {
        EXPECT_LT(corner, 4);
        EXPECT_LE(-1 - corner, static_cast<int32_t>(patch.new_points.size()) - 1);
      }
    }
  }
}

// Replaces, removes or doubles a few bytes.
std::string Mutate(std::string bytes, std::mt19937& random) {
  for (int n = 1 + static_cast<int>(random() % 3); n > 0 && !bytes.empty(); --n) {
    const size_t at = random() % bytes.size();
    switch (random() % 4) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        break;
      case 2:
        bytes.erase(at, 1 + random() % 8);
        break;
      default:
        bytes.insert(at, bytes.substr(random() % bytes.size(), 1 + random() % 8));
    }
  }
  return bytes;
}

TEST(StagePayloadsTest, DamagedBytesAreRefusedOrUsable) {
  const std::string record = ToProto(SomeRecord()).SerializeAsString();
  const std::string holes = ToProto(SomeHoles()).SerializeAsString();
  const std::string patches = ToProto(SomePatches(), SomeHoles().vertices, 0x1p-8).SerializeAsString();
  const google::protobuf::LogSilencer silence;  // damaged texts are no UTF-8
  std::mt19937 random(1);
  int accepted = 0;
  for (int i = 0; i < 6000; ++i) {
    v1::SurveyOutput r;
    v1::CellHolesBlob h;
    v1::FillOutput p;
    if (r.ParseFromString(Mutate(record, random))) {
      if (const auto value = FromProto(r); value.ok()) ExpectUsable(*value), ++accepted;
    }
    if (h.ParseFromString(Mutate(holes, random))) {
      if (const auto value = FromProto(h); value.ok()) ExpectUsable(*value), ++accepted;
    }
    if (p.ParseFromString(Mutate(patches, random))) {
      if (const auto value = FromProto(p, 4); value.ok()) ExpectUsable(*value), ++accepted;
    }
  }
  EXPECT_GT(accepted, 100);  // else the damage was too great to tell anything
}

}  // namespace
}  // namespace tilemend
