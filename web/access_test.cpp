#include "web/access.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace taut::web::access_test {

const Access ours{.port = 4711, .token = "0123456789abcdef"};

Caller good() { return {.host = "127.0.0.1:4711", .origin = "", .token = ours.token}; }

TEST(Access, TokensAreLongAndDiffer) {
  std::set<std::string> seen;
  for (int i = 0; i < 100; ++i) {
    const std::string token = new_token();
    EXPECT_EQ(token.size(), 64U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_TRUE(seen.insert(token).second);
  }
}

TEST(Access, SecretsAreComparedWhole) {
  EXPECT_TRUE(same_secret("abc", "abc"));
  for (const char* other : {"", "ab", "abd", "xbc", "abcd", "ABC"}) EXPECT_FALSE(same_secret("abc", other)) << other;
  EXPECT_FALSE(same_secret("abc", std::string("abc\0", 4)));
}

TEST(Access, OwnPagesAreAnswered) {
  EXPECT_FALSE(refused(good(), ours));
  for (const std::string host : {"127.0.0.1:4711", "localhost:4711"}) {
    EXPECT_FALSE(refused({.host = host, .origin = "http://" + host, .token = ours.token}, ours)) << host;
  }
}

TEST(Access, AMissingOrWrongTokenIsRefused) {
  for (const std::string token : {"", "0", "0123456789abcdeF", "0123456789abcde", "0123456789abcdef0"}) {
    Caller caller = good();
    caller.token = token;
    EXPECT_TRUE(refused(caller, ours)) << token;
  }
  Caller empty = good();
  empty.token = "";
  EXPECT_TRUE(refused(empty, {.port = 4711, .token = ""}));
}

TEST(Access, OtherHostsAndOriginsAreRefusedDespiteTheToken) {
  for (const std::string host : {"", "127.0.0.1", "127.0.0.1:4712", "evil.example:4711", "localhost.evil.example:4711",
                                 "127.0.0.1:4711.evil.example", "[::1]:4711", "0.0.0.0:4711", "LOCALHOST:4711 "}) {
    Caller caller = good();
    caller.host = host;
    EXPECT_TRUE(refused(caller, ours)) << host;
  }
  for (const std::string origin :
       {"null", "http://evil.example", "https://127.0.0.1:4711", "http://127.0.0.1:4712", "http://localhost:4711",
        "http://127.0.0.1:4711/", "http://127.0.0.1:4711.evil.example"}) {
    Caller caller = good();
    caller.origin = origin;
    EXPECT_TRUE(refused(caller, ours)) << origin;
  }
}

TEST(Access, ThePolicyTakesNothingOfANonceButItsLetters) {
  EXPECT_NE(policy("aB9-_").find("style-src 'self' 'nonce-aB9-_';"), std::string::npos);
  EXPECT_NE(policy("").find("style-src 'self';"), std::string::npos);
  EXPECT_NE(policy("a'; script-src *\r\nX: y").find("'nonce-ascript-srcXy'"), std::string::npos);
}

}  // namespace taut::web::access_test
