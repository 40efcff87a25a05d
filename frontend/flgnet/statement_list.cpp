// Tokens, operands, calls.
#include "frontend/flgnet/statement_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "frontend/flgnet/access_reader.hpp"
#include "frontend/flgnet/fragment.hpp"
#include "frontend/step7/cursor.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/xml/xml_shape.hpp"

namespace rungproof::flgnet {

namespace {

using step7::OperandForm;
using step7::Statement;

constexpr XmlShape listShapes[] = {
    {"StatementList", "", "StlStatement"},
    {"StlStatement", "UId UID", "LineComment Comment LabelDeclaration StlToken Access"},
    {"LabelDeclaration", "UId UID", "Label LineComment Comment"},
    {"Label", "Name UId UID", ""},
    {"StlToken", "UId UID Text TemplateReference", "LineComment Comment BlankToken"},
    {"Access",
     "UId UID Type "
     "Scope:LocalVariable|GlobalVariable|LiteralConstant|TypedConstant|LocalConstant|GlobalConstant|Address|Label|"
     "Statusword|Call|Undef",
     "Symbol Constant Address Indirect Statusword Label CallInfo Instruction Comment LineComment"},
    {"Symbol", "UId UID", "Component Address"},
    {"Component",
     "Name UId UID AccessModifier:None|Array SimpleAccessModifier:None|Periphery SliceAccessModifier:undef", "Access"},
    {"Constant", "Name UId UID", "ConstantType ConstantValue StringAttribute"},
    {"Address", "Area Type BlockNumber BitOffset Informative UId UID", ""},
    {"Indirect", "Width:None|Bit|Byte|Word|Double|Long Area Register:None|AR1|AR2 BitOffset UId UID", "Access"},
    {"Statusword", "Combination UId UID", ""},
    {"CallInfo", "Name UId UID BlockType", "Instance Parameter IntegerAttribute DateAttribute"},
    {"Instruction", "Name Version UId UID", "TemplateValue Instance Parameter"},
    {"Instance", "Scope:LocalVariable|GlobalVariable UId UID", "Component Address"},
    {"Parameter", "Name Section Type UId UID Informative", "Access StringAttribute TemplateReference"},
};

/// A token that is not the mnemonic itself, with the operand that the mnemonic brings along.
struct TokenRow {
  std::string_view token, mnemonic, operand = {};
  bool namesBlock = false;  ///< its operand is a block, not a place
};
constexpr TokenRow tokenRows[] = {
    {"Assign", "="},
    {"Rise", "FP"},
    {"Fall", "FN"},
    {"OnDelay", "SD"},
    {"OffDelay", "SF"},
    {"Pulse", "SP"},
    {"Extend", "SE"},
    {"ExtendedPulse", "SE"},
    {"Retentive", "SS"},
    {"Free", "FR"},
    {"A_BRACK", "A("},
    {"AN_BRACK", "AN("},
    {"O_BRACK", "O("},
    {"ON_BRACK", "ON("},
    {"X_BRACK", "X("},
    {"XN_BRACK", "XN("},
    {"BRACKET", ")"},
    {"MCR_BRACK", "MCR("},
    {"BRACK_MCR", ")MCR"},
    {"LT_I", "<I"},
    {"LE_I", "<=I"},
    {"EQ_I", "==I"},
    {"GE_I", ">=I"},
    {"GT_I", ">I"},
    {"NE_I", "<>I"},
    {"LT_D", "<D"},
    {"LE_D", "<=D"},
    {"EQ_D", "==D"},
    {"GE_D", ">=D"},
    {"GT_D", ">D"},
    {"NE_D", "<>D"},
    {"LT_R", "<R"},
    {"LE_R", "<=R"},
    {"EQ_R", "==R"},
    {"GE_R", ">=R"},
    {"GT_R", ">R"},
    {"NE_R", "<>R"},
    {"ADD_I", "+I"},
    {"SUB_I", "-I"},
    {"MUL_I", "*I"},
    {"DIV_I", "/I"},
    {"ADD_D", "+D"},
    {"SUB_D", "-D"},
    {"MUL_D", "*D"},
    {"DIV_D", "/D"},
    {"ADD_R", "+R"},
    {"SUB_R", "-R"},
    {"MUL_R", "*R"},
    {"DIV_R", "/R"},
    {"MOD_D", "MOD"},
    {"ADD", "+"},
    {"NEG_I", "NEGI"},
    {"NEG_D", "NEGD"},
    {"NEG_R", "NEGR"},
    {"INV_I", "INVI"},
    {"INV_D", "INVD"},
    {"ABS_R", "ABS"},
    {"NEG", "NOT"},
    {"RND_M", "RND-"},
    {"RND_P", "RND+"},
    {"SRSW", "SSI"},
    {"SRSD", "SSD"},
    {"XW", "XOW"},
    {"XD", "XOD"},
    {"NOP_0", "NOP", "0"},
    {"NOP_1", "NOP", "1"},
    {"OPEN_DB", "OPN", "", true},
    {"OPEN_DI", "OPN", "", true},
    {"UC", "UC", "", true},
    {"CC", "CC", "", true},
    {"CALL", "CALL", "", true},
    {"CAC", "TAK"},
    {"L_DBLG", "L", "DBLG"},
    {"L_DBNO", "L", "DBNO"},
    {"L_DILG", "L", "DILG"},
    {"L_DINO", "L", "DINO"},
    {"LAR1_ACCU1", "LAR1"},
    {"LAR2_ACCU1", "LAR2"},
    {"LAR1_AR2", "LAR1", "AR2"},
    {"TAR1_ACCU1", "TAR1"},
    {"TAR2_ACCU1", "TAR2"},
    {"TAR1_AR2", "TAR1", "AR2"},
    {"ADDAR1", "+AR1"},
    {"ADDAR2", "+AR2"},
    {"JUN", "JU"},
};

class StatementListReader {
 public:
  StatementListReader(const XmlText& xml, const XmlText::Part& part, SyntaxSink& sink, step7::NetworkSyntax& network,
                      const std::function<void(const pugi::xml_node&)>& comment)
      : xml_(xml), part_(part), sink_(sink), network_(network), comment_(comment) {}

