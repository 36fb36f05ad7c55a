#include "view/server/live_server.h"

#include "base/text.h"
#include "cook/recipe/recipe_keys_json.h"
#include "import/import.h"
#include "platform/program.h"
#include "view/server/request_guard.h"

#include <fmt/format.h>
#include <httplib.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

namespace coif::view {
namespace {

using httplib::Request;
using httplib::Response;

constexpr std::size_t kThreads = 24;  // Threads for connections.
constexpr int kMostStreams = 16;      // Each keeps a thread as long as a page is open.
constexpr std::uint64_t kMostRecipeBytes = std::uint64_t{1} << 20;
constexpr std::chrono::milliseconds kLook{500};  // How soon a closed page is noticed.
constexpr int kLooksOfSign = 20;                 // After this many a comment keeps proxies awake.
constexpr const char* kJson = "application/json";

std::optional<std::string> only_header(const Request& request, const char* name) {
  if (request.get_header_value_count(name) != 1) return std::nullopt;
  return request.get_header_value(name);
}

/// One byte beyond the limit where the request has no length, so that a body that is too long is noticed.
std::uint64_t body_bytes(const Request& request) {
  const auto length = only_header(request, "Content-Length");
  std::uint64_t bytes = 0;
  if (!length || request.has_header("Transfer-Encoding") || length->empty() || length->size() > 12)
    return ~std::uint64_t{0};
  for (const char c : *length) {
    if (c < '0' || c > '9') return ~std::uint64_t{0};
    bytes = 10 * bytes + std::uint64_t(c - '0');
  }
  return bytes;
}

void answer(Response& response, int status, const nlohmann::ordered_json& json) {
  response.status = status;
  response.set_content(json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace), kJson);
}

void answer(Response& response, const tl::expected<std::uint64_t, ToolError>& asked) {
  if (asked) return answer(response, 202, {{"request", *asked}});
  answer(response, 400, {{"problem", asked.error().message}});
}

/// Bytes of known number are sent directly. Content that is set as text would be compressed, which takes longer than
/// sending it.
void send(Response& response, const char* type, std::shared_ptr<const void> owner, const char* bytes,
          std::size_t count) {
  response.set_content_provider(
      count, type, [owner = std::move(owner), bytes](std::size_t at, std::size_t length, httplib::DataSink& sink) {
        return sink.write(bytes + at, length);
      });
}

const char* model_suffix(const std::string& format) {
  const auto known = importer::find_suffix("x." + format);
  return known ? known->suffix : nullptr;
}

}  // namespace

class LiveServer::Inside {
 public:
  Inside(LiveServerSettings settings, LiveState& state, LiveRequests requests)
      : settings_(std::move(settings)), state_(state), requests_(std::move(requests)) {}

  ~Inside() {
    state_.close();
    http_.stop();
    if (thread_.joinable()) thread_.join();
  }

