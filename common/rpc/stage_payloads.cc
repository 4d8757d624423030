#include "common/rpc/stage_payloads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/draco_mesh.h"
#include "common/mesh/rounding.h"
#include "common/rpc/ground_payloads.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/surface_payloads.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr double kFinestStep = 0x1p-10;  // metres
constexpr double kMostSteps = 0x1p28;  // of a mesh's extent, so that lattice coordinates fit 32 bits with room to spare

absl::Status Malformed(const char* what) {
  return absl::InvalidArgumentError(absl::StrCat("malformed payload: ", what));
}

template <typename Repeated>
void AddPoint(const Point3& p, Repeated* out) {
  for (int k = 0; k < 3; ++k) out->Add(static_cast<typename Repeated::value_type>(p[k]));
}

template <typename Repeated>
Point3 PointAt(const Repeated& values, int i) {
  return {static_cast<double>(values[3 * i]), static_cast<double>(values[3 * i + 1]),
          static_cast<double>(values[3 * i + 2])};
}

// A lattice that holds the mesh: step at least `finest`, origin at a multiple of it.
v1::LatticeMeshBlob EncodeMesh(const std::vector<Point3>& points, const std::vector<Triangle>& triangles,
                               double finest) {
  v1::LatticeMeshBlob blob;
  Point3 lo = points.empty() ? Point3::Zero() : points[0], hi = lo;
  for (const Point3& p : points) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  double step = finest;
  while ((hi - lo).maxCoeff() / step > kMostSteps) step *= 2;
  const Point3 origin = (lo / step).array().floor().matrix() * step;
  AddPoint(origin, blob.mutable_origin());
  blob.set_step(step);
  LatticeMesh mesh;
  mesh.points.reserve(points.size());
  for (const Point3& p : points) {
    std::array<int32_t, 3> q;
    for (int k = 0; k < 3; ++k) q[k] = static_cast<int32_t>(std::llround((p[k] - origin[k]) / step));
    mesh.points.push_back(q);
  }
  mesh.triangles = triangles;
  blob.set_draco(EncodeDraco(mesh));
  return blob;
}

// Whether a point lies where sums and differences of coordinates are numbers. Tiles keep much closer to the origin.
bool IsPlace(const Point3& p) {
  constexpr double kFarthest = 0x1p60;  // metres
  return p.allFinite() && p.cwiseAbs().maxCoeff() <= kFarthest;
}

absl::StatusOr<TriMesh> DecodeMesh(const v1::LatticeMeshBlob& blob) {
  if (blob.origin_size() != 3 || !IsPlace(PointAt(blob.origin(), 0)) || !(blob.step() > 0)) {
    return Malformed("lattice");
  }
  TILEMEND_ASSIGN_OR_RETURN(LatticeMesh mesh, DecodeDraco(blob.draco(), DracoLimits()));
  TriMesh result;
  const Point3 origin = PointAt(blob.origin(), 0);
  result.points.reserve(mesh.points.size());
  for (const auto& q : mesh.points) {
    result.points.emplace_back(origin.x() + q[0] * blob.step(), origin.y() + q[1] * blob.step(),
                               origin.z() + q[2] * blob.step());
    if (!IsPlace(result.points.back())) return Malformed("lattice");
  }
  result.triangles = std::move(mesh.triangles);
  return result;
}

// Whether all values are in [0, end).
template <typename Repeated>
bool AllBelow(const Repeated& values, int64_t end) {
  return std::all_of(values.begin(), values.end(), [end](int64_t v) { return v >= 0 && v < end; });
}

}  // namespace

v1::SurveyOutput ToProto(const SurveyRecord& record) {
  v1::SurveyOutput proto;
  proto.set_vertex_count(record.vertex_count);
  proto.set_triangle_count(record.triangle_count);
  proto.set_doubled_vertices(record.doubled_vertices);
  proto.set_degenerate_triangles(record.degenerate_triangles);
  proto.set_nonmanifold_edges(record.nonmanifold_edges);
  proto.set_float32(record.float32);
  if (record.vertex_count > 0) {
    AddPoint(record.lo, proto.mutable_bounds());
    AddPoint(record.hi, proto.mutable_bounds());
  }
  v1::BoundaryVertices* vertices = proto.mutable_vertices();
  for (const BoundaryVertex& v : record.vertices) {
    vertices->add_index(v.index);
    AddPoint(v.position, vertices->mutable_position());
    AddPoint(v.normal, vertices->mutable_normal());
    vertices->add_centroid_height(v.centroid_height);
  }
  for (const std::optional<Rgb>& colour : record.colours) vertices->add_colour(ColourToProto(colour));
  for (const BoundaryEdge& e : record.edges) {
    proto.add_edges(e.from);
    proto.add_edges(e.to);
    proto.add_pieces(e.piece);
  }
  *proto.mutable_band() = EncodeMesh(record.band.points, record.band.triangles, kFinestStep);
  if (!record.lowest.empty()) *proto.mutable_lowest() = ToProto(record.lowest);
  return proto;
}

