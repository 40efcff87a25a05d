// Memory for machine code: written through one mapping and executed through another, so that no page is ever both
// writable and executable. Tested by tests/cli/input_limit_test.cpp.
#pragma once

#include <asmjit/core.h>

namespace rungproof::compiled {

inline asmjit::JitRuntime& codePages() {
  static asmjit::JitRuntime runtime = [] {
    asmjit::JitAllocator::CreateParams parameters;
    parameters.options = asmjit::JitAllocatorOptions::kUseDualMapping;
    return asmjit::JitRuntime(&parameters);
  }();
  return runtime;
}

}  // namespace rungproof::compiled
