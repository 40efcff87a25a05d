// Blocks, sections, members, networks.
#include "frontend/flgnet/block_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "frontend/flgnet/circuit_reader.hpp"
#include "frontend/flgnet/circuit_statements.hpp"
#include "frontend/flgnet/fragment.hpp"
#include "frontend/flgnet/part_table.hpp"
#include "frontend/flgnet/statement_list.hpp"
#include "frontend/step7/cursor.hpp"
#include "frontend/stl/directive.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof::flgnet {

namespace {

using step7::BlockKind;
using step7::BlockSyntax;
using step7::DeclarationSyntax;
using step7::Section;

struct KindRow {
  std::string_view element;
  BlockKind kind;
};
constexpr KindRow kindRows[] = {{"SW.Blocks.OB", BlockKind::Ob},         {"SW.Blocks.FC", BlockKind::Fc},
                                {"SW.Blocks.FB", BlockKind::Fb},         {"SW.Blocks.GlobalDB", BlockKind::Db},
                                {"SW.Blocks.InstanceDB", BlockKind::Db}, {"SW.Types.PlcStruct", BlockKind::Udt}};

struct SectionRow {
  std::string_view name;
  Section section;
};
constexpr SectionRow sectionRows[] = {
    {"Input", Section::Input}, {"Output", Section::Output}, {"InOut", Section::InOut}, {"Static", Section::Static},
    {"Temp", Section::Temp},   {"Return", Section::Return}, {"None", Section::Static}};

class BlockReader {
 public:
  BlockReader(const SourceFile& file, SyntaxSink& sink)
      : file_(file), sink_(sink), xml_(file, sink, {"SW.Blocks.OB", "SW.Blocks.FB", "SW.Blocks.FC"}) {}

  DrawnSource read() {
    result_.source.file = sink_.file();
    for (const XmlText::Part& part : xml_.parts()) {
      part_ = &part;
      const std::size_t before = result_.source.blocks.size();
      for (const pugi::xml_node& top : part.document->children()) {
        object(top);
        comment(top, result_.source.directives, 0);
        for (const pugi::xml_node& node : top.children()) {
          object(node);
          comment(node, result_.source.directives, 0);
        }
      }
      // The last block of a damaged part may be cut off.
      if (part.isDamaged && result_.source.blocks.size() > before) spoil(result_.source.blocks.back());
    }
    return std::move(result_);
  }

 private:
  void object(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const auto row = std::ranges::find(kindRows, name, &KindRow::element);
    if (row != std::end(kindRows)) return block(node, row->kind);
    if (name.starts_with("SW.") && name != "SW.Tags.PlcTagTable")
      sink_.report(Syntax::BodyNotCovered, span(node), fmt::format("{} is not covered", excerpt(name)));
  }

  Span span(const pugi::xml_node& node) const { return xml_.span(*part_, node); }

  /// Comments of XML that speak to the tool.
  void comment(const pugi::xml_node& node, std::vector<step7::DirectiveSyntax>& directives, int network) {
    if (node.type() == pugi::node_comment) text(span(node), directives, network);
  }
  void text(Span where, std::vector<step7::DirectiveSyntax>& directives, int network) {
    const std::string_view all = file_.text().substr(where.offset, where.length);
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t end = std::min(all.find('\n', at), all.size());
      const std::string_view line = trimmed(all.substr(at, end - at));
      at = end + 1;
      const std::optional<std::string_view> said = directiveText(line);
      if (!said) continue;
      const auto begin = static_cast<std::uint32_t>(said->data() - file_.text().data());
      directives.push_back(
          {std::string(*said), {where.file, begin, static_cast<std::uint32_t>(said->size())}, network});
    }
  }

  /// Whether all members are marked so. A block of which some are not keeps its values as a whole.
  static bool saysNonRetain(const pugi::xml_node& sections) {
    int members = 0;
    for (const pugi::xml_node& section : sections.children()) {
      for (const pugi::xml_node& member : section.children("Member")) {
        if (std::string_view(member.attribute("Remanence").value()) != "NonRetain") return false;
        ++members;
      }
    }
    return members > 0;
  }

