// Names between UTF-8, in which the program has them, and UTF-16, in which the system has them.
#pragma once

#include <string>
#include <string_view>

namespace rungproof {

/// Bytes that are not UTF-8 become U+FFFD.
std::wstring wideName(std::string_view text);
std::string narrowName(std::wstring_view text);

}  // namespace rungproof
