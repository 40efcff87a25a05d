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

bool isSame(const Operand& a, const Operand& b) {
  return a.area == b.area && a.offset == b.offset && a.bit == b.bit && a.width == b.width;
}

/// The question whether a property holds for any program: the same assumptions over a program without instructions, in
/// which everything that the property names and that is written has any value in any scan.
struct AnyProgram {
  Program program;
  PropertySet set;
};

/// What of a program is written, for all its properties.
class UntouchedPlaces {
 public:
  UntouchedPlaces(const Facts& facts, const PropertySet& set) : facts_(facts), set_(set) {
    for (const InstructionPlace& place : facts.instructions()) {
      const Role role = roleOf(*place.instruction);
      if (role == Role::Get || usesBuffer(role)) buffers_.push_back(place.instruction);
    }
  }

  /// The addresses of a property that nothing writes, in the order of its text, each once.
  Operands of(const Property& property) const {
    Operands found;
    for (const Operand* operand : addressesOf(property)) {
      const bool isKnown = std::ranges::any_of(found, [&](const Operand& known) { return isSame(known, *operand); });
      if (!isKnown && !isWritten(*operand)) found.push_back(*operand);
    }
    return found;
  }

  /// Nothing if a written address of the property cannot be given any value (timers, counters, accumulators).
  std::optional<AnyProgram> anyProgramFor(const Property& property) {
    if (!empty_) {
      empty_.emplace(facts_.program());
      for (Pou& pou : empty_->pous) {
        for (Network& network : pou.networks) network.instructions.clear();
        if (pou.networks.size() > 1) pou.networks.resize(1);
      }
      empty_->number();
      empty_->directives.clear();
      empty_->findings.clear();
      assumed_ = set_;
      std::erase_if(assumed_.properties, [](const Property& other) { return other.isGoal(); });
    }
    AnyProgram any{*empty_, assumed_};
    any.set.properties.push_back(property);
    for (const Property& each : any.set.properties) {
      for (const Operand* operand : addressesOf(each)) {
        if (isInputArea(operand->area) || operand->area == Area::SM) continue;
        if (!isWritten(*operand)) continue;
        if (!isWrittenMemory(operand->area) || operand->area == Area::AQ) return std::nullopt;
        any.set.externals.push_back({*operand, *operand, {}});
      }
    }
    return any;
  }

 private:
  /// Whether a buffer that begins at a direct operand of such an instruction, or anywhere, may hold the place.
  bool isInBuffer(const PlaceRow& row) const {
    return std::ranges::any_of(buffers_, [&](const Instruction* instruction) {
      if (roleOf(*instruction) == Role::Get) return true;  // a pointer in its table says where
      return std::ranges::any_of(instruction->operands, [&](const Operand& o) {
        return o.kind == OperandKind::Indirect ||
               (o.kind == OperandKind::Direct && meet(row, rowOf(o.area, Width::Byte, o.offset, 0, longestTable)));
      });
    });
  }

  /// Whether a called block without text may write there, beside its outputs.
  bool isWrittenByCalls(const PlaceRow& row) const {
    return std::ranges::any_of(facts_.contracts().all(), [&](const auto& call) {
      const CallContract& contract = call.second;
      return contract.mayDoAnything || (contract.fillsAnyV && row.area == Area::V) ||
             std::ranges::any_of(contract.memory, [&](const MemoryRow& memory) {
               return meet(row, {memory.area, memory.first, memory.count});
             });
    });
  }

  bool isWritten(const Operand& operand) const {
    const bool isNumbered = hasBitAndWord(operand.area) || operand.area == Area::AC;
    if (!isNumbered && !isWrittenMemory(operand.area)) return true;
    const CellMap& cells = facts_.index().cells();
    if (isNumbered) {
      const std::uint32_t cell = cells.cell(operand.area, operand.offset, 0);
      return cell == cells.size() || facts_.index().mayBeWritten(cell);
    }
    const PlaceRow row = rowOf(operand);
    const bool isExternal = std::ranges::any_of(set_.externals, [&](const ExternalRange& range) {
      const PlaceRow first = rowOf(range.first);
      const PlaceRow last = rowOf(range.last);
      return meet(row, {first.area, first.first, last.first + last.count - first.first});
    });
    const std::optional<std::uint32_t>& clock = facts_.program().clockMemory;
    if (clock && meet(row, {Area::M, *clock * 8, 8})) return true;
    if (isExternal || isInBuffer(row) || isWrittenByCalls(row)) return true;
    for (std::uint32_t bit = row.first; bit < row.first + row.count; ++bit) {
      const std::uint32_t cell = cells.cell(operand.area, bit / 8, 0);
      if (cell == cells.size() || facts_.index().isWrittenAtLarge(cell) || facts_.writers(cell, bit % 8) > 0)
        return true;
    }
    return false;
  }

  const Facts& facts_;
  const PropertySet& set_;
  std::vector<const Instruction*> buffers_;  ///< that name a buffer which others fill
  std::optional<Program> empty_;             ///< the program without instructions
  PropertySet assumed_;                      ///< with it: the set without goals
};

}  // namespace

void noteUntouched(
    const Program& program, const PropertySet& set, const ProverOptions& options, std::vector<ProofResult>& rows,
    const std::function<ProofRun(const Program&, const PropertySet&, const ProverOptions&, const ProofProgress&)>& ask,
    const std::function<void(ProofResult&, const std::exception&)>& broken) {
  std::unique_ptr<const Facts> facts;
  std::optional<UntouchedPlaces> places;
  const auto note = [&](ProofResult& row) {
    const Operands untouched = places->of(row.property);
    for (const Operand& operand : untouched)
      row.notes.push_back(fmt::format("no instruction writes {}", toString(operand)));
    if (untouched.empty() || row.outcome != Outcome::Proved) return;
    const std::optional<AnyProgram> any = places->anyProgramFor(row.property);
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
    if (!facts) {
      facts = std::make_unique<const Facts>(program, set.externals);
      places.emplace(*facts, set);
    }
    try {
      note(row);
    } catch (const std::exception& error) {
      broken(row, error);
    }
  }
}

}  // namespace rungproof