  void block(const pugi::xml_node& node, BlockKind kind) {
    BlockSyntax& block = result_.source.blocks.emplace_back();
    const pugi::xml_node list = childNamed(node, "AttributeList");
    block.kind = kind;
    block.heading = block.span = span(node);
    block.hasBody = true;
    name(list, block);
    sink_.setPlace(block.name.kind ? toString(block.name) : block.name.symbol, 0);
    block.knowHowProtected = std::string_view(childNamed(list, "IsKnowHowProtected").child_value()) == "true";
    block.readOnly = std::string_view(childNamed(list, "IsWriteProtectedInAS").child_value()) == "true";
    block.unlinked = std::string_view(childNamed(list, "IsOnlyStoredInLoadMemory").child_value()) == "true";
    block.nonRetain = kind == BlockKind::Db && saysNonRetain(childNamed(childNamed(list, "Interface"), "Sections"));
    if (std::string_view(node.name()) == "SW.Blocks.InstanceDB")
      instance(list, block);
    else
      interface(childNamed(childNamed(list, "Interface"), "Sections"), block);
    if (block.type == nullptr && (kind == BlockKind::Db || kind == BlockKind::Udt)) {
      auto type = std::make_shared<step7::TypeSyntax>();
      type->elementary.kind = s7300::TypeKind::Struct;
      type->fields = std::exchange(block.declarations, {});
      type->span = block.heading;
      block.type = std::move(type);
    }
    for (const pugi::xml_node& child : node.children()) comment(child, block.directives, 0);
    body(childNamed(node, "ObjectList"), block);
    sink_.setPlace({}, 0);
  }

