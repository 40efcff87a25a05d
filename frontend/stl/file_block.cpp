// Reads names of files.
#include "frontend/stl/file_block.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/platform/names.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

struct BlockPrefix {
  std::string_view text;
  PouKind kind;
};
constexpr BlockPrefix blockPrefixes[] = {
    {"SBR", PouKind::Subroutine}, {"FC", PouKind::Subroutine}, {"INT", PouKind::Interrupt}, {"OB", PouKind::Main}};

struct Parts {
  PouKind kind;
  std::optional<int> number;
  std::size_t end;  ///< of prefix and number in the name
};

/// SBR3, FC0_x, INT_1, OB1, MAIN.
std::optional<Parts> partsOf(std::string_view name) {
  if (equalsIgnoringCase(name.substr(0, 4), "MAIN") && (name.size() == 4 || name[4] == '_'))
    return Parts{PouKind::Main, 1, 4};
  for (const BlockPrefix& prefix : blockPrefixes) {
    if (!equalsIgnoringCase(name.substr(0, prefix.text.size()), prefix.text)) continue;
    std::size_t at = prefix.text.size();
    if (at < name.size() && name[at] == '_') ++at;
    const std::size_t begin = at;
    int number = 0;
    while (at < name.size() && at - begin < 4 && isDigit(name[at])) number = number * 10 + (name[at++] - '0');
    if (at == begin || (at < name.size() && name[at] != '_')) return std::nullopt;
    return Parts{prefix.kind, number, at};
  }
  return std::nullopt;
}

/// Numbers of subroutines that calls and symbol tables name.
std::set<int> routineNumbers(const Program& program) {
  std::set<int> numbers;
  const auto add = [&](const Operand& operand) {
    if (operand.kind == OperandKind::Constant) numbers.insert(static_cast<int>(operand.value));
    const auto named = operand.kind == OperandKind::Symbol ? partsOf(operand.text) : std::nullopt;
    if (named && named->kind == PouKind::Subroutine && named->number) numbers.insert(*named->number);
  };
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if (instruction.desc->control == Control::Call && !instruction.operands.empty()) add(instruction.operands[0]);
      }
    }
  }
  for (const Symbol& symbol : program.symbols) add(symbol.address);
  return numbers;
}

}  // namespace

FileBlock fileBlock(std::string_view path) {
  FileBlock block;
  block.name = pathName(std::filesystem::path(path).stem());
  if (const auto parts = partsOf(block.name)) {
    block.kind = parts->kind;
    block.number = parts->number;
  }
  return block;
}

std::string_view shortName(std::string_view name) {
  const auto parts = partsOf(name);
  if (!parts || parts->end + 1 >= name.size()) return {};
  return name.substr(parts->end + 1);
}

void nameFromFiles(Program& program, const std::vector<HeadlessBlock>& blocks) {
  if (blocks.empty()) return;
  std::set<std::size_t> headless;
  std::vector<FileBlock> files;
  for (const HeadlessBlock& block : blocks) {
    headless.insert(block.pou);
    files.push_back(fileBlock(block.file));
  }
  bool hasMain = std::ranges::any_of(files, [](const FileBlock& file) { return file.kind == PouKind::Main; });
  std::set<int> taken;
  for (std::size_t i = 0; i < program.pous.size(); ++i) {
    const Pou& pou = program.pous[i];
    if (headless.contains(i)) continue;
    hasMain = hasMain || pou.kind == PouKind::Main;
    if (pou.kind == PouKind::Subroutine) taken.insert(pou.number);
  }
  for (const FileBlock& file : files) {
    if (file.kind == PouKind::Subroutine) taken.insert(file.number.value_or(0));
  }
  // A number that the project uses belongs to the block that it means, whether a file holds that or not.
  const std::set<int> meant = routineNumbers(program);
  taken.insert(meant.begin(), meant.end());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const FileBlock& file = files[i];
    Pou& pou = program.pous[blocks[i].pou];
    if (!file.kind && !hasMain) continue;
    pou.name = file.name;
    pou.kind = file.kind.value_or(PouKind::Subroutine);
    if (pou.kind == PouKind::Main) continue;
    int number = file.number.value_or(0);
    while (!file.number && taken.contains(number)) ++number;
    taken.insert(number);
    pou.number = number;
  }
}

}  // namespace rungproof
