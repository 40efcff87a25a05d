// Reading of the table of stated cases.
#include "tests/naive7/case_table.hpp"

#include <cstring>
#include <fstream>
#include <sstream>

namespace naive7 {
namespace {

std::vector<std::string> pieces(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

bool isDecimal(const std::string& key) { return key == "DB" || key == "DI"; }

std::uint32_t valueOf(const std::string& key, const std::string& text) {
  if (text[0] == 'r') {
    const float real = std::strtof(text.c_str() + 1, nullptr);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &real, 4);
    return bits;
  }
  return static_cast<std::uint32_t>(std::strtoul(text.c_str(), nullptr, isDecimal(key) ? 10 : 16));
}

bool isRegister(const std::string& key) {
  return key == "1" || key == "2" || key == "3" || key == "4" || key == "AR1" || key == "AR2" || isDecimal(key);
}

/// "IN a:INT;OUT y:INT" as the sections of a declaration.
std::string sections(const std::string& list) {
  static const std::map<std::string, std::string> keywords = {
      {"IN", "VAR_INPUT"}, {"OUT", "VAR_OUTPUT"}, {"IN_OUT", "VAR_IN_OUT"}, {"STAT", "VAR"}, {"TEMP", "VAR_TEMP"}};
  std::string text;
  for (const char* wanted : {"IN", "OUT", "IN_OUT", "STAT", "TEMP"}) {
    std::string inside;
    for (const std::string& one : pieces(list, ';')) {
      const std::size_t blank = one.find(' '), colon = one.find(':');
      if (one.substr(0, blank) != wanted) continue;
      inside += "  " + one.substr(blank + 1, colon - blank - 1) + " : " + one.substr(colon + 1) + " ;\n";
    }
    if (!inside.empty()) text += keywords.at(wanted) + "\n" + inside + "END_VAR\n";
  }
  return text;
}

std::string statementLines(const std::string& list) {
  std::string text;
  for (const std::string& one : pieces(list, ';')) text += "  " + one + " ;\n";
  return text;
}

std::string bytesBlock(int number, int bytes) {
  return "DATA_BLOCK DB " + std::to_string(number) + "\nSTRUCT\n  b : ARRAY [0 .. " + std::to_string(bytes - 1) +
         "] OF BYTE ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n";
}

/// Takes FC1(..){..}; FB1(..){..}; DB3:FB1; off the front of the program.
std::string takeBlocks(std::string rest, std::string& blocks) {
  for (;;) {
    const bool isFc = rest.starts_with("FC") && rest.find('{') != std::string::npos;
    const bool isFb = rest.starts_with("FB") && rest.find('{') != std::string::npos;
    if (isFc || isFb) {
      const std::size_t open = rest.find('{'), close = rest.find('}'), bracket = rest.find('(');
      const std::size_t nameEnd = bracket < open ? bracket : open;
      const std::string number = rest.substr(2, nameEnd - 2);
      std::string list;
      if (bracket < open) list = rest.substr(bracket + 1, open - bracket - 2);
      blocks += (isFc ? "FUNCTION FC " + number + " : VOID\n" : "FUNCTION_BLOCK FB " + number + "\n") + sections(list) +
                "BEGIN\nNETWORK\n" + statementLines(rest.substr(open + 1, close - open - 1)) +
                (isFc ? "END_FUNCTION\n" : "END_FUNCTION_BLOCK\n");
      rest = rest.substr(close + 2);
      continue;
    }
    const std::size_t colon = rest.find(":FB");
    if (rest.starts_with("DB") && colon != std::string::npos && colon < rest.find(' ') && colon < rest.find(';')) {
      const std::size_t end = rest.find(';');
      blocks += "DATA_BLOCK DB " + rest.substr(2, colon - 2) + "\nFB " + rest.substr(colon + 3, end - colon - 3) +
                "\nBEGIN\nEND_DATA_BLOCK\n";
      rest = rest.substr(end + 1);
      continue;
    }
    return rest;
  }
}

}  // namespace

std::string organizationBlock(const std::string& statements) {
  return "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n  start : ARRAY [0 .. 19] OF BYTE ;\n  own : ARRAY [0 .. 43] OF BYTE ;\n"
         "END_VAR\nBEGIN\nNETWORK\n" +
         statements + "END_ORGANIZATION_BLOCK\n";
}

std::vector<Case> readCases(const std::string& path) {
  std::vector<Case> cases;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> columns = pieces(line, '\t');
    Case c;
    if (columns.size() != 5) {
      c.text = line;
      cases.push_back(c);
      continue;
    }
    c.row = columns[0];
    c.number = columns[1];
    c.text = columns[2];
    c.regs = {{"1", 0x11111111}, {"2", 0x22222222}, {"3", 0x33333333}, {"4", 0x44444444},
              {"AR1", 0x10},     {"AR2", 0x20},     {"DB", 1},         {"DI", 2}};
    const std::vector<std::string> before = pieces(columns[3], ' '), after = pieces(columns[4], ' ');
    c.status = before[0];
    c.statusAfter = after[0];
    for (std::size_t i = 1; i < before.size(); ++i) {
      const std::size_t equals = before[i].find('=');
      const std::string key = before[i].substr(0, equals), value = before[i].substr(equals + 1);
      if (key == "cpu") {
        c.is400 = value == "400";
      } else if (isRegister(key)) {
        c.regs[key] = valueOf(key, value);
      } else if (!key.empty()) {
        c.bytes.emplace_back(key, valueOf(key, value));
      }
    }
    c.regsAfter = c.regs;
    for (std::size_t i = 1; i < after.size(); ++i) {
      const std::size_t equals = after[i].find('=');
      const std::string key = after[i].substr(0, equals), value = after[i].substr(equals + 1);
      if (key == "STOP") {
        c.stop = static_cast<int>(valueOf(key, value));
      } else if (value == "??") {
        c.openRegs.push_back(key);
      } else if (isRegister(key)) {
        c.regsAfter[key] = valueOf(key, value);
      } else if (!key.empty()) {
        c.bytesAfter.emplace_back(key, valueOf(key, value));
      }
    }
    c.blocks = bytesBlock(1, 100) + bytesBlock(2, 20);
    const std::vector<std::string> parts = pieces(takeBlocks(c.text, c.blocks), '|');
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i % 2 == 0) {
        c.scans.push_back(statementLines(parts[i].find('@') == std::string::npos ? "@;" + parts[i] : parts[i]));
      } else {
        c.pauses.push_back(std::atoi(parts[i].c_str()));
      }
    }
    cases.push_back(c);
  }
  return cases;
}

}  // namespace naive7
