#include "common/gis/vector_file.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <iterator>
#include <mutex>
#include <utility>

#include "common/gis/coordinate_reading.h"
#include "common/gis/crs_files.h"
#include "common/gis/feature_geometry.h"
#include "common/gis/feature_properties.h"
#include "common/gis/raw_features.h"

namespace tilemend {
namespace {

constexpr size_t kJournalBytes = 18;  // of SQLite's header: two that are 2 where the database has a write-ahead log
constexpr size_t kMostWarnings = 5;   // of one file that GDAL gives: drawings have thousands

// What GDAL is to open a file as. No other driver is registered.
constexpr const char* kJsonDrivers[] = {"GeoJSON", nullptr};
constexpr const char* kPackageDrivers[] = {"GPKG", nullptr};
constexpr const char* kOtherDrivers[] = {"ESRI Shapefile", "OpenFileGDB", "LIBKML", "GML",  "FlatGeobuf",
                                         "MapInfo File",   "DXF",         "DGN",    nullptr};
constexpr const char* kArchivedSuffixes[] = {"shp", "kml", "gml", "fgb", "tab", "mif", "dxf", "dgn", "gdb"};

// Collects what GDAL says on this thread, instead of printing it.
class Messages {
 public:
  Messages() { CPLPushErrorHandlerEx(&Messages::Take, this); }
  ~Messages() { CPLPopErrorHandler(); }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::vector<std::string>& failures() const { return failures_; }

 private:
  static void CPL_STDCALL Take(CPLErr kind, CPLErrorNum, const char* text) {
    auto* self = static_cast<Messages*>(CPLGetErrorHandlerUserData());
    const bool of_memory = std::string_view(text).find("/vsimem/") != std::string_view::npos;  // no name of the user's
    if (kind == CE_Debug || of_memory) return;
    std::vector<std::string>& said = kind == CE_Warning ? self->warnings_ : self->failures_;
    if (said.size() < kMostWarnings && std::find(said.begin(), said.end(), text) == said.end()) said.emplace_back(text);
  }
  std::vector<std::string> warnings_;
  std::vector<std::string> failures_;
};

// A folder in memory: GDAL writes beside what it opens, and would take some names for something else than a file.
class MemoryFolder {
 public:
  explicit MemoryFolder(const VectorRequest& request) {
    static std::atomic<int> count{0};
    path_ = "/vsimem/tilemend/" + std::to_string(count++);
    for (const MemoryPart& part : request.parts) {
      std::string& bytes = bytes_.emplace_back(part.bytes);
      // Nothing that is in a log would be here: vector_bytes.h has seen that there is none.
      if (request.format == VectorFormat::kGeoPackage) bytes.replace(kJournalBytes, 2, 2, '\1');
      const std::string path = path_ + "/" + part.name;
      VSIMkdirRecursive(CPLGetPath(path.c_str()), 0700);
      VSIFCloseL(VSIFileFromMemBuffer(path.c_str(), reinterpret_cast<GByte*>(bytes.data()), bytes.size(), FALSE));
    }
    opened_ = path_ + "/" + request.opened;
  }
  ~MemoryFolder() { VSIRmdirRecursive(path_.c_str()); }
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;

  const std::string& opened() const { return opened_; }

