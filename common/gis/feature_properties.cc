#include "common/gis/feature_properties.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <initializer_list>
#include <string_view>

#include "common/gis/feature_geometry.h"
#include "common/gis/property_names.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr size_t kMostOfName = 100;        // columns
constexpr double kMostHeight = 1e5;        // metres
constexpr double kMostClearHeight = 1000;  // metres
constexpr double kMostSigma = 1000;        // metres
// The last three: no-break, thin and narrow no-break space, which editors put between a number and its unit.
constexpr std::array<std::string_view, 7> kBlanks = {" ", "\t", "\r", "\n", "\xC2\xA0", "\xE2\x80\x89", "\xE2\x80\xAF"};

std::string_view Trimmed(std::string_view text) {
  const auto at_start = [&](std::string_view blank) { return text.starts_with(blank); };
  const auto at_end = [&](std::string_view blank) { return text.ends_with(blank); };
  for (const auto* b = kBlanks.end(); (b = std::ranges::find_if(kBlanks, at_start)) != kBlanks.end();) {
    text.remove_prefix(b->size());
  }
  for (const auto* b = kBlanks.end(); (b = std::ranges::find_if(kBlanks, at_end)) != kBlanks.end();) {
    text.remove_suffix(b->size());
  }
  return text;
}

// Without blanks around, in lower case.
std::string WordOf(const OGRFeature& feature, int index) {
  std::string word(Trimmed(feature.GetFieldAsString(index)));
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  return word;
}

bool IsOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// "`place`: property level_m: 'high': expected ..."
[[noreturn]] void RefuseValue(const std::string& place, const char* property, const std::string& value,
                              const char* expected) {
  Refuse(place, std::string("property ") + property + ": '" + ShownName(value) + "': expected " + expected);
}

bool BooleanOf(const OGRFeature& feature, const char* property, bool otherwise, const std::string& place) {
  const int index = FieldOf(feature, property);
  if (index < 0) return otherwise;
  const OGRFieldType type = feature.GetFieldDefnRef(index)->GetType();
  const std::string word = WordOf(feature, index);  // of a boolean: 0 or 1
  const bool may_be = type == OFTInteger || type == OFTInteger64 || type == OFTString;
  if (may_be && IsOneOf(word, {"1", "true", "t", "yes", "y"})) return true;
  if (may_be && IsOneOf(word, {"0", "false", "f", "no", "n"})) return false;
  RefuseValue(place, property, feature.GetFieldAsString(index), "true or false");
}

// A decimal number, with or without the unit "m"; none for anything else. A decimal comma is none: "1,250" would be
// a thousand to others.
std::optional<double> MetresOf(std::string_view text) {
  text = Trimmed(text);
  if (text.ends_with('m')) text = Trimmed(text.substr(0, text.size() - 1));
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value, std::chars_format::fixed);
  return read.ec == std::errc() && read.ptr == end ? std::optional(value) : std::nullopt;
}

bool IsNumber(const OGRFeature& feature, int index) {
  if (index < 0) return false;
  const OGRFieldDefn& definition = *feature.GetFieldDefnRef(index);
  const OGRFieldType type = definition.GetType();
  return (type == OFTReal || type == OFTInteger64 || type == OFTInteger) && definition.GetSubType() != OFSTBoolean;
}

// A number between two bounds, or text for one.
std::optional<double> MetresOf(const OGRFeature& feature, const char* property, double low, double high,
                               const char* expected, const std::string& place) {
  const int index = FieldOf(feature, property);
  if (index < 0) return std::nullopt;
  std::optional<double> metres;
  if (IsNumber(feature, index)) metres = feature.GetFieldAsDouble(index);
  if (feature.GetFieldDefnRef(index)->GetType() == OFTString) metres = MetresOf(feature.GetFieldAsString(index));
  if (metres && *metres >= low && *metres <= high) return metres;
  RefuseValue(place, property, feature.GetFieldAsString(index), expected);
}

WaterKind KindOf(const OGRFeature& feature, const std::string& place) {
  const int index = FieldOf(feature, kKindProperty);
  if (index < 0) return WaterKind::kUnsaid;
  const std::string word = WordOf(feature, index);
  if (word == "lake") return WaterKind::kLake;
  if (word == "river") return WaterKind::kRiver;
  RefuseValue(place, kKindProperty, feature.GetFieldAsString(index), "lake or river, or no value");
}

// Nothing for a property that is no whole number: it is not that of holes.geojson.
std::optional<int64_t> WholeNumberOf(const OGRFeature& feature, const char* property) {
  const int index = FieldOf(feature, property);
  if (index < 0) return std::nullopt;
  const OGRFieldType type = feature.GetFieldDefnRef(index)->GetType();
  if (type != OFTInteger && type != OFTInteger64) return std::nullopt;
  return feature.GetFieldAsInteger64(index);
}

