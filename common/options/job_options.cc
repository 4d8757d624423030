#include "common/options/job_options.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "common/grid/cell_choice.h"
#include "common/options/option_field.h"
#include "common/options/option_needs.h"
#include "common/util/colour.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr char kTrue[] = "true";  // the text of a switch that is on
constexpr size_t kMaxPathBytes = 4096;
constexpr size_t kMaxCellsBytes = size_t{64} << 10;  // kept with the job, and shown with it

absl::Status InvalidSpec(const std::string& field, const std::string& what) {
  return WithErrorInfo(absl::InvalidArgumentError(absl::StrCat(field, what)), {"INVALID_SPEC", {{"field", field}}});
}

// The value, as a message shows it, and what is allowed.
absl::Status InvalidValue(const Option& option, const std::string& value) {
  return InvalidSpec(option.field, absl::StrCat(" '", Printable(value), "': expected ", Expected(option)));
}

bool IsWord(const Option& option, const std::string& value) {
  return std::ranges::find(option.words, value) != option.words.end();
}

bool IsInRange(const Option& option, double value) {
  const bool is_whole = option.type == OptionType::kNumber || value == std::floor(value);
  return std::isfinite(value) && is_whole && value >= option.min && value <= option.max;
}

absl::Status CheckCells(const std::string& cells) {
  if (cells.size() > kMaxCellsBytes) return InvalidSpec("cells", ": more than 64 KiB");
  const absl::Status status = ParseCells(cells).status();
  return status.ok() ? status : InvalidSpec("cells", absl::StrCat(": ", std::string(status.message())));
}

// Another process has another working directory, and the system takes a path up to its first NUL.
absl::Status CheckAbsolute(const std::string& field, const std::string& path) {
  if (path.size() > kMaxPathBytes) return InvalidSpec(field, ": a path of more than 4096 bytes");
  if (path.find('\0') != std::string::npos) {
    return InvalidSpec(field, absl::StrCat(" '", Printable(path), "': a path with a NUL"));
  }
  if (!IsUtf8(path)) return InvalidSpec(field, absl::StrCat(" '", Printable(path), "': expected a path in UTF-8"));
  if (path.empty() || path.front() == '/' || path.find("://") != std::string::npos) return absl::OkStatus();
  return InvalidSpec(field, absl::StrCat(" '", Printable(path), "': a relative path; give one that begins with /"));
}

absl::Status CheckText(const Option& option, const std::string& value, bool absolute_paths) {
  switch (option.type) {
    case OptionType::kWord:
      return IsWord(option, value) ? absl::OkStatus() : InvalidValue(option, value);
    case OptionType::kPath:
      if (IsWord(option, value)) return absl::OkStatus();
      if (value.empty() && !option.default_value.empty()) return InvalidValue(option, value);
      return absolute_paths ? CheckAbsolute(option.field, value) : absl::OkStatus();
    case OptionType::kColour:
      return value.empty() || ParseColour(value) ? absl::OkStatus() : InvalidValue(option, value);
    default:
      return CheckCells(value);
  }
}

absl::Status CheckValue(const Option& option, const v1::JobSpec& spec, bool absolute_paths) {
  const OptionField field(option);
  if (field.IsAbsent(spec) || option.type == OptionType::kSwitch) return absl::OkStatus();
  if (!field.IsNumber()) return CheckText(option, field.Text(spec), absolute_paths);
  const double number = field.Number(spec);
  return IsInRange(option, number) ? absl::OkStatus() : InvalidValue(option, absl::StrCat(number));
}

// Whether `commands` have the field, in this row of the table or another.
bool IsOf(const Option& option, unsigned commands) {
  return std::ranges::any_of(AllOptions(), [&](const Option& other) {
    return (other.commands & commands) != 0 && std::string_view(other.field) == option.field;
  });
}

// kInvalidArgument for a field that no option of `commands` has.
absl::Status CheckFields(const std::map<std::string, std::string>& texts, unsigned commands) {
  std::vector<std::string> fields;
  for (const Option& option : AllOptions()) {
    if ((option.commands & commands) != 0) fields.emplace_back(option.field);
  }
  for (const auto& [field, text] : texts) {
    if (std::ranges::find(fields, field) != fields.end()) continue;
    return InvalidSpec(field, absl::StrCat(": there is no such option", DidYouMean(field, fields)));
  }
  return absl::OkStatus();
}

// `text` is what was given, or null for nothing: then fields without `optional` get their default.
absl::Status SetFromText(const Option& option, const std::string* text, v1::JobSpec& spec) {
  const OptionField field(option);
  if (option.type == OptionType::kSwitch) {
    if (text != nullptr && *text != kTrue) return InvalidValue(option, *text);
    field.SetSwitch(text != nullptr, spec);
    return absl::OkStatus();
  }
  const std::string value = text != nullptr ? *text : option.default_value;
  if (!field.IsNumber()) {
    if (text != nullptr || (!field.IsOptional() && !value.empty())) field.SetText(value, spec);
    return absl::OkStatus();
  }
  if ((text == nullptr && field.IsOptional()) || IsWord(option, value)) return absl::OkStatus();
  double number = 0;
  if (!absl::SimpleAtod(value, &number) || !IsInRange(option, number)) return InvalidValue(option, value);
  field.SetNumber(number, spec);
  return absl::OkStatus();
}

}  // namespace

