// Printing of failures. Tested by the golden tests of usage errors.
#include "frontend/files/failure.hpp"

#include <ostream>

#include "frontend/text/safe_text.hpp"

namespace rungproof {

void print(std::ostream& err, const Failure& failure) {
  err << "error: " << lineText(failure.message) << '\n';
  if (!failure.place.empty()) err << "  --> " << lineText(failure.place) << '\n';
  if (!failure.help.empty()) err << "  = help: " << lineText(failure.help) << '\n';
}

}  // namespace rungproof
