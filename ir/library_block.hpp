// Instructions that a library or a wizard adds to a project: subroutines whose bodies are hidden (001:10077, 001:10693). Known
// of them are name and output parameters (chapters 7 to 15 of the manual); what the outputs say comes from outside.
// A '#' in a name stands for one digit. Where the unit setting decides between DINT and REAL, DINT is listed: the width
// is the same. Covered by tests/engine/library_test.cpp.
#pragma once

#include <array>
#include <string_view>

#include "ir/args.hpp"

namespace rungproof {

struct LibraryOutputInfo {
  std::string_view name{};  ///< empty: unused row
  DataType type = DataType::Bool;
};

struct LibraryBlock {
  std::string_view name;
  std::string_view manual;
  std::uint32_t first;  ///< place of the first output in the operand list of CALL, from 1; the others follow
  std::array<LibraryOutputInfo, 8> outputs;
};

inline constexpr LibraryBlock libraryBlocks[] = {
    // clang-format off
    {"PWM#_RUN", "001:8073", 3, {{{"Error", DataType::Byte}}}},
    {"PTO#_CTRL", "001:8205", 3, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}, {"C_Pos", DataType::DWord}}}},
    {"PTO#_RUN", "001:8231", 4, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}, {"C_Profile", DataType::Byte}, {"C_Step", DataType::Byte}, {"C_Pos", DataType::DInt}}}},
    {"PTO#_MAN", "001:8261", 3, {{{"Error", DataType::Byte}, {"C_Pos", DataType::DInt}}}},
    {"PTO#_LDPOS", "001:8291", 3, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}, {"C_Pos", DataType::DInt}}}},
    {"PTO#_ADV", "001:8314", 1, {{}}},
    {"POS#_CTRL", "001:8601", 2, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}, {"C_Pos", DataType::DInt}, {"C_Speed", DataType::DInt}, {"C_Dir", DataType::Bool}}}},
    {"POS#_MAN", "001:8637", 6, {{{"Error", DataType::Byte}, {"C_Pos", DataType::DInt}, {"C_Speed", DataType::DInt}, {"C_Dir", DataType::Bool}}}},
    {"POS#_GOTO", "001:8678", 6, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}, {"C_Pos", DataType::DInt}, {"C_Speed", DataType::DInt}}}},
    {"POS#_RUN", "001:8719", 4, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}, {"C_Profile", DataType::Byte}, {"C_Step", DataType::Byte}, {"C_Pos", DataType::DInt}, {"C_Speed", DataType::DInt}}}},
    {"POS#_RSEEK", "001:8756", 2, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"POS#_LDOFF", "001:8781", 2, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"POS#_LDPOS", "001:8802", 3, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}, {"C_Pos", DataType::DInt}}}},
    {"POS#_SRATE", "001:8828", 5, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"POS#_DIS", "001:8851", 2, {{{"Error", DataType::Byte}}}},
    {"POS#_CLR", "001:8866", 2, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"POS#_CFG", "001:8886", 2, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"MOD#_CTRL", "001:9695", 1, {{}}},
    {"MOD#_XFR", "001:9703", 4, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"MOD#_MSG", "001:9727", 4, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"USS_INIT", "001:10105-10107", 4, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"USS_CTRL", "001:10149", 9, {{{"Resp_R", DataType::Bool}, {"Error", DataType::Byte}, {"Status", DataType::Word}, {"Speed", DataType::Real}, {"Run_EN", DataType::Bool}, {"D_Dir", DataType::Bool}, {"Inhibit", DataType::Bool}, {"Fault", DataType::Bool}}}},
    {"USS_RPM_W", "001:10252", 6, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}, {"Value", DataType::Word}}}},
    {"USS_RPM_D", "001:10252", 6, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}, {"Value", DataType::DWord}}}},
    {"USS_RPM_R", "001:10252", 6, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}, {"Value", DataType::Real}}}},
    {"USS_WPM_W", "001:10285", 8, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"USS_WPM_D", "001:10285", 8, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"USS_WPM_R", "001:10285", 8, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"MBUS_INIT", "001:10726-10728", 10, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"MBUS_SLAVE", "001:10773", 1, {{{"Done", DataType::Bool}, {"Error", DataType::Byte}}}},
    {"RCP#_READ", "001:11020", 2, {{{"Error", DataType::Byte}}}},
    {"RCP#_WRITE", "001:11034", 2, {{{"Error", DataType::Byte}}}},
    {"DAT#_WRITE", "001:11235", 1, {{{"Error", DataType::Byte}}}},
    // clang-format on
};

/// The block of that name in any case of letters, or nullptr.
constexpr const LibraryBlock* libraryBlockNamed(std::string_view name) {
  const auto capital = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; };
  for (const LibraryBlock& block : libraryBlocks) {
    bool matches = block.name.size() == name.size();
    for (std::size_t i = 0; matches && i < name.size(); ++i) {
      matches = block.name[i] == '#' ? name[i] >= '0' && name[i] <= '9' : capital(block.name[i]) == capital(name[i]);
    }
    if (matches) return &block;
  }
  return nullptr;
}

/// Place of an output in the operand list, by its name; 0: the block has none of that name.
constexpr std::uint32_t libraryOutputNamed(const LibraryBlock& block, std::string_view name) {
  for (std::uint32_t i = 0; i < block.outputs.size(); ++i) {
    if (!block.outputs[i].name.empty() && block.outputs[i].name == name) return block.first + i;
  }
  return 0;
}

/// A call of such a block with power flow: every output parameter gets a value from outside (External::LibraryOutput,
/// index = place in the operand list).
template <class D>
void callLibraryBlock(Machine<D>& m, const Instruction& instruction, const LibraryBlock& block) {
  for (std::uint32_t i = 0; i < block.outputs.size(); ++i) {
    const std::uint32_t place = block.first + i;
    if (block.outputs[i].name.empty() || place >= instruction.operands.size()) continue;
    const DataType type = block.outputs[i].type;
    const auto value = m.external(External::LibraryOutput, place, bits(widthOf(type)));
    Args<D> args(m, instruction, *instruction.desc);
    args.storeParameter(place, type, value);
  }
}

}  // namespace rungproof
