// The C runtime of Windows knows no UTF-8; std::filesystem::path asks it how names are spelt. The linker leads these
// three questions here (frontend/package/windows/windows.cmake), so that a name is UTF-8 everywhere in the program.
#include <cerrno>
#include <cwchar>

#include "engine/platform/windows/utf8_units.hpp"

namespace {

std::mbstate_t stateWithout = 0;  ///< of a caller that brings none

std::size_t told(std::size_t count) {
  if (count == rungproof::utf8::invalid) errno = EILSEQ;
  return count;
}

int longest() { return static_cast<int>(rungproof::utf8::longestCharacter); }

}  // namespace

extern "C" {

std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t count, std::mbstate_t* state) {
  std::mbstate_t& kept = state != nullptr ? *state : stateWithout;
  if (from == nullptr) {
    kept = 0;
    return 0;
  }
  unsigned unit = 0, pending = static_cast<unsigned>(kept);
  const std::size_t taken = rungproof::utf8::takeUnit(from, count, unit, pending);
  kept = static_cast<std::mbstate_t>(pending);
  if (to != nullptr && taken != rungproof::utf8::invalid && taken != rungproof::utf8::unfinished)
    *to = static_cast<wchar_t>(unit);
  return told(taken);
}

std::size_t __wrap_wcrtomb(char* to, wchar_t unit, std::mbstate_t* state) {
  std::mbstate_t& kept = state != nullptr ? *state : stateWithout;
  if (to == nullptr) {
    kept = 0;
    return 1;
  }
  unsigned pending = static_cast<unsigned>(kept);
  const std::size_t count = rungproof::utf8::putUnit(unit, to, pending);
  kept = static_cast<std::mbstate_t>(pending);
  return told(count);
}

/// What MB_CUR_MAX asks: how much room a character needs.
int (*__wrap___imp____mb_cur_max_func)() = longest;

}  // extern "C"
