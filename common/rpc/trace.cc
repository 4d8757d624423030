#include "common/rpc/trace.h"

#include <algorithm>
#include <random>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace tilemend {
namespace {

constexpr size_t kTraceDigits = 32;
constexpr size_t kSpanDigits = 16;
constexpr std::string_view kVersion = "00-";

bool IsHex(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); }) &&
         text.find_first_not_of('0') != std::string_view::npos;
}

}  // namespace

std::string NewTrace() {
  std::random_device random;
  return absl::StrFormat("%08x%08x%08x%08x", random() | 1, random(), random(), random());
}

std::string TraceParent(const std::string& trace) {
  return absl::StrCat(std::string(kVersion), trace, "-", trace.substr(0, kSpanDigits), "-01");
}

std::string TraceOf(std::string_view parent) {
  if (!parent.starts_with(kVersion) || parent.size() < kVersion.size() + kTraceDigits + 1) return "";
  const std::string_view trace = parent.substr(kVersion.size(), kTraceDigits);
  return IsHex(trace) && parent[kVersion.size() + kTraceDigits] == '-' ? std::string(trace) : "";
}

}  // namespace tilemend
