#include "view/server/request_guard.h"

#include <gtest/gtest.h>

#include <set>

namespace coif::view::request_guard_test {
namespace {

const std::string kToken = "0123456789abcdef0123456789abcdef";
const std::string kPath = "/" + kToken + "/asset";

RequestGuard guard() { return {4711, kToken}; }

TEST(RandomToken, Has128BitsThatDiffer) {
  std::set<std::string> seen;
  for (int i = 0; i < 100; ++i) {
    const std::string token = random_token();
    EXPECT_EQ(token.size(), 32u);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), token.npos);
    seen.insert(token);
  }
  EXPECT_EQ(seen.size(), 100u);
}

TEST(RequestGuard, AdmitsItsOwnPage) {
  EXPECT_EQ(guard().address(), "http://127.0.0.1:4711/" + kToken + "/");
  EXPECT_TRUE(guard().admits({kPath, "127.0.0.1:4711", {}}));
  EXPECT_TRUE(guard().admits({kPath, "localhost:4711", {}}));
  EXPECT_TRUE(guard().admits({kPath + "?a=b", "127.0.0.1:4711", "http://127.0.0.1:4711"}));
  EXPECT_TRUE(guard().admits({kPath, "localhost:4711", "http://localhost:4711"}));
}

TEST(RequestGuard, RefusesForeignHosts) {
  for (const char* host :
       {"127.0.0.1", "127.0.0.1:4712", "example.org", "example.org:4711", "127.0.0.1:4711.example.org",
        "LOCALHOST:4711", "localhost:47110", "localhost", "", " 127.0.0.1:4711", "[::1]:4711", "0.0.0.0:4711"}) {
    EXPECT_FALSE(guard().admits({kPath, host, {}})) << host;
  }
  EXPECT_FALSE(guard().admits({kPath, {}, {}}));
}

TEST(RequestGuard, RefusesForeignOrigins) {
  for (const char* origin : {"null", "", "http://example.org", "https://127.0.0.1:4711", "http://127.0.0.1",
                             "http://127.0.0.1:4712", "http://127.0.0.1:4711/", "http://localhost:4711"}) {
    EXPECT_FALSE(guard().admits({kPath, "127.0.0.1:4711", origin})) << origin;
  }
}

TEST(RequestGuard, RefusesWhoDoesNotKnowTheToken) {
  std::string last_wrong = kToken, first_wrong = kToken;
  last_wrong.back() = '0';
  first_wrong.front() = '1';
  for (const std::string& target :
       {std::string(), std::string("/"), std::string("//"), std::string("/asset"), "/" + kToken, kToken + "/asset",
        "/" + last_wrong + "/", "/" + first_wrong + "/", "/" + kToken.substr(1) + "/", "/" + kToken + "0/",
        "//" + kToken + "/", "/x/" + kToken + "/", "/?" + kToken + "/", "/x/../" + kToken + "/",
        "http://127.0.0.1:4711/" + kToken + "/"}) {
    EXPECT_FALSE(guard().admits({target, "127.0.0.1:4711", {}})) << target;
  }
}

}  // namespace
}  // namespace coif::view::request_guard_test
