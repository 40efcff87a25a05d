// Keywords and headings of the text export and of the older dialect. Keywords are read in any case.
// Tested by tests/reader/stl_parser_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ir/program.hpp"

namespace rungproof {

enum class Keyword : std::uint8_t {
  None,
  OrganizationBlock,
  SubroutineBlock,
  InterruptBlock,
  EndOrganizationBlock,
  EndSubroutineBlock,
  EndInterruptBlock,
  DataBlock,
  EndDataBlock,
  SymbolTable,
  EndSymbolTable,
  VarInput,
  VarInOut,
  VarOutput,
  Var,
  EndVar,
  Begin,
  Network,
  NetworkComment,
  NetworkTitle,
  Title
};

/// Keyword at the start of a line: `word` is its first word. `length` receives its length ("Network1": 7).
Keyword keywordOf(std::string_view word, std::size_t& length);

/// Name and number of a block.
struct Heading {
  PouKind kind = PouKind::Main;
  std::string name;
  int number = -1;  ///< -1: could not be read
};

/// "MAIN:OB1", "OB1", "Pump control:SBR3" behind the block keyword of that kind.
Heading readHeading(PouKind kind, std::string_view text);

/// Heading of the older dialect: "SBR 0", "SBR0", "INT_1", "INT" alone (number -1), or the lines MAIN and OB1.
std::optional<Heading> readOlderHeading(std::string_view first, std::string_view second, std::size_t words);

/// "MAIN", "SBR_3", "INT_0".
std::string defaultName(PouKind kind, int number);

}  // namespace rungproof
