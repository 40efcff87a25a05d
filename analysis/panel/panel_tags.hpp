// The tag list of an operator panel against the program: tags that nothing uses, widths and types that do not fit,
// words with two masters, parameters that a power failure clears. `xref --tags` prints the answers. Tested by
// tests/cli/tags_test.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "engine/start_up.hpp"

namespace rungproof {

enum class TagFault : std::uint8_t {
  Missing,       ///< the CPU does not have the address
  Unused,        ///< no instruction touches it
  Width,         ///< the type has another width than the address, or the program another one than the tag
  Type,          ///< REAL against whole number
  TwoMasters,    ///< panel and program both set it
  NotRetentive,  ///< the operator's value is lost with the power
};
std::string_view tagFaultName(TagFault fault);  ///< "unused", "two masters"

struct TagProblem {
  TagFault fault;
  std::string message;
  const Instruction* place = nullptr;  ///< of the program, if one shows it
};

/// What is known of one tag.
struct TagReport {
  const PanelTag* tag;
  std::size_t readers = 0, writers = 0;  ///< accesses that share a bit with it
  std::vector<TagProblem> problems{};
};

/// One for each tag of Facts::surroundings, in their order.
std::vector<TagReport> tagReports(const Facts& facts, const std::vector<RetentiveRange>& retentive);

}  // namespace rungproof
