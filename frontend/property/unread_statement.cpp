// By its first word.
#include "frontend/property/unread_statement.hpp"

#include <cctype>
#include <string>

namespace rungproof {

bool maySayOfTheWorld(std::string_view line) {
  std::string word;
  for (const char c : line) {
    const bool isLetter = std::isalpha(static_cast<unsigned char>(c)) != 0;
    if (isLetter) word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!isLetter && !word.empty()) break;
    if (!isLetter && c != ' ' && c != '\t') break;
  }
  return word != "prove" && word != "reach" && word != "at" && word != "reset";
}

}  // namespace rungproof
