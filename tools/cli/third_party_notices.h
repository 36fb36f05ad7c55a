#pragma once

namespace coif::cli {

/// Whose works the program has in it, and their licences. Made by third_party.cmake.
extern const char* const kThirdPartyNotices;

}  // namespace coif::cli
