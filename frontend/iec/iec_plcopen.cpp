// PLCopen XML to the syntax tree.
#include "frontend/iec/iec_plcopen.hpp"

#include <cstdlib>
#include <deque>
#include <functional>

#include "frontend/iec/iec_drawing.hpp"
#include "frontend/iec/iec_parser.hpp"
#include "frontend/iec/iec_plcopen_chart.hpp"
#include "frontend/iec/iec_rungs.hpp"
#include "frontend/plcopen/plcopen_reader.hpp"
#include "frontend/plcopen/plcopen_shapes.hpp"
#include "frontend/stl/directive.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/xml/xml_shape.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof::iec {

bool hasBodyOfThisFamily(std::string_view text) {
  for (const std::string_view language : {"ST", "SFC"}) {
    for (std::size_t at = text.find(language); at != std::string_view::npos; at = text.find(language, at + 1)) {
      const std::size_t end = at + language.size(), opening = text.rfind('<', at);
      if (end >= text.size() || opening == std::string_view::npos) continue;
      const std::string_view prefix = text.substr(opening + 1, at - opening - 1);
      const bool opens = prefix.empty() || (prefix.ends_with(':') && prefix.find_first_of(" >/\n") == prefix.npos);
      if (opens && std::string_view("> \n\r\t").find(text[end]) != std::string_view::npos) return true;
    }
  }
  return false;
}

namespace {

constexpr auto shapesOfVariables = variableListShapes("simpleValue arrayValue structValue");

class PlcopenText : private PlcopenBodies {
 public:
  PlcopenText(Program& program, const InputText& input, ProjectSyntax& project)
      : program_(program),
        project_(project),
        sink_(program, input.file),
        text_(program.sources->file(input.file).text()),
        xml_(program.sources->file(input.file), sink_, {"pou"}) {}

  void run() {
    for (const XmlText::Part& part : xml_.parts()) {
      part_ = &part;
      if (part.isDamaged) project_.isDamaged = true;
      forEachBelow(*part.document, [&](const pugi::xml_node& node) { visit(node); });
    }
    if (isAnythingThere_ || project_.isDamaged) return;
    sink_.report(Syntax::XmlStructure, {sink_.file(), 0, 0},
                 hasProject_ ? "the project has no block" : "there is no element <project>");
  }

 private:
  void visit(const pugi::xml_node& node) {
    if (node.type() == pugi::node_comment) return directives(node);
    if (node.type() != pugi::node_element) return;
    const std::string_view name = localName(node);
    hasProject_ = hasProject_ || name == "project";
    isAnythingThere_ = isAnythingThere_ || name == "pou" || name == "dataType" || name == "globalVars";
    if (name == "pou") readBlock(node);
    if (name == "dataType") readType(node);
    if (name == "globalVars" && localName(node.parent()) != "interface")
      readVariables(node, Section::Global, project_.globals);
    if (name == "configVars" || name == "accessVars")
      sink_.report(Syntax::IecNotModelled, xml_.span(*part_, node), fmt::format("<{}> is not modelled", name));
    if (name == "task") readTask(node);
    if (name == "pouInstance") readInstance(node);
  }

  void directives(const pugi::xml_node& node) {
    const Span span = xml_.span(*part_, node);
    std::string_view text = text_.substr(span.offset, span.length);
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = trimmed(text.substr(0, end));
      if (line.starts_with("<!--")) line = trimmed(line.substr(4));
      if (line.ends_with("-->")) line = trimmed(line.substr(0, line.size() - 3));
      if (const auto directive = directiveText(line)) {
        const auto offset = static_cast<std::uint32_t>(line.data() - text_.data());
        project_.directives.push_back(
            {std::string(*directive), {span.file, offset, static_cast<std::uint32_t>(line.size())}, -1, 0});
      }
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  static pugi::xml_node firstElement(const pugi::xml_node& node) {
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() == pugi::node_element) return child;
    }
    return {};
  }

