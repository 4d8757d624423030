#include "common/gis/raw_features.h"

#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "common/gis/feature_geometry.h"
#include "common/gis/feature_properties.h"
#include "common/gis/property_names.h"

namespace tilemend {
namespace {

// Features that are left out for one reason.
struct LeftOut {
  int64_t count = 0;
  std::string first;

  void Add(const std::string& label) {
    if (++count == 1) first = label;
  }
  // "feature 3 and 2 more are no polygon..."; nothing if there are none.
  void Tell(const std::string& what, std::vector<std::string>& warnings) const {
    if (count == 0) return;
    const std::string more = count > 1 ? " and " + std::to_string(count - 1) + " more" : "";
    warnings.push_back(first + more + ": " + what);
  }
};

// In holes.geojson all holes are, and those that were filled as water say so.
bool IsHole(const OGRFeature& feature) { return FieldOf(feature, kHoleProperty) >= 0; }
bool IsDryHole(const OGRFeature& feature) { return IsHole(feature) && FieldOf(feature, kWaterProperty) < 0; }

// What a feature says of its polygon.
using Metres = std::optional<double>;
using Saying = std::tuple<bool, Metres, WaterKind, bool, Metres, ReviewDecision, Metres, bool>;
Saying SayingOf(const VectorFeature& f) {
  return {f.water, f.level, f.kind, f.clear, f.clear_height, f.decision, f.level_sigma, f.is_as_found};
}
void Say(const Saying& saying, VectorFeature& f) {
  std::tie(f.water, f.level, f.kind, f.clear, f.clear_height, f.decision, f.level_sigma, f.is_as_found) = saying;
}

// Whether a hole that was no water says something of water that the program did not write.
bool IsChanged(const VectorFeature& dry) {
  const bool is_given = dry.level && !dry.level_sigma;
  return is_given || dry.kind != WaterKind::kUnsaid || dry.clear || dry.clear_height;
}

// What the rows of a cluster in holes.geojson say. A hole over several cells has a row for each: who changed some of
// them means the hole.
struct ClusterRows {
  std::optional<Saying> change;  // of the changed rows
  bool differs = false;          // they say different things
  bool was_water = false;        // a row was water before

  void Add(const VectorFeature& row) {
    was_water = was_water || row.was_water;
    if (row.is_as_found) return;
    differs = differs || (change && *change != SayingOf(row));
    change = SayingOf(row);
  }
};

// Features of one body that say the same become the first of them.
void UniteBodies(std::vector<VectorFeature>& features) {
  const auto said = [](const VectorFeature& f) { return std::pair(*f.body, SayingOf(f)); };
  std::map<std::pair<int64_t, Saying>, std::vector<VectorFeature>> bodies;
  for (VectorFeature& f : features) {
    if (f.body) bodies[said(f)].push_back(f);
  }
  std::vector<VectorFeature> united;
  for (VectorFeature& f : features) {
    const auto body = f.body ? bodies.find(said(f)) : bodies.end();
    if (f.body && body == bodies.end()) continue;
    VectorFeature& one = united.emplace_back(std::move(f));
    if (body == bodies.end()) continue;
    const size_t parts = body->second.size();
    one.polygon = Unite(body->second).polygon;
    one.holes.clear();
    for (const VectorFeature& part : body->second)
      one.holes.insert(one.holes.end(), part.holes.begin(), part.holes.end());
    if (parts > 1) one.label += " and " + std::to_string(parts - 1) + " more";
    bodies.erase(body);
  }
  features = std::move(united);
}

class Layer {
 public:
  Layer(std::string prefix, const LayerRules& rules) : prefix_(std::move(prefix)), rules_(rules) {}

  void AddAll(OGRLayer& layer) {
    if (rules_.use == VectorUse::kWater && layer.GetLayerDefn()->GetFieldIndex(kHoleProperty) >= 0) LookAtHoles(layer);
    for (const auto& feature : layer) Add(*feature);
    if (rules_.use != VectorUse::kArea) UniteBodies(read_.features);
  }

  RawFeatures Done() && {
    other_.Tell(rules_.is_drawing ? "neither polygons nor closed lines, so they have no effect"
                                  : "neither polygons nor lines, so they have no effect",
                read_.warnings);
    dry_.Tell("holes whose property water is empty, so they have no effect; true or false would decide",
              read_.warnings);
    edited_.Tell(
        "holes that were changed but whose property water is empty, so the change has no effect; set it to true",
        read_.warnings);
    return std::move(read_);
  }

 private:
  void LookAtHoles(OGRLayer& layer) {
    for (const auto& feature : layer) {
      if (!IsHole(*feature)) continue;
      const VectorFeature row = RowOf(*feature);
      if (row.cluster && !IsDryHole(*feature)) clusters_[*row.cluster].Add(row);
    }
  }

