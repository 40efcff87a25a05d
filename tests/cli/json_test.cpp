// Values of frontend/files/json.hpp: their text, and the way back.
#include "frontend/files/json.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

TEST(Json, MembersKeepTheirOrderAndNumbersTheirKind) {
  Json json = {{"z", 1}, {"a", -2}, {"truth", true}, {"half", 0.5}, {"text", "x"}, {"none", nullptr}};
  json["list"] = Json::array({1, "two", Json::object()});
  json["z"] = std::uint64_t{18446744073709551615u};
  EXPECT_EQ(json.dump(),
            R"({"z":18446744073709551615,"a":-2,"truth":true,"half":0.5,"text":"x","none":null,"list":[1,"two",{}]})");
}

TEST(Json, ObjectsInObjectsAndInArrays) {
  const Json json = {{"outer", {{"inner", {{"deep", 1}}}}}, {"rows", Json::array({{{"a", 1}, {"b", 2}}})}};
  EXPECT_EQ(json.dump(), R"({"outer":{"inner":{"deep":1}},"rows":[{"a":1,"b":2}]})");
}

TEST(Json, NullBecomesWhatIsAddedToIt) {
  Json object, array;
  object["a"]["b"] = 1;
  array.push_back({{"c", 2}});
  EXPECT_EQ(object.dump(), R"({"a":{"b":1}})");
  EXPECT_EQ(array.dump(), R"([{"c":2}])");
  EXPECT_EQ(array.size(), 1u);
}

TEST(Json, ControlsAreEscapedAndBytesThatAreNotUtf8Replaced) {
  EXPECT_EQ(Json("a\"\n\x01").dump(), R"("a\"\n\u0001")");
  EXPECT_EQ(Json("\xff").dump(), "\"\xEF\xBF\xBD\"");
  EXPECT_EQ(Json("\xC3\xA4").dump(-1, true), R"("\u00e4")");
}

TEST(Json, ReadsWhatItWrote) {
  const std::string text = R"({"a":[1,-1,2.5,"t",true,null],"b":{}})";
  const auto json = Json::read(text);
  ASSERT_TRUE(json);
  EXPECT_EQ(json->dump(), text);
  ASSERT_NE(json->find("a"), nullptr);
  EXPECT_EQ(json->find("a")->items()[0].natural(), 1u);
  EXPECT_EQ(json->find("a")->items()[3].text(), "t");
  EXPECT_EQ(json->find("c"), nullptr);
  EXPECT_FALSE(Json::read("{"));
}

}  // namespace
}  // namespace rungproof
