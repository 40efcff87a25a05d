// Printer of the text export.
#include "frontend/stl/stl_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/stl/local_layout.hpp"
#include "frontend/stl/stl_statement.hpp"
#include "ir/desc.hpp"

namespace rungproof {

namespace {

constexpr std::array<std::string_view, 3> blockKeywords = {"ORGANIZATION_BLOCK", "SUBROUTINE_BLOCK", "INTERRUPT_BLOCK"};
constexpr std::array<std::string_view, 3> numberPrefixes = {"OB", "SBR", "INT"};
constexpr std::array<std::string_view, 4> sectionKeywords = {"VAR_INPUT", "VAR_IN_OUT", "VAR_OUTPUT", "VAR"};

std::string operandText(const Operand& operand, Type type, const StlWriterOptions& options) {
  const bool hasName =
      !operand.text.empty() && operand.kind != OperandKind::Text && operand.kind != OperandKind::Symbol;
  if (options.symbolic && hasName) return operand.text;
  if (operand.kind == OperandKind::Constant && type == Type::Subroutine) return fmt::format("SBR{}", operand.value);
  if (operand.kind == OperandKind::Constant && type == Type::Interrupt) return fmt::format("INT{}", operand.value);
  return toString(operand);
}

class Writer {
 public:
  Writer(const Program& program, const StlWriterOptions& options) : program_(program), options_(options) {}

  std::string run() {
    for (const Pou& pou : program_.pous) writePou(pou);
    if (!program_.data.empty()) writeData();
    if (options_.symbolic && !program_.symbols.empty()) writeSymbols();
    return std::move(out_);
  }

 private:
  void line(std::string_view text) {
    out_ += text;
    out_ += '\n';
  }

  /// The comment with its sign; banners get one.
  std::string commentText(const Comment& comment) const {
    const std::string_view text = program_.sources->text(comment.span);
    return text.substr(0, 2) == "//" ? std::string(text) : fmt::format("// {}", text);
  }

  void writePou(const Pou& pou) {
    const auto kind = static_cast<std::size_t>(pou.kind);
    line(fmt::format("{} {}:{}{}", blockKeywords[kind], pou.name, numberPrefixes[kind], pou.number));
    line(fmt::format("TITLE={}", pou.title));
    if (options_.comments) {
      for (const Comment& comment : pou.comments) line(commentText(comment));
    }
    for (std::size_t section = 0; section < sectionKeywords.size(); ++section)
      writeSection(pou, static_cast<VarSection>(section));
    line("BEGIN");
    for (const Network& network : pou.networks) writeNetwork(network);
    line(fmt::format("END_{}", blockKeywords[kind]));
  }

  void writeSection(const Pou& pou, VarSection section) {
    const auto isHere = [&](const LocalVariable& local) { return local.section == section; };
    if (std::none_of(pou.locals.begin(), pou.locals.end(), isHere)) return;
    line(sectionKeywords[static_cast<std::size_t>(section)]);
    for (const LocalVariable& local : pou.locals) {
      if (isHere(local)) line(fmt::format("{}:{};", local.name, dataTypeName(local.type)));
    }
    line("END_VAR");
  }

  void writeNetwork(const Network& network) {
    line(network.title.empty() ? fmt::format("Network {} ", network.number)
                               : fmt::format("Network {} // {}", network.number, network.title));
    std::size_t comment = options_.comments ? 0 : network.comments.size();
    for (std::size_t i = 0; i < network.instructions.size(); ++i) {
      const Instruction& instruction = network.instructions[i];
      for (; comment < network.comments.size() && network.comments[comment].span.offset < instruction.span.offset;
           ++comment) {
        line(commentText(network.comments[comment]));
      }
      out_ += writeInstruction(instruction, options_);
      if (comment < network.comments.size() && isBehind(instruction, network.comments[comment])) {
        out_ += "  " + commentText(network.comments[comment++]);
      }
      out_ += '\n';
    }
    for (; comment < network.comments.size(); ++comment) line(commentText(network.comments[comment]));
  }

  /// Whether the comment stands on the line on which the instruction ends.
  bool isBehind(const Instruction& instruction, const Comment& comment) const {
    if (instruction.span.file != comment.span.file) return false;
    const std::uint32_t end = instruction.span.offset + instruction.span.length;
    if (comment.span.offset < end) return false;
    const std::string_view between = program_.sources->text({comment.span.file, end, comment.span.offset - end});
    return between.find('\n') == std::string_view::npos;
  }

  void writeData() {
    line("DATA_BLOCK");
    line("BEGIN");
    for (const DataInit& init : program_.data) {
      std::uint32_t value = 0;
      for (const std::uint8_t byte : init.bytes) value = value << 8 | byte;
      switch (init.bytes.size()) {
        case 0: break;
        case 1: line(fmt::format("VB{}   16#{:X}", init.offset, value)); break;
        case 2: line(fmt::format("VW{}   16#{:X}", init.offset, value)); break;
        case 4: line(fmt::format("VD{}   16#{:X}", init.offset, value)); break;
        default:
          line(fmt::format("VB{}   {}", init.offset,
                           quoted({reinterpret_cast<const char*>(init.bytes.data()), init.bytes.size()}, '\'')));
          break;
      }
    }
    line("END_DATA_BLOCK");
  }

  void writeSymbols() {
    line("SYMBOL_TABLE");
    for (const Symbol& symbol : program_.symbols) {
      const std::string address =
          symbol.address.text.empty() ? toString(symbol.address) : std::string(symbol.address.text);
      line(fmt::format("{}\t{}\t{}", symbol.name, address, symbol.comment));
    }
    line("END_SYMBOL_TABLE");
  }

  const Program& program_;
  const StlWriterOptions& options_;
  std::string out_;
};

}  // namespace

std::string writeStl(const Program& program, const StlWriterOptions& options) { return Writer(program, options).run(); }

std::string writeInstruction(const Instruction& instruction, const StlWriterOptions& options) {
  std::string result(instruction.desc->stl);
  for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
    if (i == 0) {
      result.resize(std::max<std::size_t>(result.size() + 1, 7), ' ');
    } else {
      result += ", ";
    }
    result += operandText(instruction.operands[i], operandDescOf(*instruction.desc, i).type, options);
  }
  return result;
}

}  // namespace rungproof
