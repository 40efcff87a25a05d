// By the kind of the exception: of the libraries' ones only the system's lack of something is no mistake of ours.
#include "analysis/broken_off.hpp"

#include <fmt/format.h>

#include <new>
#include <system_error>

namespace rungproof {

std::string whyBrokenOff(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "ran out of memory";
  if (const auto* refused = dynamic_cast<const std::system_error*>(&error))
    return "the system refuses what is needed: " + refused->code().message();
  return fmt::format("internal error: {}; this is a defect of rungproof", error.what());
}

}  // namespace rungproof
