// LIB003: V memory that belongs to a library and that the program touches: what the project's settings give to
// libraries, the 16 bytes behind DB_Ptr of the USS blocks, and holding registers that reach into them or beyond the
// end. What a wizard made for the program to read, such as the record of a recipe, is no such memory. Tested by its
// examples, tests/rules/library_rules_test.cpp and tests/smart/contract_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/library_use.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

struct OwnedMemory {
  std::string owner;
  std::uint32_t first, last;
  const Instruction* call;  ///< that names it; nullptr: a setting
};

std::string rangeText(std::uint32_t first, std::uint32_t last) {
  return fmt::format("{} to {}", addressName(Area::V, Width::Byte, first), addressName(Area::V, Width::Byte, last));
}

/// The operand of a call that is the address of V memory.
std::optional<std::size_t> addressOperand(const Instruction& call) {
  for (std::size_t i = 1; i < call.operands.size(); ++i) {
    if (call.operands[i].kind == OperandKind::Address && call.operands[i].area == Area::V) return i;
  }
  return std::nullopt;
}

class LibraryMemoryCheck {
 public:
  LibraryMemoryCheck(const Facts& facts, FindingSink& sink) : facts_(facts), sink_(sink), calls_(libraryCalls(facts)) {
    for (const LibraryCall& call : calls_) {
      const bool isUss = call.name.starts_with("USS_RPM") || call.name.starts_with("USS_WPM");
      const auto at = isUss ? addressOperand(*call.call) : std::nullopt;
      if (!at) continue;
      const std::uint32_t first = call.call->operands[*at].offset;
      owned_.push_back({call.name, first, first + ussScratchBytes - 1, call.call});
    }
    for (const LibraryMemory& memory : facts.program().libraryMemory) {
      const LibraryBlock* block = libraryBlockNamed(memory.block);
      if (block != nullptr && block->reach == LibraryReach::Record) continue;
      owned_.push_back({memory.block.empty() ? "a library" : memory.block, memory.first, memory.last, nullptr});
    }
  }

  void run() {
    if (owned_.empty() && calls_.empty()) return;
    registers();
    uses();
  }

 private:
  /// MBUS_INIT and MBUS_SERVER: MaxHold words from HoldStart on.
  void registers() {
    for (const LibraryCall& call : calls_) {
      if (call.name != "MBUS_INIT" && call.name != "MBUS_SERVER") continue;
      const auto at = addressOperand(*call.call);
      if (!at || *at < 2 || call.call->operands[*at - 1].kind != OperandKind::Constant) continue;
      const Operand& start = call.call->operands[*at];
      const auto words = call.call->operands[*at - 1].value;
      if (words <= 0) continue;
      const std::int64_t last = start.offset + 2 * words - 1;
      const auto report = [&](std::string message) -> Finding& {
        Finding& finding = sink_.report(start.span, std::move(message));
        finding.address = addressName(Area::V, Width::Byte, start.offset);
        finding.help = "give MaxHold and HoldStart so that the registers lie in V memory of the program's own";
        return finding;
      };
      const std::string range = fmt::format("{} holding registers from {} on", words, toString(start).substr(1));
      if (last >= static_cast<std::int64_t>(areaSize(facts_.target(), Area::V)))
        report(fmt::format("{} of {} reach beyond the end of V memory", range, call.name));
      for (const OwnedMemory& memory : owned_) {
        if (last < memory.first || start.offset > memory.last) continue;
        report(fmt::format("{} of {} reach into {} of {} (error 5)", range, call.name,
                           rangeText(memory.first, memory.last), memory.owner));
      }
    }
  }

  void uses() {
    std::set<std::pair<std::uint32_t, Width>> seen;
    for (const Access& access : facts_.accesses().all()) {
      if (access.viaPointer || access.area != Area::V || access.operand == impliedOperand) continue;
      const std::uint32_t last = access.offset + std::max(access.certainLength(), 1U) - 1;
      for (const OwnedMemory& memory : owned_) {
        if (last < memory.first || access.offset > memory.last) continue;
        if (!seen.emplace(access.offset, access.width).second) break;
        const Instruction& instruction = facts_.instruction(access.instruction);
        Finding& finding =
            sink_.report(instruction.operands[access.operand].span,
                         fmt::format("{} {} {}, which lies in the memory of {} ({})", Facts::text(instruction),
                                     access.write ? "writes" : "reads", accessRange(access), memory.owner,
                                     rangeText(memory.first, memory.last)));
        finding.address = accessName(access);
        if (memory.call != nullptr) finding.related.push_back({memory.call->span, "the library gets it here"});
        finding.help = "take other memory, or assign the library another range";
        break;
      }
    }
  }

  const Facts& facts_;
  FindingSink& sink_;
  const std::vector<LibraryCall> calls_;
  std::vector<OwnedMemory> owned_;
};

void checkLib003(const Facts& facts, FindingSink& sink) { LibraryMemoryCheck(facts, sink).run(); }

}  // namespace

extern constexpr Rule lib003_library_memory_used = {
    .id = "LIB003",
    .title = "Library memory used by the program",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "an access inside memory that the settings give to a library or the 16 bytes behind DB_Ptr of a USS block, "
        "holding registers of Modbus that reach into memory of a library or beyond the end of V",
    .why = "the library and the program overwrite each other, and nothing reports it",
    .manual = "001:2497, 001:10037, 001:10256, 001:10686",
    .bad =
        "Network 1\nLD I0.0\nEU\nCALL USS_RPM_W, I0.0, 0, 3, 0, &VB100, M0.1, VB10, VW12\nNetwork 2\nLD SM0.0\nMOVW "
        "+1, VW110\n",
    .good =
        "Network 1\nLD I0.0\nEU\nCALL USS_RPM_W, I0.0, 0, 3, 0, &VB100, M0.1, VB10, VW12\nNetwork 2\nLD SM0.0\nMOVW "
        "+1, VW116\n",
    .dialects = dialect::S7200,
    .check = checkLib003,
};

}  // namespace rungproof
