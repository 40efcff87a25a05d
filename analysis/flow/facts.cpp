// Builds the facts in the order in which they depend on each other.
#include "analysis/flow/facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "analysis/flow/dataflow_pointers.hpp"
#include "analysis/flow/pulse_bits.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/read_errors.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/isa.hpp"

namespace rungproof {

namespace {

std::uint64_t addressKey(const Operand& o) {
  const bool byNumber = hasBitAndWord(o.area);
  const std::uint64_t shape = byNumber ? 0 : static_cast<std::uint64_t>(o.width) << 4 | o.bit;
  return static_cast<std::uint64_t>(o.area) << 48 | shape << 40 | o.offset;
}

}  // namespace

namespace {

/// Whether the error stands in a source of an S7-300/400 that was read.
bool isFramedByWords(const Program& program, const Finding& finding) {
  constexpr std::string_view ofFiles[] = {"SYN001", "SYN002", "SYN006", "SYN007", "SYN050"};
  return program.declarations != nullptr && std::ranges::find(ofFiles, finding.rule) == std::end(ofFiles);
}

}  // namespace

Facts::Facts(const Program& program, std::span<const ExternalRange> externals, Surroundings around)
    : program_(program),
      surroundings_(std::move(around)),
      externals_(externals.begin(), externals.end()),
      plan_(program),
      accesses_(program, plan_),
      blocks_(plan_),
      index_(program, accesses_, blocks_),
      bits_(accesses_, index_.cells(), blocks_),
      calls_(program, plan_),
      contracts_(program),
      stack_(program, plan_, {}),
      execution_(program, plan_, calls_, stack_) {
  countUses();
  for (const Finding& finding : program.findings) {
    if (isBoundedReadError(program, finding)) continue;
    // Words frame the blocks of an S7-300/400: what is damaged ends with its block.
    hasUnreadFrame_ = hasUnreadFrame_ || (isFrameReadError(finding) && !isFramedByWords(program, finding));
    hasUnreadCode_ = hasUnreadCode_ || (finding.network == 0 && isProgramReadError(finding));
  }
  hasHiddenCode_ = hasUnreadCode_;
  // Of a source of single blocks the text shows no caller.
  const bool isOfStatements = form() == StatementForm::Accumulators;
  bool hasCallers = false;
  for (std::uint32_t block = 0; block < program.pous.size(); ++block) hasCallers = hasCallers || calls_.mayRun(block);
  for (std::uint32_t block = 0; block < program.pous.size(); ++block) {
    const bool isIdle = isOfStatements && hasCallers && !calls_.mayRun(block);
    hasUnreadCode_ = hasUnreadCode_ || (!isIdle && hasUnreadCode(block));
    hasHiddenCode_ = hasHiddenCode_ || hasUnreadCode_ || program.pous[block].protectedBlock;
  }
  for (const auto& [id, contract] : contracts_.all())
    hasHiddenCode_ = hasHiddenCode_ || contract.source != CallContract::Source::Library;
  collectBoxes();
  collectSymbols();
  collectExternals();
  findPulses();
  pointers_ = std::make_unique<const PointerTable>(*this);
  static const iec::ProjectSyntax none;
  variableUses_ = std::make_unique<const iec::VariableUses>(program.syntax != nullptr ? *program.syntax : none);
}

Facts::~Facts() = default;

bool Facts::hasUnreadCode(const Pou& block) const {
  return hasUnreadFrame_ ||
         std::ranges::any_of(block.networks, [](const Network& network) { return !network.complete; });
}

std::vector<std::uint32_t> Facts::idsIn(std::span<const std::vector<std::uint32_t>* const> rows) {
  std::vector<std::uint32_t> ids;
  std::vector<std::ptrdiff_t> starts{0};
  for (const std::vector<std::uint32_t>* row : rows) {
    ids.insert(ids.end(), row->begin(), row->end());
    starts.push_back(std::ssize(ids));
  }
  for (std::size_t width = 1; width < rows.size(); width *= 2) {
    for (std::size_t i = 0; i + width < rows.size(); i += 2 * width) {
      std::inplace_merge(ids.begin() + starts[i], ids.begin() + starts[i + width],
                         ids.begin() + starts[std::min(i + 2 * width, rows.size())]);
    }
  }
  return ids;
}

std::vector<InstructionPlace> Facts::placesOfIds(std::span<const std::uint32_t> ids) const {
  std::vector<InstructionPlace> found;
  found.reserve(ids.size());
  for (const std::uint32_t id : ids) found.push_back(place(id));
  return found;
}

void Facts::countUses() {
  const CellMap& cells = index_.cells();
  writers_.assign(static_cast<std::size_t>(cells.size()) * 8, 0);
  readers_.assign(static_cast<std::size_t>(cells.size()) * 8, 0);
  for (const Access& a : accesses_.all()) {
    if (a.viaPointer || a.certainLength() > AccessIndex::longest) continue;
    const Desc& desc = *instruction(a.instruction).desc;
    const bool isOwn = desc.control != Control::Call && a.operand < desc.operandCount &&
                       desc.operands[a.operand].direction == Direction::InOut;
    if (!a.write && isOwn) continue;
    std::vector<std::uint8_t>& counts = a.write ? writers_ : readers_;
    const std::uint32_t cell = cellOf(a);
    if (cell == cells.size()) continue;
    const std::size_t end =
        (static_cast<std::size_t>(cell) + std::min(a.certainLength(), cells.left(cell, a.area))) * 8;
    const bool isBits = a.width == Width::Bit && !a.byNumber();
    const std::size_t start = static_cast<std::size_t>(cell) * 8 + (isBits ? std::min<unsigned>(a.bit, 7) : 0);
    const std::size_t stop = isBits ? std::min(start + a.count, end) : end;
    for (std::size_t bit = start; bit < stop; ++bit)
      counts[bit] = static_cast<std::uint8_t>(std::min(counts[bit] + 1, 2));
  }
}

/// What is known about one bit may tell something about the next.
void Facts::findPulses() {
  constexpr int mostRounds = 4;
  KnownBits known;
  for (int round = 0; round < mostRounds; ++round) {
    KnownBits pulses = pulseBits(*this);
    if (pulses == known) return;
    known = std::move(pulses);
    stack_ = StackRun(program_, plan_, known);
    execution_ = ExecutionTable(program_, plan_, calls_, stack_);
  }
}

bool Facts::usesAccumulators() const {
  for (std::uint32_t number = 0; number < 4; ++number) {
    const std::uint32_t cell = index_.cells().cell(Area::AC, number, 0);
    if (cell != index_.cells().size() && !index_.at(cell).empty()) return true;
  }
  return false;
}

void Facts::noteOperand(std::uint32_t id, OperandKind kind) {
  std::vector<std::uint32_t>& ids = withOperand_[static_cast<std::size_t>(kind)];
  if (kind != OperandKind::Direct && (ids.empty() || ids.back() != id)) ids.push_back(id);
}

void Facts::collectBoxes() {
  roles_.resize(instructionCount());
  const Desc* desc = nullptr;
  std::vector<std::uint32_t>* users = nullptr;  // of that descriptor
  for (const InstructionPlace& place : instructions()) {
    const Instruction& instruction = *place.instruction;
    if (instruction.desc != desc) {
      desc = instruction.desc;
      users = &users_[desc];
    }
    users->push_back(instruction.id);
    for (const Operand& operand : instruction.operands) noteOperand(instruction.id, operand.kind);
    const Role role = roles_[instruction.id] = roleOf(instruction);
    if ((!isTimerBox(role) && !isCounterBox(role)) || instruction.operands.empty()) continue;
    const Operand& o = instruction.operands[0];
    if (o.kind != OperandKind::Direct || o.offset >= 256) continue;
    (isTimerBox(role) ? timers_ : counters_)[o.offset].push_back(instruction.id);
  }
  const auto shrink = [](auto& rows) {
    for (std::vector<std::uint32_t>& ids : rows) ids.shrink_to_fit();
  };
  shrink(timers_);
  shrink(counters_);
  shrink(withOperand_);
  for (auto& [_, ids] : users_) ids.shrink_to_fit();
}

void Facts::collectSymbols() {
  for (const Symbol& symbol : program_.symbols) {
    symbolByName_.emplace(symbol.name, &symbol);
    if (symbol.address.kind == OperandKind::Direct) symbolByAddress_.emplace(addressKey(symbol.address), &symbol);
  }
}

void Facts::collectExternals() {
  const CellMap& cells = index_.cells();
  external_.assign(cells.size(), 0);
  for (const auto& [id, contract] : contracts_.all()) {
    for (const MemoryRow& row : contract.memory) {
      for (std::uint32_t byte = row.first / 8; byte * 8 < row.first + row.count; ++byte)
        if (const std::uint32_t cell = cells.cell(row.area, byte, 0); cell != cells.size()) external_[cell] = 1;
    }
  }
  if (program_.clockMemory) {
    const std::uint32_t cell = cells.cell(Area::M, *program_.clockMemory, 0);
    if (cell != cells.size()) external_[cell] = 1;
  }
  for (const ExternalRange& range : externals_) {
    const bool byNumber = hasBitAndWord(range.first.area);
    const std::uint32_t end = range.last.offset + static_cast<std::uint32_t>(byNumber ? 1 : bytes(range.last.width));
    for (std::uint32_t at = range.first.offset; at < end; ++at) {
      const std::uint32_t cell = cells.cell(range.first.area, at, 0);
      if (cell == cells.size()) break;
      external_[cell] = 1;
    }
  }
}

Condition Facts::conditionOf(std::uint32_t id) const {
  const Condition flow = stack_.at(id).flow;
  return static_cast<Condition>(flow | execution_.at(id).within | execution_.condition(blockOf(id)));
}

const Symbol* Facts::symbolOf(const Operand& address) const {
  const auto found = symbolByAddress_.find(addressKey(address));
  return found == symbolByAddress_.end() ? nullptr : found->second;
}

const Symbol* Facts::symbolNamed(std::string_view name) const {
  const auto found = symbolByName_.find(name);
  return found == symbolByName_.end() ? nullptr : found->second;
}

std::string Facts::name(const Operand& operand) const {
  const std::string address = toString(operand);
  if (operand.kind != OperandKind::Direct) return address;
  const Symbol* symbol = symbolOf(operand);
  return symbol == nullptr ? address : fmt::format("{} ({})", address, symbol->name);
}

std::string Facts::bitName(std::uint32_t key) const {
  const CellMap& cells = index_.cells();
  return name(direct(cells.areaOf(key / 8), Width::Bit, cells.offsetOf(key / 8), key % 8));
}

std::string Facts::text(const Program& program, const Instruction& instruction) {
  const auto isInText = [&](const Pou& pou) {
    return std::ranges::any_of(pou.networks, [&](const Network& network) {
      return network.isStructured && instruction.span.beginsIn(network.span);
    });
  };
  const bool isText =
      formOf(program.target) == StatementForm::Expressions || std::ranges::any_of(program.pous, isInText);
  if (!isText) return text(instruction);
  const std::string_view written = program.sources->text(instruction.span);
  return std::string(written.substr(0, written.find_first_of("\r\n")));
}

std::string Facts::text(const Instruction& instruction) {
  std::string text(writtenMnemonic(*instruction.desc, false));
  if (!instruction.operands.empty()) text = text.substr(0, text.find(' '));  // L T, S C: the operand says the rest
  const bool isCall = instruction.desc->control == Control::BlockCall;
  for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
    const Operand& operand = instruction.operands[i];
    if (isCall && operand.kind == OperandKind::Missing) continue;  // a parameter that the call leaves as it is
    const bool isInstance = isCall && i == 1 && operand.kind == OperandKind::Direct && operand.area == Area::DB &&
                            hasInstance(blockTypeOf(static_cast<int>(instruction.operands[0].value)));
    text += (i == 0 ? " " : ", ") + (isInstance ? fmt::format("DB{}", blockOfByte(operand.offset)) : toString(operand));
  }
  return text;
}

}  // namespace rungproof
