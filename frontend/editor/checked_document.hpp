// A document and everything the tool knows about it: the program that it belongs to, and what `rungproof lint` reports
// for it. Every part of the editor server answers from here:
//   diagnostics      what is wrong, and the verdicts of proofs
//   cursor           what stands at a place of the text
//   hover            what that is: instruction, address, symbol, network
//   navigation       where it is declared, written and used; the outline; what can be folded
//   rename           another name for it, at all of its places
//   semantic_tokens  what each word is, for colours
//   inlay_hints      symbols beside addresses, seconds beside presets
//   formatting       the statements in columns
//   completion       what may stand there
//   code_action      mending and silencing what is wrong
//   property_words   the names in properties
//   structured_navigation  names in texts of IEC 61131-3
//   proof            "prove this property"
//   coverage_hints   what the tests beside it cover
// A part is a function of a CheckedDocument and a place, and knows nothing of messages; editor_server.cpp does.
// Tested by tests/editor.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/xref.hpp"
#include "frontend/editor/document.hpp"
#include "frontend/input/program_input.hpp"

namespace rungproof {

class CheckedDocument {
 public:
  /// Reads the document, whose text is held (disk_file.hpp), with the program that it belongs to: that of `inputs` in
  /// its configuration if they contain it, otherwise itself.
  CheckedDocument(const Context& context, const Document& document);
  CheckedDocument(const CheckedDocument&) = delete;
  CheckedDocument& operator=(const CheckedDocument&) = delete;

  const std::string& uri() const { return uri_; }
  std::int64_t version() const { return version_; }
  const Settings& settings() const { return settings_; }
  const Program& program() const { return input_.program; }
  const PropertySet& properties() const { return input_.properties; }
  /// What lint reports, of all files of the program.
  const Report& report() const { return report_; }
  /// Why the document could not be checked at all, as a broken configuration.
  const std::optional<Failure>& failure() const { return failure_; }
  /// Files of the program, for a command line.
  const std::vector<std::string>& files() const { return files_; }
  /// Property files that are given beside them.
  const std::vector<std::string>& propertyFiles() const { return propertyFiles_; }
  /// Index of the document in the sources.
  std::uint32_t file() const { return file_; }
  const SourceFile& source() const { return program().sources->file(file_); }
  bool isHere(Span span) const { return span.file == file_; }

  /// Range of a place in the document, or of a place in another file of the program, and the URI of that.
  Json range(Span span) const;
  std::string uriOf(std::uint32_t file) const;
  Json location(Span span) const { return {{"uri", uriOf(span.file)}, {"range", range(span)}}; }
  std::uint32_t offset(ClientPlace place) const;
  /// The place of an offset in the document.
  ClientPlace place(std::uint32_t offset) const;

  const Facts& facts() const;
  const Xref& xref() const;

 private:
  void read(const Context& context, const std::string& path);
  void chooseFiles(const Context& context, const std::string& path);
  void lint();

  std::string uri_;
  std::int64_t version_;
  bool hasMark_;  ///< the client's text begins with a byte order mark, which ours does not have
  Settings settings_;
  ProgramInput input_;
  Report report_;
  std::optional<Failure> failure_;
  std::vector<std::string> files_, propertyFiles_;
  std::uint32_t file_ = 0;
  mutable std::unique_ptr<const Facts> facts_;
  mutable std::unique_ptr<const Xref> xref_;
};

}  // namespace rungproof
