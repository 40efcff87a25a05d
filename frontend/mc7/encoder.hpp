// Statements back to machine code: the inverse of textOf(). The shortest form that holds an operand is taken, as STEP 7
// takes it. Tested by tests/mc7/code_test.cpp, encoder_test.cpp.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frontend/mc7/opcode.hpp"
#include "frontend/step7/statement_parser.hpp"

namespace rungproof::mc7 {

/// What #name means in code.
struct LocalMeaning {
  unsigned parameter = 0;      ///< number of a parameter of an FC; 0: `place` counts
  Size size = Size::Bit;       ///< of the type of the parameter
  std::string_view kind = {};  ///< "T", "C", "DB", "FC", "FB" of a parameter that is a number, "P#" of one by pointer
  step7::Operand place;
};

struct EncodeNames {
  std::function<std::optional<LocalMeaning>(const step7::Operand& local)> local;
};

struct EncodedStatement {
  std::string bytes;
  std::string label;  ///< of a jump, whose distance is still 0
  std::string fault;  ///< why there is no code; empty: there is
};

/// One statement. `preferred`: the row among several for one text, as `L W#16#` of a call has one of its own.
EncodedStatement encode(const step7::Statement& statement, const EncodeNames& names, const Opcode* preferred = nullptr);

struct AssembledCode {
  std::string bytes;
  std::vector<std::uint32_t> starts;  ///< offset of each statement
  std::string fault;
};
/// Statements with their labels. `preferred`: one for each statement, or empty.
AssembledCode assemble(std::span<const step7::Statement> statements, const EncodeNames& names,
                       std::span<const Opcode* const> preferred = {});

}  // namespace rungproof::mc7
