#include "common/gis/vector_file.h"

#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include "common/gis/coordinate_reading.h"
#include "common/gis/raw_features.h"

namespace tilemend {
namespace {

constexpr std::string_view kSqlite("SQLite format 3\0", 16);
constexpr size_t kJournalBytes = 18;  // of SQLite's header: two that are 2 where the database has a write-ahead log

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
    if (kind != CE_Debug && !of_memory) (kind == CE_Warning ? self->warnings_ : self->failures_).emplace_back(text);
  }
  std::vector<std::string> warnings_;
  std::vector<std::string> failures_;
};

// A file in memory: GDAL writes beside what it opens, and would take some names for something else than a file.
class MemoryFile {
 public:
  MemoryFile(std::string_view bytes, const std::string& suffix) : bytes_(bytes) {
    static std::atomic<int> count{0};
    path_ = "/vsimem/tilemend/" + std::to_string(count++) + suffix;
    VSIFCloseL(VSIFileFromMemBuffer(path_.c_str(), reinterpret_cast<GByte*>(bytes_.data()), bytes_.size(), FALSE));
  }
  ~MemoryFile() { VSIUnlink(path_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string& bytes() { return bytes_; }
  const std::string& path() const { return path_; }

 private:
  std::string bytes_;
  std::string path_;
};

GDALDatasetUniquePtr Open(MemoryFile& file, bool package) {
  // Nothing that is in a log would be here: area_file.h has seen that there is none.
  if (package) file.bytes().replace(kJournalBytes, 2, 2, '\1');
  const char* const drivers[] = {package ? "GPKG" : "GeoJSON", nullptr};
  return GDALDatasetUniquePtr(
      GDALDataset::Open(file.path().c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers));
}

// GDAL takes GeoJSON with a CRS that it does not know for WGS 84 as well.
void CheckCrsName(const std::string& name) {
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

// Whether a layer of a GeoPackage is to be read. Layers of points have nothing to do with water and areas, and one
// without features is no second layer for an area.
bool IsOfUse(OGRLayer& layer, bool unite) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  return type != wkbPoint && type != wkbMultiPoint && (!unite || layer.GetFeatureCount() != 0);
}

[[noreturn]] void RefuseSeveral(const std::vector<OGRLayer*>& layers) {
  constexpr size_t kShown = 5;
  std::string what = "expected one layer of polygons, found " + std::to_string(layers.size()) + ": ";
  for (size_t i = 0; i < std::min(layers.size(), kShown); ++i) {
    what += (i > 0 ? ", " : "") + ShownName(layers[i]->GetName());
  }
  throw BadVectors{what + (layers.size() > kShown ? ", ..." : "")};
}

void ReadLayer(OGRLayer& layer, const VectorRequest& request, const std::string& prefix, VectorFile& file) {
  auto [features, warnings] = RawFeaturesOf(layer, prefix, request.unite ? Crossings::kRefuse : Crossings::kRepair);
  if (request.features >= 0 && std::ssize(features) != request.features)
    throw BadVectors{"not all members of \"features\" are Features"};
  if (request.unite) {
    features = {Unite(features)};
  } else {
    for (std::string& warning : NearMisses(layer, prefix)) warnings.push_back(std::move(warning));
  }
  if (features.empty()) return;
  file.warnings.insert(file.warnings.end(), warnings.begin(), warnings.end());
  file.coordinates = PlaceInScene(request.frame, CrsOf(layer, request), features, file.warnings);
  file.features.insert(file.features.end(), features.begin(), features.end());
}

void Read(const VectorRequest& request, VectorFile& file) {
  CheckCrsName(request.crs_name);
  const bool package = request.bytes.starts_with(kSqlite) && request.bytes.size() > kJournalBytes + 2;
  MemoryFile memory(request.bytes, package ? ".gpkg" : ".geojson");
  const GDALDatasetUniquePtr data = Open(memory, package);
  if (data == nullptr) throw BadVectors{"neither GeoJSON nor GeoPackage with polygons"};
  std::vector<OGRLayer*> layers;
  for (OGRLayer* layer : data->GetLayers()) {
    if (layer->GetGeomType() != wkbNone && (!package || IsOfUse(*layer, request.unite))) layers.push_back(layer);
  }
  if (request.unite && layers.empty()) throw BadVectors{"holds no polygon"};
  if (request.unite && layers.size() > 1) RefuseSeveral(layers);
  for (OGRLayer* layer : layers) {
    ReadLayer(*layer, request, layers.size() > 1 ? ShownName(layer->GetName()) + ", " : "", file);
  }
}

}  // namespace

VectorFile ReadVectors(const VectorRequest& request) {
  static std::once_flag registered;
  std::call_once(registered, [] {
    RegisterOGRGeoJSON();
    RegisterOGRGeoPackage();
  });
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

void TilemendReadVectors(const VectorRequest& request, VectorFile& file) { file = ReadVectors(request); }

}  // namespace tilemend