  void read(const pugi::xml_node& list) {
    for (const ShapeFault& found : faultsOf(list, listShapes)) {
      sink_.report(Syntax::XmlStructure, xml_.span(part_, found.node), found.message);
      network_.isUnread = true;
    }
    for (const pugi::xml_node& node : list.children()) {
      if (localName(node) == "StlStatement") statement(node);
    }
  }

 private:
  void statement(const pugi::xml_node& node) {
    span_ = xml_.span(part_, node);
    Statement result;
    result.span = span_;
    pugi::xml_node token, access;
    for (const pugi::xml_node& child : node.children()) {
      const std::string_view kind = localName(child);
      if (kind == "LineComment" || kind == "Comment") comment_(child);
      if (kind == "LabelDeclaration")
        result.label = {childNamed(child, "Label").attribute("Name").value(), xml_.span(part_, child)};
      if (kind == "StlToken") token = child;
      if (kind == "Access") access = child;
    }
    const std::string_view text = token.attribute("Text").value();
    const bool saysNothing = text.empty() || text == "COMMENT" || text == "EMPTY_LINE";
    if (saysNothing && access) return spoil(node, "an operand stands without an instruction");
    if (saysNothing) {
      if (!result.label.text.empty()) network_.statements.push_back(std::move(result));
      return;
    }
    const auto row = std::ranges::find(tokenRows, text, &TokenRow::token);
    const std::string mnemonic(row == std::end(tokenRows) ? text : row->mnemonic);
    result.mnemonic = {mnemonic, xml_.span(part_, token)};
    const bool bringsOperand = row != std::end(tokenRows) && !row->operand.empty();
    if (bringsOperand && access) return spoil(node, fmt::format("{} takes no operand", excerpt(text)));
    if (bringsOperand) result.operand = *operandFrom(row->operand, span_);
    const bool namesBlock = row != std::end(tokenRows) && row->namesBlock;
    if (access && !operand(access, namesBlock, result))
      return spoil(access, fmt::format("the operand of {} cannot be read", excerpt(text)));
    if (text == "OPEN_DI" && result.operand.form == OperandForm::Symbol) return openInstance(std::move(result));
    network_.statements.push_back(std::move(result));
  }

  void spoil(const pugi::xml_node& node, std::string message) {
    sink_.report(Syntax::XmlStructure, xml_.span(part_, node), std::move(message));
    network_.isUnread = true;
  }

  /// OPN DI of a name has no form in a source: CDB; OPN "name"; CDB leaves the same in both registers.
  void openInstance(Statement open) {
    Statement exchange;
    exchange.mnemonic = {"CDB", open.mnemonic.span};
    exchange.span = open.span;
    network_.statements.push_back(exchange);
    network_.statements.back().label = std::exchange(open.label, {});
    network_.statements.push_back(std::move(open));
    network_.statements.push_back(std::move(exchange));
  }

  bool operand(const pugi::xml_node& access, bool namesBlock, Statement& result) {
    const Span place = xml_.span(part_, access);
    if (const pugi::xml_node info = childNamed(access, "CallInfo")) return call(info, result);
    if (const pugi::xml_node info = childNamed(access, "Instruction")) return call(info, result);
    const std::optional<step7::Operand> read = namesBlock ? blockFrom(access, place) : accessFrom(access, place);
    if (read) result.operand = *read;
    return read.has_value();
  }

  bool call(const pugi::xml_node& info, Statement& result) {
    const std::string name = info.attribute("Name").value();
    const pugi::xml_node instance = childNamed(info, "Instance");
    result.operand.form = OperandForm::Symbol;
    result.operand.name = name;
    result.operand.span = span_;
    if (instance) {
      const std::optional<step7::Operand> data = instanceFrom(instance, xml_.span(part_, instance));
      if (!data) return false;
      (data->form == OperandForm::Local ? result.operand : result.instance) = *data;
    }
    if (result.operand.form == OperandForm::Symbol && name.empty()) return false;
    result.hasArguments = true;
    for (const pugi::xml_node& parameter : info.children()) {
      const pugi::xml_node access =
          localName(parameter) == "Parameter" ? childNamed(parameter, "Access") : pugi::xml_node();
      if (!access) continue;
      const Span place = xml_.span(part_, parameter);
      std::optional<step7::Operand> actual = accessFrom(access, place);
      if (!actual) actual = blockFrom(access, place);
      if (!actual) return false;
      result.arguments.push_back({{parameter.attribute("Name").value(), place}, std::move(*actual), place});
    }
    return true;
  }

  const XmlText& xml_;
  const XmlText::Part& part_;
  SyntaxSink& sink_;
  step7::NetworkSyntax& network_;
  const std::function<void(const pugi::xml_node&)>& comment_;
  Span span_;
};

}  // namespace

void readStatementList(const XmlText& xml, const XmlText::Part& part, const pugi::xml_node& list, SyntaxSink& sink,
                       step7::NetworkSyntax& network, const std::function<void(const pugi::xml_node&)>& comment) {
  StatementListReader(xml, part, sink, network, comment).read(list);
}

}  // namespace rungproof::flgnet