  VectorFeature RowOf(const OGRFeature& feature) const {
    VectorFeature row;
    row.label = LabelOf(feature, prefix_);
    SetProperties(feature, row);
    return row;
  }

  void Add(const OGRFeature& feature) {
    if (rules_.use == VectorUse::kDecisions && FieldOf(feature, kDecisionProperty) < 0) return;
    if (rules_.use == VectorUse::kWater && IsHole(feature)) return AddHole(feature);
    AddGeometry(feature);
  }

  // A row that is as found says the same as the changed ones of its cluster, unless these differ. So does one that is
  // no water, where no row of the cluster was water: there it is the dry part.
  void AddHole(const OGRFeature& feature) {
    const bool is_dry = IsDryHole(feature);
    const VectorFeature row = RowOf(feature);
    if (is_dry && IsChanged(row)) return edited_.Add(row.label);
    const auto rows = row.cluster ? clusters_.find(*row.cluster) : clusters_.end();
    const bool is_changed = rows != clusters_.end() && rows->second.change && !rows->second.differs;
    const bool follows = is_changed && (is_dry ? !rows->second.was_water : row.is_as_found);
    if (is_dry && !follows) return dry_.Add(row.label);
    const size_t before = read_.features.size();
    AddGeometry(feature);
    if (follows && read_.features.size() > before) Say(*rows->second.change, read_.features.back());
  }

  void AddGeometry(const OGRFeature& feature) {
    const std::string label = LabelOf(feature, prefix_);
    const OGRGeometry* geometry = feature.GetGeometryRef();
    if (geometry == nullptr && rules_.needs_geometry)
      throw BadVectors{label + ": no geometry, or none that can be read"};
    const GeometryPtr linear(geometry != nullptr ? geometry->getLinearGeometry() : nullptr);  // arcs become chords
    if (linear != nullptr) geometry = linear.get();
    const GeometryPtr area(rules_.is_drawing && geometry != nullptr ? AreaWithin(*geometry) : nullptr);
    if (area != nullptr) geometry = area.get();
    if (!IsOfUse(geometry, IsHole(feature))) return other_.Add(label);
    Take(feature, *geometry, label);
  }

  bool IsOfUse(const OGRGeometry* geometry, bool is_hole) const {
    if (geometry == nullptr || !IsAreaOrLine(*geometry)) return false;
    return geometry->getDimension() == 2 || !(rules_.is_drawing || is_hole);
  }

  void Take(const OGRFeature& feature, const OGRGeometry& geometry, const std::string& label) {
    VectorFeature& raw = read_.features.emplace_back();
    raw.label = label;
    SetGeometry(geometry, raw);
    if (rules_.use == VectorUse::kDecisions) SetDecision(feature, raw);
    if (rules_.use == VectorUse::kWater) SetProperties(feature, raw);
    if (raw.polygon.empty()) return;
    const std::string fault =
        Repair(geometry, rules_.use == VectorUse::kArea ? Crossings::kRefuse : Crossings::kRepair, raw);
    if (!fault.empty()) {
      read_.warnings.push_back(label + ": " + fault + "; it is taken as repaired: all that it surrounds is inside");
    }
    if (rules_.use == VectorUse::kWater) raw.line = CentrelineOf(feature, label);
  }

  const std::string prefix_;
  const LayerRules rules_;
  RawFeatures read_;
  LeftOut other_, dry_, edited_;
  std::map<int64_t, ClusterRows> clusters_;
};

}  // namespace

RawFeatures RawFeaturesOf(OGRLayer& layer, const std::string& prefix, const LayerRules& rules) {
  Layer read(prefix, rules);
  read.AddAll(layer);
  return std::move(read).Done();
}

std::vector<std::string> NearMisses(OGRLayer& layer, const std::string& prefix) {
  std::vector<std::string> warnings;
  OGRFeatureDefn& definition = *layer.GetLayerDefn();
  for (int i = 0; i < definition.GetFieldCount(); ++i) {
    const char* const name = definition.GetFieldDefn(i)->GetNameRef();
    const std::string meant(PropertyMeantBy(name));
    if (meant.empty() || name == std::string_view(kShortClearHeight) || definition.GetFieldIndex(meant.c_str()) == i)
      continue;
    std::string first;
    int64_t count = 0;
    for (const auto& feature : layer) {
      const OGRGeometry* geometry = feature->GetGeometryRef();
      const bool is_area = geometry != nullptr && geometry->getDimension() == 2;
      if (!is_area || !feature->IsFieldSetAndNotNull(i) || FieldOf(*feature, meant.c_str()) >= 0) continue;
      if (++count == 1) first = LabelOf(*feature, prefix);
    }
    if (count == 0) continue;
    std::string warning = first;
    if (count > 1) warning += " and " + std::to_string(count - 1) + " more";
    warning += ": property '" + ShownName(name) + "' has no effect; the name that has is '" + meant + "'";
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace tilemend