  void error(const pugi::xml_node& node, std::string message) {
    sink_.report(Syntax::XmlStructure, xml_.span(*part_, node), std::move(message));
  }

  void readBlock(const pugi::xml_node& node) {
    BlockSyntax made;
    made.span = xml_.span(*part_, node);
    made.name = node.attribute("name").value();
    const std::string_view kind = node.attribute("pouType").value();
    made.kind = kind == "function"        ? BlockKind::Function
                : kind == "functionBlock" ? BlockKind::FunctionBlock
                                          : BlockKind::Program;
    if (made.name.empty() || (kind != "function" && kind != "functionBlock" && kind != "program")) {
      error(node, fmt::format("block \"{}\" needs a name and the type program, functionBlock or function",
                              excerpt(made.name)));
      made.isWhole = false;
    }
    sink_.setPlace(made.name, 0);
    int bodies = 0;
    for (const pugi::xml_node& child : node.children()) {
      const std::string_view name = localName(child);
      if (name == "interface") readInterface(child, made);
      if (name == "body") {  // several worksheets: one behind the other
        ++bodies;
        readBody(child, made);
      }
    }
    readActions(childNamed(node, "actions"), made);
    if (bodies == 0) {
      error(node, fmt::format("block {} has no body", made.name));
      made.isWhole = false;
    }
    sink_.setPlace("", 0);
    project_.blocks.push_back(std::move(made));
  }

  /// Bodies that the block calls by their names; those of a chart are there already.
  void readActions(const pugi::xml_node& list, BlockSyntax& block) {
    for (const pugi::xml_node& node : list.children()) {
      const std::string name = node.attribute("name").value();
      const bool isThere = std::ranges::any_of(
          block.actions, [&](const ActionSyntax& a) { return foldedName(a.name) == foldedName(name); });
      if (localName(node) != "action" || isThere) continue;
      ActionSyntax made;
      made.name = name;
      made.span = xml_.span(*part_, node);
      made.body = statementsOf(childNamed(node, "body"), block);
      block.actions.push_back(std::move(made));
    }
  }

  void readInterface(const pugi::xml_node& node, BlockSyntax& block) {
    static const std::map<std::string_view, Section> sections = {
        {"localVars", Section::Local},   {"tempVars", Section::Temp},   {"inputVars", Section::Input},
        {"outputVars", Section::Output}, {"inOutVars", Section::InOut}, {"externalVars", Section::External},
        {"globalVars", Section::Local}};
    for (const pugi::xml_node& child : node.children()) {
      const std::string_view name = localName(child);
      if (name == "returnType") block.result = typeOf(firstElement(child));
      const bool isPassedOver = child.type() != pugi::node_element || name == "returnType" || name == "documentation" ||
                                name == "addData" || name == "configVars" || name == "accessVars";
      if (const auto section = sections.find(name); section != sections.end())
        readVariables(child, section->second, block.variables);
      else if (!isPassedOver)
        error(child, fmt::format("element <{}> is not known in an interface", excerpt(name)));
    }
  }

  ExprPtr expression(const std::string& text, const pugi::xml_node& at) {
    std::string& kept = kept_.emplace_back(text);
    const Span span = xml_.span(*part_, at);
    std::vector<std::uint32_t>& places = places_.emplace_back(kept.size() + 1, span.offset);
    return parseExpression({kept, span.file, 0, &places}, sink_);
  }

