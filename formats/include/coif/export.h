#pragma once
// What the shared libraries export. A shared build (BUILD_SHARED_LIBS) hides every other symbol. In archives COIF_API
// is empty, so a game that hides its own symbols hides these too. Games need not define COIF_SHARED.

// g++ 10 says 201709 for its C++20.
#if defined _MSVC_LANG ? _MSVC_LANG < 202002L : __cplusplus < 201709L
#error "coif's C++ headers need C++20: compile with -std=c++20 or later (coif.h is for C and older C++)"
#endif

#ifdef COIF_SHARED
#define COIF_API __attribute__((visibility("default")))
#else
#define COIF_API
#endif
