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
constexpr double kFarthest = 0x1p60;           // metres
constexpr int64_t kMostSquaresOfVertex = 256;  // around holes: one vertex has up to 225

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

v1::GroundOutput ToProto(const RimGround& rim) {
  v1::GroundOutput proto;
  proto.mutable_on_object()->Add(rim.on_object.begin(), rim.on_object.end());
  proto.mutable_ground()->Add(rim.ground.begin(), rim.ground.end());
  proto.set_side(rim.side);
  for (const GroundSquare& square : rim.around) {
    proto.add_around_col(square.col);
    proto.add_around_row(square.row);
    proto.add_around_height(square.height);
  }
  return proto;
}

absl::StatusOr<RimGround> FromProto(const v1::GroundOutput& proto, int vertices) {
  if (proto.on_object_size() != vertices || proto.ground_size() != vertices) {
    return absl::InvalidArgumentError("not a value for each boundary vertex");
  }
  const int squares = proto.around_height_size();
  const bool has_columns = proto.around_col_size() == squares && proto.around_row_size() == squares;
  if (!has_columns || squares > kMostSquaresOfVertex * int64_t{vertices} || !std::isfinite(proto.side())) {
    return absl::InvalidArgumentError("malformed payload: squares with ground");
  }
  RimGround rim{{proto.on_object().begin(), proto.on_object().end()},
                {proto.ground().begin(), proto.ground().end()},
                proto.side()};
  for (int i = 0; i < squares; ++i) {
    const GroundSquare square{proto.around_col(i), proto.around_row(i), proto.around_height(i)};
    if (!std::isfinite(square.height)) return absl::InvalidArgumentError("a height around a hole that is no number");
    rim.around.push_back(square);
  }
  return rim;
}

}  // namespace tilemend
