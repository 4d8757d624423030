#include "coordinator/web/open_api.h"

#include <google/protobuf/descriptor.h>

#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/util/version.h"
#include "coordinator/web/routes.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;
using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;
using google::protobuf::FieldDescriptor;

Json Ref(const std::string& name) { return {{"$ref", absl::StrCat("#/components/schemas/", name)}}; }

// Schemas of messages, and of all that they hold.
class MessageSchemas {
 public:
  // The reference to a message's schema, which is made if it is not there.
  Json RefTo(const Descriptor& message) {
    if (message.full_name() == "google.protobuf.Timestamp") return {{"type", "string"}, {"format", "date-time"}};
    if (message.full_name() == "google.protobuf.Any") return {{"type", "object"}};
    if (known_.insert(message.full_name()).second) waiting_.push_back(&message);
    return Ref(message.full_name());
  }

  Json OfField(const FieldDescriptor& field) {
    Json one = OfValue(field);
    if (!field.is_repeated()) return one;
    return {{"type", "array"}, {"items", std::move(one)}};
  }

  // All that were referred to.
  Json Take() {
    Json schemas = Json::object();
    for (size_t k = 0; k < waiting_.size(); ++k) {  // NOLINT(modernize-loop-convert): it grows meanwhile
      const Descriptor& message = *waiting_[k];
      Json properties = Json::object();
      for (int f = 0; f < message.field_count(); ++f) {
        properties[message.field(f)->json_name()] = OfField(*message.field(f));
      }
      schemas[message.full_name()] = {{"type", "object"}, {"properties", std::move(properties)}};
    }
    return schemas;
  }

 private:
  Json OfValue(const FieldDescriptor& field) {
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_MESSAGE:
        return RefTo(*field.message_type());
      case FieldDescriptor::CPPTYPE_ENUM: {
        Json names = Json::array();
        for (int k = 0; k < field.enum_type()->value_count(); ++k) names.push_back(field.enum_type()->value(k)->name());
        return {{"type", "string"}, {"enum", std::move(names)}};
      }
      case FieldDescriptor::CPPTYPE_BOOL:
        return {{"type", "boolean"}};
      case FieldDescriptor::CPPTYPE_INT32:
      case FieldDescriptor::CPPTYPE_UINT32:
        return {{"type", "integer"}, {"format", "int32"}};
      case FieldDescriptor::CPPTYPE_INT64:
      case FieldDescriptor::CPPTYPE_UINT64:
        return {{"type", "string"}, {"format", "int64"}};  // as JSON of protobuf has them
      case FieldDescriptor::CPPTYPE_FLOAT:
      case FieldDescriptor::CPPTYPE_DOUBLE:
        return {{"type", "number"}};
      case FieldDescriptor::CPPTYPE_STRING:
        return {{"type", "string"}};
    }
    return Json::object();
  }

  std::set<std::string> known_;
  std::vector<const Descriptor*> waiting_;
};

// What the mirror answers beyond the messages.
constexpr char kOwnSchemas[] = R"({
  "OpenApi": {"type": "object"},
  "Error": {"type": "object", "properties": {"error": {"type": "object", "properties": {
    "code": {"type": "string"}, "message": {"type": "string"}, "reason": {"type": "string"},
    "metadata": {"type": "object", "additionalProperties": {"type": "string"}}}}}},
  "Me": {"type": "object", "properties": {
    "name": {"type": "string"}, "maySteer": {"type": "boolean"}, "isAdmin": {"type": "boolean"},
    "listen": {"type": "string", "description": "where gRPC is served, as --listen with the port"}}},
  "Cells": {"type": "object", "properties": {
    "state": {"type": "string"},
    "column": {"type": "integer", "description": "of the first cell of a row"},
    "row": {"type": "integer", "description": "the first row, in the south"},
    "columns": {"type": "integer"}, "rows": {"type": "integer"},
    "cellSize": {"type": "array", "items": {"type": "number"}, "description": "metres; absent if not known"},
    "hasTiles": {"type": "boolean", "description": "whether before and after of its cells can be asked for"},
    "cells": {"type": "string", "description": "row after row: space no cell, - without surface, . waiting, s surveyed, p planned, f filling, F filled, w written, x failed, ? not known"},
    "isRemembered": {"type": "boolean", "description": "false: the job was over before the coordinator began, and is not done; failures are not known"},
    "held": {"type": "array", "items": {"type": "array", "items": {"type": "integer"}}, "description": "[column, row] of tasks that workers hold now"},
    "failures": {"type": "array", "items": {"type": "object", "properties": {
      "cell": {"type": "array", "items": {"type": "integer"}}, "stage": {"type": "string"}, "reason": {"type": "string"}}}}}},
  "Holes": {"type": "object", "properties": {
    "holeCount": {"type": "integer"}, "holes": {"type": "array", "items": {"type": "object"}},
    "planned": {"type": "boolean", "description": "true: the plan's; what became of them is not known yet"},
    "date": {"type": "string", "nullable": true, "description": "of the report, once there is one"},
    "fillsToDecide": {"type": "integer", "description": "rows of the report's review, once there is one"},
    "warnings": {"type": "array", "items": {"type": "string"}, "description": "of the report, once there is one"}}},
  "Review": {"type": "object", "properties": {
    "scene": {"type": "string"}, "out": {"type": "string"}, "date": {"type": "string"},
    "changed_options": {"type": "object", "description": "options of the job that are not the defaults, by name"},
    "look_at": {"type": "array", "items": {"type": "object"}},
    "review": {"type": "object", "properties": {
      "count": {"type": "integer", "description": "rows of the report's review"},
      "items": {"type": "array", "items": {"type": "object"}, "description": "the first 1000 of these rows"},
      "z": {"type": "number", "nullable": true, "description": "the height of the levels' zero; null if the scene cannot be read"},
      "crs": {"type": "object", "nullable": true, "description": "of all polygons here, as holes.geojson has it"},
      "scene": {"type": "object", "nullable": true, "description": "tilemend_scene of holes.geojson, for the file of decisions"},
      "outlines": {"type": "string", "description": "base64 of gzip of JSON: by hole of an item a list of {hole, cluster, geometry}"},
      "others": {"type": "string", "description": "the same of an object: by number of each other hole with a fill {hole, cluster, geometry}"},
      "without_outline": {"type": "array", "items": {"type": "integer"}, "description": "holes with a fill that have no outline here, so that they cannot be decided on"},
      "decided": {"type": "integer", "description": "features in earlier"},
      "earlier": {"type": "string", "description": "the same of a list: features of the decisions of earlier rounds"}}}}},
  "Log": {"type": "object", "properties": {"lines": {"type": "array", "items": {"type": "string"}}}}
})";

