// By kind, index and instruction.
#include "analysis/encoding/site_name.hpp"

#include <fmt/format.h>

namespace rungproof {

std::string siteName(const ExternalSite& site) {
  switch (site.kind) {
    case External::ImmediateInput:
      return fmt::format("I{}.{} immediate, instruction {}", site.index / 8, site.index % 8, site.instruction);
    case External::AnalogInput: return fmt::format("AIW{}, instruction {}", site.index, site.instruction);
    case External::StackBottom: return fmt::format("stack bottom, instruction {}", site.instruction);
    case External::LocalMemory: return fmt::format("LB{}, instruction {}", site.index, site.instruction);
    default:
      return fmt::format("external {} {}, instruction {}", static_cast<int>(site.kind), site.index, site.instruction);
  }
}

}  // namespace rungproof