v1::JobSpec WithDefaults(v1::JobSpec spec) {
  spec.DiscardUnknownFields();  // options of earlier releases
  // The slash would be part of the keys of objects.
  for (std::string* const path : {spec.mutable_scene(), spec.mutable_out()}) {
    while (path->find("://") != std::string::npos && path->ends_with('/')) path->pop_back();
  }
  for (const Option& option : AllOptions()) {
    if ((option.commands & kOfJobs) != 0) OptionField(option).SetDefault(spec);
  }
  return spec;
}

bool AreEqual(const v1::JobSpec& a, const v1::JobSpec& b) { return a.SerializeAsString() == b.SerializeAsString(); }

absl::Status CheckOptions(const v1::JobSpec& spec, unsigned commands, const IsGiven& is_given) {
  for (const Option& option : AllOptions()) {
    if ((option.commands & commands) == 0) continue;
    TILEMEND_RETURN_IF_ERROR(CheckValue(option, spec, (commands & kOfJobs) != 0));
    if (!(is_given ? is_given(option) : OptionField(option).Differs(spec))) continue;
    if (const std::string why = WhyWithoutEffect(option.needs, spec); !why.empty()) {
      return InvalidSpec(option.field, absl::StrCat(": ", why));
    }
  }
  return absl::OkStatus();
}

absl::Status CheckJob(const v1::JobSpec& spec, const IsGiven& is_given) {
  if (spec.scene().empty()) return InvalidSpec("scene", ": no path is given");
  TILEMEND_RETURN_IF_ERROR(CheckAbsolute("scene", spec.scene()));
  if (spec.out().empty() && !spec.dry_run()) return InvalidSpec("out", ": no folder is given to write to");
  for (const Option& option : AllOptions()) {
    if (!IsOf(option, kOfJobs) && OptionField(option).Differs(spec)) {
      return InvalidSpec(option.field, ": only `tilemend fill` has this option; leave it out");
    }
  }
  return CheckOptions(spec, kOfJobs, is_given);
}

absl::StatusOr<v1::JobSpec> SpecFromTexts(const std::map<std::string, std::string>& texts, unsigned commands) {
  TILEMEND_RETURN_IF_ERROR(CheckFields(texts, commands));
  v1::JobSpec spec;
  for (const Option& option : AllOptions()) {
    if ((option.commands & commands) == 0) continue;
    const auto given = texts.find(option.field);
    TILEMEND_RETURN_IF_ERROR(SetFromText(option, given == texts.end() ? nullptr : &given->second, spec));
  }
  return spec;
}

absl::StatusOr<v1::JobSpec> SpecFromFlags(const Flags& flags, unsigned commands) {
  std::map<std::string, std::string> texts;
  for (const Option& option : AllOptions()) {
    const std::string name = FlagOf(option);
    if ((option.commands & commands) == 0) continue;
    if (flags.IsGiven(name)) {
      texts[option.field] = option.type == OptionType::kSwitch ? kTrue : flags.Text(name);
    } else if (!OptionField(option).IsOptional() && !flags.Text(name).empty()) {
      texts[option.field] = flags.Text(name);  // a command may have a default of its own
    }
  }
  auto spec = SpecFromTexts(texts, commands);
  return spec.ok() ? std::move(spec) : NamedAsFlag(spec.status());
}

absl::Status NamedAsFlag(const absl::Status& status) {
  const auto info = GetErrorInfo(status);
  if (!info || !info->metadata.contains("field")) return status;
  const std::string& field = info->metadata.at("field");
  if (field == "scene") return status;
  return absl::Status(status.code(), absl::StrCat("--", absl::StrReplaceAll(field, {{"_", "-"}}),
                                                  std::string(status.message()).substr(field.size())));
}

v1::JobSpec OptionsForWorkers(const v1::JobSpec& spec) {
  v1::JobSpec sent;
  for (const Option& option : AllOptions()) {
    if (option.to_workers) OptionField(option).Copy(spec, sent);
  }
  return sent;
}

absl::Status CheckOptionsForWorkers(const v1::JobSpec& spec) {
  for (const Option& option : AllOptions()) {
    if (option.to_workers) TILEMEND_RETURN_IF_ERROR(CheckValue(option, spec, true));
  }
  return absl::OkStatus();
}

std::vector<ReportedOption> ReportedOptions(const v1::JobSpec& spec, unsigned commands) {
  std::vector<ReportedOption> reported;
  for (const Option& option : AllOptions()) {
    const bool is_of_method = option.group == FlagGroup::kPapers;
    if ((option.commands & commands) == 0 || !option.in_report) continue;
    if (is_of_method && !WhyWithoutEffect(option.needs, spec).empty()) continue;
    reported.push_back({FlagOf(option), OptionField(option).Value(spec)});
  }
  return reported;
}

}  // namespace tilemend