  tl::expected<void, ToolError> start() {
    if (auto page = live_page(settings_.page, "-"); !page) return tl::unexpected(page.error());
    http_.set_socket_options([](socket_t socket) { platform::own_port_alone(std::uintptr_t(socket)); });
    const int port = settings_.port == 0                               ? http_.bind_to_any_port("127.0.0.1")
                     : http_.bind_to_port("127.0.0.1", settings_.port) ? settings_.port
                                                                       : -1;
    if (port <= 0) {
      return failure(
          ToolError::Kind::kFileAccess,
          fmt::format(
              "127.0.0.1:{}: cannot listen there; another program does, perhaps; leave --port out to have a free one",
              settings_.port));
    }
    guard_.emplace(std::uint16_t(port), random_token());
    set_up();
    thread_ = std::thread([this] { http_.listen_after_bind(); });
    // A server that is stopped before it runs never stops.
    while (!http_.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return {};
  }

  [[nodiscard]] std::string address() const { return guard_->address(); }

 private:
  void set_up() {
    http_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    http_.set_keep_alive_max_count(1);  // The unread rest of one request cannot be taken for another.
    http_.set_tcp_nodelay(true);
    http_.set_payload_max_length(settings_.most_model_bytes);
    http_.set_default_headers({{"X-Content-Type-Options", "nosniff"},
                               {"Cross-Origin-Resource-Policy", "same-origin"},
                               {"Cross-Origin-Opener-Policy", "same-origin"},
                               {"Cache-Control", "no-store"},
                               {"Referrer-Policy", "no-referrer"}});
    http_.set_exception_handler([](const Request&, Response& response, std::exception_ptr) { response.status = 500; });
    http_.set_pre_routing_handler(
        [this](const Request& request, Response& response) { return admit(request, response); });
    const std::string folder = "/" + guard_->token() + "/";
    http_.Get(folder, [this](const Request&, Response& response) { send_page(response); });
    http_.Get(folder + "asset", [this](const Request&, Response& response) { send_asset(response); });
    http_.Get(folder + "events", [this](const Request&, Response& response) { send_events(response); });
    http_.Get(folder + "keys", [](const Request&, Response& response) {
      response.set_content(cook::recipe_keys_json(), "application/json");
    });
    http_.Post(folder + "recipe", [this](const Request& request, Response& response) {
      answer(response, requests_.change(request.body));
    });
    http_.Post(folder + "model", [this](const Request& request, Response& response) { take_model(request, response); });
  }

  /// Before anything of a body is read.
  httplib::Server::HandlerResponse admit(const Request& request, Response& response) const {
    using enum httplib::Server::HandlerResponse;
    RequestOrigin from{request.target, only_header(request, "Host"), std::nullopt};
    if (request.has_header("Origin")) from.origin = only_header(request, "Origin").value_or("");
    if (!guard_->admits(from)) {
      response.status = 403;
      return Handled;
    }
    response.set_header("Content-Security-Policy", "default-src 'none'; frame-ancestors 'none'");
    if (request.method != "GET" && request.method != "POST") {
      response.status = 405;
      return Handled;
    }
    const bool is_recipe = request.target.ends_with("/recipe");
    if (request.method == "POST" && body_bytes(request) > (is_recipe ? kMostRecipeBytes : settings_.most_model_bytes)) {
      answer(response, 413,
             {{"problem", fmt::format("the file is too large for the page; at most {} MiB",
                                      (is_recipe ? kMostRecipeBytes : settings_.most_model_bytes) >> 20)}});
      return Handled;
    }
    return Unhandled;
  }

  void send_page(Response& response) const {
    const std::string nonce = random_token();
    const auto page = std::make_shared<const std::string>(live_page(settings_.page, nonce).value());
    response.headers.erase("Content-Security-Policy");
    response.set_header("Content-Security-Policy", live_policy(nonce));
    send(response, "text/html; charset=utf-8", page, page->data(), page->size());
  }

  void send_asset(Response& response) const {
    const auto asset = state_.asset();
    if (!asset) return answer(response, 404, {{"problem", "nothing is cooked yet"}});
    response.set_header("Coif-Revision", std::to_string(asset->revision));
    send(response, "application/octet-stream", asset, reinterpret_cast<const char*>(asset->bytes.data()),
         asset->bytes.size());
  }

  void send_events(Response& response) {
    if (++streams_ > kMostStreams) {
      --streams_;
      return answer(response, 503, {{"problem", "too many pages are open"}});
    }
    const auto seen = std::make_shared<std::pair<std::uint64_t, int>>(0, 0);  // state; looks without news
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, seen](std::size_t, httplib::DataSink& sink) {
          const LiveState::News news = state_.wait(seen->first, kLook);
          if (news.is_closed) {
            sink.done();
            return true;
          }
          std::string text;
          if (!news.json.empty())
            text = fmt::format("id: {}\nretry: 1000\ndata: {}\n\n", news.number, news.json);
          else if (++seen->second % kLooksOfSign == 0)
            text = ": still here\n\n";
          seen->first = news.number;
          return text.empty() ? sink.is_writable() : sink.write(text.data(), text.size());
        },
        [this](bool) { --streams_; });
  }

  void take_model(const Request& request, Response& response) const {
    const char* const suffix = model_suffix(request.get_param_value("format"));
    if (suffix == nullptr) {
      return answer(response, 400,
                    {{"problem", fmt::format("not a model that can be cooked; export as one of {}",
                                             importer::supported_suffixes())}});
    }
    const std::string name = printable_text(request.get_param_value("name"), 100);
    answer(response, requests_.drop(suffix, name.empty() ? "the dropped model" : name, request.body));
  }

  LiveServerSettings settings_;
  LiveState& state_;
  LiveRequests requests_;
  std::optional<RequestGuard> guard_;
  std::atomic<int> streams_ = 0;
  httplib::Server http_;
  std::thread thread_;
};

tl::expected<std::unique_ptr<LiveServer>, ToolError> LiveServer::start(LiveServerSettings settings, LiveState& state,
                                                                       LiveRequests requests) {
  auto inside = std::make_unique<Inside>(std::move(settings), state, std::move(requests));
  if (auto started = inside->start(); !started) return tl::unexpected(started.error());
  return std::unique_ptr<LiveServer>(new LiveServer(std::move(inside)));
}

LiveServer::LiveServer(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
LiveServer::~LiveServer() = default;

std::string LiveServer::address() const { return inside_->address(); }

}  // namespace coif::view
