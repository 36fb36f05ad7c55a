#pragma once

namespace coif {

/// Whose works the program has in it, and their licences. Made by third_party.cmake.
extern const char* const kThirdPartyNotices;

}  // namespace coif
