// Asks the access lists who writes the addresses of a property.
#include "analysis/proof/untouched.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "analysis/schedule/schedule.hpp"
#include "analysis/unread/influence.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t longestTable = 256;  ///< bytes of a communication or clock buffer

bool isWrittenMemory(Area area) { return isMemoryArea(area) || isOutputArea(area); }

/// Fills or reads a buffer while the program goes on (001:3145, 000:1113).
bool usesBuffer(Role role) {
  return role == Role::Rcv || role == Role::Xmt || role == Role::Netr || role == Role::Netw || role == Role::Put ||
         role == Role::Todr;
}

/// Whether a buffer that begins at a direct operand of such an instruction, or anywhere, may hold the place.
bool isInBuffer(const Facts& facts, const PlaceRow& row) {
  return std::ranges::any_of(facts.instructions(), [&](const InstructionPlace& place) {
    if (roleOf(*place.instruction) == Role::Get) return true;  // a pointer in its table says where
    if (!usesBuffer(roleOf(*place.instruction))) return false;
    return std::ranges::any_of(place.instruction->operands, [&](const Operand& o) {
      return o.kind == OperandKind::Indirect ||
             (o.kind == OperandKind::Direct && meet(row, rowOf(o.area, Width::Byte, o.offset, 0, longestTable)));
    });
  });
}

/// Whether a called block without text may write there, beside its outputs.
bool isWrittenByCalls(const Facts& facts, const PlaceRow& row) {
  return std::ranges::any_of(facts.contracts().all(), [&](const auto& call) {
    const CallContract& contract = call.second;
    return contract.mayDoAnything || (contract.fillsAnyV && row.area == Area::V) ||
           std::ranges::any_of(contract.memory, [&](const MemoryRow& memory) {
             return meet(row, {memory.area, memory.first, memory.count});
           });
  });
}

bool isWritten(const Facts& facts, const PropertySet& set, const Operand& operand) {
  const bool isNumbered = hasBitAndWord(operand.area) || operand.area == Area::AC;
  if (!isNumbered && !isWrittenMemory(operand.area)) return true;
  const CellMap& cells = facts.index().cells();
  if (isNumbered) {
    const std::uint32_t cell = cells.cell(operand.area, operand.offset, 0);
    return cell == cells.size() || facts.index().mayBeWritten(cell);
  }
  const PlaceRow row = rowOf(operand);
  const bool isExternal = std::ranges::any_of(set.externals, [&](const ExternalRange& range) {
    const PlaceRow first = rowOf(range.first);
    const PlaceRow last = rowOf(range.last);
    return meet(row, {first.area, first.first, last.first + last.count - first.first});
  });
  const std::optional<std::uint32_t>& clock = facts.program().clockMemory;
  if (clock && meet(row, {Area::M, *clock * 8, 8})) return true;
  if (isExternal || isInBuffer(facts, row) || isWrittenByCalls(facts, row)) return true;
  for (std::uint32_t bit = row.first; bit < row.first + row.count; ++bit) {
    const std::uint32_t cell = cells.cell(operand.area, bit / 8, 0);
    if (cell == cells.size() || facts.index().isWrittenAtLarge(cell) || facts.writers(cell, bit % 8) > 0) return true;
  }
  return false;
}

bool isSame(const Operand& a, const Operand& b) {
  return a.area == b.area && a.offset == b.offset && a.bit == b.bit && a.width == b.width;
}

}  // namespace

Operands untouchedBy(const Facts& facts, const PropertySet& set, const Property& property) {
  Operands found;
  for (const Operand* operand : addressesOf(property)) {
    const bool isKnown = std::ranges::any_of(found, [&](const Operand& known) { return isSame(known, *operand); });
    if (!isKnown && !isWritten(facts, set, *operand)) found.push_back(*operand);
  }
  return found;
}

std::optional<AnyProgram> anyProgramFor(const Facts& facts, const PropertySet& set, const Property& property) {
  AnyProgram any{facts.program(), set};
  for (Pou& pou : any.program.pous) {
    for (Network& network : pou.networks) network.instructions.clear();
  }
  any.program.number();
  std::erase_if(any.set.properties, [](const Property& other) { return other.isGoal(); });
  any.set.properties.push_back(property);
  for (const Property& each : any.set.properties) {
    for (const Operand* operand : addressesOf(each)) {
      if (isInputArea(operand->area) || operand->area == Area::SM) continue;
      if (!isWritten(facts, set, *operand)) continue;
      if (!isWrittenMemory(operand->area) || operand->area == Area::AQ) return std::nullopt;
      any.set.externals.push_back({*operand, *operand, {}});
    }
  }
  return any;
}

void noteUntouched(
    const Program& program, const PropertySet& set, const ProverOptions& options, std::vector<ProofResult>& rows,
    const std::function<ProofRun(const Program&, const PropertySet&, const ProverOptions&, const ProofProgress&)>& ask,
    const std::function<void(ProofResult&, const std::exception&)>& broken) {
  std::unique_ptr<const Facts> facts;
  const auto note = [&](ProofResult& row) {
    const Operands untouched = untouchedBy(*facts, set, row.property);
    for (const Operand& operand : untouched)
      row.notes.push_back(fmt::format("no instruction writes {}", toString(operand)));
    if (untouched.empty() || row.outcome != Outcome::Proved) return;
    const std::optional<AnyProgram> any = anyProgramFor(*facts, set, row.property);
    if (!any) return;
    ProverOptions quick = options;
    quick.checks = {};
    quick.unread = nullptr;
    quick.certificates = quick.evidence = false;
    quick.timeout = std::min(options.timeout, schedule::premiseSeconds);
    const ProofRun run = ask(any->program, any->set, quick, {});
    if (run.results.size() != 1 || run.results.front().outcome != Outcome::Proved) return;
    row.outcome = Outcome::Vacuous;
    row.notes.push_back("it holds for any program that leaves these alone");
  };
  for (ProofResult& row : rows) {
    if (row.builtin || row.property.first.nodes.empty()) continue;
    if (!facts) facts = std::make_unique<const Facts>(program, set.externals);
    try {
      note(row);
    } catch (const std::exception& error) {
      broken(row, error);
    }
  }
}

}  // namespace rungproof
