// The sources and symbol tables of an S7-300/400 project, collected while files are read, and the program that they
// make together, in whatever order they came. Tested by tests/step7/project_test.cpp.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontend/files/file_reader.hpp"
#include "frontend/step7/constant_parser.hpp"
#include "frontend/step7/drawn_instances.hpp"
#include "frontend/step7/syntax.hpp"

namespace rungproof::step7 {

/// A file that is read when all are known: the mnemonics of one may be told by another.
struct PendingFile {
  std::uint32_t file = 0;
  TextEncoding encoding = TextEncoding::Utf8;
  std::optional<MnemonicSet> set{};             ///< known beforehand; nothing: the texts tell
  std::shared_ptr<const std::string> hidden{};  ///< what is read in place of the text of the file, and shown to nobody
  std::shared_ptr<const std::string> image{};   ///< of a stored data block: its bytes, which count
};

struct Step7Project {
  std::vector<PendingFile> sources;
  std::vector<PendingFile> tables;
  std::vector<SourceSyntax> drawn;            ///< what drawings say, as sources (frontend/flgnet)
  std::vector<SymbolRow> drawnSymbols;        ///< names of their blocks
  std::vector<DrawnInstance> drawnInstances;  ///< data blocks that their calls name

  std::map<std::string, std::string> texts;  ///< titles of drawings by their ids

  bool hasBlocks() const { return !sources.empty() || !drawn.empty(); }
};

/// Reads what was collected and appends its blocks, data blocks, symbols and findings to the program.
void buildStep7Project(Program& program, const Step7Project& project, const ReadOptions& options);

}  // namespace rungproof::step7