void AddQuery(const Descriptor& request, MessageSchemas& schemas, Json& parameters) {
  for (int f = 0; f < request.field_count(); ++f) {
    const FieldDescriptor& field = *request.field(f);
    if (field.is_repeated()) continue;
    parameters.push_back({{"name", field.json_name()}, {"in", "query"}, {"schema", schemas.OfField(field)}});
  }
}

Json AnswersOf(const Route& route, MessageSchemas& schemas) {
  Json done = {{"description", "done"}};
  const DescriptorPool& pool = *DescriptorPool::generated_pool();
  if (const Descriptor* message = pool.FindMessageTypeByName(std::string(route.answer))) {
    done["content"]["application/json"]["schema"] = schemas.RefTo(*message);
  } else if (!route.answer.empty()) {
    done["content"]["application/json"]["schema"] = Ref(std::string(route.answer));
  } else {
    done["content"]["application/octet-stream"]["schema"] = {{"type", "string"}, {"format", "binary"}};
  }
  Json error = {{"description", "an error"}};
  error["content"]["application/json"]["schema"] = Ref("Error");
  return {{"200", std::move(done)}, {"default", std::move(error)}};
}

Json OperationOf(const Route& route, MessageSchemas& schemas) {
  Json operation = {{"summary", route.summary}, {"parameters", Json::array()}};
  for (const char* name : {"job", "cell"}) {
    if (route.pattern.find(absl::StrCat("{", name, "}")) == std::string_view::npos) continue;
    operation["parameters"].push_back(
        {{"name", name}, {"in", "path"}, {"required", true}, {"schema", {{"type", "string"}}}});
  }
  if (!route.parameter.empty()) {
    operation["parameters"].push_back(
        {{"name", std::string(route.parameter)}, {"in", "query"}, {"schema", {{"type", "string"}}}});
  }
  const Descriptor* const request = DescriptorPool::generated_pool()->FindMessageTypeByName(std::string(route.request));
  if (request != nullptr && route.method == "GET") AddQuery(*request, schemas, operation["parameters"]);
  if (request != nullptr && route.method == "POST") {
    operation["requestBody"]["content"]["application/json"]["schema"] = schemas.RefTo(*request);
  }
  operation["responses"] = AnswersOf(route, schemas);
  if (!route.rpc.empty()) {
    operation["description"] = absl::StrCat("As ", std::string(route.rpc), ".");
    operation["security"] = {{{"token", Json::array()}}};
  }
  return operation;
}

}  // namespace

std::string OpenApiDocument() {
  v1::Job::descriptor();  // puts the messages into the pool
  MessageSchemas schemas;
  Json document = {{"openapi", "3.0.3"},
                   {"info", {{"title", "tilemend coordinator"}, {"version", Version()}}},
                   {"paths", Json::object()}};
  for (const Route& route : Routes()) {
    const char* const method = route.method == "GET" ? "get" : "post";
    document["paths"][std::string(route.pattern)][method] = OperationOf(route, schemas);
  }
  document["components"]["schemas"] = Json::parse(kOwnSchemas);
  document["components"]["schemas"].update(schemas.Take());
  document["components"]["securitySchemes"]["token"] = {{"type", "http"}, {"scheme", "bearer"}};
  return document.dump();
}

}  // namespace tilemend
