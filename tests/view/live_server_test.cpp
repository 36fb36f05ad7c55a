#include "view/server/live_server.h"

#include "base/json.h"
#include "cook/recipe/recipe_keys_json.h"

#include <gtest/gtest.h>
#include <httplib.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace coif::view::live_server_test {
namespace {

using namespace std::chrono_literals;

constexpr const char* kPage =
    "<html lang=\"en\"><style>a{}</style><script>program</script>"
    "<script type=\"application/octet-stream\" id=\"asset\" data-name=\"@NAME@\">@ASSET@</script><script "
    "type=\"module\">page</script></html>";

class LiveServerTest : public testing::Test {
 protected:
  LiveServerTest() {
    LiveRequests requests;
    requests.change = [this](std::string_view changes) -> tl::expected<std::uint64_t, ToolError> {
      changes_.emplace_back(changes);
      if (changes == "bad") return failure(ToolError::Kind::kBadInput, "changes of the page: bad");
      return changes_.size();
    };
    requests.drop = [this](const char* suffix, std::string name,
                           std::string_view bytes) -> tl::expected<std::uint64_t, ToolError> {
      dropped_.push_back(std::string(suffix) + " " + name + " " + std::to_string(bytes.size()));
      return 7;
    };
    LiveServerSettings settings;
    settings.page = kPage;
    settings.most_model_bytes = 4 << 20;
    auto server = LiveServer::start(std::move(settings), state_, std::move(requests));
    EXPECT_TRUE(server) << server.error().message;
    server_ = std::move(*server);
    const std::string address = server_->address();  // http://127.0.0.1:PORT/TOKEN/
    const std::size_t path = address.find('/', 7);
    host_ = address.substr(7, path - 7);
    folder_ = address.substr(path);
    port_ = std::stoi(host_.substr(host_.find(':') + 1));
  }

  [[nodiscard]] httplib::Client client() const {
    httplib::Client client("127.0.0.1", port_);
    client.set_read_timeout(10s);
    return client;
  }
  [[nodiscard]] int status(const std::string& path, const httplib::Headers& headers = {}) const {
    const auto answer = client().Get(path, headers);
    return answer ? answer->status : -1;
  }

