// Projects, blocks and variables.
#include "frontend/plcopen/plcopen_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "frontend/graphical/iec_type.hpp"
#include "frontend/plcopen/plcopen_shapes.hpp"
#include "frontend/stl/directive.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

void readComment(Span span, std::string_view text, std::vector<Comment>& lines, std::vector<Directive>& directives) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = trimmed(text.substr(at, end - at));
    if (!line.empty()) {
      const Span place{span.file, span.offset + static_cast<std::uint32_t>(line.data() - text.data()),
                       static_cast<std::uint32_t>(line.size())};
      if (const auto directive = directiveText(line)) directives.push_back({std::string(*directive), place, -1, 0});
      lines.push_back({place});
    }
    at = end + 1;
  }
}

namespace {

constexpr auto variableShapes = variableListShapes("simpleValue");

class PlcopenReader {
 public:
  PlcopenReader(Program& program, const InputText& input, DrawnProject& project)
      : program_(program),
        project_(project),
        sink_(program, input.file),
        text_(program.sources->file(input.file).text()),
        xml_(program.sources->file(input.file), sink_, {"pou"}) {}

  void run() {
    const std::size_t before = project_.blocks.size();
    bool hasProject = false;
    for (const XmlText::Part& part : xml_.parts()) {
      part_ = &part;
      pugi::xml_node at = part.document->first_child();
      while (at) {
        if (at.type() == pugi::node_element && localName(at) == "project") hasProject = true;
        const bool isRead = visit(at);
        if (!isRead && at.first_child()) {
          at = at.first_child();
          continue;
        }
        while (at && !at.next_sibling()) at = at.parent();
        if (at) at = at.next_sibling();
      }
      if (part.isDamaged && project_.blocks.size() > before) damageLast();
    }
    if (project_.blocks.size() == before && !xml_.parts().empty() && !xml_.parts().front().isDamaged) {
      sink_.report(Syntax::XmlStructure, {sink_.file(), 0, 0},
                   hasProject ? "the project has no block" : "there is no element <project>");
    }
  }

 private:
  /// Whether the element was read with all that is in it.
  bool visit(const pugi::xml_node& node) {
    if (node.type() == pugi::node_comment) {
      std::vector<Comment> lines;
      const Span span = xml_.span(*part_, node);
      readComment(span, text_.substr(span.offset, span.length), lines, project_.directives);
      return true;
    }
    if (node.type() != pugi::node_element) return true;
    const std::string_view name = localName(node);
    if (name == "pou") {
      readPou(node);
      return true;
    }
    if (name == "globalVars") {
      readVariables(node, DrawnSection::Global, project_.globals);
      if (const std::string list = node.attribute("name").value(); !list.empty()) project_.globalLists.push_back(list);
      return true;
    }
    if (name == "pouInstance") {
      const std::string type = node.attribute("typeName").value();
      project_.instances.push_back({node.attribute("name").value(),
                                    type.empty() ? node.attribute("name").value() : type, xml_.span(*part_, node)});
      return true;
    }
    return false;
  }

  void damageLast() { damage(project_.blocks.back()); }

  /// What the block does besides is not known.
  static void damage(DrawnBlock& block) {
    if (block.networks.empty()) block.networks.emplace_back();
    block.networks.back().isDamaged = true;
    block.networks.back().span = block.span;
  }

