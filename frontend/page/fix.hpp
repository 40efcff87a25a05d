// Applying the safe fixes of findings to their files. A file is changed only if its bytes are what was read: texts that
// were converted from another encoding are left alone. Tested by tests/golden/lint/fix.test.
#pragma once

#include <string>
#include <vector>

#include "frontend/command/command.hpp"

namespace rungproof {

/// A file with its safe fixes applied; of fixes that overlap the first is taken.
struct FixedFile {
  std::string name;
  std::string text;
  std::size_t count = 0;
};
std::vector<FixedFile> fixedFiles(const Report& report);

/// Writes them; says on Context::err what was changed and what could not be. False if a file could not be written.
bool applyFixes(const Context& context, const Report& report);

}  // namespace rungproof
