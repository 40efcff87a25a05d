// Nothing in here allocates.
#include "frontend/cli/last_words.hpp"

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "engine/platform/console.hpp"
#include "engine/platform/waitable.hpp"
#include "frontend/files/exit.hpp"
#include "frontend/files/part_file.hpp"

namespace rungproof {

namespace {

std::terminate_handler usualEnd = nullptr;

/// Functions of the C++ library that promise not to throw end the program without catching what was thrown in them;
/// that is nothing but the lack of memory.
bool isMemoryOver() {
  const std::exception_ptr exception = std::current_exception();
  if (exception == nullptr) return std::uncaught_exceptions() > 0;
  try {
    std::rethrow_exception(exception);
  } catch (const std::bad_alloc&) {
    return true;
  } catch (...) {
    return false;
  }
}

/// The first thread that comes here ends the process, and the others with it.
[[noreturn]] void endAtOnce() {
  static std::atomic_flag hasBegun;
  while (hasBegun.test_and_set()) hasBegun.wait(true);
  removeOpenParts();
  if (!isMemoryOver()) {
    usualEnd();
    std::abort();
  }
  for (const std::string_view text : {"error: ", outOfMemory, "\n"}) writeBytes(static_cast<int>(Stream::Err), text);
  std::_Exit(static_cast<int>(Exit::Failed));
}

}  // namespace

void prepareLastWords() { usualEnd = std::set_terminate(endAtOnce); }

}  // namespace rungproof
