#include "client/report_agreement.h"

#include <cstdint>
#include <map>
#include <set>

#include "absl/strings/str_cat.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// The sum of the numbers in an object of numbers and such objects.
int64_t Total(const Json& counts) {
  if (counts.is_number_integer()) return counts.get<int64_t>();
  int64_t total = 0;
  if (counts.is_object()) {
    for (const Json& part : counts) total += Total(part);
  }
  return total;
}

const Json& RowsOf(const Json& report, const char* name) {
  static const Json kNone = Json::array();
  const Json& rows = Member(report, name);
  return rows.is_array() ? rows : kNone;
}

class Comparison {
 public:
  explicit Comparison(const Json& report) : report_(report) {}

  std::vector<std::string> Run() {
    for (const Json& hole : RowsOf(report_, "per_hole")) TakeHole(hole);
    for (const Json& row : RowsOf(report_, "water")) CompareWater(row);
    for (const auto& [hole, level] : water_) {
      if (!named_.contains(hole)) Add("hole ", hole, ": filled as water, and in no row of `water`");
    }
    Compare("holes", found_);
    Compare("filled", filled_);
    return std::move(contradictions_);
  }

 private:
  template <typename... Parts>
  void Add(const Parts&... parts) {
    contradictions_.push_back(absl::StrCat("report.json: ", parts...));
  }

  void TakeHole(const Json& hole) {
    ++found_;
    if (Member(hole, "outcome") != "filled") return;
    ++filled_;
    if (Member(hole, "method") == "water") {
      water_[static_cast<int64_t>(Number(Member(hole, "id")))] = Member(hole, "level_m");
    }
  }

  void CompareWater(const Json& row) {
    const Json& level = Member(row, "level_m");
    for (const Json& number : RowsOf(row, "holes")) {
      const auto hole = static_cast<int64_t>(Number(number));
      const auto found = water_.find(hole);
      if (found == water_.end()) {
        Add("hole ", hole, ": in a row of `water`, and not filled as water");
      } else if (found->second != level) {
        Add("hole ", hole, ": level ", Text(found->second), " m, in its row of `water` ", Text(level), " m");
      }
      named_.insert(hole);
    }
  }

  void Compare(const char* name, int64_t rows) {
    const int64_t total = Total(Member(report_, name));
    if (total != rows) Add("`", name, "` counts ", total, ", `per_hole` has ", rows);
  }

  const Json& report_;
  int64_t found_ = 0, filled_ = 0;
  std::map<int64_t, Json> water_;  // levels of holes that were filled as water
  std::set<int64_t> named_;        // holes in rows of `water`
  std::vector<std::string> contradictions_;
};

}  // namespace

std::vector<std::string> ReportContradictions(const Json& report) { return Comparison(report).Run(); }

}  // namespace tilemend
