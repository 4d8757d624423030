#include "client/repeated_reasons.h"

#include <map>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

constexpr size_t kMinLength = 30;  // what is shorter takes no more room than its number is worth
constexpr char kColon[] = ": ";

struct Seen {
  int count = 0, number = 0;
  std::string first;
};

std::string BeginningOf(const std::string& reason) { return reason.substr(0, reason.find(kColon)); }

std::string DifferenceOf(const std::string& reason) {
  const size_t colon = reason.find(kColon);
  const size_t begin = colon == std::string::npos ? reason.size() : colon + 2;
  return reason.substr(begin, reason.find(',', begin) - begin);
}

}  // namespace

void ShortenRepeated(const std::vector<std::string*>& reasons) {
  std::map<std::string, Seen> all;
  for (const std::string* reason : reasons) ++all[BeginningOf(*reason)].count;
  int last = 0;
  for (std::string* reason : reasons) {
    Seen& seen = all[BeginningOf(*reason)];
    if (seen.count < 2 || reason->size() <= kMinLength) continue;
    const bool is_first = seen.number == 0;
    if (is_first) {
      seen.number = ++last;
      seen.first = *reason;
    }
    const std::string number = absl::StrCat("[", seen.number, "]");
    const std::string shown = is_first ? *reason : *reason == seen.first ? "" : DifferenceOf(*reason);
    *reason = absl::StrCat(number, shown.empty() ? "" : " ", shown);
  }
}

void ShortenRepeated(std::vector<std::vector<std::string>>& rows) {
  std::vector<std::string*> reasons;
  for (std::vector<std::string>& row : rows) reasons.push_back(&row.back());
  ShortenRepeated(reasons);
}

}  // namespace tilemend
