// Printing of failures. Tested by the golden tests of usage errors.
#include "frontend/files/failure.hpp"

#include <ostream>

namespace rungproof {

void print(std::ostream& err, const Failure& failure) {
  err << "error: " << failure.message << '\n';
  if (!failure.place.empty()) err << "  --> " << failure.place << '\n';
  if (!failure.help.empty()) err << "  = help: " << failure.help << '\n';
}

}  // namespace rungproof
