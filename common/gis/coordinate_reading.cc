#include "common/gis/coordinate_reading.h"

#include <cpl_conv.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "common/gis/crs_files.h"
#include "common/gis/feature_geometry.h"
#include "common/gis/feature_properties.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr double kMostMetres = 1e9;  // from the origin, as of coordinates in tiles
constexpr char kLonLat[] = "OGC:CRS84";
constexpr char kSceneCoordinates[] = "scene coordinates";

struct Extent {
  Point2 lo = Point2::Constant(std::numeric_limits<double>::infinity());
  Point2 hi = -lo;

  void Add(const Point2& p) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  double Area() const { return (hi - lo).cwiseMax(0).prod(); }
  std::string Text() const {
    char text[200];
    std::snprintf(text, sizeof text, "x %.10g to %.10g, y %.10g to %.10g", lo.x(), hi.x(), lo.y(), hi.y());
    return text;
  }
};

// 0: apart or merely touching; 1: the same.
double Likeness(const Extent& a, const Extent& b) {
  const Extent common{a.lo.cwiseMax(b.lo), a.hi.cwiseMin(b.hi)};
  const double larger = std::max(a.Area(), b.Area());
  return larger > 0 && (common.lo.array() < common.hi.array()).all() ? common.Area() / larger : 0;
}

Extent ExtentOf(const std::vector<VectorFeature>& features) {
  Extent extent;
  for (const VectorFeature& feature : features) {
    for (const auto& ring : feature.polygon.rings)
      std::for_each(ring.begin(), ring.end(), [&](auto& p) { extent.Add(p); });
    for (const Point2& p : feature.line) extent.Add(p);
  }
  return extent;
}

template <typename Visit>
void ForEachPoint(VectorFeature& feature, const Visit& visit) {
  for (auto& ring : feature.polygon.rings) std::for_each(ring.begin(), ring.end(), visit);
  std::for_each(feature.line.begin(), feature.line.end(), visit);
}

// Feet of any kind are not.
bool IsMetre(double metres) { return std::abs(metres - 1) < 1e-9; }

