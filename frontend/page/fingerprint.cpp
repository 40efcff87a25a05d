// Fingerprints of findings: 64-bit FNV-1a, which is fixed for ever, unlike std::hash.
#include "frontend/page/fingerprint.hpp"

#include <fmt/core.h>

namespace rungproof {

std::string fingerprintOf(const Finding& finding, const SourceSet& sources) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  const auto add = [&](std::string_view text, bool withSpaces) {
    for (const char c : text) {
      if (!withSpaces && (c == ' ' || c == '\t')) continue;
      hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
    }
    hash = (hash ^ 0xFF) * 0x100000001B3ULL;  // a byte that UTF-8 never holds ends each part
  };
  const SourceFile& file = sources.file(finding.span.file);
  add(finding.rule, true);
  add(finding.pou, true);
  add(finding.address, true);
  add(file.line(file.position(finding.span.offset).line), false);
  return fmt::format("{:016x}", hash);
}

}  // namespace rungproof
