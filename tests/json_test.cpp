// Our JSON values: round trips, exact numbers, limits, and the place of a mistake.
#include "core/base/json.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/random.h"

namespace netwright {
namespace {

TEST(Json, RoundTripsAllKindsOfValues) {
  Json value;
  value.set("text", "a \"b\" \\ \n ü");
  value.set("yes", true).set("nothing", Json()).set("count", 42).set("share", 0.1);
  value.set("list", Json::Array{1, "two", Json::Array{}, Json::Object{}});
  for (const bool is_indented : {false, true})
    EXPECT_EQ(parse_json(to_text(value, {.is_indented = is_indented}), "test"), value);
}

TEST(Json, KeepsTheOrderOfMembers) {
  EXPECT_EQ(to_text(parse_json(R"({"z":1,"a":2,"m":3})", "test")), R"({"z":1,"a":2,"m":3})");
}

TEST(Json, KeepsEveryBitOfAFraction) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const double value = std::ldexp(random.unit() - 0.5, random.below(200) - 100);
    for (const int digits : {0, 17})
      EXPECT_EQ(parse_json(to_text(Json(value), {.significant_digits = digits}), "test").number(), value);
  }
}

TEST(Json, TellsWholeNumbersFromFractions) {
  EXPECT_EQ(parse_json("7", "test").integer(), 7);
  EXPECT_FALSE(parse_json("7.5", "test").integer());
  EXPECT_FALSE(parse_json("\"7\"", "test").number());
  EXPECT_EQ(parse_json("18446744073709551615", "test").number(), 18446744073709551615.0);
}

TEST(Json, FindsMembersOnlyInObjects) {
  const Json value = parse_json(R"({"a": 1})", "test");
  ASSERT_NE(value.find("a"), nullptr);
  EXPECT_EQ(value.find("b"), nullptr);
  EXPECT_EQ(Json(3).find("a"), nullptr);
}

TEST(Json, WritesWhatIsNotFiniteAsNull) {
  EXPECT_EQ(to_text(Json(std::nan(""))), "null");
  EXPECT_EQ(to_text(Json(INFINITY)), "null");
}

TEST(Json, WritesInvalidUtf8AsAReplacement) {
  EXPECT_EQ(parse_json(to_text(Json("a\xff"
                                    "b")),
                       "test"),
            Json("a\xef\xbf\xbd"
                 "b"));
}

TEST(Json, RefusesTooManyValues) {
  EXPECT_NO_THROW(parse_json("[1,2,3]", "test", 4));
  EXPECT_THROW(parse_json("[1,2,3,4]", "test", 4), Error);
}

TEST(Json, NamesThePlaceOfAMistake) {
  try {
    parse_json("{\n \"a\": 1,\n \"b\" 2\n}", "some.json");
    FAIL() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "some.json is not valid JSON: something unexpected stands at line 3, column 6.");
  }
}

}  // namespace
}  // namespace netwright
