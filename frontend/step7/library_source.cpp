// From what a block does to the text that stands for it.
#include "frontend/step7/library_source.hpp"

#include <fmt/format.h>

namespace rungproof::step7 {

namespace {

/// Statements that give every output, ENO and the registers a value of temporary data that nobody has written. Where
/// that is 0, as in `sim`, the block has met no error: RET_VAL is 0 and BR 1 (002:2387).
std::string anyOutputs(const s7300::LibraryBlock& block, std::string_view before = {}) {
  std::string data = "VAR_TEMP\n  left : INT;\n  eno : BOOL;\n  accu1 : DWORD;\n  accu2 : DWORD;\n  ar1 : DWORD;\n",
              statements;
  const auto parameters = s7300::interfaceOf(block);
  for (const s7300::Field& field : parameters->fields) {
    if (field.section != s7300::Section::Output) continue;
    const bool isBit = field.type.kind == s7300::TypeKind::Bool;
    data += fmt::format("  any_{} : {};\n", field.name, s7300::toString(field.type));
    statements += fmt::format("{0} #any_{1}; {2} #{1};\n", isBit ? "A" : "L", field.name, isBit ? "=" : "T");
  }
  return data + "END_VAR\nBEGIN\nNETWORK\n" + std::string(before) + statements +
         "L #ar1; LAR1; L #accu2; L #accu1; AN #eno; SAVE; BEU;";
}

}  // namespace

std::string librarySource(const s7300::LibraryBlock& block, std::uint32_t imageBytes) {
  if (block.isBuiltIn) return std::string(emptyBody);
  if (block.begin != nullptr) return anyOutputs(block, block.begin(imageBytes));
  if (block.statements.empty()) return block.isContract ? anyOutputs(block) : std::string();
  const std::string text = std::string(block.head).append(block.statements);
  return text.find("BEGIN") != std::string::npos ? text : "BEGIN\nNETWORK\n" + text;
}

bool isModelled(const s7300::LibraryBlock& block) { return block.stopsCpu || !librarySource(block, 0).empty(); }

}  // namespace rungproof::step7