  void name(const pugi::xml_node& list, BlockSyntax& block) {
    const std::string symbol = childNamed(list, "Name").child_value();
    const std::string_view written = childNamed(list, "Number").child_value();
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), number);
    block.name.span = block.heading;
    if (error != std::errc() || end != written.data() + written.size() || block.kind == BlockKind::Udt) {
      if (symbol.empty()) sink_.report(Syntax::XmlStructure, block.heading, "a block has neither name nor number");
      block.name.symbol = symbol;
      return;
    }
    block.name.kind = block.kind;
    block.name.number = number;
    if (symbol.empty()) return;
    step7::SymbolRow row;
    row.name = {symbol, block.heading};
    row.address.form = step7::OperandForm::Block;
    row.address.block = block.name;
    row.address.span = block.heading;
    result_.symbols.push_back(std::move(row));
  }

  // Interfaces ------------------------------------------------------------------------------------------------------

  void interface(const pugi::xml_node& sections, BlockSyntax& block) {
    for (const pugi::xml_node& node : sections.children()) {
      if (localName(node) != "Section") continue;
      const std::string_view name = node.attribute("Name").value();
      if (name == "Constant") {
        fields(node, Section::Static, block, block.constants);
        continue;
      }
      const auto row = std::ranges::find(sectionRows, name, &SectionRow::name);
      if (row == std::end(sectionRows)) {
        if (node.first_child()) notRead(node, fmt::format("section {} is not covered", excerpt(name)), block);
        continue;
      }
      if (row->section == Section::Return) {
        for (const pugi::xml_node& member : node.children()) block.type = typeOf(member, block);
        continue;
      }
      fields(node, row->section, block, block.declarations);
    }
  }

  void notRead(const pugi::xml_node& node, std::string message, BlockSyntax& block) {
    sink_.report(Syntax::Declaration7, span(node), std::move(message));
    block.declarationsRead = false;
  }

  /// The type of a member; nullptr: Void, or reported.
  std::shared_ptr<const step7::TypeSyntax> typeOf(const pugi::xml_node& member, BlockSyntax& block) {
    const std::string_view written = member.attribute("Datatype").value();
    if (step7::equalsWord(written, "VOID")) return nullptr;
    if (step7::equalsWord(written, "STRUCT")) {
      auto type = std::make_shared<step7::TypeSyntax>();
      type->elementary.kind = s7300::TypeKind::Struct;
      type->span = span(member);
      fields(member, Section::Static, block, type->fields);
      return type;
    }
    std::shared_ptr<const step7::TypeSyntax> type = typeFrom(written, span(member));
    if (type == nullptr) notRead(member, fmt::format("type {} is not covered", excerpt(written)), block);
    const bool isStructArray = type != nullptr && type->element != nullptr &&
                               type->element->elementary.kind == s7300::TypeKind::Struct && !type->element->named;
    if (isStructArray) notRead(member, "an array of a structure without a name is not covered", block);
    return type;
  }

  void fields(const pugi::xml_node& parent, Section section, BlockSyntax& block,
              std::vector<DeclarationSyntax>& declarations) {
    for (const pugi::xml_node& member : parent.children()) {
      if (localName(member) != "Member") continue;
      DeclarationSyntax declaration;
      declaration.name = {member.attribute("Name").value(), span(member)};
      declaration.section = section;
      declaration.span = span(member);
      declaration.type = typeOf(member, block);
      if (declaration.type == nullptr) {
        auto unknown = std::make_shared<step7::TypeSyntax>();
        unknown->span = declaration.span;
        declaration.type = std::move(unknown);
      }
      if (const pugi::xml_node value = childNamed(member, "StartValue"))
        initial(member, value, declaration.initial, block);
      if (childNamed(member, "Subelement")) notRead(member, "start values of single elements are not covered", block);
      declarations.push_back(std::move(declaration));
    }
  }

  void initial(const pugi::xml_node& member, const pugi::xml_node& value, std::vector<s7300::Constant>& values,
               BlockSyntax& block) {
    const std::string_view written = trimmed(value.child_value());
    if (written.empty()) return;
    const auto constant = constantFrom(member.attribute("Datatype").value(), written, span(member));
    if (constant)
      values.push_back(constant->constant);
    else
      notRead(member, fmt::format("the start value {} cannot be read", excerpt(written)), block);
  }

  void instance(const pugi::xml_node& list, BlockSyntax& block) {
    const std::string of = childNamed(list, "InstanceOfName").child_value();
    block.type = typeFrom("\"" + of + "\"", block.heading);
    if (of.empty() || block.type == nullptr) notRead(list, "the instance says of no block whose it is", block);
    for (const pugi::xml_node& section : childNamed(childNamed(list, "Interface"), "Sections").children()) {
      for (const pugi::xml_node& member : section.children()) assign(member, block);
    }
  }

  /// Start values of an instance are its actual values.
  void assign(const pugi::xml_node& member, BlockSyntax& block) {
    if (localName(member) != "Member") return;
    if (childNamed(member, "Member") || childNamed(member, "Subelement") || childNamed(member, "Sections")) {
      bool hasValue = false;
      forEachBelow(member, [&](const pugi::xml_node& node) { hasValue = hasValue || localName(node) == "StartValue"; });
      if (hasValue) notRead(member, "start values of single elements are not covered", block);
      return;
    }
    const pugi::xml_node value = childNamed(member, "StartValue");
    if (!value) return;
    step7::Assignment assignment;
    assignment.span = span(member);
    assignment.path.push_back({member.attribute("Name").value(), {}, span(member)});
    initial(member, value, assignment.values, block);
    if (!assignment.values.empty()) block.assignments.push_back(std::move(assignment));
  }

  // Networks --------------------------------------------------------------------------------------------------------

  void body(const pugi::xml_node& objects, BlockSyntax& block) {
    BoxLabels labels;
    forEachBelow(objects, [&](const pugi::xml_node& node) {
      if (localName(node) == "LabelDeclaration")
        labels.taken.emplace(childNamed(node, "Label").attribute("Name").value());
    });
    for (const pugi::xml_node& child : objects.children()) {
      comment(child, block.directives, 0);
      const std::string_view name = child.name();
      if (name == "MultilingualText")
        textOf(child, block.title, block.directives, 0);
      else if (name == "SW.Blocks.CompileUnit")
        network(child, labels, block);
      else if (child.type() == pugi::node_element) {
        sink_.report(Syntax::XmlStructure, span(child),
                     fmt::format("element <{}> is not known in a block", excerpt(name)));
        spoil(block);
      }
    }
  }

  void network(const pugi::xml_node& node, BoxLabels& labels, BlockSyntax& block) {
    step7::NetworkSyntax& network = block.networks.emplace_back();
    network.number = static_cast<int>(block.networks.size());
    network.span = span(node);
    sink_.setPlace(block.name.kind ? toString(block.name) : block.name.symbol, network.number);
    const pugi::xml_node list = childNamed(node, "AttributeList");
    const pugi::xml_node source = childNamed(list, "NetworkSource");
    for (const pugi::xml_node& child : childNamed(node, "ObjectList").children()) {
      if (localName(child) == "MultilingualText") textOf(child, network.title, block.directives, network.number);
    }
    const std::string_view language = childNamed(list, "ProgrammingLanguage").child_value();
    if (const pugi::xml_node net = childNamed(source, "FlgNet")) {
      network.form = language.ends_with("FBD") ? Form::Fbd : Form::Ladder;
      const std::optional<Circuit> circuit = readCircuit(xml_, *part_, net, sink_);
      if (circuit) noteInstances(*circuit, block, result_.instances);
      if (!circuit || !writeStatements(*circuit, labels, sink_, network)) network.isUnread = true;
    } else if (const pugi::xml_node statements = childNamed(source, "StatementList")) {
      const int number = network.number;
      readStatementList(xml_, *part_, statements, sink_, network, [&](const pugi::xml_node& said) {
        forEachBelow(said, [&](const pugi::xml_node& characters) {
          if (characters.type() == pugi::node_pcdata) text(span(characters), block.directives, number);
        });
      });
      for (const step7::Statement& statement : network.statements) noteInstance(statement);
    } else if (source.first_child()) {
      sink_.report(Syntax::BodyNotCovered, network.span,
                   fmt::format("the network is written in {}, which is not covered", excerpt(language)));
      network.isUnread = true;
    }
  }

  void noteInstance(const step7::Statement& call) {
    if (call.instance.form == step7::OperandForm::Symbol && call.operand.form == step7::OperandForm::Symbol)
      result_.instances.push_back({{std::nullopt, 0, call.operand.name, call.operand.span}, call.instance, call.span});
  }

  /// A title, or a comment that may speak to the tool.
  void textOf(const pugi::xml_node& node, std::string& title, std::vector<step7::DirectiveSyntax>& directives,
              int network) {
    const bool isTitle = std::string_view(node.attribute("CompositionName").value()) == "Title";
    for (const pugi::xml_node& item : childNamed(node, "ObjectList").children()) {
      const pugi::xml_node characters = childNamed(childNamed(item, "AttributeList"), "Text").first_child();
      if (!characters) continue;
      if (!isTitle)
        text(span(characters), directives, network);
      else if (title.empty())
        title = trimmed(characters.value());
    }
  }

  static void spoil(BlockSyntax& block) {
    if (block.networks.empty()) block.networks.emplace_back();
    for (step7::NetworkSyntax& network : block.networks) network.isUnread = true;
  }

  const SourceFile& file_;
  SyntaxSink& sink_;
  XmlText xml_;
  const XmlText::Part* part_ = nullptr;
  DrawnSource result_;
};

}  // namespace

void noteInstances(const Circuit& circuit, BlockSyntax& block, std::vector<step7::DrawnInstance>& instances) {
  for (const Part& part : circuit.parts) {
    const std::optional<Operand> of = operandFrom(iecBlock(part.name), part.span);
    const std::optional<step7::BlockName> callee = part.callee ? part.callee : of ? of->block : std::nullopt;
    if (!callee) continue;
    if (part.instance.form == step7::OperandForm::Symbol)
      instances.push_back({*callee, part.instance, part.span});
    else if (part.instance.form == step7::OperandForm::Local)
      step7::settleGeneric(block.declarations, part.instance.path, *callee);
  }
}

DrawnSource readBlocks(const SourceFile& file, SyntaxSink& sink) { return BlockReader(file, sink).read(); }

}  // namespace rungproof::flgnet
