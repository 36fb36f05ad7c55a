#pragma once

#include "base/tool_error.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace coif::view {

/// 128 bits of the system's generator in hexadecimal digits. Throws std::system_error where there is none.
[[nodiscard]] std::string random_token();

/// The request's own statements about its origin. Owns them, so that comparisons read no memory of others.
struct RequestOrigin {
  std::string target;               ///< As it was sent: the path, and the part after a question mark.
  std::optional<std::string> host;  ///< The only header of that name; none where it is absent, or occurs several times.
  std::optional<std::string> origin;  ///< None where the header is absent; empty where it occurs several times.
};

/// Decides which requests a server on the loopback address answers: those with the token and from its own page. Refuses
/// other pages of the same browser, other users of the machine, and names that somebody else's DNS maps to this
/// address.
class RequestGuard {
 public:
  RequestGuard(std::uint16_t port, std::string token);

  /// The page's address for people: http://127.0.0.1:PORT/TOKEN/
  [[nodiscard]] std::string address() const;
  [[nodiscard]] const std::string& token() const { return token_; }

  [[nodiscard]] bool admits(const RequestOrigin& request) const;

 private:
  std::string token_;
  std::string hosts_[2];  ///< 127.0.0.1:PORT and localhost:PORT
};

/// The page of view_page() in the server's form: it requests its asset, and a browser runs only scripts that carry
/// `nonce`. kBadInput for a file that is no such page.
[[nodiscard]] tl::expected<std::string, ToolError> live_page(std::string_view page, std::string_view nonce);

/// Content-Security-Policy of that page: nothing from elsewhere, and nothing that was put into it later.
[[nodiscard]] std::string live_policy(std::string_view nonce);

}  // namespace coif::view
