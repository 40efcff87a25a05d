// Names of IEC 61131-3.
#include "ir/iec/syntax.hpp"

#include <cctype>

namespace rungproof::iec {

std::string foldedName(std::string_view name) {
  std::string folded(name);
  for (char& c : folded) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return folded;
}

}  // namespace rungproof::iec
