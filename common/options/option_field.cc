#include "common/options/option_field.h"

#include "absl/strings/numbers.h"

namespace tilemend {
namespace {

using google::protobuf::FieldDescriptor;

const google::protobuf::Reflection& ReflectionOf(const v1::JobSpec& spec) { return *spec.GetReflection(); }

}  // namespace

OptionField::OptionField(const Option& option)
    : option_(option), field_(v1::JobSpec::descriptor()->FindFieldByName(option.field)) {}

bool OptionField::IsOptional() const { return field_->has_presence(); }

bool OptionField::IsNumber() const {
  return field_->cpp_type() != FieldDescriptor::CPPTYPE_STRING && field_->cpp_type() != FieldDescriptor::CPPTYPE_BOOL;
}

bool OptionField::IsAbsent(const v1::JobSpec& spec) const {
  return IsOptional() && !ReflectionOf(spec).HasField(spec, field_);
}

bool OptionField::Differs(const v1::JobSpec& spec) const {
  if (IsOptional()) return ReflectionOf(spec).HasField(spec, field_);
  if (field_->cpp_type() == FieldDescriptor::CPPTYPE_BOOL) return ReflectionOf(spec).GetBool(spec, field_);
  if (!IsNumber()) return Text(spec) != option_.default_value;
  double value = 0;
  return !absl::SimpleAtod(option_.default_value, &value) || Number(spec) != value;
}

double OptionField::Number(const v1::JobSpec& spec) const {
  switch (field_->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return ReflectionOf(spec).GetInt32(spec, field_);
    case FieldDescriptor::CPPTYPE_INT64:
      return static_cast<double>(ReflectionOf(spec).GetInt64(spec, field_));
    default:
      return ReflectionOf(spec).GetDouble(spec, field_);
  }
}

std::string OptionField::Text(const v1::JobSpec& spec) const { return ReflectionOf(spec).GetString(spec, field_); }

void OptionField::SetNumber(double value, v1::JobSpec& spec) const {
  switch (field_->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return ReflectionOf(spec).SetInt32(&spec, field_, static_cast<int32_t>(value));
    case FieldDescriptor::CPPTYPE_INT64:
      return ReflectionOf(spec).SetInt64(&spec, field_, static_cast<int64_t>(value));
    default:
      return ReflectionOf(spec).SetDouble(&spec, field_, value);
  }
}

void OptionField::SetText(const std::string& value, v1::JobSpec& spec) const {
  ReflectionOf(spec).SetString(&spec, field_, value);
}

void OptionField::SetSwitch(bool value, v1::JobSpec& spec) const { ReflectionOf(spec).SetBool(&spec, field_, value); }

void OptionField::SetDefault(v1::JobSpec& spec) const {
  if (IsOptional() || option_.default_value.empty() || ReflectionOf(spec).HasField(spec, field_)) return;
  double value = 0;
  if (!IsNumber()) {
    SetText(option_.default_value, spec);
  } else if (absl::SimpleAtod(option_.default_value, &value)) {
    SetNumber(value, spec);
  }
}

void OptionField::Copy(const v1::JobSpec& from, v1::JobSpec& to) const {
  if (IsAbsent(from)) return;
  if (IsNumber()) return SetNumber(Number(from), to);
  if (field_->cpp_type() == FieldDescriptor::CPPTYPE_BOOL) {
    return SetSwitch(ReflectionOf(from).GetBool(from, field_), to);
  }
  SetText(Text(from), to);
}

decltype(ReportedOption::value) OptionField::Value(const v1::JobSpec& spec) const {
  double value = 0;
  if (IsAbsent(spec)) {
    if (absl::SimpleAtod(option_.default_value, &value)) return value;
    return option_.default_value;
  }
  if (IsNumber()) return Number(spec);
  if (field_->cpp_type() == FieldDescriptor::CPPTYPE_BOOL) return ReflectionOf(spec).GetBool(spec, field_);
  return Text(spec);
}

}  // namespace tilemend
