#include "taut/app/explain/schema.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

TEST(Schema, KnowsEveryMethod) {
  const auto schema = nlohmann::json::parse(taut::app::schema_text());
  EXPECT_EQ(schema.at("$schema"), "http://json-schema.org/draft-07/schema#");
  EXPECT_EQ(schema.at("properties").at("method").at("enum").size(), 4U);
}
