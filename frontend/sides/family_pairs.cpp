// Variables of an IEC 61131-3 program and the addresses of an S7-200 or S7-300/400 program: by symbol, or by the
// address at which a variable is declared.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "frontend/sides/variable_pairs.hpp"
#include "frontend/stl/missing_address.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "ir/iec/cpu.hpp"
#include "ir/iec/syntax.hpp"
#include "ir/iec/variables.hpp"

namespace rungproof {

namespace {

/// A variable with all names of its place; the first one is what reports call it.
struct PlacedVariable {
  Operand place;
  std::vector<std::string> names;
};

std::vector<PlacedVariable> placedVariables(const Program& program) {
  std::vector<PlacedVariable> variables;
  std::map<std::uint32_t, std::size_t> byOffset;
  for (const Symbol& symbol : program.symbols) {
    const auto [at, isNew] = byOffset.try_emplace(symbol.address.offset, variables.size());
    if (isNew) variables.push_back({symbol.address, {}});
    variables[at->second].names.push_back(symbol.name);
  }
  return variables;
}

/// The terminal whose address a variable has as one of its names: "IX0.3" and "I0.3" are I0.3. What the number of a
/// word counts depends on the maker of the controller; bits are alike on all.
std::optional<Operand> terminalNamed(std::string_view name) {
  std::string text = iec::foldedName(name);
  if (text.size() < 3 || (text[0] != 'I' && text[0] != 'Q')) return std::nullopt;
  if (text[1] == 'X') text.erase(1, 1);
  const bool isBit = std::isdigit(static_cast<unsigned char>(text[1])) != 0 && std::ranges::count(text, '.') == 1;
  Operand operand;
  if (!isBit || !readAddress(text, Spelling::International, operand)) return std::nullopt;
  return operand;
}

class FamilyPairing {
 public:
  FamilyPairing(Sides& sides, std::vector<Failure>& failures)
      : sides_(sides),
        failures_(failures),
        isOldOfVariables_(dialectOf(sides.before.program.target).memory.isOfVariables),
        iec_(isOldOfVariables_ ? sides.before : sides.after),
        other_(isOldOfVariables_ ? sides.after : sides.before),
        outputs_(iec_.program) {
    for (const Symbol& symbol : other_.program.symbols) bySymbol_.emplace(iec::foldedName(symbol.name), symbol.address);
  }

  void make() {
    const bool asksNothing = sides_.observed.empty();
    for (const PlacedVariable& variable : placedVariables(iec_.program)) {
      const bool isOutput = outputs_.contains(variable.place);
      if (!isMapped(variable.place)) pair(variable, isOutput);
      if (asksNothing && isOutput) observe(variable);
    }
    if (asksNothing && !hasOutput_ && failures_.empty())
      failures_.push_back({fmt::format("{} has no output that could be compared", side(true)),
                           {},
                           "name variables with --observe, or declare outputs of the program"});
  }

 private:
  /// OLD or NEW.
  std::string_view side(bool ofVariables) const { return ofVariables == isOldOfVariables_ ? "OLD" : "NEW"; }
  std::optional<Address> there(const Operand& place) const {
    const Address own = addressOf(place);
    return isOldOfVariables_ ? sides_.pairs.after(own) : sides_.pairs.before(own);
  }
  bool isMapped(const Operand& place) const { return there(place).has_value(); }
  bool isInput(const Operand& place, const ProgramInput& program) const {
    if (isInputArea(place.area)) return true;
    const Address own = addressOf(place);
    return std::ranges::any_of(program.properties.externals, [&](const ExternalRange& range) {
      const Address first = addressOf(range.first), last = addressOf(range.last);
      return own.area == first.area && own.index >= first.index && own.index < last.index + extentOf(range.last);
    });
  }
  void fail(std::string message, std::string help) { failures_.push_back({std::move(message), {}, std::move(help)}); }

  /// What of the other program has one of the names: by its symbols and by the address in the declaration.
  void pair(const PlacedVariable& variable, bool isOutput) {
    const bool isFree = isInput(variable.place, iec_);
    std::optional<Operand> partner;
    for (const std::string& name : variable.names) {
      std::optional<Operand> found = terminalNamed(name);
      if (found && missingFrom(other_.program.target, *found)) found.reset();
      if (const auto symbol = bySymbol_.find(iec::foldedName(name)); symbol != bySymbol_.end()) found = symbol->second;
      if (!found || found->kind != OperandKind::Direct || isInput(*found, other_) != isFree) continue;
      if (isWholeValue(found->area)) {
        if (isFree && isAnalogue(found->area))
          fail(fmt::format("{} of {} is {} of {}, an analog value that is read in the middle of a scan",
                           variable.names.front(), side(true), toString(*found), side(false)),
               "such inputs cannot be compared with a variable: copy the value to memory in both programs and declare "
               "that as external");
        continue;
      }
      if (extentOf(*found) != extentOf(variable.place)) continue;
      if (partner && addressOf(*partner) != addressOf(*found))
        return fail(fmt::format("{} of {} stands for {} by one of its names and for {} by another",
                                variable.names.front(), side(true), toString(*partner), toString(*found)),
                    "say with --map which one it is");
      partner = found;
    }
    if (!partner) return;
    const Address own = addressOf(variable.place), theirs = addressOf(*partner);
    const std::uint32_t count = extentOf(*partner);
    if (!(isOldOfVariables_ ? sides_.pairs.add(own, theirs, count) : sides_.pairs.add(theirs, own, count)))
      return fail(fmt::format("{} of {} and another variable stand for {} of {}", variable.names.front(), side(true),
                              toString(*partner), side(false)),
                  "say with --map which one it is");
    if (count > 1 && isOutput) sides_.pairs.compareAsOne({isOldOfVariables_ ? own : theirs, count});
  }
  /// What the other program gives out is compared anyway, with 0 where nothing stands for it.
  void observe(const PlacedVariable& variable) {
    hasOutput_ = true;
    const std::optional<Address> partner = there(variable.place);
    if (!partner)
      return fail(fmt::format("{} has the output {}, {} has no symbol of that name and size", side(true),
                              variable.names.front(), side(false)),
                  "pair it with --map, give the symbol table, or choose what is compared with --observe");
    sides_.pairs.compareToo({isOldOfVariables_ ? addressOf(variable.place) : *partner, extentOf(variable.place)});
  }

  Sides& sides_;
  std::vector<Failure>& failures_;
  const bool isOldOfVariables_;
  const ProgramInput& iec_;
  const ProgramInput& other_;
  const ProgramOutputs outputs_;
  std::map<std::string, Operand> bySymbol_;
  bool hasOutput_ = false;
};

}  // namespace

void pairWithOtherFamily(Sides& sides, std::vector<Failure>& failures) { FamilyPairing(sides, failures).make(); }

}  // namespace rungproof
