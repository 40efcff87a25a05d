// Blocks, interfaces, data blocks and tag tables.
#include "frontend/simatic/simatic_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/graphical/drawn_scope.hpp"
#include "frontend/plcopen/plcopen_reader.hpp"
#include "frontend/stl/directive.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

/// "TON_TIME", "IEC_TIMER", "CTU_INT": data types of instances of standard blocks.
bool isStandardData(std::string_view type) {
  const std::string name = foldedName(type);
  return name == "IEC_TIMER" || name == "IEC_COUNTER" || name.ends_with("_TIME") ||
         (name.starts_with("CT") && name.find('_') != std::string::npos);
}

std::string standardOfData(const std::string& type) {
  const std::string name = foldedName(type);
  const std::size_t bar = name.find('_');
  const std::string block = name.substr(0, bar);
  return standardBlockNamed(block) != StandardBlock::None ? block : type;
}

class SimaticReader {
 public:
  SimaticReader(Program& program, const InputText& input, DrawnProject& project)
      : project_(project),
        sink_(program, input.file),
        text_(program.sources->file(input.file).text()),
        xml_(program.sources->file(input.file), sink_,
             {"SW.Blocks.OB", "SW.Blocks.FB", "SW.Blocks.FC", "SW.Blocks.CompileUnit"}) {}

  void run() {
    bool isUsed = false;
    for (const XmlText::Part& part : xml_.parts()) {
      part_ = &part;
      const std::size_t before = project_.blocks.size();
      for (const pugi::xml_node& top : part.document->children()) {
        comment(top);
        if (top.type() == pugi::node_element && object(top)) {
          isUsed = true;
          continue;
        }
        for (const pugi::xml_node& node : top.children()) {
          comment(node);
          isUsed = object(node) || isUsed;
        }
      }
      if (!part.isDamaged) continue;
      isUsed = true;
      if (project_.blocks.size() > before && !project_.blocks.back().networks.empty())
        project_.blocks.back().networks.back().isDamaged = true;
    }
    if (!isUsed)
      sink_.report(Syntax::XmlStructure, {sink_.file(), 0, 0}, "there is no block and no table of tags in the file");
  }

 private:
  void comment(const pugi::xml_node& node) {
    if (node.type() != pugi::node_comment) return;
    std::vector<Comment> lines;
    const Span span = xml_.span(*part_, node);
    readComment(span, text_.substr(span.offset, span.length), lines, project_.directives);
  }

  bool object(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    if (name == "SW.Blocks.OB" || name == "SW.Blocks.FB" || name == "SW.Blocks.FC") {
      block(node, name);
    } else if (name == "SW.Blocks.CompileUnit") {  // saved behind damage: its block is not known
      if (!project_.blocks.empty()) compileUnit(node, project_.blocks.back());
    } else if (name == "SW.Blocks.GlobalDB" || name == "SW.Blocks.InstanceDB") {
      dataBlock(node, name == "SW.Blocks.InstanceDB");
    } else if (name == "SW.Tags.PlcTagTable") {
      for (const pugi::xml_node& tag : childNamed(node, "ObjectList").children()) addTag(tag);
    } else if (name.starts_with("SW.")) {
      const std::string named = childNamed(childNamed(node, "AttributeList"), "Name").child_value();
      sink_.report(Syntax::XmlStructure, xml_.span(*part_, node),
                   fmt::format("{} {} is not one that the S7-200 has", name, excerpt(named)));
    } else {
      return false;
    }
    return true;
  }

  void addTag(const pugi::xml_node& node) {
    const std::string_view kind = node.name();
    if (kind != "SW.Tags.PlcTag" && kind != "SW.Tags.PlcUserConstant") return;
    const pugi::xml_node list = childNamed(node, "AttributeList");
    DrawnVariable variable;
    variable.section = DrawnSection::Global;
    variable.span = xml_.span(*part_, node);
    variable.name = childNamed(list, "Name").child_value();
    variable.typeName = childNamed(list, "DataTypeName").child_value();
    variable.type = iecTypeNamed(variable.typeName);
    variable.address = childNamed(list, "LogicalAddress").child_value();
    if (kind == "SW.Tags.PlcUserConstant") {
      variable.isConstant = true;
      variable.initial = childNamed(list, "Value").child_value();
    }
    if (variable.name.empty() || variable.type == IecType::None) {
      return sink_.report(Syntax::XmlStructure, variable.span,
                          fmt::format("tag {} has type {}, which the S7-200 does not have", excerpt(variable.name),
                                      excerpt(variable.typeName)));
    }
    project_.globals.push_back(std::move(variable));
  }