  LiveState state_{"draft"};
  std::unique_ptr<LiveServer> server_;
  std::vector<std::string> changes_, dropped_;
  std::string host_, folder_;
  int port_ = 0;
};

TEST_F(LiveServerTest, SendsThePageWithItsRules) {
  const auto answer = client().Get(folder_);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_EQ(answer->get_header_value("Content-Type"), "text/html; charset=utf-8");
  EXPECT_EQ(answer->get_header_value("X-Content-Type-Options"), "nosniff");
  EXPECT_EQ(answer->get_header_value("Cross-Origin-Resource-Policy"), "same-origin");
  EXPECT_EQ(answer->get_header_value("Cache-Control"), "no-store");
  EXPECT_EQ(answer->get_header_value("Referrer-Policy"), "no-referrer");
  EXPECT_FALSE(answer->has_header("Access-Control-Allow-Origin"));
  EXPECT_EQ(answer->get_header_value_count("Content-Security-Policy"), 1u);
  const std::string policy = answer->get_header_value("Content-Security-Policy");
  EXPECT_TRUE(policy.starts_with("default-src 'none'; script-src 'nonce-"));
  EXPECT_EQ(policy.find("unsafe-inline"), policy.npos);
  const std::string nonce = policy.substr(policy.find("nonce-") + 6, 32);
  EXPECT_EQ(answer->body,
            "<html lang=\"en\" data-live><style nonce=\"" + nonce + "\">a{}</style><script nonce=\"" + nonce +
                "\">program</script><script type=\"application/octet-stream\" id=\"asset\" data-name=\"\"></script>"
                "<script type=\"module\" nonce=\"" +
                nonce + "\">page</script></html>");
  EXPECT_EQ(client().Get(folder_)->get_header_value("Content-Security-Policy").find(nonce), std::string::npos)
      << "a nonce is used once";
}

TEST_F(LiveServerTest, RefusesStrangers) {
  EXPECT_EQ(status(folder_), 200);
  EXPECT_EQ(status("/"), 403);
  EXPECT_EQ(status("/asset"), 403);
  EXPECT_EQ(status("/" + std::string(32, '0') + "/"), 403);
  EXPECT_EQ(status(folder_, {{"Host", "example.org"}}), 403);
  EXPECT_EQ(status(folder_, {{"Host", host_}, {"Host", "example.org"}}), 403);
  EXPECT_EQ(status(folder_, {{"Origin", "http://example.org"}}), 403);
  EXPECT_EQ(status(folder_, {{"Origin", "null"}}), 403);
  std::string neighbour = host_;  // another server of this machine, whose name is as long
  neighbour.back() = neighbour.back() == '1' ? '2' : '1';
  EXPECT_EQ(status(folder_, {{"Origin", "http://" + neighbour}}), 403);
  EXPECT_EQ(status(folder_, {{"Origin", "http://" + host_}}), 200);
  EXPECT_EQ(status(folder_, {{"Origin", "http://" + host_}, {"Origin", "http://" + host_}}), 403);
  const auto posted = client().Post(folder_ + "recipe", {{"Origin", "http://example.org"}}, "{}", "text/plain");
  ASSERT_TRUE(posted);
  EXPECT_EQ(posted->status, 403);
  EXPECT_TRUE(changes_.empty());
}

TEST_F(LiveServerTest, HasNothingButItsRoutes) {
  for (const char* path : {"../", "../../etc/passwd", "..%2f..%2fetc%2fpasswd", "%2e%2e/etc/passwd", "asset/",
                           "asset/../../x", "recipe", "model", "index.html", "/etc/passwd", "asset%00"}) {
    const int code = status(folder_ + path);
    EXPECT_TRUE(code == 404 || code == 403 || code == 400) << path << ": " << code;
  }
  EXPECT_EQ(client().Put(folder_ + "recipe", "{}", "text/plain")->status, 405);
  EXPECT_EQ(client().Delete(folder_ + "asset")->status, 405);
  EXPECT_EQ(client().Options(folder_ + "asset")->status, 405);
  EXPECT_EQ(client().Post(folder_ + "asset", "{}", "text/plain")->status, 404);
}

TEST_F(LiveServerTest, SendsTheLastGoodAsset) {
  EXPECT_EQ(status(folder_ + "asset"), 404);
  LiveResult result;
  result.asset = {std::byte{1}, std::byte{0}, std::byte{2}};
  state_.publish(1, std::move(result));
  state_.begin();
  state_.fail(2, "spoilt");
  const auto answer = client().Get(folder_ + "asset");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->body, std::string("\1\0\2", 3));
  EXPECT_EQ(answer->get_header_value("Coif-Revision"), "1");
}

TEST_F(LiveServerTest, SendsTheTableOfRecipeKeys) {
  const auto answer = client().Get(folder_ + "keys");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_EQ(answer->get_header_value("Content-Type"), "application/json");
  EXPECT_EQ(answer->body, cook::recipe_keys_json());
  EXPECT_EQ(status("/keys"), 403);
}

TEST_F(LiveServerTest, TakesChangesAndModels) {
  auto answer = client().Post(folder_ + "recipe", "{\"a\": 1}", "application/json");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 202);
  EXPECT_EQ(answer->body, "{\"request\":1}");
  EXPECT_EQ(changes_.back(), "{\"a\": 1}");
  answer = client().Post(folder_ + "recipe", "bad", "application/json");
  EXPECT_EQ(answer->status, 400);
  EXPECT_EQ(answer->body, "{\"problem\":\"changes of the page: bad\"}");

  answer = client().Post(folder_ + "model?format=GLB&name=..%2Fmy%20hair.glb", std::string(3000000, 'x'),
                         "application/octet-stream");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->body, "{\"request\":7}");
  EXPECT_EQ(dropped_, std::vector<std::string>{".glb ../my hair.glb 3000000"});
  for (const char* format : {"exe", "", "../glb", "glb/../../x", "glb.exe"}) {
    answer = client().Post(folder_ + "model?format=" + format, "x", "application/octet-stream");
    EXPECT_EQ(answer->status, 400) << format;
  }
  EXPECT_EQ(dropped_.size(), 1u);
}

