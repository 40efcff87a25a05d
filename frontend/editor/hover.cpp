// Pages for the pointer.
#include "frontend/editor/hover.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "frontend/editor/inlay_hints.hpp"
#include "frontend/editor/picture.hpp"
#include "frontend/editor/structured_navigation.hpp"
#include "frontend/editor/structured_text.hpp"
#include "frontend/explain/address_page.hpp"
#include "frontend/explain/instruction_page.hpp"
#include "frontend/picture/network_view.hpp"
#include "frontend/rpc/command_output.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/text/excerpt.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostUses = 8;  ///< of each kind that are named

std::string block(std::string_view text) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  return fmt::format("```text\n{}\n```\n", text);
}

/// "CPU 226: VW up to VW10238, T up to T255": of the direct forms that the operands take.
std::string limitsOf(const Target& target, const Desc& desc) {
  std::vector<std::string> limits;
  std::set<std::string> seen;
  for (int i = 0; i < desc.operandCount; ++i) {
    const OperandDesc& operand = desc.operand(i);
    for (int a = 0; a < areaCount; ++a) {
      const auto area = static_cast<Area>(a);
      if ((operand.forms & form::area(area)) == 0) continue;
      const std::optional<AddressLimit> limit = addressLimit(target, area, widthOf(operand.type));
      if (!limit) continue;
      const std::string last = addressName(area, widthOf(operand.type), limit->lastByte,
                                           widthOf(operand.type) == Width::Bit && !addressedByNumber(area) ? 7 : 0);
      if (seen.insert(last).second) limits.push_back(last);
    }
  }
  if (limits.empty()) return {};
  return fmt::format("CPU {}, highest addresses: {}\n", cpuName(target.cpu), fmt::join(limits, ", "));
}

std::string instructionText(const CheckedDocument& document, const Desc& desc) {
  const Target& target = document.program().target;
  std::string text = block(instructionPage(desc, Paint{}));
  if ((desc.cpus & cpuBit(target.cpu)) == 0)
    text += fmt::format("\nThe CPU {} does not have it.\n", cpuName(target.cpu));
  if (const std::string limits = limitsOf(target, desc); !limits.empty()) text += "\n" + limits;
  return text;
}

std::string useText(const CheckedDocument& document, const Access& access) {
  const Facts& facts = document.facts();
  const Instruction& instruction = facts.instruction(access.instruction);
  const SourceSet& sources = *document.program().sources;
  const std::string place = document.isHere(instruction.span)
                                ? fmt::format("line {}", sources.position(instruction.span).line)
                                : placeText(sources, instruction.span);
  const Network& network = facts.networkOf(access.instruction);
  const std::string said = network.isStructured ? excerpt(sources.text(instruction.span)) : Facts::text(instruction);
  return fmt::format("- {} network {}, {}: `{}`\n", facts.pouOf(access.instruction).name, network.number, place, said);
}

std::string usesText(const CheckedDocument& document, std::string_view heading, const std::vector<const Access*>& uses,
                     std::string_view none) {
  if (uses.empty()) return fmt::format("\n{}\n", none);
  std::string text = fmt::format("\n{}\n\n", heading);
  for (std::size_t i = 0; i < std::min(uses.size(), mostUses); ++i) text += useText(document, *uses[i]);
  if (uses.size() > mostUses) text += fmt::format("- and {} more\n", uses.size() - mostUses);
  return text;
}

/// The preset of each box of the timer or counter, with the time that it stands for.
std::string presetText(const CheckedDocument& document, const Operand& address) {
  std::string text;
  const Facts& facts = document.facts();
  const bool isTimer = address.area == Area::T;
  for (const std::uint32_t id : isTimer ? facts.timerBoxes(address.offset) : facts.counterBoxes(address.offset)) {
    const Instruction& box = facts.instruction(id);
    if (box.operands.size() < 2) continue;
    const Operand& preset = box.operands[1];
    text += fmt::format("\nPreset {} in network {}", toString(preset), facts.networkOf(id).number);
    if (const std::string time = presetTime(box); !time.empty()) text += ": " + time;
    text += "\n";
  }
  return text;
}

