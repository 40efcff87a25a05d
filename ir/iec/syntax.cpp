// Names of IEC 61131-3.
#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

std::string foldedName(std::string_view name) {
  std::string folded(name);
  for (char& c : folded) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;  // no look at the locale
  return folded;
}

}  // namespace rungproof::iec
