// Puts blocks and networks together while a statement list is read: numbers, comments, directives, layout of local
// variables, rungs of texts without Network lines, protected blocks. Tested by tests/reader/stl_parser_test.cpp and
// older_dialect_test.cpp.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "frontend/stl/stl_keyword.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof {

class PouBuilder {
 public:
  PouBuilder(Program& program, std::string_view text, SyntaxSink& sink) : program_(program), text_(text), sink_(sink) {}

  bool isOpen() const { return isOpen_; }
  /// The open block began with a ..._BLOCK line and needs its END_ line.
  bool isFramed() const { return isOpen_ && isFramed_; }
  bool hadBlock() const { return hadBlock_; }
  bool inNetwork() const { return inNetwork_; }
  PouKind kind() const { return pou_.kind; }
  std::vector<LocalVariable>& locals() { return pou_.locals; }

  /// Opens a block; a heading without number gets the next one, with a report. Comments since the last block go to it.
  void open(Heading heading, Span span, bool isFramed);
  /// Opens the main program of a text without headings; comments before it belong to its first network.
  void openMain(std::uint32_t offset);
  void close(std::uint32_t end);
  /// Reports that the open block, or the table opened last, has no end.
  void reportOpen(Span heading, std::string_view what);
  void reportOpen() { reportOpen(heading_, "block " + pou_.name); }
  /// A data block or symbol table began: lines behind it are outside of blocks.
  void noteTable() { hadBlock_ = true; }

  /// BEGIN: local variables get their places; instructions before the first Network line have a network of their own.
  void startBody(std::uint32_t offset);
  void layOutLocalsOnce();
  /// A Network line. The network before it ends.
  void startNetwork(int number, std::uint32_t offset);
  void renumberNetwork(int number);
  int nextNetworkNumber() const;
  /// A network for an instruction behind the last one, if none is open.
  void needNetwork(std::uint32_t offset);

  void addInstruction(Instruction&& instruction) { instructions_.push_back(std::move(instruction)); }
  /// The line at `offset` could not be read.
  void addDamage(std::uint32_t offset);
  /// To the open network, the open block, or the block that comes next. Directives are collected as well.
  void addComment(Span span);
  void setTitle(std::string_view title);
  void setNetworkTitle(std::string_view title) { network_.title = title; }
  /// Comment lines behind the last instruction belong to the heading that follows.
  void releaseTrailingComments();
  /// At the end of the text: comments behind the last block go to it.
  void finish(std::uint32_t end);

 private:
  void reset(Span span);
  void closeNetwork(std::uint32_t end);
  void numberRungs(const std::vector<std::uint32_t>& begins);
  void checkProtection();

  Program& program_;
  std::string_view text_;
  SyntaxSink& sink_;
  Pou pou_;
  Network network_;
  std::vector<Instruction> instructions_;  ///< of network_, which gets them in one piece when it is closed
  Span heading_;
  bool isOpen_ = false;
  bool isFramed_ = false;
  bool hadBlock_ = false;
  bool inNetwork_ = false;
  bool isLeadIn_ = false;  ///< network_ has no Network line
  bool hasNetworkLines_ = false;
  bool isLaidOut_ = false;
  std::array<int, 3> nextNumber_ = {1, 0, 0};  ///< by PouKind, of this text
  std::vector<std::uint32_t> damaged_;
  std::vector<Comment> pending_;
  std::size_t firstFinding_ = 0;
  std::size_t firstDirective_ = 0;
};

}  // namespace rungproof
