#include "coordinator/report/scene_member.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSamePlace = 0.001;  // metres: a corner may go through the arithmetic of another program

std::string NameOf(const Scene& scene) {
  std::filesystem::path folder = scene.root;
  if (std::error_code error; !IsObjectPath(scene.root)) folder = std::filesystem::absolute(folder, error);
  folder = folder.lexically_normal();
  return Printable((folder.has_filename() ? folder : folder.parent_path()).filename().string());
}

bool AreNear(const Json& a, const Json& b) {
  const auto is_pair = [](const Json& p) { return p.is_array() && p.size() == 2; };
  if (!is_pair(a) || !is_pair(b)) return false;
  return std::abs(Number(a[0]) - Number(b[0])) <= kSamePlace && std::abs(Number(a[1]) - Number(b[1])) <= kSamePlace;
}

// What differs but for the name, in the words of a message; empty: nothing.
std::vector<std::string> DifferencesOf(const Json& a, const Json& b) {
  std::vector<std::string> differences;
  if (Member(a, "crs") != Member(b, "crs")) differences.emplace_back("the CRS");
  if (!AreNear(Member(a, "grid_corner"), Member(b, "grid_corner"))) differences.emplace_back("the corner of the grid");
  if (!AreNear(Member(a, "cell_size"), Member(b, "cell_size"))) differences.emplace_back("the cell size");
  return differences;
}

std::string PairText(const Json& pair, const char* between) {
  if (!pair.is_array() || pair.size() != 2) return "?";
  return absl::StrFormat("%.10g%s%.10g", Number(pair[0]), between, Number(pair[1]));
}

// "'city' (EPSG:25832, cells of 80 x 80 m from 500000, 4100000)".
std::string SceneText(const Json& scene) {
  const std::string crs = Text(Member(scene, "crs"));
  return Printable(absl::StrCat("'", Text(Member(scene, "name")), "' (", crs.empty() ? "no CRS" : crs, ", cells of ",
                                PairText(Member(scene, "cell_size"), " x "), " m from ",
                                PairText(Member(scene, "grid_corner"), ", "), ")"));
}

// Letters of a text, which counts the lines up to the last one that was read.
class CountedLetters {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountedLetters(const char* at, int64_t* line) : at_(at), line_(line) {}
  reference operator*() const { return *at_; }
  CountedLetters& operator++() {
    if (*at_++ == '\n') ++*line_;
    return *this;
  }
  bool operator==(const CountedLetters& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  int64_t* line_;
};

// The member of the file; null if it is not there or is null, or if the file is no JSON. kInvalidArgument if it is
// neither that nor an object. Lists of the file are not kept.
absl::StatusOr<Json> ReadSceneMember(const std::string& bytes, const std::string& file) {
  int64_t line = 1, line_of_member = 0;
  bool is_member = false;
  std::string wrong;  // what it is in place of an object
  const auto look = [&](int depth, Json::parse_event_t event, const Json& value) {
    const bool is_list = event == Json::parse_event_t::array_start;
    if (depth != 1) return true;
    if (event == Json::parse_event_t::key) {
      is_member = value == kSceneMember;
      if (is_member) line_of_member = line;
    } else if (is_member && (is_list || (event == Json::parse_event_t::value && !value.is_null()))) {
      wrong = is_list ? "a list" : value.is_string() ? "text" : value.is_boolean() ? "true or false" : "a number";
    }
    return !is_list;
  };
  const CountedLetters begin(bytes.data(), &line), end(bytes.data() + bytes.size(), &line);
  Json json = Json::parse(begin, end, look, false);
  if (json.is_discarded() || wrong.empty()) return Member(json, kSceneMember);
  return absl::InvalidArgumentError(
      absl::StrCat(file, ": line ", line_of_member, ": ", kSceneMember, " is ", wrong,
                   "; expected an object with name, crs, grid_corner and cell_size, as holes.geojson has it; it may be "
                   "left out"));
}

}  // namespace

Json SceneMemberOf(const Scene& scene) {
  const Point2 corner = scene.origin.head<2>() + scene.grid.corner;
  return {{"name", NameOf(scene)},
          {"crs", scene.crs},
          {"grid_corner", {corner.x(), corner.y()}},
          {"cell_size", {scene.grid.cell_size.x(), scene.grid.cell_size.y()}}};
}

absl::StatusOr<std::string> CheckSceneMember(const std::string& bytes, const std::string& file, const Scene& scene) {
  TILEMEND_ASSIGN_OR_RETURN(const Json other, ReadSceneMember(bytes, file));
  if (!other.is_object()) return "";
  const Json own = SceneMemberOf(scene);
  const std::vector<std::string> differences = DifferencesOf(other, own);
  if (!differences.empty()) {
    return absl::InvalidArgumentError(absl::StrCat(file, ": its decisions are on scene ", SceneText(other), ", not on ",
                                                   SceneText(own), "; different: ", absl::StrJoin(differences, ", "),
                                                   "; give the file of this scene"));
  }
  if (Member(other, "name") == Member(own, "name")) return "";
  return Printable(absl::StrCat(file, ": its decisions are on a scene in folder '", Text(Member(other, "name")),
                                "', and this one is in '", Text(Member(own, "name")),
                                "'; they have the same grid; if it is another scene, give the file of this one"));
}

}  // namespace tilemend
