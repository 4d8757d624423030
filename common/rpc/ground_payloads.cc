#include "common/rpc/ground_payloads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace tilemend {
namespace {

constexpr double kFinestStep = 0x1p-6;  // metres
constexpr double kMostSteps = 0x7ff0;   // to either side of the middle
constexpr int kNoSurface = 0x7fff;
constexpr double kFarthest = 0x1p60;  // metres

absl::Status Malformed() { return absl::InvalidArgumentError("malformed payload: ground raster"); }

bool HasShape(const v1::GroundRasterBlob& proto) {
  constexpr int64_t kFarthestSquare = int64_t{1} << 30;
  const auto squares =
      static_cast<uint64_t>(std::max(proto.cols(), 0)) * static_cast<uint64_t>(std::max(proto.rows(), 0));
  return proto.cols() >= 0 && proto.rows() >= 0 && proto.heights().size() == 2 * squares &&
         std::abs(int64_t{proto.col()}) <= kFarthestSquare && std::abs(int64_t{proto.row()}) <= kFarthestSquare &&
         proto.square() > 0 && std::isfinite(proto.square()) && proto.step() > 0 && proto.step() < kFarthest &&
         std::abs(proto.middle()) <= kFarthest;
}

}  // namespace

v1::GroundRasterBlob ToProto(const GroundRaster& raster) {
  v1::GroundRasterBlob proto;
  proto.set_square(raster.square);
  proto.set_col(raster.col);
  proto.set_row(raster.row);
  proto.set_cols(raster.cols);
  proto.set_rows(raster.rows);
  double low = std::numeric_limits<double>::infinity(), high = -low, step = kFinestStep;
  for (const float h : raster.heights) {
    if (std::isnan(h)) continue;
    low = std::min<double>(low, h);
    high = std::max<double>(high, h);
  }
  while (low <= high && (high - low) / 2 / step > kMostSteps) step *= 2;
  const double middle = low <= high ? std::round((low + high) / 2 / step) * step : 0;
  proto.set_middle(middle);
  proto.set_step(step);
  std::string* bytes = proto.mutable_heights();
  bytes->reserve(2 * raster.heights.size());
  for (const float h : raster.heights) {
    const auto steps = static_cast<uint16_t>(std::isnan(h) ? kNoSurface : std::lround((h - middle) / step));
    bytes->push_back(static_cast<char>(steps & 0xff));
    bytes->push_back(static_cast<char>(steps >> 8));
  }
  return proto;
}

absl::StatusOr<GroundRaster> FromProto(const v1::GroundRasterBlob& proto) {
  if (!HasShape(proto)) return Malformed();
  GroundRaster raster = EmptyRaster(proto.square(), proto.col(), proto.row(), proto.cols(), proto.rows());
  for (size_t i = 0; i < raster.heights.size(); ++i) {
    const auto low = static_cast<uint8_t>(proto.heights()[2 * i]),
               high = static_cast<uint8_t>(proto.heights()[2 * i + 1]);
    const auto steps = static_cast<int16_t>(low | high << 8);
    if (steps != kNoSurface) raster.heights[i] = static_cast<float>(proto.middle() + steps * proto.step());
  }
  return raster;
}

}  // namespace tilemend
