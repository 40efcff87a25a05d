// A body in SCL as a syntax tree: the statements of IEC 61131-3 with what SCL adds, and the sections CONST of its
// block. Read before names are known; scl_lowering.hpp gives it a meaning. Tested by tests/scl/malformed_test.cpp.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/step7/syntax.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof::step7 {

/// CONST name := value; of a name that may be another constant.
struct SclConstant {
  std::string name;
  iec::ExprPtr value;
};

struct SclBody {
  iec::Statements statements;
  std::vector<SclConstant> constants;
  bool isWhole = true;  ///< false: some statement could not be read, and has a finding
};

/// Where the parts of a block stand in its text.
struct SclPlaces {
  std::uint32_t begin = 0, end = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sections;  ///< CONST and LABEL, from the word to its end
};

/// Reads the body; its comments and directives go to the network and the block.
std::shared_ptr<const SclBody> readSclBody(std::string_view text, const SclPlaces& places, SyntaxSink& sink,
                                           BlockSyntax& block, NetworkSyntax& network);

}  // namespace rungproof::step7
