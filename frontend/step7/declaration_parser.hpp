// Declarations of STEP 7 sources: sections of variables, STRUCT, ARRAY, types by name, initial values with repetition,
// attributes, AT views. Recovers at the next semicolon or section. Tested by tests/step7/layout_test.cpp.
#pragma once

#include <memory>
#include <vector>

#include "frontend/step7/operand_parser.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::step7 {

class DeclarationParser {
 public:
  DeclarationParser(Cursor& cursor, const Spelling7& spelling, SyntaxSink& sink)
      : cursor_(cursor), spelling_(spelling), sink_(sink) {}

  /// Declarations up to the word that ends them (END_VAR, END_STRUCT), which is taken; another word of a frame ends
  /// them too, with a report.
  void readFields(Section section, std::string_view endWord, std::vector<DeclarationSyntax>& fields);
  /// A type at the cursor; nullptr, with a report, if none stands there.
  std::shared_ptr<const TypeSyntax> readType();
  /// Values behind := ; false, with a report, if they cannot be read.
  bool readValues(std::vector<Constant>& values);
  /// { attributes } at the cursor, if they stand there.
  void skipAttributes();
  /// Behind a mistake: past the next semicolon, or before the next word of a frame.
  void recover();

  /// How many mistakes have been reported.
  std::size_t faults() const { return faults_; }

 private:
  void field(Section section, std::vector<DeclarationSyntax>& fields);
  std::shared_ptr<const TypeSyntax> arrayType(std::uint32_t begin);
  bool bounds(std::vector<s7300::Bounds>& bounds);
  bool valueList(std::vector<Constant>& values, int depth);
  bool valueOrGroup(std::uint32_t from, std::vector<Constant>& values, int depth);
  std::optional<Constant> objectNumber();
  void report(std::uint32_t from, std::uint32_t to, std::string message);
  void reportHere(std::string message);

  Cursor& cursor_;
  const Spelling7& spelling_;
  SyntaxSink& sink_;
  std::size_t faults_ = 0;
  int depth_ = 0;  ///< of STRUCT in STRUCT
};

}  // namespace rungproof::step7
