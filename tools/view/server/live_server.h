#pragma once

#include "base/tool_error.h"
#include "view/server/live_state.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace coif::view {

/// The actions of requests. Called on threads of connections, several at once. They return the number of the requested
/// cook.
struct LiveRequests {
  std::function<tl::expected<std::uint64_t, ToolError>(std::string_view changes)> change;
  /// `suffix` is the importer's, such as ".glb"; `name` is the model's for people.
  std::function<tl::expected<std::uint64_t, ToolError>(const char* suffix, std::string name, std::string_view bytes)>
      drop;
};

struct LiveServerSettings {
  std::uint16_t port = 0;                                     ///< 0: the system's choice.
  std::string page;                                           ///< From find_view_page().
  std::uint64_t most_model_bytes = std::uint64_t{256} << 20;  ///< Limit for a model that is dropped on the page.
};

/// Speaks HTTP on 127.0.0.1, to whom RequestGuard admits. Below the token's folder there are
///   GET  (the folder itself)  the page
///   GET  asset                the last good asset; its revision in the header Coif-Revision; 404 before there is one
///   GET  events               server-sent events: LiveState's JSON, at once and whenever it changes
///   GET  keys                 the table of a recipe's keys: recipe_keys_json()
///   POST recipe               a JSON object of what differs from the recipe's file -> 202 {"request": number}
///   POST model?format=glb&name=bob.glb   a model's bytes; the name is for people -> 202 {"request": number}
/// and nothing else. No path of a file comes from a request. A request with bad content gets 400 and {"problem":
/// sentence}.
class LiveServer {
 public:
  /// Listens when this returns. `state` outlives the server. Errors: kFileAccess (the port is taken), kBadInput (no
  /// page).
  static tl::expected<std::unique_ptr<LiveServer>, ToolError> start(LiveServerSettings settings, LiveState& state,
                                                                    LiveRequests requests);
  /// Ends all connections; closes `state`, for which they may wait.
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  /// With the token: everybody who knows it sees the page.
  [[nodiscard]] std::string address() const;

 private:
  class Inside;
  explicit LiveServer(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace coif::view
