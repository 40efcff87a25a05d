// The tools and their parameters.
#include <array>

#include "frontend/assistant/tool.hpp"
#include "frontend/settings/options.hpp"

namespace rungproof {

namespace {

constexpr ToolParameter programText = {
    "program", ParameterKind::Text, ParameterUse::Program, "",
    "the program as text: STL (AWL) export, SCL, structured text, PLCopen XML or SimaticML"};
constexpr ToolParameter programPath = {"path", ParameterKind::Text, ParameterUse::Path, "",
                                       "instead of 'program': a file, or the folder of a project"};
constexpr ToolParameter symbolText = {"symbols", ParameterKind::Text, ParameterUse::HeldFile, "--symbols=symbols.csv",
                                      "symbol table as text: name,address,comment a line"};
constexpr ToolParameter cpuOption = {
    "cpu", ParameterKind::Text, ParameterUse::Option, "--cpu",
    "CPU: 221 222 224 224XP 226 226XM 212 214, CR20s ... ST60, 319-3 and others of the S7-300/400"};
constexpr ToolParameter scanTimeOption = {"scan_time", ParameterKind::Text, ParameterUse::Option, "--scan-time",
                                          "length of a scan: 10ms or 5ms..20ms"};

constexpr std::array lintParameters = {
    programText,
    programPath,
    symbolText,
    cpuOption,
    ToolParameter{"prove", ParameterKind::Truth, ParameterUse::Option, "--prove",
                  "also the rules that need the prover; slower"},
    ToolParameter{"select", ParameterKind::Text, ParameterUse::Option, "--select",
                  "only these rules: codes or beginnings of codes, with commas"},
    ToolParameter{"ignore", ParameterKind::Text, ParameterUse::Option, "--ignore", "not these rules"},
};
constexpr std::array checkParameters = {programText, programPath, symbolText, cpuOption,
                                        ToolParameter{"language", ParameterKind::Text, ParameterUse::Option,
                                                      "--language", "view that must show the networks", "ladder|stl"}};
constexpr std::array proveParameters = {
    programText,
    programPath,
    symbolText,
    cpuOption,
    scanTimeOption,
    ToolParameter{"properties", ParameterKind::Text, ParameterUse::HeldFile, "--props=properties.prop",
                  "one a line, beside those in //@ comments: 'prove NAME: never Q0.0 and Q0.1', 'reach NAME: Q0.0', "
                  "'prove NAME: I0.0 leads to Q0.0 within 500ms', 'assume NAME: not I0.7'"},
    ToolParameter{"only", ParameterKind::Text, ParameterUse::Option, "--only",
                  "names of the properties to prove; * and ? stand for characters"},
    ToolParameter{"builtin", ParameterKind::Truth, ParameterUse::Option, "--builtin",
                  "also set/reset conflicts, ranges, timers, division, loops"},
    ToolParameter{"timeout", ParameterKind::Text, ParameterUse::Option, "--timeout",
                  "longest time for one property: 30s"},
};
constexpr std::array simParameters = {
    programText,
    programPath,
    symbolText,
    cpuOption,
    scanTimeOption,
    ToolParameter{"stimulus", ParameterKind::Text, ParameterUse::HeldFile, "--stimulus=stimulus.csv",
                  "CSV: the first column is 'scan' (from 1) or 'time_ms', the others are inputs"},
    ToolParameter{"expected", ParameterKind::Text, ParameterUse::HeldFile, "--expect=expected.csv",
                  "CSV of the values as they should be"},
    ToolParameter{"scans", ParameterKind::Number, ParameterUse::Option, "--scans", "how many scans to run"},
    ToolParameter{"signals", ParameterKind::Text, ParameterUse::Option, "--signals",
                  "what to trace, with commas; all that the program touches"},
};
constexpr std::array testParameters = {
    programText,
    programPath,
    symbolText,
    cpuOption,
    scanTimeOption,
    ToolParameter{
        "table", ParameterKind::Text, ParameterUse::HeldFile, "--table=table.test.csv",
        "CSV with the columns test, step, wait ('1 scan', '500ms'), 'set ADDRESS', 'expect ADDRESS'; a new name "
        "in 'test' begins with power-on; a row sets, waits and compares"},
    ToolParameter{"coverage", ParameterKind::Truth, ParameterUse::Option, "--coverage",
                  "also measure networks, contacts, transitions and MC/DC pairs"},
    ToolParameter{"kill", ParameterKind::Truth, ParameterUse::Option, "--kill",
                  "also plant faults and say which of them the tests notice; slower"},
    ToolParameter{"show", ParameterKind::Text, ParameterUse::Option, "--show",
                  "draw the networks behind a failing value", "ladder|fbd|stl"},
};
constexpr std::array showParameters = {
    programText,
    programPath,
    symbolText,
    cpuOption,
    ToolParameter{"as", ParameterKind::Text, ParameterUse::Option, "--as", "form of the drawing", "lad|fbd|stl"},
    ToolParameter{"network", ParameterKind::Text, ParameterUse::Option, "--network", "only these networks: 3 or 2-5"},
    ToolParameter{"pou", ParameterKind::Text, ParameterUse::Option, "--pou", "only this block"}};
constexpr std::array explainParameters = {
    ToolParameter{"topic", ParameterKind::Text, ParameterUse::Argument, "",
                  "a code (STK002), an instruction (TON), an address (T37, SM0.1), a verdict"},
    cpuOption};
constexpr std::array xrefParameters = {programText, programPath, symbolText, cpuOption,
                                       ToolParameter{"address", ParameterKind::Text, ParameterUse::Argument, "",
                                                     "an address or a symbol; without it everything is listed"}};

constexpr std::array<Tool, 8> tools = {{
    {"lint", "Check a PLC program",
     "Findings of the static rules for the family of the program, with place, reason and help.", "human", "json",
     lintParameters},
    {"check", "Would the editor take it?",
     "Says of each network whether the editor of its controller takes it, or why not.", "text", "json",
     checkParameters},
    {"prove", "Prove properties",
     "Proves declared properties for every run, or shows the shortest run found that breaks one, repeated by the "
     "reference engine.",
     "human", "json", proveParameters},
    {"sim", "Run a program", "Runs the program on the reference engine and gives the trace; compares it if wanted.",
     "human", "json", simParameters},
    {"test", "Run a test table",
     "Runs a table of test steps on the reference engine: what failed where, what the tests cover, which planted "
     "faults "
     "they notice.",
     "human", "json", testParameters},
    {"show", "Draw networks", "Draws networks as ladder, function block diagram or statement list, as text.", "text",
     "", showParameters},
    {"explain", "Explain a term", "The page of a rule, an instruction, an address, a verdict or a method.", "text",
     "json", explainParameters, false},
    {"xref", "Cross reference", "Who reads and who writes each address, overlaps and free areas.", "text", "json",
     xrefParameters},
}};

std::string_view schemaType(ParameterKind kind) {
  return kind == ParameterKind::Text ? "string" : kind == ParameterKind::Number ? "integer" : "boolean";
}

}  // namespace

std::span<const Tool> allTools() { return tools; }

const Tool* toolNamed(std::string_view name) {
  for (const Tool& tool : tools) {
    if (tool.name == name) return &tool;
  }
  return nullptr;
}

Json toolJson(const Tool& tool) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const ToolParameter& parameter : tool.parameters) {
    Json schema{{"type", schemaType(parameter.kind)}, {"description", parameter.description}};
    if (!parameter.values.empty()) schema["enum"] = Json(permittedWords(parameter.values));
    properties[parameter.name] = std::move(schema);
    if (!tool.needsProgram && parameter.use == ParameterUse::Argument) required.push_back(parameter.name);
  }
  Json input{{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
  if (!required.empty()) input["required"] = std::move(required);
  Json json{{"name", tool.name},
            {"title", tool.title},
            {"description", tool.description},
            {"inputSchema", std::move(input)},
            {"annotations", Json{{"readOnlyHint", true}, {"openWorldHint", false}}}};
  return json;
}

}  // namespace rungproof
