// Reading a report that may come from another release: members that are missing or of another type are empty.
#ifndef TILEMEND_COORDINATOR_REPORT_JSON_ACCESS_H_
#define TILEMEND_COORDINATOR_REPORT_JSON_ACCESS_H_

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace tilemend {

// null if `object` is none or has no such member.
inline const nlohmann::ordered_json& Member(const nlohmann::ordered_json& object, const char* name) {
  static const nlohmann::ordered_json kNull;
  if (!object.is_object()) return kNull;
  const auto it = object.find(name);
  return it == object.end() ? kNull : *it;
}

// A text as it is, "" of null, other values as JSON.
inline std::string Text(const nlohmann::ordered_json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

// 0 if it is no number.
inline double Number(const nlohmann::ordered_json& value) { return value.is_number() ? value.get<double>() : 0; }

// With so many decimals; as Text if it is no number. As on the page halves are rounded away from 0, where the decimal
// number is one, though the nearest binary number may be less: 1.8005 is 1.801.
inline std::string Decimals(const nlohmann::ordered_json& value, int digits) {
  constexpr double kFewUlps = 4 * std::numeric_limits<double>::epsilon(), kMostExact = 1e15;
  if (!value.is_number()) return Text(value);
  const double number = value.get<double>(), scale = std::pow(10.0, digits), scaled = number * scale;
  if (!(std::abs(scaled) < kMostExact)) return absl::StrFormat("%.*f", digits, number);
  return absl::StrFormat("%.*f", digits, std::round(scaled * (1 + kFewUlps)) / scale);
}

// An area in square metres with so many decimals; "< 0.1" if it is smaller than the last one, and not 0. Those of loops
// that run the wrong way round are negative.
inline std::string AreaText(double area, int digits = 1) {
  const double size = std::abs(area), smallest = std::pow(10.0, -digits);
  if (size > 0 && size < smallest) return absl::StrFormat("< %.*f", digits, smallest);
  return absl::StrFormat("%.*f", digits, size);
}

// The same; "-" if it is not known.
inline std::string AreaText(const nlohmann::ordered_json& value, int digits = 1) {
  if (value.is_null()) return "-";
  return value.is_number() ? AreaText(value.get<double>(), digits) : Text(value);
}

// A place in a scene (two coordinates) with two decimals. That of a mesh, which may be small, is as precise as it is.
inline std::string CentreText(const nlohmann::ordered_json& value) {
  if (!value.is_array() || value.size() != 2) return Text(value);
  return absl::StrCat("[", Decimals(value[0], 2), ",", Decimals(value[1], 2), "]");
}

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_JSON_ACCESS_H_
