// Tag tables of TIA Portal as XML (SimaticML): SW.Tags.PlcTagTable with one SW.Tags.PlcTag for each tag and one
// SW.Tags.PlcUserConstant for each name of a value.
#include <fmt/format.h>

#include "frontend/step7/symbol_list.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof::step7 {

namespace {

/// The address in either set of mnemonics, %I0.0 or %E0.0, or the value of a constant.
std::optional<Operand> tagOperand(std::string_view written, Span span, bool isConstant) {
  for (const MnemonicSet set : {MnemonicSet::International, MnemonicSet::German}) {
    Cursor cursor(written, span.file);
    OperandOutcome outcome = readOperand7(cursor, {set, TextEncoding::Utf8});
    const OperandForm form = outcome.operand.form;
    const bool isMeant =
        isConstant ? form == OperandForm::Constant : form == OperandForm::Address || form == OperandForm::Block;
    if (!outcome.fault.empty() || !isMeant || !cursor.atEnd()) continue;
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
      const bool isConstant = localName(node) == "SW.Tags.PlcUserConstant";
      if (!isConstant && localName(node) != "SW.Tags.PlcTag") return;
      const pugi::xml_node list = childNamed(node, "AttributeList");
      const Span span = xml.span(part, node);
      SymbolRow row;
      row.name = {childNamed(list, "Name").child_value(), span};
      row.type = childNamed(list, "DataTypeName").child_value();
      const std::string written = childNamed(list, isConstant ? "Value" : "LogicalAddress").child_value();
      if (written.empty()) return;                                      // a tag without an address names nothing yet
      if (isConstant && s7300::foldedName(row.type) == "BOOL") return;  // no instruction takes a truth value
      std::optional<Operand> address = tagOperand(written, span, isConstant);
      if (!address || row.name.text.empty()) {
        sink.report(Syntax::SymbolRow, span,
                    fmt::format("{} {} has the {} {}, which no S7-300/400 has", isConstant ? "constant" : "tag",
                                excerpt(row.name.text), isConstant ? "value" : "address", excerpt(written)));
        return;
      }
      row.address = std::move(*address);
      rows.push_back(std::move(row));
    });
  }
  return rows;
}

}  // namespace rungproof::step7