  TypePtr typeOf(const pugi::xml_node& node) {
    auto made = std::make_shared<TypeSyntax>();
    made->span = node ? xml_.span(*part_, node) : Span{sink_.file(), 0, 0};
    const std::string_view name = localName(node);
    if (name == "derived") {
      made->name = node.attribute("name").value();
    } else if (name == "array") {
      made->form = TypeForm::Array;
      for (const pugi::xml_node& child : node.children()) {
        if (localName(child) == "dimension")
          made->bounds.emplace_back(expression(child.attribute("lower").value(), child),
                                    expression(child.attribute("upper").value(), child));
        if (localName(child) == "baseType") made->element = typeOf(firstElement(child));
      }
      if (made->element == nullptr || made->bounds.empty()) {
        error(node, "an array needs dimensions and a type");
        made->form = TypeForm::Named;
        made->name = "ANY";
      }
      for (auto& [low, high] : made->bounds) {
        if (low != nullptr && high != nullptr) continue;
        made->form = TypeForm::Named;
        made->name = "ANY";
      }
    } else if (name == "struct") {
      made->form = TypeForm::Struct;
      for (const pugi::xml_node& child : node.children()) {
        if (localName(child) == "variable") made->fields.push_back(readVariable(child, Section::Local));
      }
    } else if (name == "enum") {
      made->form = TypeForm::Enum;
      forEachBelow(node, [&](const pugi::xml_node& value) {
        if (value.type() != pugi::node_element || localName(value) != "value") return;
        const std::string number = value.attribute("value").value();
        made->items.emplace_back(value.attribute("name").value(), number.empty() ? nullptr : expression(number, value));
      });
    } else if (name == "subrangeSigned" || name == "subrangeUnsigned") {
      const pugi::xml_node range = childNamed(node, "range");
      made->name = typeOf(firstElement(childNamed(node, "baseType")))->name;
      made->low = expression(range.attribute("lower").value(), node);
      made->high = expression(range.attribute("upper").value(), node);
    } else {
      made->name = node ? foldedName(name) : "ANY";
    }
    return made;
  }

  VariableSyntax readVariable(const pugi::xml_node& node, Section section) {
    VariableSyntax made;
    made.span = xml_.span(*part_, node);
    made.name = node.attribute("name").value();
    made.address = node.attribute("address").value();
    made.section = section;
    made.type = typeOf(firstElement(childNamed(node, "type")));
    const bool isText = localName(firstElement(childNamed(node, "type"))) == "string";
    if (const pugi::xml_node initial = childNamed(node, "initialValue"))
      made.initial =
          std::make_shared<Initial>(isText ? initialText(firstElement(initial)) : initialOf(firstElement(initial)));
    return made;
  }

  /// Beremiz writes the value of a STRING without quotes.
  Initial initialText(const pugi::xml_node& node) {
    std::string text = node.attribute("value").value();
    if (localName(node) != "simpleValue" || text.starts_with('\'') || text.starts_with('"') ||
        text.starts_with("STRING#"))
      return initialOf(node);
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' || c == '$' ? std::string{'$', c} : std::string(1, c);
    Initial made;
    made.span = xml_.span(*part_, node);
    made.value = expression(quoted + "'", node);
    return made;
  }

  Initial initialOf(const pugi::xml_node& node) {
    Initial made;
    made.span = xml_.span(*part_, node);
    const std::string_view name = localName(node);
    if (name == "arrayValue") {
      made.isRow = true;
      for (const pugi::xml_node& child : node.children()) {
        if (localName(child) != "value") continue;
        const unsigned long times = std::strtoul(child.attribute("repetitionValue").value(), nullptr, 10);
        made.row.emplace_back(static_cast<std::uint32_t>(std::clamp(times, 1UL, 1'000'000UL)),
                              initialOf(firstElement(child)));
      }
    } else if (name == "structValue") {
      made.isStructure = true;
      for (const pugi::xml_node& child : node.children()) {
        if (localName(child) == "value")
          made.fields.emplace_back(child.attribute("member").value(), initialOf(firstElement(child)));
      }
    } else {
      made.value = expression(node.attribute("value").value(), node);
    }
    return made;
  }

  void readVariables(const pugi::xml_node& list, Section section, std::vector<VariableSyntax>& into) {
    for (const ShapeFault& fault : faultsOf(list, shapesOfVariables)) error(fault.node, fault.message);
    for (const pugi::xml_node& node : list.children()) {
      if (localName(node) != "variable") continue;
      VariableSyntax made = readVariable(node, section);
      made.isConstant = list.attribute("constant").as_bool();
      made.isRetain = list.attribute("retain").as_bool();
      if (made.name.empty()) {
        error(node, "a variable has no name");
        continue;
      }
      into.push_back(std::move(made));
    }
  }

