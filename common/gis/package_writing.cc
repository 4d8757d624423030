#include "common/gis/package_writing.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

namespace tilemend {
namespace {

constexpr char kInput[] = "/vsimem/tilemend/input.geojson";
constexpr char kOutput[] = "/vsimem/tilemend/output.gpkg";
constexpr char kNoTime[] = "1970-01-01T00:00:00.000Z";

// False where GDAL fails.
bool Copy(const std::string& layer) {
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  const GDALDatasetUniquePtr from(GDALDataset::Open(kInput, GDAL_OF_VECTOR));
  const GDALDatasetUniquePtr to(driver != nullptr ? driver->Create(kOutput, 0, 0, 0, GDT_Unknown, nullptr) : nullptr);
  if (from == nullptr || to == nullptr || from->GetLayerCount() != 1) return false;
  return to->CopyLayer(from->GetLayer(0), layer.c_str()) != nullptr;
}

}  // namespace

std::string PackageOf(const std::string& geojson, const std::string& layer) {
  RegisterOGRGeoJSON();
  RegisterOGRGeoPackage();
  const CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);
  const CPLConfigOptionSetter no_time("OGR_CURRENT_DATE", kNoTime, false);
  std::string input = geojson;
  VSIFCloseL(VSIFileFromMemBuffer(kInput, reinterpret_cast<GByte*>(input.data()), input.size(), FALSE));
  std::string package;
  if (Copy(layer)) {
    vsi_l_offset size = 0;
    const GByte* const bytes = VSIGetMemFileBuffer(kOutput, &size, FALSE);
    if (bytes != nullptr) package.assign(reinterpret_cast<const char*>(bytes), size);
  }
  VSIUnlink(kInput);
  VSIUnlink(kOutput);
  return package;
}

}  // namespace tilemend