absl::StatusOr<SurveyRecord> FromProto(const v1::SurveyOutput& proto) {
  SurveyRecord record;
  record.vertex_count = proto.vertex_count();
  record.triangle_count = proto.triangle_count();
  record.doubled_vertices = proto.doubled_vertices();
  record.degenerate_triangles = proto.degenerate_triangles();
  record.nonmanifold_edges = proto.nonmanifold_edges();
  record.float32 = proto.float32();
  if (proto.bounds_size() != 0 && proto.bounds_size() != 6) return Malformed("bounds");
  record.lo = proto.bounds_size() == 6 ? PointAt(proto.bounds(), 0)
                                       : Point3(Point3::Constant(std::numeric_limits<double>::infinity()));
  record.hi = proto.bounds_size() == 6 ? PointAt(proto.bounds(), 1) : Point3(-record.lo);
  const v1::BoundaryVertices& v = proto.vertices();
  const int n = v.index_size();
  if (v.position_size() != 3 * n || v.normal_size() != 3 * n || v.centroid_height_size() != n ||
      (v.colour_size() != 0 && v.colour_size() != n)) {
    return Malformed("boundary vertices");
  }
  if (!AllBelow(v.index(), record.vertex_count) || proto.edges_size() != 2 * proto.pieces_size() ||
      !AllBelow(proto.edges(), n)) {
    return Malformed("boundary indices");
  }
  for (int i = 0; i < n; ++i) {
    record.vertices.push_back({v.index(i), PointAt(v.position(), i), PointAt(v.normal(), i), v.centroid_height(i)});
    if (!IsPlace(record.vertices.back().position)) return Malformed("boundary vertex position");
  }
  for (const uint32_t colour : v.colour()) record.colours.push_back(ColourFromProto(colour));
  for (int i = 0; i < proto.pieces_size(); ++i) {
    record.edges.push_back({proto.edges(2 * i), proto.edges(2 * i + 1), proto.pieces(i)});
  }
  TILEMEND_ASSIGN_OR_RETURN(record.band, DecodeMesh(proto.band()));
  if (record.band.points.size() < record.vertices.size()) return Malformed("band");
  for (int i = 0; i < n; ++i) record.band.points[i] = record.vertices[i].position;
  return record;
}

v1::RimVertices ToProto(const std::vector<RimVertex>& vertices) {
  v1::RimVertices proto;
  for (const RimVertex& v : vertices) {
    proto.add_col(v.tile.col);
    proto.add_row(v.tile.row);
    proto.add_index(v.index);
    proto.add_seam_vertex(v.seam_vertex);
    proto.add_lines(v.lines);
    AddPoint(v.position, proto.mutable_position());
    proto.add_height_known(v.height_known);
    proto.add_centroid_height(v.centroid_height);
    proto.add_size(v.size);
    proto.add_laplacian_known(v.laplacian_known);
    proto.add_laplacian(v.laplacian);
  }
  if (std::any_of(vertices.begin(), vertices.end(), [](const RimVertex& v) { return v.on_object || v.ground; })) {
    for (const RimVertex& v : vertices) {
      proto.add_on_object(v.on_object);
      proto.add_ground_known(v.ground.has_value());
      proto.add_ground(v.ground.value_or(0));
    }
  }
  if (std::ranges::any_of(vertices, &RimVertex::on_ground)) {
    for (const RimVertex& v : vertices) proto.add_on_ground(v.on_ground);
  }
  if (std::any_of(vertices.begin(), vertices.end(), [](const RimVertex& v) { return v.follows >= 0; })) {
    for (const RimVertex& v : vertices) proto.add_follows(v.follows);
  }
  return proto;
}

