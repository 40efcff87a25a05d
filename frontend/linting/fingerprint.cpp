// Fingerprints of findings: 64-bit FNV-1a, which is fixed for ever, unlike std::hash.
#include "frontend/linting/fingerprint.hpp"

#include <fmt/core.h>

namespace rungproof {

std::string fingerprintOf(const std::vector<std::string>& parts) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  const auto add = [&](unsigned char byte) { hash = (hash ^ byte) * 0x100000001B3ULL; };
  for (const std::string& part : parts) {
    for (const char c : part) add(static_cast<unsigned char>(c));
    add(0xFF);  // a byte that UTF-8 never holds ends each part
  }
  return fmt::format("{:016x}", hash);
}

std::string fingerprintOf(const Finding& finding, const SourceSet& sources) {
  const SourceFile& file = sources.file(finding.span.file);
  std::string line(file.line(file.position(finding.span.offset).line));
  std::erase_if(line, [](char c) { return c == ' ' || c == '\t'; });
  return fingerprintOf({finding.rule, finding.pou, finding.address, line});
}

}  // namespace rungproof