  void dataBlock(const pugi::xml_node& node, bool isInstance) {
    const pugi::xml_node list = childNamed(node, "AttributeList");
    const std::string name = childNamed(list, "Name").child_value();
    if (isInstance) {
      const std::string type = childNamed(list, "InstanceOfName").child_value();
      addInstance(
          {name, DrawnSection::Global, IecType::None, standardOfData(type), "", "", false, xml_.span(*part_, node)});
      return;
    }
    for (const pugi::xml_node& section : childNamed(childNamed(list, "Interface"), "Sections").children())
      members(section, DrawnSection::Global, name + ".", project_.globals);
  }

  void addInstance(DrawnVariable variable) {
    const bool isThere = std::any_of(project_.globals.begin(), project_.globals.end(), [&](const DrawnVariable& other) {
      return foldedName(other.name) == foldedName(variable.name);
    });
    if (!isThere) project_.globals.push_back(std::move(variable));
  }

  void members(const pugi::xml_node& parent, DrawnSection section, const std::string& prefix,
               std::vector<DrawnVariable>& variables) {
    for (const pugi::xml_node& node : parent.children()) {
      if (localName(node) != "Member") continue;
      DrawnVariable variable;
      variable.span = xml_.span(*part_, node);
      variable.name = prefix + node.attribute("Name").value();
      variable.section = section;
      variable.typeName = node.attribute("Datatype").value();
      std::erase(variable.typeName, '"');
      if (foldedName(variable.typeName) == "VOID") continue;
      if (variable.typeName == "Struct") {
        members(node, section, variable.name + ".", variables);
        continue;
      }
      variable.type = iecTypeNamed(variable.typeName);
      variable.initial = trimmed(childNamed(node, "StartValue").child_value());
      variable.isConstant = section == DrawnSection::Constant;
      if (variable.typeName.starts_with("Array") || variable.typeName.empty()) {
        sink_.report(
            Syntax::XmlStructure, variable.span,
            fmt::format("type {} of {} is not one that the S7-200 has", excerpt(variable.typeName), variable.name));
        continue;
      }
      variables.push_back(std::move(variable));
    }
  }

  void interface(const pugi::xml_node& sections, DrawnBlock& block) {
    for (const pugi::xml_node& section : sections.children()) {
      const std::string_view name = section.attribute("Name").value();
      if (block.kind == DrawnBlockKind::Program && name == "Input") {
        for (const pugi::xml_node& member : section.children()) {
          if (std::string_view(member.attribute("Name").value()) != "Initial_Call") continue;
          block.variables.push_back({"Initial_Call", DrawnSection::Local, IecType::Bool, "Bool", "%SM0.1", "", false,
                                     xml_.span(*part_, member)});
        }
        continue;
      }
      const DrawnSection kind = name == "Input"      ? DrawnSection::Input
                                : name == "Output"   ? DrawnSection::Output
                                : name == "InOut"    ? DrawnSection::InOut
                                : name == "Temp"     ? DrawnSection::Temp
                                : name == "Constant" ? DrawnSection::Constant
                                : name == "Return"   ? DrawnSection::Output
                                                     : DrawnSection::Local;
      members(section, kind, "", block.variables);
    }
  }

  void block(const pugi::xml_node& node, std::string_view kind) {
    DrawnBlock block;
    block.span = xml_.span(*part_, node);
    block.kind = kind == "SW.Blocks.OB"   ? DrawnBlockKind::Program
                 : kind == "SW.Blocks.FB" ? DrawnBlockKind::FunctionBlock
                                          : DrawnBlockKind::Function;
    const pugi::xml_node list = childNamed(node, "AttributeList");
    block.name = childNamed(list, "Name").child_value();
    if (block.name.empty()) {
      sink_.report(Syntax::XmlStructure, block.span, "a block has no name");
      block.name = "unnamed";
    }
    sink_.setPlace(block.name, 0);
    const std::string_view event = childNamed(list, "SecondaryType").child_value();
    if (block.kind == DrawnBlockKind::Program && !event.empty() && event != "ProgramCycle") {
      sink_.report(Syntax::BodyNotCovered, block.span,
                   fmt::format("{} is started by {}, which is not covered", block.name, excerpt(event)));
      sink_.setPlace("", 0);
      return;
    }
    block.form =
        std::string_view(childNamed(list, "ProgrammingLanguage").child_value()) == "FBD" ? Form::Fbd : Form::Ladder;
    interface(childNamed(childNamed(list, "Interface"), "Sections"), block);
    for (const pugi::xml_node& child : node.children()) comment(child);
    std::vector<Comment> notes;
    for (const pugi::xml_node& child : childNamed(node, "ObjectList").children()) {
      comment(child);
      const std::string_view name = child.name();
      if (name == "SW.Blocks.CompileUnit") compileUnit(child, block);
      if (child.type() == pugi::node_element && name != "SW.Blocks.CompileUnit" && name != "MultilingualText") {
        sink_.report(Syntax::XmlStructure, xml_.span(*part_, child),
                     fmt::format("element <{}> is not known in a block", excerpt(name)));
      }
      if (localName(child) == "MultilingualText") block.title = textOf(child, block.comments);
    }
    for (DrawnVariable& variable : block.variables) {
      if (variable.type != IecType::None || !isStandardData(variable.typeName)) continue;
      // The type of a timer's data does not always say which timer it is; the part that uses it does.
      std::string type = standardOfData(variable.typeName);
      for (const DrawnNetwork& network : block.networks) {
        for (const DrawnElement& element : network.elements) {
          if (element.kind == DrawnKind::Block && foldedName(element.instance) == foldedName(variable.name))
            type = element.text;
        }
      }
      variable.typeName = type;
    }
    sink_.setPlace("", 0);
    project_.blocks.push_back(std::move(block));
  }

