// Pages from the tables of the family.
#include "frontend/explain/step7_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "frontend/explain/instruction_page.hpp"
#include "frontend/step7/library_source.hpp"
#include "frontend/text/columns.hpp"
#include "ir/block_event.hpp"
#include "ir/manual.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/coverage.hpp"
#include "ir/s7300/fbd_box.hpp"
#include "ir/s7300/isa.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/library_contract.hpp"
#include "ir/s7300/organization_block.hpp"
#include "ir/s7300/status_effect.hpp"

namespace rungproof {

namespace {

std::string statusLine(const Desc& desc) {
  const std::string_view bits = s7300::statusEffect(desc);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    if (bits[i] == '-') continue;
    parts.push_back(bits[i] == 'x' ? std::string(s7300::statusBitNames[i])
                                   : fmt::format("{} = {}", s7300::statusBitNames[i], bits[i]));
  }
  return parts.empty() ? "no bit of the status word" : fmt::format("{}", fmt::join(parts, ", "));
}

Step7Page pageOfInstruction(const Desc& desc, const Paint& paint) {
  const std::string name(writtenMnemonic(desc, false)), german(writtenMnemonic(desc, true));
  Step7Page page;
  page.text = fmt::format("{}: {}\n\n", paint.bold(name), desc.meaning);
  std::vector<TextRow> rows;
  if (german != name) rows.push_back({"German", german});
  rows.push_back({"Group", std::string(desc.group)});
  rows.push_back({"Family", "S7-300 and S7-400"});
  rows.push_back({"Writes", statusLine(desc)});
  if (!desc.manual.empty()) rows.push_back({"Manual", manualPlace(desc.manual)});
  appendRows(page.text, rows, 16);
  page.json = {{"stl", name},           {"german", german},      {"meaning", desc.meaning},
               {"group", desc.group},   {"manual", desc.manual}, {"status", s7300::statusEffect(desc)},
               {"family", "S7-300/400"}};
  page.json["operands"] = Json::array();
  if (desc.operandCount == 0) return page;
  page.text += fmt::format("\n  {}\n", paint.bold("Operands"));
  for (int i = 0; i < desc.operandCount; ++i) {
    const OperandDesc& operand = desc.operand(i);
    const std::string forms = operand.type == Type::Parameter ? "as the block declares them" : formsText(operand.forms);
    appendParagraph(page.text,
                    fmt::format("{}{}: {}", operand.name, operand.optional ? " (may be left out)" : "", forms), 4);
    page.json["operands"].push_back({{"name", operand.name}, {"forms", forms}});
  }
  return page;
}

Step7Page pageOfBox(const s7300::FbdBox& box, const Paint& paint) {
  const std::string expansion = expansionOf(box);
  Step7Page page;
  page.text = fmt::format("{}: {}\n\n", paint.bold(std::string(box.name)), box.title);
  std::vector<TextRow> rows;
  if (!box.german.empty()) rows.push_back({"German", std::string(box.german)});
  rows.push_back({"Drawn in", "LAD and FBD of the S7-300 and S7-400"});
  if (const auto pins = pinsOf(box); !pins.empty()) rows.push_back({"Pins", fmt::format("{}", fmt::join(pins, ", "))});
  rows.push_back({"Same as", expansion});
  rows.push_back({"Manual", manualPlace(box.manual)});
  appendRows(page.text, rows, 16);
  page.json = {{"box", box.name},         {"german", box.german}, {"meaning", box.title},
               {"statements", expansion}, {"pins", pinsOf(box)},  {"manual", box.manual}};
  return page;
}

std::string numbersOf(const s7300::OrganizationBlock& row) {
  return row.first == row.last ? fmt::format("OB{}", row.first) : fmt::format("OB{} to OB{}", row.first, row.last);
}

/// What the CPU does at the event where the program does not have the block; "": it is not known, or no such event.
std::string withoutIt(int number) {
  const BlockEventRow* row = blockEventRow(number);
  if (row == nullptr) return "";
  switch (row->withoutBlock) {
    case WithoutBlock::Nothing: return "nothing happens";
    case WithoutBlock::ProgramError: return "OB85 runs; the CPU stops if that is missing too (002:1158, 002:1338)";
    case WithoutBlock::Stop: return "the CPU stops (002:1278)";
  }
  return "";
}

/// "every CPU (of its kind the only one of an S7-300, 002:1096)"
std::string startersText(int number, const s7300::OrganizationBlock& row) {
  const s7300::StartedBy starters = s7300::startersOf(row, number);
  std::string text(s7300::startedByText(starters));
  if (row.of300 == 0) return text;
  if (starters == s7300::StartedBy::Every) return text + fmt::format("; an S7-300 has no other ({})", row.manual300);
  return text + fmt::format("; an S7-300 has OB{} only ({})", row.of300, row.manual300);
}

Step7Page pageOfOb(int number, const s7300::OrganizationBlock& row, const Paint& paint) {
  const std::string name = fmt::format("OB{}", number);
  const std::string_view covered = row.isModelled ? "modelled" : "NOT COVERED";
  Step7Page page;
  page.text = fmt::format("{}: {}\n\n", paint.bold(name), row.kind);
  std::vector<TextRow> rows = {
      {"Started by", std::string(row.event)},
      {"Kind", numbersOf(row)},
      {"Exists on", startersText(number, row)},
      {"Model", row.isModelled ? std::string(covered) : fmt::format("{}: {}", covered, gapReasonOf(row))}};
  if (const std::string text = withoutIt(number); !text.empty()) rows.push_back({"Without it", text});
  rows.push_back({"Manual", manualPlace(row.manual)});
  appendRows(page.text, rows, 16);
  page.json = {{"block", name}, {"kind", row.kind}, {"event", row.event}, {"model", covered}, {"manual", row.manual}};
  return page;
}

std::string nameOfBlock(const s7300::LibraryBlock& block) { return blockName(blockNumber(block.type, block.number)); }

constexpr std::string_view contractOnly = "contract only: every output is any value after each call";
constexpr std::string_view outputsOnly =
    "modelled: what it does to interrupts, errors or the watchdog; every output is any value after each call";

constexpr std::string_view beyondParameters = "NOT COVERED: it changes more than the places that its calls name";

/// modelled, or how far the model goes.
std::string_view modelOf(const s7300::LibraryBlock& block) {
  if (isContractOnly(block)) return block.actsOnCpu ? outputsOnly : contractOnly;
  if (block.readsClock)
    return "modelled in sim: the clock of the run; in proofs any value at each read, and verdicts say so";
  if (block.isBuiltIn) return "modelled";
  return step7::isModelled(block) ? "modelled: its statements are known" : "NOT COVERED: only its parameters are known";
}

Step7Page pageOfLibraryBlock(const s7300::LibraryBlock& block, const Paint& paint) {
  const std::string name = nameOfBlock(block);
  Step7Page page;
  page.text = fmt::format("{}: {}, a block of {}\n\n", paint.bold(name), block.name,
                          block.type == BlockType::Fc ? "the standard libraries" : "the CPU");
  page.json = {{"block", name}, {"name", block.name}, {"model", modelOf(block)}};
  page.json["parameters"] = Json::array();
  appendRows(page.text, {{"Model", std::string(modelOf(block))}}, 16);
  static constexpr std::string_view sections[] = {"input", "output", "in and out"};
  const auto structure = interfaceOf(block);
  std::vector<TextRow> rows;
  for (const s7300::Field& field : structure->fields) {
    if (field.section > s7300::Section::InOut) continue;
    const std::string_view section = sections[static_cast<std::size_t>(field.section)];
    rows.push_back({field.name, fmt::format("{}, {}", section, s7300::toString(field.type))});
    page.json["parameters"].push_back(
        {{"name", field.name}, {"section", section}, {"type", s7300::toString(field.type)}});
  }
  if (rows.empty()) return page;
  page.text += fmt::format("\n  {}\n", paint.bold("Parameters"));
  for (TextRow& row : rows) row.left = "  " + row.left;
  appendRows(page.text, rows, 22);
  return page;
}

/// A block of the CPU that no table describes: its calls say which parameters it has.
Step7Page pageOfUndescribed(BlockType type, int number, const Paint& paint) {
  const std::string name = blockName(blockNumber(type, number));
  const auto beyond = type == BlockType::Sfc ? s7300::functionsBeyondParameters() : s7300::blocksBeyondParameters();
  const bool isCovered = std::ranges::find(beyond, number) == beyond.end();
  Step7Page page;
  page.text = fmt::format("{}: a block of the CPU\n\n", paint.bold(name));
  page.json = {{"block", name}, {"model", isCovered ? contractOnly : beyondParameters}};
  if (!isCovered) {
    appendRows(page.text, {{"Model", std::string(beyondParameters)}}, 16);
    return page;
  }
  appendRows(page.text,
             {{"Model", std::string(contractOnly)},
              {"Parameters", "those that its calls name; each place that is given counts as an output"}},
             16);
  return page;
}

/// "SFC 20", "OB35": kind and number.
std::optional<std::pair<std::string_view, int>> blockWord(std::string_view word) {
  for (const std::string_view kind : {"SFC", "SFB", "OB", "FC"}) {
    if (!word.starts_with(kind)) continue;
    std::string_view digits = word.substr(kind.size());
    while (digits.starts_with(' ')) digits.remove_prefix(1);
    int number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size()) continue;
    return std::pair(kind, number);
  }
  return std::nullopt;
}