  void readPou(const pugi::xml_node& node) {
    DrawnBlock block;
    block.span = xml_.span(*part_, node);
    block.name = node.attribute("name").value();
    const std::string_view kind = node.attribute("pouType").value();
    block.kind = kind == "function"        ? DrawnBlockKind::Function
                 : kind == "functionBlock" ? DrawnBlockKind::FunctionBlock
                                           : DrawnBlockKind::Program;
    if (block.name.empty() || (kind != "function" && kind != "functionBlock" && kind != "program")) {
      sink_.report(Syntax::XmlStructure, block.span,
                   fmt::format("block \"{}\" needs a name and the type program, functionBlock or function",
                               excerpt(block.name)));
      if (block.name.empty()) block.name = "unnamed";
    }
    sink_.setPlace(block.name, 0);
    for (const pugi::xml_node& child : node.children()) {
      const std::string_view name = localName(child);
      if (name == "interface") readInterface(child, block);
      if (name == "body") readBody(child, block);
      if (name == "documentation") readNote(child, block.comments);
      if (child.type() == pugi::node_comment) visit(child);
      // CODESYS: <addData><data name=".../pou"> of methods and actions is not executed by itself.
    }
    const auto isBody = [](const pugi::xml_node& child) { return localName(child) == "body"; };
    const auto bodies = std::count_if(node.begin(), node.end(), isBody);
    if (bodies > 1) {
      sink_.report(Syntax::XmlStructure, block.span,
                   fmt::format("block {} has {} bodies; which of them runs is not known", block.name, bodies));
      damage(block);
    }
    if (bodies == 0) {
      sink_.report(Syntax::XmlStructure, block.span, fmt::format("block {} has no body", block.name));
      damage(block);
    }
    sink_.setPlace("", 0);
    project_.blocks.push_back(std::move(block));
  }

  void readNote(const pugi::xml_node& node, std::vector<Comment>& lines) {
    forEachBelow(node, [&](const pugi::xml_node& at) {
      if (at.type() != pugi::node_pcdata && at.type() != pugi::node_cdata && at.type() != pugi::node_comment) return;
      const Span span = xml_.span(*part_, at);
      readComment(span, text_.substr(span.offset, span.length), lines, project_.directives);
    });
  }

  void readInterface(const pugi::xml_node& node, DrawnBlock& block) {
    static const std::map<std::string_view, DrawnSection> sections = {
        {"localVars", DrawnSection::Local}, {"tempVars", DrawnSection::Temp},
        {"inputVars", DrawnSection::Input}, {"outputVars", DrawnSection::Output},
        {"inOutVars", DrawnSection::InOut}, {"externalVars", DrawnSection::External},
        {"globalVars", DrawnSection::Local}};
    for (const pugi::xml_node& child : node.children()) {
      const std::string_view name = localName(child);
      if (name == "returnType") {
        const pugi::xml_node type = firstElement(child);
        block.returnType = iecTypeNamed(foldedType(type));
        if (block.returnType == IecType::None)
          sink_.report(Syntax::XmlStructure, xml_.span(*part_, child),
                       fmt::format("type {} of function {} is not known", excerpt(typeName(type)), block.name));
        continue;
      }
      if (name == "documentation") readNote(child, block.comments);
      const auto section = sections.find(name);
      if (section == sections.end() && child.type() == pugi::node_element && name != "documentation" &&
          name != "addData") {
        sink_.report(Syntax::XmlStructure, xml_.span(*part_, child),
                     fmt::format("element <{}> is not known in an interface", excerpt(name)));
      }
      if (section != sections.end()) readVariables(child, section->second, block.variables);
    }
  }