OGRSpatialReference EastFirst(OGRSpatialReference crs) {
  crs.StripVertical();
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

// Coordinates east and north of a place, as photogrammetry without a CRS has them, are those of the orthographic
// projection about it (EPSG method 9840) as far as heights do not matter: 2 cm a kilometre at 100 m.
std::string ProjectionOf(const std::string& crs) {
  double latitude = 0, longitude = 0;
  if (std::sscanf(crs.c_str(), "ENU:%lf,%lf", &latitude, &longitude) != 2) return crs;
  char text[200];
  std::snprintf(text, sizeof text, "+proj=ortho +lat_0=%.12f +lon_0=%.12f +datum=WGS84 +units=m +no_defs", latitude,
                longitude);
  return text;
}

std::optional<OGRSpatialReference> CrsNamed(const std::string& crs) {
  const char* const offline[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
  OGRSpatialReference read;
  if (!FileNamedIn(crs).empty()) return std::nullopt;
  if (crs.empty() || read.SetFromUserInput(ProjectionOf(crs).c_str(), offline) != OGRERR_NONE) return std::nullopt;
  return EastFirst(std::move(read));
}

// "EPSG:25832"; "": it has no code.
std::string CodeOf(const OGRSpatialReference& crs) {
  const char* const authority = crs.GetAuthorityName(nullptr);
  const char* const code = crs.GetAuthorityCode(nullptr);
  return authority != nullptr && code != nullptr ? std::string(authority) + ":" + code : "";
}

// Whether it places this point where the CRS of its code does; true if that is not known. Photogrammetry programs write
// a local CRS with the code of the one that they made it from.
bool IsAsItsCodeSays(const OGRSpatialReference& crs, const Point2& point) {
  const std::optional<OGRSpatialReference> coded = CrsNamed(CodeOf(crs));
  if (!coded || coded->IsProjected() == 0 || crs.IsProjected() == 0) return true;
  const std::unique_ptr<OGRCoordinateTransformation> way(OGRCreateCoordinateTransformation(&crs, &*coded));
  double x = point.x(), y = point.y();
  constexpr double kSame = 0.01;  // metres, for rounding
  return way == nullptr || way->Transform(1, &x, &y) == 0 || (Point2(x, y) - point).norm() <= kSame;
}

std::string NameOf(const OGRSpatialReference& crs) {
  if (std::string code = CodeOf(crs); !code.empty()) return code;
  return crs.GetName() != nullptr ? crs.GetName() : "a CRS without a name";
}

// A CRS as WKT of one kind; "" if it cannot be written so.
std::string WktOf(const OGRSpatialReference& crs, const char* format) {
  char* written = nullptr;
  const char* const options[] = {format, nullptr};
  const bool is_written = crs.exportToWkt(&written, options) == OGRERR_NONE && written != nullptr;
  std::string text = is_written ? written : "";
  CPLFree(written);
  return text;
}

// PROJ would open the file as soon as a position is transformed. WKT of 2019 has the grids of a bound CRS, that of GDAL
// the PROJ strings beside a CRS.
void CheckNoFile(const OGRSpatialReference& crs, const std::string& name) {
  const std::string text = WktOf(crs, "FORMAT=WKT2_2019") + "\n" + WktOf(crs, "FORMAT=WKT1_GDAL");
  if (const std::string file = FileNamedIn(text); !file.empty()) {
    throw BadVectors{"its CRS " + name + " names a file (" + Printable(file) + "); transform it to a CRS without one"};
  }
}

// One way to take a layer's coordinates.
struct Reading {
  std::string name;
  std::shared_ptr<OGRCoordinateTransformation> to_scene_crs;  // null: they are in it
  Point3 shift{0, 0, 0};                                      // to the origin

  // No value where a position is none of the scene's CRS.
  std::optional<std::vector<VectorFeature>> Apply(std::vector<VectorFeature> features) const {
    bool good = true;
    for (VectorFeature& feature : features) {
      ForEachPoint(feature, [&](Point2& p) {
        good = good && (to_scene_crs == nullptr || to_scene_crs->Transform(1, &p.x(), &p.y()));
        p -= shift.head<2>();
        good = good && p.cwiseAbs().maxCoeff() <= kMostMetres;
      });
      if (feature.level) *feature.level -= shift.z();
    }
    return good ? std::optional(std::move(features)) : std::nullopt;
  }
};

class Placement {
 public:
  Placement(const SceneFrame& frame, std::vector<VectorFeature>& features, std::vector<std::string>& warnings)
      : frame_(frame),
        features_(features),
        warnings_(warnings),
        crs_(CrsNamed(frame.crs)),
        has_extent_((frame.lo.array() <= frame.hi.array()).all()),
        scene_{frame.lo, frame.hi} {}

  std::string ByName(const OGRSpatialReference& named) {
    const std::string name = NameOf(named);
    CheckNoFile(named, name);
    if (frame_.crs.empty()) {
      throw BadVectors{"its coordinates are in " + name +
                       ", but the scene names no CRS; give the scene's CRS in scene.json (\"crs\", \"origin\"), or "
                       "coordinates relative to the scene's origin in a file that names no CRS"};
    }
    if (IsTakenForScene(named, name)) {
      const Reading as_scene{name, nullptr, frame_.origin};
      auto placed = as_scene.Apply(features_);
      if (IsIn(placed)) {
        warnings_.push_back("its CRS is called " + name +
                            ", as the scene's is, which is another one: its coordinates are "
                            "taken for the scene's; if they are not, name the CRS by its definition");
        return Take(std::move(placed), name);
      }
    }
    const Reading reading = From(EastFirst(named), name);
    auto placed = reading.Apply(features_);
    if (IsIn(placed)) return Take(std::move(placed), reading.name);
    CheckNotExchanged({reading});
    if (!placed) throw BadVectors{"coordinates (" + ExtentOf(features_).Text() + ") that are none of " + name};
    return Take(std::move(placed), reading.name);
  }

  std::string ByFit() {
    const Reading as_scene{kSceneCoordinates, nullptr, {0, 0, 0}};
    const Reading in_crs{frame_.crs.empty() ? "the scene's CRS" : frame_.crs, nullptr, frame_.origin};
    auto placed = as_scene.Apply(features_);
    if (!has_extent_) return Take(std::move(placed), as_scene.name);
    std::vector<Reading> readings = {as_scene, in_crs};
    if (const std::optional<Reading> degrees = LonLat()) {
      auto by_degrees = degrees->Apply(features_);
      if (Fit(by_degrees) > Fit(placed)) return Take(std::move(by_degrees), degrees->name);
      if (Fit(degrees->Apply(Exchanged())) > Fit(placed)) ThrowExchanged();
      readings.push_back(*degrees);
    }
    auto by_crs = in_crs.Apply(features_);
    const size_t only_so = CountOnlyIn(placed, by_crs), only_in_crs = CountOnlyIn(by_crs, placed);
    if (only_so > 0 && only_in_crs > 0) ThrowMixed(only_so, only_in_crs);
    if (only_in_crs > 0) return Take(std::move(by_crs), in_crs.name);
    if (IsIn(placed)) return Take(std::move(placed), as_scene.name);
    if (IsIn(by_crs)) return Take(std::move(by_crs), in_crs.name);
    CheckNotExchanged(readings);
    throw BadVectors{"its coordinates (" + ExtentOf(features_).Text() + ") are neither in the scene (" + scene_.Text() +
                     " relative to its origin) nor in its CRS (" +
                     Extent{scene_.lo + frame_.origin.head<2>(), scene_.hi + frame_.origin.head<2>()}.Text() +
                     "), and the file names no CRS of its own"};
  }

 private:
  // Whether the scene's CRS has the code of `named`, and is another one: files drawn over the scene keep the code
  // alone.
  bool IsTakenForScene(const OGRSpatialReference& named, const std::string& code) const {
    const Point2 origin = frame_.origin.head<2>();
    return crs_ && CodeOf(*crs_) == code && !IsAsItsCodeSays(*crs_, origin) &&
           IsAsItsCodeSays(EastFirst(named), origin);
  }

  // Throws if the scene's CRS is not understood or has no metres.
  Reading From(const OGRSpatialReference& crs, const std::string& name) const {
    if (!crs_)
      throw BadVectors{"its coordinates are in " + name + ", but the scene's CRS '" + frame_.crs +
                       "' is not understood"};
    if (crs_->IsGeographic()) {
      throw BadVectors{"its coordinates are in " + name + ", but the scene's CRS '" + frame_.crs +
                       "' has degrees and cannot be that of its tiles"};
    }
    OGRCoordinateTransformationOptions exact;
    exact.SetBallparkAllowed(false);
    std::shared_ptr<OGRCoordinateTransformation> best(OGRCreateCoordinateTransformation(&crs, &*crs_, exact));
    const Point2 probe = ExtentOf(features_).lo;
    double x = probe.x(), y = probe.y();
    if (best == nullptr || (probe.allFinite() && !best->Transform(1, &x, &y))) {
      best.reset(OGRCreateCoordinateTransformation(&crs, &*crs_));
      if (best == nullptr) throw BadVectors{"no way from " + name + " to the scene's CRS '" + frame_.crs + "'"};
      x = probe.x(), y = probe.y();
      if (probe.allFinite() && best->Transform(1, &x, &y)) {
        warnings_.push_back("no grid is installed for the shift from " + name + " to " + ShownName(frame_.crs) +
                            ": positions may be some metres off");
      }
    }
    return {name, best, frame_.origin};
  }

  // Longitudes and latitudes, as GeoJSON has them; none if these are no degrees, or the scene is nowhere on earth.
  std::optional<Reading> LonLat() const {
    const Extent extent = ExtentOf(features_);  // x and y may be exchanged, which is told later
    const bool degrees = extent.lo.minCoeff() >= -180 && extent.hi.maxCoeff() <= 180;
    if (!degrees || !crs_ || crs_->IsGeographic()) return std::nullopt;
    return From(*CrsNamed(kLonLat), "longitude and latitude");
  }

  // With a cell's width around, since waters and areas reach out of a scene.
  bool MeetsScene(const Extent& extent) const {
    return (extent.lo.array() <= scene_.hi.array()).all() && (extent.hi.array() >= scene_.lo.array()).all();
  }

  bool IsIn(const std::optional<std::vector<VectorFeature>>& placed) const {
    if (!placed) return false;
    return !has_extent_ || placed->empty() || MeetsScene(ExtentOf(*placed));
  }

  // How many features lie in the scene as they are in `placed`, and do not as in `other`.
  size_t CountOnlyIn(const std::optional<std::vector<VectorFeature>>& placed,
                     const std::optional<std::vector<VectorFeature>>& other) const {
    size_t count = 0;
    for (size_t i = 0; placed && i < placed->size(); ++i) {
      const bool is_in = MeetsScene(ExtentOf({(*placed)[i]}));
      if (is_in && !(other && MeetsScene(ExtentOf({(*other)[i]})))) ++count;
    }
    return count;
  }

  // Such as a drawing with a frame around (0, 0).
  [[noreturn]] void ThrowMixed(size_t only_so, size_t only_in_crs) const {
    throw BadVectors{"of its " + std::to_string(features_.size()) + " features " + std::to_string(only_so) +
                     " lie in the scene only if coordinates are relative to its origin, and " +
                     std::to_string(only_in_crs) +
                     " only if they are in its CRS; take out what does not belong there, such as a drawing's frame"};
  }

  double Fit(const std::optional<std::vector<VectorFeature>>& placed) const {
    return placed ? Likeness(ExtentOf(*placed), scene_) : 0;
  }

  // Throws if the layer would lie in the scene with x and y exchanged.
  void CheckNotExchanged(const std::vector<Reading>& readings) const {
    const std::vector<VectorFeature> exchanged = Exchanged();
    for (const Reading& reading : readings) {
      if (IsIn(reading.Apply(exchanged))) ThrowExchanged();
    }
  }

  std::vector<VectorFeature> Exchanged() const {
    std::vector<VectorFeature> exchanged = features_;
    for (VectorFeature& feature : exchanged) ForEachPoint(feature, [](Point2& p) { std::swap(p.x(), p.y()); });
    return exchanged;
  }

  [[noreturn]] void ThrowExchanged() const {
    throw BadVectors{"its coordinates (" + ExtentOf(features_).Text() +
                     ") are not in the scene, but they are with x and y exchanged: the file must have x (east, "
                     "longitude) first"};
  }

  std::string Take(std::optional<std::vector<VectorFeature>> placed, const std::string& name) {
    if (!placed)
      throw BadVectors{"coordinates must be at most 1e9 m from the origin (" + ExtentOf(features_).Text() + ")"};
    features_ = *std::move(placed);
    return name;
  }

  const SceneFrame& frame_;
  std::vector<VectorFeature>& features_;
  std::vector<std::string>& warnings_;
  const std::optional<OGRSpatialReference> crs_;  // of the scene
  const bool has_extent_;
  const Extent scene_;
};

}  // namespace

std::string FaultOfCrs(const std::string& crs) {
  if (crs.empty()) return "";
  const CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);
  if (const std::string file = FileNamedIn(crs); !file.empty()) return "names a file: " + Printable(file);
  const std::optional<OGRSpatialReference> known = CrsNamed(crs);
  if (!known) return "PROJ knows no such CRS";
  if (known->IsGeographic()) return "has degrees and cannot be that of tiles in metres";
  if (known->IsGeocentric()) return "is geocentric and cannot be that of tiles with z up";
  const char* unit = nullptr;
  const double metres = known->GetLinearUnits(&unit);
  if (!IsMetre(metres)) return std::string("has the unit ") + unit + ", in which options and levels then count";
  const Point2 any(500000, 2000000);  // on most zones of projected CRS
  return IsAsItsCodeSays(*known, any) ? "" : "is not " + CodeOf(*known) + ", as which it is marked";
}

bool ToLonLat(const std::string& crs, std::vector<Point2>& points) {
  const CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);
  const std::optional<OGRSpatialReference> from = CrsNamed(crs), to = CrsNamed(kLonLat);
  if (!from || !to || from->IsGeocentric() || !IsMetre(from->GetLinearUnits())) return false;
  const std::unique_ptr<OGRCoordinateTransformation> way(OGRCreateCoordinateTransformation(&*from, &*to));
  return way != nullptr && std::all_of(points.begin(), points.end(),
                                       [&](Point2& p) { return way->Transform(1, &p.x(), &p.y()) && p.allFinite(); });
}

std::string PlaceInScene(const SceneFrame& frame, const OGRSpatialReference* named,
                         std::vector<VectorFeature>& features, std::vector<std::string>& warnings) {
  // What fails here is tried otherwise, or told in words of the scene.
  const CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);
  Placement placement(frame, features, warnings);
  return named != nullptr ? placement.ByName(*named) : placement.ByFit();
}

}  // namespace tilemend
