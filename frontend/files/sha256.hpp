// The fingerprint of bytes that certificates, acceptance pages and kept results name. Tested by
// tests/cli/certificate_file_test.cpp.
#pragma once

#include <string>
#include <string_view>

namespace rungproof {

/// SHA-256 of the bytes as 64 hexadecimal digits, as sha256sum prints it.
std::string sha256(std::string_view bytes);

}  // namespace rungproof
