#pragma once
// What the shared libraries show. A shared build (BUILD_SHARED_LIBS) hides every other symbol; in archives the word
// says nothing, so a game that hides its own symbols hides theirs, too. Games need not define COIF_SHARED.

// 201709: what g++ 10 calls its C++20.
#if defined _MSVC_LANG ? _MSVC_LANG < 202002L : __cplusplus < 201709L
#error "coif's C++ headers need C++20: compile with -std=c++20 or later (coif.h is for C and older C++)"
#endif

#ifdef COIF_SHARED
#define COIF_API __attribute__((visibility("default")))
#else
#define COIF_API
#endif