absl::StatusOr<std::vector<RimVertex>> FromProto(const v1::RimVertices& proto) {
  const int n = proto.col_size();
  if (proto.row_size() != n || proto.index_size() != n || proto.seam_vertex_size() != n || proto.lines_size() != n ||
      proto.position_size() != 3 * n || proto.height_known_size() != n || proto.centroid_height_size() != n ||
      proto.size_size() != n || proto.laplacian_known_size() != n || proto.laplacian_size() != n ||
      (proto.on_object_size() != n && proto.on_object_size() != 0) || proto.ground_size() != proto.on_object_size() ||
      proto.ground_known_size() != proto.on_object_size() || (proto.follows_size() != n && proto.follows_size() != 0) ||
      (proto.on_ground_size() != n && proto.on_ground_size() != 0)) {
    return Malformed("rim vertices");
  }
  std::vector<RimVertex> vertices(n);
  for (int i = 0; i < n; ++i) {
    RimVertex& v = vertices[i];
    v.tile = {proto.col(i), proto.row(i)};
    v.index = proto.index(i);
    v.seam_vertex = proto.seam_vertex(i);
    v.lines = static_cast<uint8_t>(proto.lines(i) & 3);
    v.position = PointAt(proto.position(), i);
    v.height_known = proto.height_known(i);
    v.centroid_height = proto.centroid_height(i);
    v.size = proto.size(i);
    v.laplacian_known = proto.laplacian_known(i);
    v.laplacian = proto.laplacian(i);
    v.on_object = proto.on_object_size() > 0 && proto.on_object(i);
    v.on_ground = proto.on_ground_size() > 0 && proto.on_ground(i);
    if (proto.follows_size() > 0) v.follows = proto.follows(i);
    if (proto.ground_known_size() > 0 && proto.ground_known(i)) v.ground = proto.ground(i);
    if (!std::isfinite(v.ground.value_or(0))) return Malformed("rim vertex ground");
    if (!std::isfinite(v.laplacian)) return Malformed("rim vertex Laplacian");
    if (!IsPlace(v.position)) return Malformed("rim vertex position");
  }
  return vertices;
}

v1::CellHolesBlob ToProto(const CellHoles& holes) {
  v1::CellHolesBlob proto;
  proto.set_col(holes.cell.col);
  proto.set_row(holes.cell.row);
  proto.set_float32(holes.float32);
  proto.set_lattice_step(holes.lattice_step);
  *proto.mutable_vertices() = ToProto(holes.vertices);
  for (const CellHole& hole : holes.holes) {
    v1::HoleBoundary* h = proto.add_holes();
    h->set_id(hole.id);
    h->set_open(hole.open);
    h->set_slope_x(hole.slope.x());
    h->set_slope_y(hole.slope.y());
    if (hole.tension) h->set_tension(*hole.tension);
    if (hole.walls.is_told()) *h->mutable_walls() = ToProto(hole.walls);
    if (hole.level) h->set_level(*hole.level);
    for (const Point3& station : hole.river.stations) AddPoint(station, h->mutable_station());
    h->set_in_ground(hole.in_ground);
    h->set_own_outline(hole.own_outline);
    for (const RimSegment& s : hole.inner_edges) {
      h->add_inner_from(s.from);
      h->add_inner_to(s.to);
    }
    for (const RimSegment& s : hole.segments) {
      h->add_from(s.from);
      h->add_to(s.to);
      h->add_seam(s.seam);
    }
  }
  if (!holes.band.points.empty()) {
    *proto.mutable_band() = EncodeMesh(holes.band.points, holes.band.triangles, kFinestStep);
  }
  return proto;
}

absl::Status ReadEdges(const v1::HoleBoundary& h, int64_t vertices, CellHole& hole) {
  if (h.to_size() != h.from_size() || h.seam_size() != h.from_size() || h.from_size() == 0 ||
      !AllBelow(h.from(), vertices) || !AllBelow(h.to(), vertices)) {
    return Malformed("hole boundary");
  }
  for (int i = 0; i < h.from_size(); ++i) hole.segments.push_back({h.from(i), h.to(i), h.seam(i)});
  if (h.inner_to_size() != h.inner_from_size() || !AllBelow(h.inner_from(), vertices) ||
      !AllBelow(h.inner_to(), vertices)) {
    return Malformed("edges inside a hole");
  }
  for (int i = 0; i < h.inner_from_size(); ++i) hole.inner_edges.push_back({h.inner_from(i), h.inner_to(i), true});
  return absl::OkStatus();
}