std::optional<Step7Page> pageOfBlock(std::string_view word, const Paint& paint) {
  if (const s7300::LibraryBlock* block = s7300::libraryBlockNamed(word)) return pageOfLibraryBlock(*block, paint);
  const auto named = blockWord(word);
  if (!named) return std::nullopt;
  const auto [kind, number] = *named;
  if (kind == "OB") {
    const s7300::OrganizationBlock* row = s7300::organizationBlock(number);
    return row == nullptr ? std::nullopt : std::optional(pageOfOb(number, *row, paint));
  }
  const BlockType type = kind == "SFC" ? BlockType::Sfc : kind == "SFB" ? BlockType::Sfb : BlockType::Fc;
  const s7300::LibraryBlock* block = s7300::libraryBlock(type, static_cast<std::uint32_t>(number));
  if (block != nullptr) return pageOfLibraryBlock(*block, paint);
  const bool isOfSystem = type == BlockType::Sfc || type == BlockType::Sfb;
  return isOfSystem ? std::optional(pageOfUndescribed(type, number, paint)) : std::nullopt;
}

/// "SFB 0 to 5, SFC 41, 42" of numbers in order.
std::string numberText(std::string_view kind, const std::vector<int>& numbers) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i;
    while (end + 1 < numbers.size() && numbers[end + 1] == numbers[end] + 1) ++end;
    const bool isRange = end > i + 2;
    for (std::size_t k = i; !isRange && k <= end; ++k) parts.push_back(fmt::format("{}", numbers[k]));
    if (isRange) parts.push_back(fmt::format("{} to {}", numbers[i], numbers[end]));
    i = end + 1;
  }
  return fmt::format("{} {}", kind, fmt::join(parts, ", "));
}