std::string pageText(const CheckedDocument& document, const std::string& name, const Operand& address) {
  const Target& target = document.program().target;
  if (address.area == Area::SM) {
    const std::string cpu = fmt::format("--cpu={}", cpuName(target.cpu));
    const CommandOutput page = outputOf({"explain", name, "--isolated", cpu});
    return page.exit == 0 ? block(page.out) : std::string();
  }
  const std::optional<AddressPage> page = addressPage(target, name, Paint{});
  return page ? block(page->text) : std::string();
}

std::string addressText(const CheckedDocument& document, const Operand& operand) {
  Operand address = operand;
  address.kind = OperandKind::Direct;
  const bool isVariable = dialectOf(document.program().target).memory.isOfVariables;
  const std::string name =
      isVariable ? toString(address) : addressName(address.area, address.width, address.offset, address.bit);
  const Symbol* const symbol = isVariable ? nullptr : document.facts().symbolOf(address);
  std::string text = fmt::format("**{}**", name);
  if (symbol != nullptr) text += fmt::format(" {}", symbol->name);
  if (symbol != nullptr && !symbol->comment.empty()) text += fmt::format(": {}", symbol->comment);
  text += "\n\n";
  if (!isVariable) text += pageText(document, name, address);
  if (hasBitAndWord(address.area)) text += presetText(document, address);
  std::vector<const Access*> writers, readers;
  for (const std::size_t entry : entriesTouching(document.xref(), address)) {
    for (const Access* use : document.xref().entries[entry].uses)
      (use->write || use->isBox || use->maybe ? writers : readers).push_back(use);
  }
  const auto isEarlier = [](const Access* a, const Access* b) { return a->instruction < b->instruction; };
  const auto isSame = [](const Access* a, const Access* b) { return a->instruction == b->instruction; };
  for (std::vector<const Access*>* uses : {&writers, &readers}) {
    std::ranges::stable_sort(*uses, isEarlier);
    uses->erase(std::unique(uses->begin(), uses->end(), isSame), uses->end());
  }
  text += usesText(document, "Written by", writers, "No instruction writes it.");
  text += usesText(document, "Read by", readers, "No instruction reads it.");
  return text;
}

std::string pouText(const Pou* pou) {
  if (pou == nullptr) return "A block without text in this program";
  std::string text = fmt::format("**{}** {}\n", blockHeading(*pou), pou->protectedBlock ? "(protected)" : "");
  for (const LocalVariable& local : pou->locals) {
    if (local.section == VarSection::Temp || local.section == VarSection::Static) continue;
    const std::string_view section = local.section == VarSection::Input    ? "in"
                                     : local.section == VarSection::Output ? "out"
                                                                           : "in and out";
    text += fmt::format("- {} ({})\n", local.name, section);
  }
  return text;
}

std::string routineText(const CheckedDocument& document, Type type, const Cursor& cursor) {
  const auto number = static_cast<int>(cursor.operand->value);
  if (type == Type::Label) {
    const bool isName = dialectOf(document.program().target).text.labelsAreNames;
    return isName ? fmt::format("Label {}", trimmed(document.source().text(cursor.span)))
                  : fmt::format("Label {}", number);
  }
  return pouText(type == Type::Subroutine ? document.program().subroutine(number)
                                          : document.program().interrupt(number));
}

/// S7-300/400: FB 1 of "CALL FB 1" is a number of a block; nullptr: the constant is none.
const Pou* blockOfConstant(const CheckedDocument& document, const Cursor& cursor) {
  if (!isLetter(document.source().text(cursor.span).substr(0, 1).front())) return nullptr;
  const auto found = std::ranges::find_if(document.program().pous, [&](const Pou& pou) {
    return pou.type != BlockType::None && pou.number == cursor.operand->value;
  });
  return found == document.program().pous.end() ? nullptr : &*found;
}