absl::StatusOr<CellHoles> FromProto(const v1::CellHolesBlob& proto) {
  CellHoles holes;
  holes.cell = {proto.col(), proto.row()};
  holes.float32 = proto.float32();
  holes.lattice_step = proto.lattice_step();
  if (!(holes.lattice_step > 0) || !std::isfinite(holes.lattice_step)) return Malformed("lattice step");
  TILEMEND_ASSIGN_OR_RETURN(holes.vertices, FromProto(proto.vertices()));
  const auto n = static_cast<int64_t>(holes.vertices.size());
  for (const v1::HoleBoundary& h : proto.holes()) {
    CellHole hole;
    hole.id = h.id();
    hole.open = h.open();
    hole.slope = {h.slope_x(), h.slope_y()};
    if (!hole.slope.allFinite()) return Malformed("slope");
    if (h.has_tension()) hole.tension = h.tension();
    if (!(h.tension() >= 0) || !std::isfinite(h.tension())) return Malformed("tension");
    if (h.has_walls()) {
      TILEMEND_ASSIGN_OR_RETURN(hole.walls, FromProto(h.walls()));
    }
    if (h.has_level()) hole.level = h.level();
    if (!std::isfinite(h.level())) return Malformed("water level");
    if (h.station_size() % 3 != 0 || h.station_size() == 3) return Malformed("river stations");
    for (int i = 0; i < h.station_size() / 3; ++i) {
      hole.river.stations.push_back(PointAt(h.station(), i));
      if (!hole.river.stations.back().allFinite()) return Malformed("river stations");
    }
    hole.in_ground = h.in_ground();
    hole.own_outline = h.own_outline();
    TILEMEND_RETURN_IF_ERROR(ReadEdges(h, n, hole));
    holes.holes.push_back(std::move(hole));
  }
  if (proto.has_band()) {
    TILEMEND_ASSIGN_OR_RETURN(holes.band, DecodeMesh(proto.band()));
    if (holes.band.points.size() < holes.vertices.size()) return Malformed("band");
    for (size_t i = 0; i < holes.vertices.size(); ++i) holes.band.points[i] = holes.vertices[i].position;
  }
  return holes;
}

v1::FillOutput ToProto(const std::vector<HolePatch>& patches, const std::vector<RimVertex>& vertices,
                       double lattice_step) {
  v1::FillOutput proto;
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
  for (const RimVertex& v : vertices) points.push_back(v.position);
  for (const HolePatch& patch : patches) {
    v1::PatchExtent* extent = proto.add_patches();
    extent->set_hole(patch.hole);
    extent->set_failure(patch.failure);
    extent->set_way(static_cast<v1::FillWay>(patch.way));
    extent->set_loop_cuts(patch.loop_cuts);
    extent->set_creases(patch.creases);
    extent->set_crossings(patch.crossings);
    extent->set_rim_is_crossed(patch.rim_is_crossed);
    extent->set_new_points(static_cast<int64_t>(patch.new_points.size()));
    extent->set_triangles(static_cast<int64_t>(patch.triangles.size()));
    if (patch.hold_out) *extent->mutable_hold_out() = ToProto(*patch.hold_out);
    const auto base = static_cast<int32_t>(points.size());
    points.insert(points.end(), patch.new_points.begin(), patch.new_points.end());
    for (Triangle t : patch.triangles) {
      for (int32_t& corner : t) corner = corner >= 0 ? corner : base - 1 - corner;
      triangles.push_back(t);
    }
  }
  *proto.mutable_mesh() = EncodeMesh(points, triangles, lattice_step);
  const double step = proto.mesh().step();
  for (size_t i = vertices.size(); i < points.size(); ++i) {
    if (RoundedToLattice(points[i], step) == points[i]) continue;
    proto.add_off_lattice(static_cast<int64_t>(i - vertices.size()));
    AddPoint(points[i], proto.mutable_off_lattice_position());
  }
  return proto;
}