std::optional<int64_t> BodyOf(const OGRFeature& feature) {
  return FieldOf(feature, kHoleProperty) < 0 ? std::nullopt : WholeNumberOf(feature, kBodyProperty);
}

// Of a hole in holes.geojson: its cluster, whether it was water, whether its level is the program's estimate, and
// whether all of its water is as found.
void SetFound(const OGRFeature& feature, VectorFeature& to) {
  if (FieldOf(feature, kHoleProperty) < 0) return;
  to.cluster = WholeNumberOf(feature, kClusterProperty);
  const auto number = [&](const char* property, double low, double high) {
    return MetresOf(feature, property, low, high, "a number as it was written, or no value", to.label);
  };
  const auto word = [&](const char* property) {
    const int index = FieldOf(feature, property);
    return index < 0 ? std::string() : WordOf(feature, index);
  };
  const std::optional<double> sigma = number(kSigmaProperty, 0, kMostSigma);
  const std::optional<double> estimate = number(kEstimateProperty, -kMostHeight, kMostHeight);
  if (to.water && to.level && to.level == estimate) to.level_sigma = sigma;
  const std::string taken_for = word(kTakenForProperty);
  to.was_water = IsOneOf(taken_for, {"lake", "river"});
  to.is_as_found = to.water && word(kDecidedByProperty) == kByRim && word(kKindProperty) == taken_for && !to.clear &&
                   (to.level_sigma || (to.kind == WaterKind::kRiver && !to.level));
}

ReviewDecision DecisionOf(const OGRFeature& feature, const std::string& place) {
  const int index = FieldOf(feature, kDecisionProperty);
  if (index < 0) return ReviewDecision::kNone;
  const std::string word = WordOf(feature, index);
  if (word == "accept") return ReviewDecision::kAccept;
  if (word == "water") return ReviewDecision::kWater;
  if (word == "ground") return ReviewDecision::kGround;
  if (word == "open") return ReviewDecision::kOpen;
  RefuseValue(place, kDecisionProperty, feature.GetFieldAsString(index), "accept, water, ground or open");
}

std::optional<double> LevelOf(const OGRFeature& feature, const std::string& place) {
  return MetresOf(feature, kLevelProperty, -kMostHeight, kMostHeight,
                  "a height in metres from -100000 to 100000, such as 3.25 or \"3.25 m\"", place);
}

}  // namespace

int FieldOf(const OGRFeature& feature, const char* name) {
  const int index = feature.GetFieldIndex(name);
  if (index < 0 || !feature.IsFieldSetAndNotNull(index)) return -1;
  const bool is_text = feature.GetFieldDefnRef(index)->GetType() == OFTString;
  return is_text && Trimmed(feature.GetFieldAsString(index)).empty() ? -1 : index;
}

std::string ShownName(const std::string& name) { return SqueezedTo(Printable(name), kMostOfName); }

std::string LabelOf(const OGRFeature& feature, const std::string& prefix) {
  std::string label = prefix + "feature " + std::to_string(feature.GetFID());
  const int index = FieldOf(feature, "name");
  if (index >= 0) label += " (" + ShownName(feature.GetFieldAsString(index)) + ")";
  return label;
}

void SetProperties(const OGRFeature& feature, VectorFeature& to) {
  to.water = BooleanOf(feature, kWaterProperty, true, to.label);
  to.level = LevelOf(feature, to.label);
  to.clear = BooleanOf(feature, kClearProperty, false, to.label);
  const bool is_short = FieldOf(feature, kClearHeightProperty) < 0;
  to.clear_height = MetresOf(feature, is_short ? kShortClearHeight : kClearHeightProperty, 0, kMostClearHeight,
                             "a number of metres from 0 to 1000", to.label);
  to.kind = KindOf(feature, to.label);
  to.body = BodyOf(feature);
  SetFound(feature, to);
}

void SetDecision(const OGRFeature& feature, VectorFeature& to) {
  to.decision = DecisionOf(feature, to.label);
  if (const auto hole = WholeNumberOf(feature, kHoleProperty)) to.holes = {*hole};
  to.body = WholeNumberOf(feature, kClusterProperty);
  to.level = LevelOf(feature, to.label);
}

std::vector<Point2> CentrelineOf(const OGRFeature& feature, const std::string& place) {
  const int index = FieldOf(feature, kCentrelineProperty);
  if (index < 0) return {};
  std::string text = feature.GetFieldAsString(index);
  if (text.starts_with('[')) text = R"({"type": "LineString", "coordinates": )" + text + "}";
  GeometryPtr geometry;
  if (text.starts_with('{')) {
    geometry.reset(OGRGeometryFactory::createFromGeoJson(text.c_str()));
  } else if (OGRGeometry* read = nullptr;
             OGRGeometryFactory::createFromWkt(text.c_str(), nullptr, &read) == OGRERR_NONE) {
    geometry.reset(read);
  }
  return LineOf(geometry.get(), place + ", property centreline");
}

}  // namespace tilemend