 private:
  std::deque<std::string> bytes_;  // where they are stays
  std::string path_, opened_;
};

GDALDatasetUniquePtr OpenAs(const char* const* drivers, const std::string& path) {
  return GDALDatasetUniquePtr(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers));
}

// What in an archive is to be opened, in order of name: a File Geodatabase is a folder.
std::vector<std::string> OpenableIn(const std::string& archive) {
  const CPLStringList names(VSIReadDirRecursive(archive.c_str()));
  std::vector<std::string> found;
  for (int i = 0; i < names.size(); ++i) {
    std::string name = names[i];
    if (name.ends_with('/')) name.pop_back();
    const std::string suffix = CPLGetExtension(name.c_str());
    const bool is_known = std::any_of(std::begin(kArchivedSuffixes), std::end(kArchivedSuffixes),
                                      [&](const char* known) { return EQUAL(known, suffix.c_str()); });
    if (is_known && !name.starts_with("__MACOSX/")) found.push_back(name);
  }
  std::sort(found.begin(), found.end());
  return found;
}

using Datasets = std::vector<GDALDatasetUniquePtr>;

void OpenArchive(const std::string& path, Datasets& data) {
  const std::string archive = "/vsizip/{" + path + "}";
  const std::vector<std::string> names = OpenableIn(archive);
  for (const std::string& name : names) {
    std::string inside = archive;
    inside.append("/").append(name);
    data.push_back(OpenAs(kOtherDrivers, inside));
    if (data.back() == nullptr) throw BadVectors{"'" + ShownName(name) + "' in it cannot be read"};
  }
  if (names.empty())
    throw BadVectors{"an archive without a file of polygons that can be read in one (shapefile, KML, ...)"};
}

Datasets Open(const MemoryFolder& folder, VectorFormat format) {
  Datasets data;
  if (format == VectorFormat::kArchive) {
    OpenArchive(folder.opened(), data);
    return data;
  }
  const CPLConfigOptionSetter mended("SHAPE_RESTORE_SHX", "YES", false);  // a shapefile without its index
  const char* const* drivers = format == VectorFormat::kGeoJson      ? kJsonDrivers
                               : format == VectorFormat::kGeoPackage ? kPackageDrivers
                                                                     : kOtherDrivers;
  data.push_back(OpenAs(drivers, folder.opened()));
  if (data.back() == nullptr) {
    throw BadVectors{"a file of no format that is read (GeoJSON, GeoPackage, shapefile, KML, DXF, ...), or damaged"};
  }
  return data;
}

// GDAL takes GeoJSON with a CRS that it does not know for WGS 84 as well.
void CheckCrsName(const std::string& name) {
  if (const std::string file = FileNamedIn(name); !file.empty()) {
    throw BadVectors{"it names a CRS that names a file: '" + ShownName(file) + "'"};
  }
  OGRSpatialReference crs;
  static const char* const offline[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
  if (!name.empty() && crs.SetFromUserInput(name.c_str(), offline) != OGRERR_NONE) {
    throw BadVectors{"it names a CRS that is not known: '" + ShownName(name) + "'"};
  }
}

// The CRS that a layer names, or null. GDAL takes GeoJSON without one for WGS 84.
const OGRSpatialReference* CrsOf(OGRLayer& layer, const VectorRequest& request) {
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  const bool undefined = crs == nullptr || crs->IsLocal() || std::string_view(crs->GetName()).starts_with("Undefined");
  return undefined || !request.names_crs ? nullptr : crs;
}

// Whether a layer is to be read. Layers of points have nothing to do with water and areas, and one without features is
// no second layer for an area. GeoJSON is one layer, of which all features are read.
bool IsOfUse(OGRLayer& layer, const VectorRequest& request) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  if (type == wkbNone) return false;
  return request.format == VectorFormat::kGeoJson ||
         (type != wkbPoint && type != wkbMultiPoint &&
          (request.use != VectorUse::kArea || layer.GetFeatureCount() != 0));
}

[[noreturn]] void RefuseSeveral(const std::vector<std::pair<OGRLayer*, LayerRules>>& layers) {
  constexpr size_t kShown = 5;
  std::string what = "expected one layer of polygons, found " + std::to_string(layers.size()) + ": ";
  for (size_t i = 0; i < std::min(layers.size(), kShown); ++i) {
    what += (i > 0 ? ", " : "") + ShownName(layers[i].first->GetName());
  }
  throw BadVectors{what + (layers.size() > kShown ? ", ..." : "")};
}

bool HasPart(const VectorRequest& request, std::string_view suffix) {
  return std::ranges::any_of(request.parts, [&](const auto& part) { return part.name.ends_with(suffix); });
}

// A shapefile without its .dbf has no field.
void CheckHasProperties(GDALDataset& data, OGRLayer& layer, const VectorRequest& request) {
  if (request.use == VectorUse::kArea || !EQUAL(data.GetDriverName(), "ESRI Shapefile")) return;
  if (layer.GetLayerDefn()->GetFieldCount() > 0) return;
  const std::string which = request.format == VectorFormat::kArchive ? ShownName(layer.GetName()) + ".shp in it: " : "";
  throw BadVectors{which + "a shapefile without its .dbf, which says what the polygons are; put it beside the .shp"};
}

void ReadLayer(OGRLayer& layer, const VectorRequest& request, const std::string& prefix, const LayerRules& rules,
               VectorFile& file) {
  auto [features, warnings] = RawFeaturesOf(layer, prefix, rules);
  if (request.features >= 0 && layer.GetFeatureCount() != request.features)
    throw BadVectors{"not all members of \"features\" are Features"};
  if (request.use == VectorUse::kArea) {
    features = {Unite(features)};
  } else {
    for (std::string& warning : NearMisses(layer, prefix)) warnings.push_back(std::move(warning));
  }
  file.warnings.insert(file.warnings.end(), warnings.begin(), warnings.end());
  if (features.empty()) return;
  if (HasPart(request, ".prj") && CrsOf(layer, request) == nullptr) {
    file.warnings.push_back(prefix + "its .prj names no CRS that is known, so its coordinates decide what they are");
  }
  file.coordinates = PlaceInScene(request.frame, CrsOf(layer, request), features, file.warnings);
  file.features.insert(file.features.end(), features.begin(), features.end());
}

// The DXF driver of GDAL 3.6 never ends on some drawings that are cut off.
void CheckDrawingEnds(const VectorRequest& request) {
  if (!EQUAL(CPLGetExtension(request.opened.c_str()), "dxf") || request.parts.empty()) return;
  const std::string_view text = request.parts.front().bytes;
  const size_t end = text.find_last_not_of(" \t\r\n");
  if (!text.substr(0, end == std::string_view::npos ? 0 : end + 1).ends_with("EOF")) {
    throw BadVectors{"a drawing that is cut off: its last line is not EOF"};
  }
}

// Features of which none is a decision are those of a wrong file, which would undo all that was decided before.
void CheckHasDecisions(const Datasets& data, const VectorFile& file) {
  if (!file.features.empty()) return;
  GIntBig features = 0;
  for (const GDALDatasetUniquePtr& set : data) {
    for (OGRLayer* layer : set->GetLayers()) {
      if (wkbFlatten(layer->GetGeomType()) != wkbNone) features += layer->GetFeatureCount();
    }
  }
  if (features == 0) return;
  throw BadVectors{
      "none of its features (" + std::to_string(features) +
      ") is a decision: a polygon of a hole with the property \"decision\" (accept, water, ground or open), "
      "as report.html writes it; a file without features undoes all decisions"};
}

void Read(const VectorRequest& request, VectorFile& file) {
  CheckCrsName(request.crs_name);
  CheckDrawingEnds(request);
  const MemoryFolder folder(request);
  const Datasets data = Open(folder, request.format);
  std::vector<std::pair<OGRLayer*, LayerRules>> layers;
  for (const GDALDatasetUniquePtr& set : data) {
    const bool is_drawing = EQUAL(set->GetDriverName(), "DXF") || EQUAL(set->GetDriverName(), "DGN");
    for (OGRLayer* layer : set->GetLayers()) {
      if (IsOfUse(*layer, request)) {
        CheckHasProperties(*set, *layer, request);
        layers.push_back({layer, {request.use, is_drawing, request.format == VectorFormat::kGeoJson}});
      }
    }
  }
  const bool is_area = request.use == VectorUse::kArea;
  if (is_area && layers.empty()) throw BadVectors{"holds no polygon"};
  if (is_area && layers.size() > 1) RefuseSeveral(layers);
  for (const auto& [layer, rules] : layers) {
    ReadLayer(*layer, request, layers.size() > 1 ? ShownName(layer->GetName()) + ", " : "", rules, file);
  }
  if (request.use == VectorUse::kDecisions) CheckHasDecisions(data, file);
}

// What no driver may do in this process.
void Configure() {
  static constexpr std::pair<const char*, const char*> kOptions[] = {
      {"GML_DOWNLOAD_SCHEMA", "NO"},   // from where the file says
      {"LIBKML_RESOLVE_STYLE", "NO"},  // likewise
      {"CPL_VSIL_CURL_ALLOWED_FILENAME", "none"}};
  for (const auto& [name, value] : kOptions) CPLSetConfigOption(name, value);
  OSRSetPROJEnableNetwork(FALSE);  // PROJ would fetch grids
  for (void (*add)() :
       {&RegisterOGRGeoJSON, &RegisterOGRGeoPackage, &RegisterOGRShape, &RegisterOGROpenFileGDB, &RegisterOGRLIBKML,
        &RegisterOGRGML, &RegisterOGRFlatGeobuf, &RegisterOGRTAB, &RegisterOGRDXF, &RegisterOGRDGN}) {
    add();
  }
}

}  // namespace

VectorFile ReadVectors(const VectorRequest& request) {
  static std::once_flag registered;
  std::call_once(registered, Configure);
  const Messages messages;
  VectorFile file;
  try {
    Read(request, file);
  } catch (const BadVectors& bad) {
    file.features.clear();
    file.error = request.name + ": " + bad.what;
    if (!messages.failures().empty()) file.error += " (" + messages.failures().front() + ")";
    return file;
  }
  file.warnings.insert(file.warnings.end(), messages.warnings().begin(), messages.warnings().end());
  if (!messages.failures().empty()) {
    file.features.clear();
    file.error = request.name + ": " + messages.failures().front();
  }
  return file;
}

}  // namespace tilemend
