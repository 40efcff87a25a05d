// Printing of failures. Tested by the golden tests of usage errors.
#include "frontend/files/failure.hpp"

#include <ostream>

#include "frontend/text/safe_text.hpp"

namespace rungproof {

void print(std::ostream& err, const Failure& failure) {
  err << "error: " << messageText(failure.message) << '\n';
  if (!failure.place.empty()) err << "  --> " << messageText(failure.place) << '\n';
  if (!failure.help.empty()) err << "  = help: " << messageText(failure.help) << '\n';
}

}  // namespace rungproof
