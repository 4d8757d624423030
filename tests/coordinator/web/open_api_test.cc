#include "coordinator/web/open_api.h"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "coordinator/web/routes.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

TEST(OpenApiTest, HasEveryRouteAndNoOther) {
  const Json document = Json::parse(OpenApiDocument());
  size_t operations = 0;
  for (const auto& [path, methods] : document["paths"].items()) operations += methods.size();
  EXPECT_EQ(operations, Routes().size());
  for (const Route& route : Routes()) {
    const Json& methods = document["paths"][std::string(route.pattern)];
    EXPECT_TRUE(methods.contains(route.method == "GET" ? "get" : "post")) << route.pattern;
  }
}

TEST(OpenApiTest, EveryReferenceLeadsToASchema) {
  const Json document = Json::parse(OpenApiDocument());
  size_t count = 0;
  const std::function<void(const Json&)> look = [&](const Json& value) {
    if (value.is_object() && value.contains("$ref")) {
      ++count;
      const std::string name = value["$ref"].get<std::string>().substr(std::string("#/components/schemas/").size());
      EXPECT_TRUE(document["components"]["schemas"].contains(name)) << name;
    }
    if (value.is_structured()) {
      for (const Json& part : value) look(part);
    }
  };
  look(document);
  EXPECT_GT(count, 20);
}

TEST(OpenApiTest, DescribesMessagesAsTheirJsonIs) {
  const Json schemas = Json::parse(OpenApiDocument())["components"]["schemas"];
  const Json& job = schemas["tilemend.v1.Job"]["properties"];
  EXPECT_EQ(job["createTime"]["format"], "date-time");
  EXPECT_EQ(job["warnings"]["type"], "array");
  EXPECT_EQ(job["paused"]["type"], "boolean");
  EXPECT_EQ(schemas["tilemend.v1.Progress"]["properties"]["cellsDone"]["type"], "string");
  EXPECT_EQ(OpenApiDocument(), OpenApiDocument());
}

}  // namespace
}  // namespace tilemend
