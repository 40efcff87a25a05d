// Names to addresses.
#include "frontend/sides/variable_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "ir/iec/cpu.hpp"
#include "ir/iec/syntax.hpp"
#include "ir/iec/variables.hpp"

namespace rungproof {

namespace {

/// One value of a program with the name that reports give it: the first one of its place.
struct NamedValue {
  std::string name;
  Operand place;
};

class Variables {
 public:
  explicit Variables(const Program& program) : outputs_(program) {
    for (const Symbol& symbol : program.symbols) {
      byName_.emplace(iec::foldedName(symbol.name), symbol.address);
      if (seen_.insert(symbol.address.offset).second) values_.push_back({symbol.name, symbol.address});
    }
    for (const Directive& directive : program.directives) {
      constexpr std::string_view free = "external ";
      if (directive.text.starts_with(free)) inputs_.insert(iec::foldedName(directive.text.substr(free.size())));
    }
  }

  const std::vector<NamedValue>& values() const { return values_; }
  /// The value of that name and size.
  const Operand* like(const NamedValue& value) const {
    const auto found = byName_.find(iec::foldedName(value.name));
    return found != byName_.end() && found->second.width == value.place.width ? &found->second : nullptr;
  }
  bool isInput(const NamedValue& value) const { return inputs_.contains(iec::foldedName(value.name)); }
  bool isOutput(const NamedValue& value) const { return outputs_.contains(value.place); }

 private:
  ProgramOutputs outputs_;
  std::map<std::string, Operand> byName_;
  std::vector<NamedValue> values_;
  std::set<std::uint32_t> seen_;
  std::set<std::string> inputs_;
};

/// Bytes that neither program uses, for variables that shall have no partner.
class FreePlaces {
 public:
  FreePlaces(const Program& before, const Program& after) {
    end_ = iecRow(std::min(before.target.cpu, after.target.cpu)).bytes;
    for (const Program* program : {&before, &after}) {
      for (const Symbol& symbol : program->symbols) begin_ = std::max(begin_, symbol.address.offset + 8);
    }
  }
  std::optional<Address> next(const Operand& place) {
    if (begin_ + 4 > end_) return std::nullopt;
    end_ -= 4;
    Operand there = place;
    there.offset = end_;
    return addressOf(there);
  }

 private:
  std::uint32_t begin_ = 0, end_ = 0;
};

class VariablePairs {
 public:
  VariablePairs(Sides& sides, std::vector<Failure>& failures)
      : sides_(sides),
        failures_(failures),
        old_(sides.before.program),
        new_(sides.after.program),
        free_(sides.before.program, sides.after.program) {}

  void make() {
    const bool asksNothing = sides_.observed.empty();
    for (const NamedValue& value : old_.values()) {
      const bool isAsked = std::ranges::any_of(
          sides_.observed, [&](const Operand& operand) { return addressOf(operand) == addressOf(value.place); });
      if (isAsked && old_.isInput(value))
        failures_.push_back({fmt::format("--observe: {} is an input: it has any value in both programs", value.name),
                             {},
                             "name outputs or variables that the program writes"});
    }
    for (const NamedValue& value : old_.values()) {
      if (const Operand* partner = new_.like(value))
        sides_.pairs.add(addressOf(value.place), addressOf(*partner), extentOf(value.place));
      if (extentOf(value.place) > 1) sides_.pairs.compareAsOne({addressOf(value.place), extentOf(value.place)});
    }
    for (const NamedValue& value : old_.values()) {
      const bool isAlone = new_.like(value) == nullptr && !isMapped(addressOf(value.place), true);
      if (asksNothing && old_.isOutput(value)) isAlone ? fail(value.name, "OLD", "NEW") : observe(value);
      if (isAlone && old_.isInput(value)) setApart(value.place, true);
    }
    for (const NamedValue& value : new_.values()) {
      if (old_.like(value) != nullptr || isMapped(addressOf(value.place), false)) continue;
      if (asksNothing && new_.isOutput(value)) fail(value.name, "NEW", "OLD");
      if (new_.isInput(value)) setApart(value.place, false);
    }
    if (asksNothing && sides_.observed.empty() && failures_.empty())
      failures_.push_back({"OLD has no output that could be compared",
                           {},
                           "name variables with --observe, or declare outputs of the program"});
  }

 private:
  bool isMapped(Address address, bool isOld) const {
    return isOld ? sides_.pairs.after(address) != address || sides_.pairs.names(address) : sides_.pairs.names(address);
  }
  void observe(const NamedValue& value) {
    Operand operand = value.place;
    operand.text = value.name;
    sides_.observed.push_back(std::move(operand));
  }
  void fail(const std::string& name, std::string_view one, std::string_view other) {
    failures_.push_back(
        {fmt::format("{} has the output {}, {} has no variable of that name and size", one, name, other),
         {},
         "pair it with --map, or choose what is compared with --observe"});
  }
  /// An input that one program lacks is none of the other's, wherever it lies.
  void setApart(const Operand& place, bool isOld) {
    const std::optional<Address> nowhere = free_.next(place);
    const Address here = addressOf(place);
    if (nowhere && isOld)
      sides_.pairs.add(here, *nowhere, extentOf(place));
    else if (nowhere)
      sides_.pairs.add(*nowhere, here, extentOf(place));
    else
      failures_.push_back({"the programs have inputs of different names and no byte is left to keep them apart",
                           {},
                           "pair them with --map"});
  }

  Sides& sides_;
  std::vector<Failure>& failures_;
  Variables old_, new_;
  FreePlaces free_;
};

}  // namespace

void pairVariables(Sides& sides, std::vector<Failure>& failures) { VariablePairs(sides, failures).make(); }

}  // namespace rungproof
