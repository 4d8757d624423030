#include "coordinator/web/message_json.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/type_resolver.h>
#include <google/protobuf/util/type_resolver_util.h>

#include <memory>

#include "absl/strings/str_cat.h"
#include "tilemend/v1/error_info.pb.h"

namespace tilemend {
namespace {

constexpr char kTypes[] = "type.googleapis.com";

// The program's own messages, and ErrorInfo by its other name.
class MessageTypes {
 public:
  MessageTypes() {
    google::protobuf::FileDescriptorProto file;
    file.set_name("google/rpc/error_details.proto");
    file.set_package("google.rpc");
    file.set_syntax("proto3");
    google::protobuf::DescriptorProto& info = *file.add_message_type();
    v1::ErrorInfo::descriptor()->CopyTo(&info);
    for (google::protobuf::FieldDescriptorProto& field : *info.mutable_field()) {
      if (field.has_type_name()) field.set_type_name(".google.rpc.ErrorInfo.MetadataEntry");
    }
    pool_.BuildFile(file);
    resolver_.reset(google::protobuf::util::NewTypeResolverForDescriptorPool(kTypes, &pool_));
  }

  google::protobuf::util::TypeResolver* resolver() const { return resolver_.get(); }

 private:
  google::protobuf::DescriptorPool pool_{google::protobuf::DescriptorPool::generated_pool()};
  std::unique_ptr<google::protobuf::util::TypeResolver> resolver_;
};

}  // namespace

absl::StatusOr<std::string> MessageJson(const google::protobuf::Message& message) {
  static const auto& types = *new MessageTypes;
  google::protobuf::util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;
  std::string text;
  const auto status = google::protobuf::util::BinaryToJsonString(
      types.resolver(), absl::StrCat(kTypes, "/", message.GetDescriptor()->full_name()), message.SerializeAsString(),
      &text, options);
  if (!status.ok()) return absl::InternalError(absl::StrCat("the answer is no JSON: ", status.ToString()));
  return text;
}

}  // namespace tilemend