std::string joinedWithAnd(std::vector<std::string> parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

/// Blocks that do more than their parameters tell; what has no row in the table otherwise is a contract.
std::string blocksNotModelled() {
  const auto functions = s7300::functionsBeyondParameters(), blocks = s7300::blocksBeyondParameters();
  return joinedWithAnd(
      {numberText("SFC", {functions.begin(), functions.end()}), numberText("SFB", {blocks.begin(), blocks.end()})});
}

std::string modelledObs() {
  std::vector<std::string> parts;
  for (const s7300::OrganizationBlock& row : s7300::organizationBlocks()) {
    if (row.isModelled) parts.push_back(numbersOf(row));
  }
  return joinedWithAnd(std::move(parts));
}

Step7Page coveragePage(const Paint& paint) {
  Step7Page page{paint.bold("Not covered of the S7-300 and S7-400") +
                     "\n\nNothing is proved beside code that holds one of these:\n\n",
                 Json::array()};
  for (const std::string& line : step7NotCovered()) {
    appendParagraph(page.text, "- " + line, 2);
    page.json.push_back(line);
  }
  return page;
}

}  // namespace

std::vector<std::string> step7NotCovered() {
  std::vector<std::string> lines;
  for (const s7300::GapRow& row : s7300::gapRows()) {
    std::string line(row.subject);
    if (row.gap == s7300::Gap::OrganizationBlock) line += " " + modelledObs();
    if (row.gap == s7300::Gap::LibraryBlock) line += " " + blocksNotModelled();
    lines.push_back(std::move(line));
  }
  return lines;
}

bool isStep7Instruction(std::string_view word) { return !instructionsWritten(word, true, true).empty(); }

std::optional<Step7Page> step7Page(std::string_view word, Mnemonics mnemonics, const Paint& paint) {
  if (word == "COVERAGE") return coveragePage(paint);
  std::vector<Step7Page> pages;
  const std::vector<const Desc*> found =
      instructionsWritten(word, mnemonics != Mnemonics::German, mnemonics != Mnemonics::International);
  for (const Desc* desc : found) pages.push_back(pageOfInstruction(*desc, paint));
  for (const s7300::FbdBox* box : s7300::fbdBoxesNamed(word)) {
    if (found.empty()) pages.push_back(pageOfBox(*box, paint));
  }
  if (pages.empty()) return pageOfBlock(word, paint);
  Step7Page all = std::move(pages.front());
  for (std::size_t i = 1; i < pages.size(); ++i) {
    if (i == 1) all.json = Json::array({all.json});
    all.text += "\n" + pages[i].text;
    all.json.push_back(pages[i].json);
  }
  return all;
}

}  // namespace rungproof
