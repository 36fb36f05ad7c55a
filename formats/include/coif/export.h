#pragma once
// What the shared libraries show. A shared build (BUILD_SHARED_LIBS) hides every other symbol; in archives the word says
// nothing, so a game that hides its own symbols hides theirs, too. Games need not define COIF_SHARED.

#ifdef COIF_SHARED
#define COIF_API __attribute__((visibility("default")))
#else
#define COIF_API
#endif