namespace {

// Whether the counts in the message fit each other and the mesh.
absl::Status CheckPatchCounts(const v1::FillOutput& proto, size_t vertex_count, const TriMesh& mesh) {
  int64_t points = static_cast<int64_t>(vertex_count), triangles = 0;
  for (const v1::PatchExtent& e : proto.patches()) {
    if (e.new_points() < 0 || e.triangles() < 0 || e.new_points() > kMaxResultPoints ||
        e.triangles() > kMaxResultTriangles || !v1::FillWay_IsValid(e.way())) {
      return Malformed("patch extent");
    }
    points += e.new_points();
    triangles += e.triangles();
  }
  if (points != static_cast<int64_t>(mesh.points.size()) || triangles != static_cast<int64_t>(mesh.triangles.size()) ||
      proto.off_lattice_position_size() != 3 * proto.off_lattice_size() ||
      !AllBelow(proto.off_lattice(), points - static_cast<int64_t>(vertex_count))) {
    return Malformed("patch counts");
  }
  return absl::OkStatus();
}

// The patch whose new points begin at `point` and whose triangles begin at `triangle` of the mesh of all patches.
absl::StatusOr<HolePatch> PatchFrom(const v1::PatchExtent& extent, const TriMesh& mesh, size_t vertex_count,
                                    int64_t point, int64_t triangle) {
  HolePatch patch{.hole = extent.hole(), .failure = extent.failure(), .way = static_cast<FillWay>(extent.way())};
  patch.loop_cuts = extent.loop_cuts(), patch.creases = extent.creases(), patch.crossings = extent.crossings();
  patch.rim_is_crossed = extent.rim_is_crossed();
  if (extent.has_hold_out()) {
    TILEMEND_ASSIGN_OR_RETURN(patch.hold_out, FromProto(extent.hold_out()));
  }
  const auto base = static_cast<int32_t>(point);
  patch.new_points.assign(mesh.points.begin() + point, mesh.points.begin() + point + extent.new_points());
  for (int64_t k = 0; k < extent.triangles(); ++k) {
    Triangle t = mesh.triangles[static_cast<size_t>(triangle + k)];
    for (int32_t& corner : t) {
      if (corner < static_cast<int32_t>(vertex_count)) continue;
      if (corner < base || corner >= base + extent.new_points()) return Malformed("patch triangle");
      corner = base - 1 - corner;
    }
    patch.triangles.push_back(t);
  }
  return patch;
}

}  // namespace

absl::StatusOr<std::vector<HolePatch>> FromProto(const v1::FillOutput& proto, size_t vertex_count) {
  TILEMEND_ASSIGN_OR_RETURN(TriMesh mesh, DecodeMesh(proto.mesh()));
  TILEMEND_RETURN_IF_ERROR(CheckPatchCounts(proto, vertex_count, mesh));
  for (int i = 0; i < proto.off_lattice_size(); ++i) {
    const Point3 position = PointAt(proto.off_lattice_position(), i);
    if (!IsPlace(position)) return Malformed("patch position");
    mesh.points[vertex_count + static_cast<size_t>(proto.off_lattice(i))] = position;
  }
  std::vector<HolePatch> patches;
  int64_t point = static_cast<int64_t>(vertex_count), triangle = 0;
  for (const v1::PatchExtent& extent : proto.patches()) {
    TILEMEND_ASSIGN_OR_RETURN(HolePatch patch, PatchFrom(extent, mesh, vertex_count, point, triangle));
    patches.push_back(std::move(patch));
    point += extent.new_points();
    triangle += extent.triangles();
  }
  return patches;
}

v1::QualityTally ToProto(const QualityTally& tally) {
  v1::QualityTally proto;
  proto.set_triangles(tally.triangles);
  proto.set_sum_millionths(tally.sum_millionths);
  proto.set_least(tally.least);
  proto.mutable_histogram()->Add(tally.histogram.begin(), tally.histogram.end());
  proto.set_poor(tally.poor);
  proto.set_poor_forced(tally.poor_forced);
  return proto;
}

absl::StatusOr<QualityTally> FromProto(const v1::QualityTally& proto) {
  QualityTally tally;
  if (proto.histogram_size() != QualityTally::kBins) return Malformed("quality histogram");
  tally.triangles = proto.triangles();
  tally.sum_millionths = proto.sum_millionths();
  tally.least = proto.least();
  std::copy(proto.histogram().begin(), proto.histogram().end(), tally.histogram.begin());
  tally.poor = proto.poor();
  tally.poor_forced = proto.poor_forced();
  return tally;
}

}  // namespace tilemend