/// S7-300/400: #n is what the block declares; its place, in the instance or in L, is none that the text names.
std::string localPage(const CheckedDocument& document, const Cursor& cursor) {
  const LocalVariable* const local = localAt(document, cursor);
  if (local == nullptr) return {};
  const std::string_view section = local->section == VarSection::Input    ? "input"
                                   : local->section == VarSection::Output ? "output"
                                   : local->section == VarSection::InOut  ? "input and output"
                                   : local->section == VarSection::Temp   ? "temporary"
                                                                          : "static";
  std::string text = fmt::format("**#{}** of {}, {}\n", local->name, cursor.pou->name, section);
  if (local->span.length > 0) text += "\n" + block(document.program().sources->text(local->span));
  std::vector<const Access*> writers, readers;
  for (const Access* use : usesOfLocal(document, cursor)) (use->write || use->maybe ? writers : readers).push_back(use);
  text += usesText(document, "Written by", writers, "This block does not write it.");
  text += usesText(document, "Read by", readers, "This block does not read it.");
  return text;
}

}  // namespace

namespace {

/// IEC 61131-3: who reads and who writes the variable of that name.
Json hoverOfVariable(const CheckedDocument& document, std::uint32_t offset) {
  const std::string_view text = document.source().text();
  const auto isPart = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isalnum(byte) != 0 || c == '_' || c == '.' || byte >= 0x80;
  };
  std::uint32_t begin = std::min<std::uint32_t>(offset, static_cast<std::uint32_t>(text.size())), end = begin;
  while (begin > 0 && isPart(text[begin - 1])) --begin;
  while (end < text.size() && isPart(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  const bool hasNames = isStructuredText(document) || isSclText(document);
  const auto name = hasNames ? textNameAt(document, offset) : std::nullopt;
  const auto named = [&](const std::string& wanted) {
    return std::ranges::find_if(document.program().symbols,
                                [&](const Symbol& one) { return equalsIgnoringCase(one.name, wanted); });
  };
  const auto none = document.program().symbols.end();
  auto symbol = name && name->isOfProgram ? named(fmt::format("{}.{}", name->block, word)) : none;
  // Each instance of a block has a variable of that name: what another block has under it is none of them.
  const bool isOfInstances = name && !name->block.empty() && !name->isOfProgram;
  if (symbol == none && !isOfInstances) symbol = named(std::string(word));
  if (word.empty() || (symbol == none && !name)) return nullptr;
  if (symbol == none) {
    std::string page = fmt::format("**{}**", name->name);
    if (!name->block.empty()) page += fmt::format(" of {}", name->block);
    page += fmt::format("\n\n{}{}{}\n", name->section, name->type.empty() ? "" : " : ", name->type);
    return {{"contents", Json{{"kind", "markdown"}, {"value", page}}},
            {"range", document.range({document.file(), begin, end - begin})}};
  }
  return {{"contents", Json{{"kind", "markdown"}, {"value", addressText(document, symbol->address)}}},
          {"range", document.range({document.file(), begin, end - begin})}};
}

}  // namespace

Json hoverAt(const CheckedDocument& document, ClientPlace place) {
  if (document.source().text().empty()) return nullptr;
  if (formOf(document.program().target) == StatementForm::Expressions)
    return hoverOfVariable(document, document.offset(place));
  if (isSclText(document) && textNameAt(document, document.offset(place)))
    return hoverOfVariable(document, document.offset(place));
  const Cursor cursor = cursorAt(document, document.offset(place));
  std::string text;
  if (cursor.isMnemonic && !isSclText(document)) {
    text = instructionText(document, *cursor.instruction->desc);
  } else if (cursor.operand && cursor.routine()) {
    text = routineText(document, *cursor.routine(), cursor);
  } else if (cursor.operand && !localPage(document, cursor).empty()) {
    text = localPage(document, cursor);
  } else if (cursor.operand && (cursor.operand->isMemory() || cursor.operand->kind == OperandKind::Address)) {
    text = addressText(document, *cursor.operand);
  } else if (cursor.operand && cursor.operand->kind == OperandKind::Constant && cursor.span.length > 0 &&
             blockOfConstant(document, cursor) != nullptr) {
    text = pouText(blockOfConstant(document, cursor));
  } else if (cursor.operand && cursor.operand->kind == OperandKind::Constant) {
    text = fmt::format("{} = 16#{:X}", cursor.operand->value, static_cast<std::uint32_t>(cursor.operand->value));
  } else if (cursor.isHeading) {
    text = block(pictureOf(document, *cursor.pou, *cursor.network).text);
  }
  if (text.empty()) return nullptr;
  return {{"contents", Json{{"kind", "markdown"}, {"value", text}}}, {"range", document.range(cursor.span)}};
}

}  // namespace rungproof
