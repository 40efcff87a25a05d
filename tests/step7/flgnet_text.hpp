// SimaticML as text: parts, wires, networks, blocks. Operands are absolute addresses. Part of the tests of this folder.
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rungproof::test7 {

/// A network that is put together pin by pin.
class DrawnNet {
 public:
  /// An operand: "M0.1", "MW10", "DB10.DBW2", "5:Int", "S5T#2S:S5Time", "#name", "\"name\"", "label:end".
  int access(const std::string& text) {
    const int id = ++ids_;
    parts_ += accessText(id, text);
    return id;
  }
  int part(const std::string& name, const std::string& inner = "") {
    const int id = ++ids_;
    parts_ += fmt::format("<Part Name=\"{}\" UId=\"{}\">{}</Part>", name, id, inner);
    return id;
  }
  int call(const std::string& info) {
    const int id = ++ids_;
    parts_ += fmt::format("<Call UId=\"{}\">{}</Call>", id, info);
    return id;
  }
  void in(const std::string& operand, int part, const std::string& pin) {
    const int id = access(operand);
    wires_ += fmt::format("<Wire><IdentCon UId=\"{}\"/><NameCon UId=\"{}\" Name=\"{}\"/></Wire>", id, part, pin);
  }
  void out(int part, const std::string& pin, const std::string& operand) {
    const int id = access(operand);
    wires_ += fmt::format("<Wire><NameCon UId=\"{}\" Name=\"{}\"/><IdentCon UId=\"{}\"/></Wire>", part, pin, id);
  }
  using End = std::pair<int, std::string>;
  void rail(const std::vector<End>& ends) { wires_ += "<Wire><Powerrail/>" + names(ends) + "</Wire>"; }
  void flow(const End& from, const std::vector<End>& to) { wires_ += "<Wire>" + names({from}) + names(to) + "</Wire>"; }
  void label(const std::string& name) {
    labels_ += fmt::format("<LabelDeclaration UId=\"{}\"><Label Name=\"{}\"/></LabelDeclaration>", ++ids_, name);
  }

  std::string text() const {
    return "<FlgNet>" + (labels_.empty() ? std::string() : "<Labels>" + labels_ + "</Labels>") + "<Parts>" + parts_ +
           "</Parts><Wires>" + wires_ + "</Wires></FlgNet>";
  }

 private:
  static std::string names(const std::vector<End>& ends) {
    std::string text;
    for (const auto& [part, pin] : ends) text += fmt::format("<NameCon UId=\"{}\" Name=\"{}\"/>", part, pin);
    return text;
  }

  static std::string components(std::string path) {
    std::string text;
    for (std::size_t at = 0; at <= path.size();) {
      const std::size_t end = std::min(path.find('.', at), path.size());
      text += fmt::format("<Component Name=\"{}\"/>", path.substr(at, end - at));
      at = end + 1;
    }
    return "<Symbol>" + text + "</Symbol>";
  }

  static std::string accessText(int id, const std::string& text) {
    const auto scoped = [&](const char* scope, const std::string& inner) {
      return fmt::format("<Access Scope=\"{}\" UId=\"{}\">{}</Access>", scope, id, inner);
    };
    if (text.starts_with("label:")) return scoped("Label", fmt::format("<Label Name=\"{}\"/>", text.substr(6)));
    if (text.starts_with('#')) return scoped("LocalVariable", components(text.substr(1)));
    if (text.starts_with('"')) return scoped("GlobalVariable", components(text.substr(1, text.size() - 2)));
    if (const std::size_t colon = text.rfind(':'); colon != std::string::npos)
      return scoped("LiteralConstant", fmt::format("<Constant><ConstantType>{}</ConstantType><ConstantValue>{}</"
                                                   "ConstantValue></Constant>",
                                                   text.substr(colon + 1), text.substr(0, colon)));
    return scoped("Address", addressText(text));
  }

  static std::string addressText(std::string text) {
    std::string block;
    if (text.starts_with("DB")) {
      block = fmt::format(" BlockNumber=\"{}\"", text.substr(2, text.find('.') - 2));
      text = "d" + text.substr(text.find('.') + 3);
      if (text[1] == 'X') text.erase(1, 1);
    }
    static const std::map<char, std::string> areas = {{'I', "Input"}, {'Q', "Output"}, {'M', "Memory"},
                                                      {'d', "DB"},    {'T', "Timer"},  {'C', "Counter"}};
    const std::string area = areas.at(text[0]);
    const bool isSized = text[1] > '9';
    const std::string type = !isSized ? "Bool" : text[1] == 'B' ? "Byte" : text[1] == 'W' ? "Word" : "DWord";
    const std::size_t dot = text.find('.');
    const int byte = std::stoi(text.substr(isSized ? 2 : 1));
    const bool isNumber = area == "Timer" || area == "Counter";
    const int offset = isNumber ? byte : byte * 8 + (dot == std::string::npos ? 0 : std::stoi(text.substr(dot + 1)));
    return fmt::format("<Address Area=\"{}\" Type=\"{}\"{} BitOffset=\"{}\"/>", area, isNumber ? area : type, block,
                       offset);
  }

  int ids_ = 20;
  std::string parts_, wires_, labels_;
};

inline std::string instanceText(const std::string& operand) {
  DrawnNet net;
  net.access(operand);
  const std::string text = net.text();  // <FlgNet><Parts><Access ...>INNER</Access>
  const std::size_t begin = text.find('>', text.find("<Access")) + 1;
  std::string inner = text.substr(begin, text.find("</Access>") - begin);
  for (const char* tag : {"<Symbol>", "</Symbol>"}) {
    if (const std::size_t at = inner.find(tag); at != std::string::npos) inner.erase(at, std::string(tag).size());
  }
  return fmt::format("<Instance Scope=\"{}\" UId=\"9\">{}</Instance>",
                     operand.starts_with('#') ? "LocalVariable" : "GlobalVariable", inner);
}

inline std::string typed(const std::string& name, const std::string& value) {
  return fmt::format("<TemplateValue Name=\"{}\" Type=\"{}\">{}</TemplateValue>", name,
                     name == "Card" ? "Cardinality" : "Type", value);
}
inline std::string negated(const std::string& pin) { return fmt::format("<Negated Name=\"{}\"/>", pin); }

inline std::string unit(const std::string& source, const std::string& language = "FBD") {
  return fmt::format(
      "<SW.Blocks.CompileUnit ID=\"3\"><AttributeList><NetworkSource>{}</NetworkSource><ProgrammingLanguage>{}</"
      "ProgrammingLanguage></AttributeList></SW.Blocks.CompileUnit>",
      source, language);
}
/// kind: "OB", "FC", "FB", "GlobalDB", "InstanceDB".
inline std::string drawnBlock(const std::string& kind, const std::string& name, int number, const std::string& sections,
                              const std::string& units, const std::string& more = "") {
  return fmt::format(
      "<SW.Blocks.{0} "
      "ID=\"1\"><AttributeList>{1}<Interface><Sections>{2}</Sections></Interface><Name>{3}</Name><Number>"
      "{4}</Number><ProgrammingLanguage>FBD</ProgrammingLanguage></AttributeList><ObjectList>{5}</ObjectList></"
      "SW.Blocks.{0}>",
      kind, more, sections, name, number, units);
}
inline std::string section(const std::string& name, const std::string& members) {
  return fmt::format("<Section Name=\"{}\">{}</Section>", name, members);
}
inline std::string member(const std::string& name, const std::string& type, const std::string& inner = "") {
  return fmt::format("<Member Name=\"{}\" Datatype=\"{}\">{}</Member>", name, type, inner);
}
inline std::string drawnDocument(const std::string& blocks) {
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Document>" + blocks + "</Document>\n";
}

}  // namespace rungproof::test7
