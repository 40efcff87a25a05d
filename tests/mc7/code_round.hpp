// Code to text and back, with names by which every parameter finds its number and type again.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frontend/mc7/code_text.hpp"
#include "frontend/mc7/encoder.hpp"

namespace rungproof::test {

/// Parameters are called by number and what the instruction takes them for: "P3_Word", "P3_T".
inline std::string parameterName(const mc7::Opcode& opcode, unsigned number) {
  constexpr const char* sizes[] = {"Bit", "Byte", "Word", "DWord"};
  const std::string kind = !opcode.operand.empty() && opcode.operand != "P#"
                               ? std::string(opcode.operand == "DI" ? "DB" : opcode.operand)
                               : sizes[static_cast<std::size_t>(opcode.size)];
  return fmt::format("P{}_{}", number, kind);
}

inline mc7::EncodeNames parameterMeanings() {
  return {[](const step7::Operand& local) -> std::optional<mc7::LocalMeaning> {
    const std::string& name = local.path.at(0).name;
    mc7::LocalMeaning meaning;
    meaning.parameter = static_cast<unsigned>(std::stoul(name.substr(1)));
    const std::string kind = name.substr(name.find('_') + 1);
    constexpr std::string_view sizes[] = {"Bit", "Byte", "Word", "DWord"};
    for (std::size_t i = 0; i < 4; ++i) {
      if (kind == sizes[i]) meaning.size = static_cast<mc7::Size>(i);
    }
    for (const std::string_view number : {"T", "C", "DB", "FC", "FB"}) {
      if (kind == number) meaning.kind = number;
    }
    return meaning;
  }};
}

struct CodeRound {
  std::string text;   ///< one statement a line, with labels
  std::string bytes;  ///< after the way there and back
  std::string fault;
};

/// Decodes, prints, reads and encodes.
inline CodeRound roundOf(const std::string& code) {
  CodeRound round;
  const mc7::DecodedCode decoded = mc7::decodeCode(code);
  if (decoded.fault) {
    round.fault = fmt::format("byte {}: {}", decoded.fault->at, decoded.fault->reason);
    return round;
  }
  mc7::CodeNames names;
  names.label = [](std::uint32_t target) { return fmt::format("L{:03}", target); };
  std::vector<step7::Statement> statements;
  std::vector<const mc7::Opcode*> rows;
  std::vector<std::unique_ptr<std::string>> kept;
  for (const mc7::CodeItem& item : decoded.items) {
    names.parameter = [&item](unsigned number) { return parameterName(*item.opcode, number); };
    const std::string& text = *kept.emplace_back(
        std::make_unique<std::string>(fmt::format("L{:03}: {} ;", item.at, mc7::textOf(item, names))));
    round.text += text + "\n";
    step7::Cursor cursor(text, 0);
    std::vector<Span> remarks;
    statements.push_back(
        step7::readStatement(cursor, {step7::MnemonicSet::International, TextEncoding::Utf8}, remarks));
    rows.push_back(item.opcode);
  }
  const mc7::AssembledCode assembled = mc7::assemble(statements, parameterMeanings(), rows);
  round.bytes = assembled.bytes;
  round.fault = assembled.fault;
  return round;
}

inline std::string hexOf(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) text += fmt::format("{:02X}", static_cast<std::uint8_t>(c));
  return text;
}

}  // namespace rungproof::test