  void readType(const pugi::xml_node& node) {
    NamedType made;
    made.span = xml_.span(*part_, node);
    made.name = node.attribute("name").value();
    made.type = typeOf(firstElement(childNamed(node, "baseType")));
    if (const pugi::xml_node initial = childNamed(node, "initialValue"))
      made.initial = std::make_shared<Initial>(initialOf(firstElement(initial)));
    project_.types.push_back(std::move(made));
  }

  void readTask(const pugi::xml_node& node) {
    TaskSyntax made;
    made.span = xml_.span(*part_, node);
    made.name = node.attribute("name").value();
    if (const std::string single = node.attribute("single").value(); !single.empty())
      made.single = expression(single, node);
    std::string interval = foldedName(node.attribute("interval").value());
    if (interval.starts_with("T#")) {
      made.intervalMs = millisecondsOf(std::string_view(interval).substr(2));
    } else if (interval.starts_with("PT") && interval.ends_with("S")) {
      const double seconds = std::strtod(interval.c_str() + 2, nullptr);
      made.intervalMs = static_cast<std::int64_t>(seconds * 1000 + 0.5);
    } else if (!interval.empty() && interval.find_first_not_of("0123456789") == std::string::npos) {
      made.intervalMs = std::strtoll(interval.c_str(), nullptr, 10);
    }
    if (!interval.empty() && (!made.intervalMs || *made.intervalMs <= 0)) {
      error(node, fmt::format("the interval {} of a task cannot be read", excerpt(interval)));
      made.intervalMs.reset();
    }
    for (const pugi::xml_node& child : node.children()) {
      if (localName(child) == "pouInstance") taskOf_[child.hash_value()] = made.name;
    }
    project_.tasks.push_back(std::move(made));
  }

  void readInstance(const pugi::xml_node& node) {
    InstanceSyntax made;
    made.span = xml_.span(*part_, node);
    made.name = node.attribute("name").value();
    made.type = node.attribute("typeName").value();
    if (made.type.empty()) made.type = made.name;
    made.task = taskOf_[node.hash_value()];
    project_.instances.push_back(std::move(made));
  }

