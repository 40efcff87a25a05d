// Tag tables of TIA Portal as XML (SimaticML): SW.Tags.PlcTagTable with one SW.Tags.PlcTag each.
#include <fmt/format.h>

#include "frontend/step7/symbol_list.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof::step7 {

namespace {

/// The address in either set of mnemonics: %I0.0, %E0.0.
std::optional<Operand> tagAddress(std::string_view written, Span span) {
  for (const MnemonicSet set : {MnemonicSet::International, MnemonicSet::German}) {
    Cursor cursor(written, span.file);
    OperandOutcome outcome = readOperand7(cursor, {set, TextEncoding::Utf8});
    const bool isAddress = outcome.operand.form == OperandForm::Address || outcome.operand.form == OperandForm::Block;
    if (!outcome.fault.empty() || !isAddress || !cursor.atEnd()) continue;
    outcome.operand.span = span;
    if (outcome.operand.block) outcome.operand.block->span = span;
    return std::move(outcome.operand);
  }
  return std::nullopt;
}

}  // namespace

std::vector<SymbolRow> readTagTable(const SourceFile& file, SyntaxSink& sink) {
  std::vector<SymbolRow> rows;
  const XmlText xml(file, sink, {"SW.Tags.PlcTagTable"});
  for (const XmlText::Part& part : xml.parts()) {
    forEachBelow(*part.document, [&](const pugi::xml_node& node) {
      if (localName(node) != "SW.Tags.PlcTag") return;
      const pugi::xml_node list = childNamed(node, "AttributeList");
      const Span span = xml.span(part, node);
      SymbolRow row;
      row.name = {childNamed(list, "Name").child_value(), span};
      row.type = childNamed(list, "DataTypeName").child_value();
      const std::string written = childNamed(list, "LogicalAddress").child_value();
      if (written.empty()) return;  // a tag without an address names nothing yet
      std::optional<Operand> address = tagAddress(written, span);
      if (!address || row.name.text.empty()) {
        sink.report(Syntax::SymbolRow, span,
                    fmt::format("tag {} has the address {}, which no S7-300/400 has", excerpt(row.name.text),
                                excerpt(written)));
        return;
      }
      row.address = std::move(*address);
      rows.push_back(std::move(row));
    });
  }
  return rows;
}

}  // namespace rungproof::step7
