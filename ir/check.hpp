// The programmer's assertion: states that cannot occur abort loudly, in every build.
#pragma once

#include <cstdio>
#include <cstdlib>

/// Aborts with place and text unless `condition` holds. Never for errors that a user can cause.
#define CHECK(condition, text)                                                                        \
  do {                                                                                                \
    if (!(condition)) {                                                                               \
      std::fprintf(stderr, "%s:%d: internal error: %s (%s)\n", __FILE__, __LINE__, text, #condition); \
      std::abort();                                                                                   \
    }                                                                                                 \
  } while (false)