  /// Title or comment; the text of a comment goes to `lines`.
  std::string textOf(const pugi::xml_node& text, std::vector<Comment>& lines) {
    const bool isTitle = std::string_view(text.attribute("CompositionName").value()) == "Title";
    std::string title;
    for (const pugi::xml_node& item : childNamed(text, "ObjectList").children()) {
      const pugi::xml_node content = childNamed(childNamed(item, "AttributeList"), "Text");
      const pugi::xml_node characters = content.first_child();
      if (!characters) continue;
      if (isTitle) {
        if (title.empty()) title = trimmed(characters.value());
        continue;
      }
      const Span span = xml_.span(*part_, characters);
      readComment(span, text_.substr(span.offset, span.length), lines, project_.directives);
    }
    return title;
  }

  void compileUnit(const pugi::xml_node& node, DrawnBlock& block) {
    const int number = static_cast<int>(block.networks.size()) + 1;
    sink_.setPlace(block.name, number);
    const pugi::xml_node list = childNamed(node, "AttributeList");
    const pugi::xml_node source = childNamed(list, "NetworkSource");
    const pugi::xml_node net = childNamed(source, "FlgNet");
    DrawnNetwork network;
    if (net) {
      std::vector<DrawnVariable> instances;
      network = readFlgNet(xml_, *part_, net, sink_, instances);
      for (DrawnVariable& instance : instances) addInstance(std::move(instance));
    } else if (const pugi::xml_node other = firstElement(source)) {
      const std::string language = childNamed(list, "ProgrammingLanguage").child_value();
      UncoveredBody body{language.empty() ? std::string(localName(other)) : language, namesIn(other),
                         xml_.span(*part_, other)};
      if (block.uncovered) body.text += " " + block.uncovered->text;
      block.uncovered = std::move(body);
    } else if (!source) {
      sink_.report(Syntax::XmlStructure, xml_.span(*part_, node), "the network has no content");
      network.isDamaged = true;
    }
    network.isWhole = true;
    network.number = number;
    if (network.span.length == 0) network.span = xml_.span(*part_, node);
    DrawnNote note;
    for (const pugi::xml_node& child : childNamed(node, "ObjectList").children()) {
      if (localName(child) != "MultilingualText") continue;
      const std::string title = textOf(child, note.lines);
      if (!title.empty()) note.title = title;
    }
    network.notes.push_back(std::move(note));
    block.networks.push_back(std::move(network));
  }

  static pugi::xml_node firstElement(const pugi::xml_node& node) {
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() == pugi::node_element) return child;
    }
    return {};
  }

  /// Every variable that a text in another language names, separated by blanks.
  static std::string namesIn(const pugi::xml_node& body) {
    std::string names;
    forEachBelow(body, [&](const pugi::xml_node& at) {
      if (localName(at) != "Symbol") return;
      names += ' ';
      for (const pugi::xml_node& component : at.children()) {
        if (localName(component) == "Component")
          names += fmt::format("{}{}", names.back() == ' ' ? "" : ".", component.attribute("Name").value());
      }
    });
    return names;
  }

  DrawnProject& project_;
  SyntaxSink sink_;
  std::string_view text_;
  XmlText xml_;
  const XmlText::Part* part_ = nullptr;
};

}  // namespace

void readSimatic(Program& program, const InputText& input, DrawnProject& project) {
  project.isSimatic = true;
  SimaticReader(program, input, project).run();
}

}  // namespace rungproof