  Span placeOf(const pugi::xml_node& node) const override { return xml_.span(*part_, node); }
  void report(const pugi::xml_node& node, Syntax code, std::string message) override {
    sink_.report(code, placeOf(node), std::move(message));
  }
  Statements statementsOf(const pugi::xml_node& body, BlockSyntax& block) override {
    Statements outer = std::exchange(block.body, {});
    readBody(body, block);
    return std::exchange(block.body, std::move(outer));
  }
  Statements statementsOf(const DrawnNetwork& network, BlockSyntax& block) override {
    Statements outer = std::exchange(block.body, {});
    drawnStatements(program_, network, Form::Ladder, block, sink_);
    return std::exchange(block.body, std::move(outer));
  }
  ExprPtr expressionOf(const pugi::xml_node& node) override {
    SourceText source = textOf(node);
    std::string& kept = kept_.back();
    const std::size_t first = kept.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && kept.compare(first, 2, ":=") == 0) kept.replace(first, 2, "  ");
    while (!source.text.empty() && (source.text.back() == ';' || source.text.back() <= ' '))
      source.text.remove_suffix(1);
    return parseExpression(source, sink_);
  }
  ExprPtr expressionOf(const std::string& text, const pugi::xml_node& at) override { return expression(text, at); }
  DrawnNetwork networkOf(const pugi::xml_node& body) override { return readPlcopenBody(xml_, *part_, body, text_); }

  void readBody(const pugi::xml_node& body, BlockSyntax& block) {
    int languages = 0;
    for (const pugi::xml_node& child : body.children()) {
      if (child.type() != pugi::node_element) continue;
      const std::string_view language = localName(child);
      if (language == "documentation" || language == "addData") continue;
      if (++languages == 2)
        error(child, fmt::format("the body of {} has a second language; which of them runs is not known", block.name));
      if (language == "LD" && holdsRungs(child)) {
        for (Statement& s : rungStatements(*this, child, block)) block.body.push_back(std::move(s));
        continue;
      }
      if (language == "LD" || language == "FBD") {
        readDrawing(child, block);
        continue;
      }
      if (language == "SFC") {
        pugi::xml_node pou = body;
        while (pou && localName(pou) != "pou") pou = pou.parent();
        // The named actions of the block belong to its own chart, not to one within an action.
        const bool isOwn = localName(body.parent()) == "pou";
        chartStatements(readPlcopenChart(*this, child, isOwn ? pou : pugi::xml_node{}, block), block, sink_);
        continue;
      }
      if (language != "ST" && language != "IL") {
        block.unread = language;
        continue;
      }
      readStatements(child, block);
    }
  }

  void readDrawing(const pugi::xml_node& node, BlockSyntax& block) {
    DrawnNetwork network = readPlcopenBody(xml_, *part_, node, text_);
    for (const ShapeFault& fault : plcopenFaults(node)) {
      sink_.report(Syntax::XmlStructure, xml_.span(*part_, fault.node), fault.message);
      network.isDamaged = true;
    }
    for (const DrawnNote& note : network.notes) {
      for (const Comment& line : note.lines) {
        if (const auto directive = directiveText(text_.substr(line.span.offset, line.span.length)))
          project_.directives.push_back({std::string(*directive), line.span, -1, 0});
      }
    }
    drawnStatements(program_, network, localName(node) == "FBD" ? Form::Fbd : Form::Ladder, block, sink_);
  }

  void readStatements(const pugi::xml_node& node, BlockSyntax& block) {
    const SourceText source = textOf(node);
    Statements made = localName(node) == "IL" ? parseList(source, sink_, project_.directives)
                                              : parseBody(source, sink_, project_.directives);
    for (Statement& s : made) block.body.push_back(std::move(s));
  }

  /// The characters of the body with the place of each in the file.
  SourceText textOf(const pugi::xml_node& node) {
    std::string& kept = kept_.emplace_back();
    std::vector<std::uint32_t>& places = places_.emplace_back();
    forEachBelow(node, [&](const pugi::xml_node& at) {
      if (at.type() != pugi::node_pcdata && at.type() != pugi::node_cdata) return;
      const Span span = xml_.span(*part_, at);
      append(std::string_view(at.value()), at.type() == pugi::node_cdata, span, kept, places);
    });
    places.push_back(places.empty() ? xml_.span(*part_, node).offset : places.back() + 1);
    return {kept, sink_.file(), 0, &places};
  }

  /// Each character of the value stands where it, or its entity, stands in the file.
  void append(std::string_view value, bool isRaw, Span span, std::string& kept,
              std::vector<std::uint32_t>& places) const {
    std::size_t at = span.offset;
    if (isRaw && text_.substr(at, 9) == "<![CDATA[") at += 9;
    for (const char c : value) {
      if (c == '\n' && at < text_.size() && text_[at] == '\r') ++at;
      kept += c;
      places.push_back(static_cast<std::uint32_t>(std::min(at, text_.size())));
      if (!isRaw && at < text_.size() && text_[at] == '&') {
        at = std::min(text_.find(';', at), text_.size() - 1);
      }
      ++at;
    }
  }

  Program& program_;
  ProjectSyntax& project_;
  SyntaxSink sink_;
  std::string_view text_;
  XmlText xml_;
  const XmlText::Part* part_ = nullptr;
  bool hasProject_ = false, isAnythingThere_ = false;
  std::map<std::size_t, std::string> taskOf_;
  std::deque<std::string> kept_;
  std::deque<std::vector<std::uint32_t>> places_;
};

}  // namespace

void readPlcopenText(Program& program, const InputText& input, ProjectSyntax& project) {
  PlcopenText(program, input, project).run();
}

}  // namespace rungproof::iec
