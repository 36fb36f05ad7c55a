#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

/// Ends a test that lacks what tests/run.sh installs, such as an EGL device: as failed, or as skipped on the machine of
/// a developer who sets COIF_MAY_SKIP.
#define COIF_FAIL_FOR_LACK_OF(what)                                                       \
  do {                                                                                    \
    if (std::getenv("COIF_MAY_SKIP") != nullptr) GTEST_SKIP() << (what);                  \
    FAIL() << (what) << "; with COIF_MAY_SKIP=1 in the environment this test is skipped"; \
  } while (false)
