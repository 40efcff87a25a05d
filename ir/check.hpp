// The programmer's assertion: states that cannot occur are told loudly, in every build, and end what runs into them:
// one question of many, or the command.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>

namespace rungproof {

/// A broken assertion. Who answers several questions catches it for each of them.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void breakCheck(const char* file, int line, const char* text, const char* condition) {
  std::fprintf(stderr, "%s:%d: internal error: %s (%s)\n", file, line, text, condition);
  throw InternalError(text);
}

}  // namespace rungproof

/// Throws InternalError unless `condition` holds. Never for errors that a user can cause.
#define CHECK(condition, text)                                                       \
  do {                                                                               \
    if (!(condition)) ::rungproof::breakCheck(__FILE__, __LINE__, text, #condition); \
  } while (false)
