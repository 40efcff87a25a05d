// PTR005: tables and searches that are not prepared: no maximum length, more than 100 entries, FND at the wrong word,
// a search whose start position is never set. Tested by its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr std::int64_t mostEntries = 100;  // 001:6262

const Access* tableOf(const Facts& facts, const Instruction& instruction, std::uint8_t operand) {
  for (const Access& access : facts.accesses().of(instruction.id)) {
    if (access.operand == operand && !access.viaPointer && !access.byNumber()) return &access;
  }
  return nullptr;
}

/// Whether something else than table instructions writes the word at the cell.
bool isPrepared(const Facts& facts, std::uint32_t cell, const Instruction& own) {
  if (facts.index().mayBePointedTo(cell) || facts.isExternal(cell)) return true;
  for (const DataInit& init : facts.program().data) {
    const std::uint32_t offset = facts.index().cells().offsetOf(cell);
    if (facts.index().cells().areaOf(cell) == Area::V && offset >= init.offset &&
        offset < init.offset + init.bytes.size())
      return true;
  }
  const std::span<const std::uint32_t> accesses = facts.index().at(cell);
  const bool isWritten = std::any_of(accesses.begin(), accesses.end(), [&](std::uint32_t i) {
    const Access& access = facts.access(i);
    const Role role = roleOf(facts.instruction(access.instruction));
    return access.write && access.instruction != own.id && role != Role::Att && role != Role::Fifo &&
           role != Role::Lifo;
  });
  if (isWritten) return true;
  const std::span<const std::uint32_t> wide = facts.index().wide();
  return std::any_of(wide.begin(), wide.end(), [&](std::uint32_t i) {
    const Access& access = facts.access(i);
    const std::uint32_t start = access.viaPointer ? facts.index().cells().size() : facts.cellOf(access);
    return access.write && cell >= start && cell < start + access.possibleLength();
  });
}

void checkLength(const Facts& facts, FindingSink& sink, const Instruction& instruction, const Access& table) {
  const std::uint32_t cell = facts.cellOf(table);
  if (cell == facts.index().cells().size()) return;
  if (!isPrepared(facts, cell, instruction)) {
    Finding& finding = sink.report(
        instruction.span, fmt::format("nothing writes {}, the maximum length of the table of {}; it takes no entry",
                                      accessName(table), Facts::text(instruction)));
    finding.address = accessName(table);
    finding.help = "move the number of entries (1 to 100) there in the first scan (001:6511)";
    return;
  }
  for (const std::uint32_t i : facts.index().at(cell)) {
    const Access& access = facts.access(i);
    const Instruction& move = facts.instruction(access.instruction);
    const bool isMove = access.write && isMoveOf(*move.desc, Type::Word) && access.offset == table.offset &&
                        move.operands[0].kind == OperandKind::Constant;
    if (!isMove || (move.operands[0].value >= 1 && move.operands[0].value <= mostEntries)) continue;
    Finding& finding = sink.report(move.operands[0].span,
                                   fmt::format("the table at {} gets a maximum length of {}; 1 to {} are allowed",
                                               accessName(table), move.operands[0].value, mostEntries));
    finding.address = accessName(table);
    finding.related.push_back({instruction.span, "the table is used here"});
    finding.help = "split the data into several tables (001:6262)";
    return;
  }
}

void checkSearch(const Facts& facts, FindingSink& sink, const Instruction& instruction) {
  for (const Access& access : facts.accesses().of(instruction.id)) {
    if (!access.write || access.viaPointer || access.area == Area::AC) continue;
    const std::uint32_t cell = facts.cellOf(access);
    if (cell == facts.index().cells().size() || isPrepared(facts, cell, instruction)) continue;
    Finding& finding = sink.report(instruction.operands[access.operand].span,
                                   fmt::format("{} starts its search at {}, which nothing sets; 0 is error 009B",
                                               Facts::text(instruction), accessName(access)));
    finding.address = accessName(access);
    finding.help = "move 1 there before each search; after a search without success it is 0 (001:6165)";
  }
}

void checkPtr005(const Facts& facts, FindingSink& sink) {
  if (facts.hasHiddenCode()) return;
  std::unordered_map<std::uint32_t, const Instruction*> tables;  // by cell
  for (const InstructionPlace& place : facts.placesOf([](const Desc& desc) {
         return desc.role == Role::StringFind || desc.role == Role::Att || desc.role == Role::Fifo ||
                desc.role == Role::Lifo;
       })) {
    const Instruction& instruction = *place.instruction;
    const Role role = roleOf(instruction);
    if (role == Role::StringFind) checkSearch(facts, sink, instruction);
    if (role != Role::Att && role != Role::Fifo && role != Role::Lifo) continue;
    const Access* table = tableOf(facts, instruction, role == Role::Att ? 1 : 0);
    if (table == nullptr || !tables.emplace(facts.cellOf(*table), &instruction).second) continue;
    if (role == Role::Att) checkLength(facts, sink, instruction, *table);
  }
  for (const InstructionPlace& place : facts.placesOf(Role::Find)) {
    const Instruction& instruction = *place.instruction;
    if (roleOf(instruction) != Role::Find) continue;
    const Access* table = tableOf(facts, instruction, 0);
    const auto found = table == nullptr ? tables.end() : tables.find(facts.cellOf(*table));
    if (found == tables.end()) continue;
    Finding& finding = sink.report(
        instruction.operands[0].span,
        fmt::format("{} names the table at its maximum length; it needs the entry count, two bytes further on",
                    Facts::text(instruction)));
    finding.address = accessName(*table);
    finding.related.push_back({found->second->span, "the table instruction with the same address"});
    finding.help = fmt::format("write {} (001:6441)", addressName(table->area, Width::Word, table->offset + 2));
  }
}

constexpr Hazard ptr005Hazards[] = {Hazard::StringIndexZero};

}  // namespace

extern constexpr Rule ptr005_table_header = {
    .id = "PTR005",
    .title = "Table or string header wrong",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "ATT on a table whose maximum length nothing sets or that is not 1-100; FND at the maximum length instead of "
        "the entry count; SFND or CFND "
        "whose start position nothing sets",
    .why = "a table of length 0 takes no entry, FND would compare the header, a search from position 0 is error 009B",
    .manual = "001:6262, 001:6441, 001:6511, 001:6165, 001:13972",
    .bad = "Network 1\nLD I0.0\nEU\nATT VW0, VW200\n",
    .good = "Network 1\nLD SM0.1\nMOVW +10, VW200\nNetwork 2\nLD I0.0\nEU\nATT VW0, VW200\n",
    .falsePositives = "tables that an operator panel prepares: declare them with //@ external",
    .dialects = dialect::S7200,
    .check = checkPtr005,
    .ask = {.in = asked::Builtin, .turn = 30, .cost = 1, .hazards = ptr005Hazards},
};

}  // namespace rungproof
