// PLCopen texts for tests: declarations and one body around the elements that a test is about.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "frontend/input/project.hpp"

namespace rungproof {

/// "name:TYPE", "name:TYPE@%IX0.0", "name:TYPE=5"; a type that is not elementary is that of a function block.
inline std::string declarations(const std::vector<std::string>& variables) {
  std::string text;
  for (const std::string& variable : variables) {
    const std::size_t colon = variable.find(':');
    std::string type = variable.substr(colon + 1), address, initial;
    if (const std::size_t at = type.find('@'); at != std::string::npos) {
      address = fmt::format(" address=\"{}\"", type.substr(at + 1));
      type.resize(at);
    }
    if (const std::size_t at = type.find('='); at != std::string::npos) {
      initial = fmt::format("<initialValue><simpleValue value=\"{}\"/></initialValue>", type.substr(at + 1));
      type.resize(at);
    }
    static const std::vector<std::string> plain = {"BOOL", "SINT", "USINT", "BYTE",  "INT",  "UINT",
                                                   "WORD", "DINT", "UDINT", "DWORD", "TIME", "REAL"};
    const bool isPlain = std::find(plain.begin(), plain.end(), type) != plain.end();
    text += fmt::format("<variable name=\"{}\"{}><type>{}</type>{}</variable>\n", variable.substr(0, colon), address,
                        isPlain ? "<" + type + "/>" : fmt::format("<derived name=\"{}\"/>", type), initial);
  }
  return text;
}

inline std::string pouText(const std::string& name, const std::string& kind, const std::string& interface,
                           const std::string& language, const std::string& elements) {
  return fmt::format("<pou name=\"{}\" pouType=\"{}\"><interface>{}</interface><body><{}>\n{}\n</{}></body></pou>\n",
                     name, kind, interface, language, elements, language);
}

/// The heading says that the program is one of an S7-200.
inline constexpr const char* headingOfS7200 =
    "<fileHeader companyName=\"\" productName=\"S7-200\" productVersion=\"1\"/>";

inline std::string projectText(const std::string& pous, const std::string& heading = headingOfS7200) {
  return "<?xml version=\"1.0\"?>\n<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\" "
         "xmlns:xhtml=\"http://www.w3.org/1999/xhtml\">" +
         heading + "<types><dataTypes/><pous>\n" + pous + "</pous></types></project>\n";
}

/// A drawing of the corpus as a program of an S7-200: its heading says so.
inline Program readAsS7200(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::size_t name = text.find("productName=");
  if (name != std::string::npos) text.insert(text.find('"', name) + 1, "S7-200 ");
  return readText(path.filename().string(), text);
}

/// A program with local variables.
inline std::string plcopen(const std::vector<std::string>& variables, const std::string& language,
                           const std::string& elements) {
  return projectText(
      pouText("Main", "program", "<localVars>" + declarations(variables) + "</localVars>", language, elements));
}

// Elements. `from`: ids of what feeds them, "3" or "3.Q".

inline std::string pointIn(const std::vector<std::string>& from) {
  std::string text = "<connectionPointIn>";
  for (const std::string& one : from) {
    const std::size_t point = one.find('.');
    text +=
        fmt::format("<connection refLocalId=\"{}\"{}/>", one.substr(0, point),
                    point == std::string::npos ? "" : fmt::format(" formalParameter=\"{}\"", one.substr(point + 1)));
  }
  return text + "</connectionPointIn>";
}
inline std::string at(int x, int y) { return fmt::format("<position x=\"{}\" y=\"{}\"/>", x, y); }
inline std::string railElement(int id) {
  return fmt::format("<leftPowerRail localId=\"{}\">{}<connectionPointOut formalParameter=\"\"/></leftPowerRail>\n", id,
                     at(0, 0));
}
inline std::string contactElement(int id, const std::vector<std::string>& from, const std::string& name,
                                  const std::string& attributes = "", int x = 0, int y = 0) {
  return fmt::format("<contact localId=\"{}\" {}>{}{}<connectionPointOut/><variable>{}</variable></contact>\n", id,
                     attributes, at(x, y), pointIn(from), name);
}
inline std::string coilElement(int id, const std::vector<std::string>& from, const std::string& name,
                               const std::string& attributes = "", int x = 0, int y = 0) {
  return fmt::format("<coil localId=\"{}\" {}>{}{}<connectionPointOut/><variable>{}</variable></coil>\n", id,
                     attributes, at(x, y), pointIn(from), name);
}
inline std::string inElement(int id, const std::string& expression, const std::string& attributes = "", int x = 0,
                             int y = 0) {
  return fmt::format("<inVariable localId=\"{}\" {}>{}<connectionPointOut/><expression>{}</expression></inVariable>\n",
                     id, attributes, at(x, y), expression);
}
inline std::string outElement(int id, const std::vector<std::string>& from, const std::string& expression,
                              const std::string& attributes = "", int x = 0, int y = 0) {
  return fmt::format("<outVariable localId=\"{}\" {}>{}{}<expression>{}</expression></outVariable>\n", id, attributes,
                     at(x, y), pointIn(from), expression);
}
struct TestPin {
  std::string name;
  std::vector<std::string> from;
  std::string attributes{};
};
inline std::string blockElement(int id, const std::string& type, const std::string& instance,
                                const std::vector<TestPin>& inputs, const std::vector<std::string>& outputs, int x = 0,
                                int y = 0, const std::string& attributes = "") {
  std::string text =
      fmt::format("<block localId=\"{}\" typeName=\"{}\"{} {}>{}<inputVariables>", id, type,
                  instance.empty() ? "" : fmt::format(" instanceName=\"{}\"", instance), attributes, at(x, y));
  for (const TestPin& pin : inputs)
    text +=
        fmt::format("<variable formalParameter=\"{}\" {}>{}</variable>", pin.name, pin.attributes, pointIn(pin.from));
  text += "</inputVariables><inOutVariables/><outputVariables>";
  for (const std::string& name : outputs)
    text += fmt::format("<variable formalParameter=\"{}\"><connectionPointOut/></variable>", name);
  return text + "</outputVariables></block>\n";
}

}  // namespace rungproof
