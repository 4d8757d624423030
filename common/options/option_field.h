// The field of a v1::JobSpec that an option stands for, by the descriptor of the message.
#ifndef TILEMEND_COMMON_OPTIONS_OPTION_FIELD_H_
#define TILEMEND_COMMON_OPTIONS_OPTION_FIELD_H_

#include <string>

#include "common/options/option.h"
#include "tilemend/v1/job_spec.pb.h"

namespace tilemend {

// Precondition: the message has a field of the option's name, of a type that fits (OptionTableTest holds them to it).
// The option outlives this.
class OptionField {
 public:
  explicit OptionField(const Option& option);

  // With `optional` in the message: absent where nothing is given.
  bool IsOptional() const;
  bool IsNumber() const;
  bool IsAbsent(const v1::JobSpec& spec) const;
  // Present, or for a field without `optional` other than its default.
  bool Differs(const v1::JobSpec& spec) const;

  // Precondition of each: the field has that type.
  double Number(const v1::JobSpec& spec) const;
  std::string Text(const v1::JobSpec& spec) const;
  void SetNumber(double value, v1::JobSpec& spec) const;
  void SetText(const std::string& value, v1::JobSpec& spec) const;
  void SetSwitch(bool value, v1::JobSpec& spec) const;

  // The option's default where a field without `optional` is empty or 0.
  void SetDefault(v1::JobSpec& spec) const;
  void Copy(const v1::JobSpec& from, v1::JobSpec& to) const;
  // For the report. Of an absent field its default.
  decltype(ReportedOption::value) Value(const v1::JobSpec& spec) const;

 private:
  const Option& option_;
  const google::protobuf::FieldDescriptor* const field_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_OPTIONS_OPTION_FIELD_H_
