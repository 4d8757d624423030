#include "common/s3/s3_answers.h"

#include <pugixml.hpp>

#include "absl/strings/strip.h"

namespace tilemend {
namespace {

pugi::xml_document Parsed(const std::string& xml) {
  pugi::xml_document document;
  document.load_buffer(xml.data(), xml.size());
  return document;
}

}  // namespace

S3Error ErrorInAnswer(const std::string& xml) {
  const pugi::xml_document document = Parsed(xml);
  const pugi::xml_node error = document.child("Error");
  return {error.child_value("Code"), error.child_value("Message")};
}

std::string TextInAnswer(const std::string& xml, std::span<const char* const> above, const char* name) {
  const pugi::xml_document document = Parsed(xml);
  pugi::xml_node node = document;
  for (const char* element : above) node = node.child(element);
  return node.child_value(name);
}

std::string UnquotedETag(std::string_view etag) {
  return std::string(absl::StripPrefix(absl::StripSuffix(absl::string_view(etag.data(), etag.size()), "\""), "\""));
}

absl::StatusOr<S3Page> ReadListing(const std::string& xml, const std::string& prefix) {
  const pugi::xml_document document = Parsed(xml);
  const pugi::xml_node listing = document.child("ListBucketResult");
  if (!listing) return absl::DataLossError("the store's answer is no list of objects");
  S3Page page;
  const auto add = [&](std::string_view key, bool is_folder) {
    if (!key.starts_with(prefix)) return;
    key.remove_prefix(prefix.size());
    if (is_folder && key.ends_with('/')) key.remove_suffix(1);
    if (!key.empty()) page.entries.push_back({std::string(key), is_folder});
  };
  for (const pugi::xml_node object : listing.children("Contents")) add(object.child_value("Key"), false);
  for (const pugi::xml_node folder : listing.children("CommonPrefixes")) add(folder.child_value("Prefix"), true);
  if (std::string_view(listing.child_value("IsTruncated")) == "true") {
    page.next = listing.child_value("NextContinuationToken");
    if (page.next.empty()) return absl::DataLossError("the store's list of objects has more, but does not say where");
  }
  return page;
}

}  // namespace tilemend