  static pugi::xml_node firstElement(const pugi::xml_node& node) {
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() == pugi::node_element) return child;
    }
    return {};
  }
  static std::string_view foldedType(const pugi::xml_node& type) {
    const std::string_view name = localName(type);
    return name == "string" ? "STRING" : name;
  }
  static std::string typeName(const pugi::xml_node& type) {
    return localName(type) == "derived" ? type.attribute("name").value() : std::string(localName(type));
  }

  void readVariables(const pugi::xml_node& list, DrawnSection section, std::vector<DrawnVariable>& variables) {
    for (const ShapeFault& fault : faultsOf(list, variableShapes))
      sink_.report(Syntax::XmlStructure, xml_.span(*part_, fault.node), fault.message);
    const bool isConstant = list.attribute("constant").as_bool();
    for (const pugi::xml_node& node : list.children()) {
      if (node.type() == pugi::node_comment) visit(node);
      if (localName(node) != "variable") continue;
      DrawnVariable variable;
      variable.span = xml_.span(*part_, node);
      variable.name = node.attribute("name").value();
      variable.section = section;
      variable.address = node.attribute("address").value();
      variable.isConstant = isConstant;
      const pugi::xml_node type = firstElement(childNamed(node, "type"));
      variable.typeName = typeName(type);
      if (localName(type) != "derived") {
        variable.type = iecTypeNamed(foldedType(type));
        if (variable.type == IecType::None) {
          sink_.report(Syntax::XmlStructure, variable.span,
                       type ? fmt::format("type {} of {} is not one that the S7-200 has", excerpt(variable.typeName),
                                          excerpt(variable.name))
                            : fmt::format("variable {} has no type", excerpt(variable.name)));
          continue;
        }
      }
      if (variable.name.empty()) {
        sink_.report(Syntax::XmlStructure, variable.span, "a variable has no name");
        continue;
      }
      const pugi::xml_node initial = childNamed(node, "initialValue");
      if (initial) variable.initial = childNamed(initial, "simpleValue").attribute("value").value();
      std::vector<Comment> comments;
      if (const pugi::xml_node documentation = childNamed(node, "documentation")) readNote(documentation, comments);
      variables.push_back(std::move(variable));
    }
  }

  void readBody(const pugi::xml_node& body, DrawnBlock& block) {
    int languages = 0;
    for (const pugi::xml_node& child : body.children()) {
      if (child.type() == pugi::node_element && localName(child) != "documentation" && localName(child) != "addData" &&
          ++languages == 2) {
        sink_.report(Syntax::XmlStructure, xml_.span(*part_, child),
                     fmt::format("the body of {} has a second language; which of them runs is not known", block.name));
        damage(block);
      }
      if (child.type() != pugi::node_element) {
        visit(child);
        continue;
      }
      const std::string_view language = localName(child);
      if (language == "LD" || language == "FBD") {
        block.form = language == "LD" ? Form::Ladder : Form::Fbd;
        DrawnNetwork network = readPlcopenBody(xml_, *part_, child, text_);
        for (const pugi::xml_node& element : child.children()) {
          if (element.type() == pugi::node_comment) visit(element);
        }
        collectDirectives(network);
        reportUnknown(child, network);
        block.networks.push_back(std::move(network));
      } else if (language == "IL") {
        const Span span = textSpan(child);
        block.form = Form::Fbd;
        block.networks.push_back(
            readInstructionList(program_, span, text_.substr(span.offset, span.length), block.name));
      } else if (language == "ST" || language == "SFC") {
        block.uncovered = UncoveredBody{std::string(language), language == "ST" ? allText(child) : expressionsOf(child),
                                        xml_.span(*part_, child)};
      } else if (language == "documentation") {
        readNote(child, block.comments);
      } else if (language != "addData") {
        sink_.report(Syntax::XmlStructure, xml_.span(*part_, child),
                     fmt::format("a body in {} is not known", excerpt(language)));
        damage(block);
      }
    }
  }

  /// All variables and texts that a chart names.
  static std::string expressionsOf(const pugi::xml_node& chart) { return allText(chart); }

  Span textSpan(const pugi::xml_node& node) const {
    pugi::xml_node at = node;
    while (at && at.type() == pugi::node_element) at = at.first_child();
    return at ? xml_.span(*part_, at) : xml_.span(*part_, node);
  }

  void collectDirectives(const DrawnNetwork& network) {
    for (const DrawnNote& note : network.notes) {
      for (const Comment& line : note.lines) {
        const auto directive = directiveText(text_.substr(line.span.offset, line.span.length));
        if (directive) project_.directives.push_back({std::string(*directive), line.span, -1, 0});
      }
    }
  }

  void reportUnknown(const pugi::xml_node& body, DrawnNetwork& network) {
    for (const ShapeFault& fault : plcopenFaults(body)) {
      sink_.report(Syntax::XmlStructure, xml_.span(*part_, fault.node), fault.message);
      network.isDamaged = true;
    }
  }

  Program& program_;
  DrawnProject& project_;
  SyntaxSink sink_;
  std::string_view text_;
  XmlText xml_;
  const XmlText::Part* part_ = nullptr;
};

}  // namespace

void readPlcopen(Program& program, const InputText& input, DrawnProject& project) {
  PlcopenReader(program, input, project).run();
}

}  // namespace rungproof