TEST_F(LiveServerTest, RefusesWhatIsTooLarge) {
  const auto send = [&](const char* route, std::size_t bytes) {
    // By its announcement: the server need not read what follows.
    const auto answer =
        client().Post(folder_ + route, {{"Content-Length", std::to_string(bytes)}}, "", "application/octet-stream");
    return answer ? answer->status : -1;
  };
  EXPECT_EQ(send("recipe", (1 << 20) + 1), 413);
  EXPECT_EQ(send("model?format=glb", (4 << 20) + 1), 413);
  EXPECT_EQ(send("model?format=glb&x=/recipe", (4 << 20) + 1), 413);
  const auto in_pieces = client().Post(
      folder_ + "recipe",
      [](std::size_t, httplib::DataSink& sink) {
        sink.write("{}", 2);
        sink.done();
        return true;
      },
      "application/json");
  EXPECT_TRUE(!in_pieces || in_pieces->status == 413) << "of unknown length";
  EXPECT_TRUE(changes_.empty());
  EXPECT_TRUE(dropped_.empty());
}

TEST_F(LiveServerTest, EventsTellEachState) {
  std::vector<nlohmann::json> states;
  std::thread cooking;
  std::string text;
  auto listener = client();
  const auto answer = listener.Get(folder_ + "events", [&](const char* data, std::size_t length) {
    text.append(data, length);
    for (std::size_t end; (end = text.find("\n\n")) != text.npos; text.erase(0, end + 2)) {
      const std::size_t at = text.find("data: ");
      if (at < end) states.push_back(nlohmann::json::parse(text.substr(at + 6, end - at - 6)));
      if (states.size() == 1 && !cooking.joinable())
        cooking = std::thread([this] {
          state_.publish(3, {"bob\xff.glb", {std::byte{1}}, {}, {}, {{"C144", "odd"}}, 0.5});
        });
    }
    return states.size() < 2;
  });
  if (cooking.joinable()) cooking.join();
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[0]["revision"], 0);
  EXPECT_EQ(states[1]["revision"], 1);
  EXPECT_EQ(states[1]["request"], 3);
  EXPECT_EQ(states[1]["warnings"][0]["code"], "C144");
  EXPECT_EQ(states[1]["warnings"][0]["message"], "odd");
  EXPECT_EQ(states[1]["quality"], "draft");
}

TEST_F(LiveServerTest, EndsWhileSomebodyListens) {
  std::atomic<bool> listens = false;
  std::thread listener([&] {
    auto client = this->client();
    (void)client.Get(folder_ + "events", [&](const char*, std::size_t) { return listens = true; });
  });
  const auto begin = std::chrono::steady_clock::now();
  while (!listens && std::chrono::steady_clock::now() - begin < 10s) std::this_thread::sleep_for(1ms);
  server_.reset();
  listener.join();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
}

TEST(LiveServer, SaysThatAPortIsTaken) {
  LiveState state("draft");
  LiveServerSettings settings;
  settings.page = kPage;
  const auto first = LiveServer::start(settings, state, {});
  ASSERT_TRUE(first);
  const std::string address = (*first)->address();
  settings.port = std::uint16_t(std::stoi(address.substr(address.rfind(':') + 1)));
  const auto second = LiveServer::start(settings, state, {});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().kind, ToolError::Kind::kFileAccess);
  EXPECT_NE(second.error().message.find("cannot listen there"), std::string::npos);
  settings.page = "<html>";
  EXPECT_FALSE(LiveServer::start(settings, state, {})) << "not its page";
}

}  // namespace
}  // namespace coif::view::live_server_test
