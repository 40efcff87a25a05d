// How the naive interpreter reads sources: blocks, declarations and their offsets, statements, constants.
#include <cctype>
#include <cmath>
#include <cstring>
#include <sstream>

#include "tests/naive7/machine.hpp"

namespace naive7 {
namespace {

std::string trimmed(const std::string& text) {
  std::size_t a = 0, b = text.size();
  while (a < b && std::isspace(static_cast<unsigned char>(text[a])) != 0) ++a;
  while (b > a && std::isspace(static_cast<unsigned char>(text[b - 1])) != 0) --b;
  return text.substr(a, b - a);
}

std::string squeezed(const std::string& text) {
  std::string out;
  bool isQuoted = false;
  for (char c : text) {
    if (c == '\'') isQuoted = !isQuoted;
    if (isQuoted || std::isspace(static_cast<unsigned char>(c)) == 0) out += c;
  }
  return out;
}

std::vector<std::string> split(const std::string& text, char at, bool isNested = true) {
  std::vector<std::string> parts;
  std::string part;
  int depth = 0;
  bool isQuoted = false;
  for (char c : text) {
    if (c == '\'') isQuoted = !isQuoted;
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (c == at && !isQuoted && (!isNested || depth <= 0)) {
      parts.push_back(part);
      part.clear();
    } else {
      part += c;
    }
  }
  parts.push_back(part);
  return parts;
}

Statement readStatement(std::string text) {
  Statement s;
  text = trimmed(text);
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos && (colon + 1 >= text.size() || text[colon + 1] != '=')) {
    bool isWord = colon > 0;
    for (std::size_t i = 0; i < colon; ++i) {
      if (std::isalnum(static_cast<unsigned char>(text[i])) == 0 && text[i] != '_') isWord = false;
    }
    if (isWord) {
      s.label = text.substr(0, colon);
      text = trimmed(text.substr(colon + 1));
    }
  }
  std::size_t end = 0;
  while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end])) == 0) ++end;
  s.op = text.substr(0, end);
  std::string rest = trimmed(text.substr(end));
  if (s.op == "NOP") {
    s.op += " " + rest;
    return s;
  }
  if (s.op == "CALL") {
    const std::size_t open = rest.find('(');
    if (open != std::string::npos) {
      for (const std::string& pair : split(rest.substr(open + 1, rest.rfind(')') - open - 1), ',')) {
        const std::size_t assign = pair.find(":=");
        if (assign == std::string::npos) continue;
        s.actuals.emplace_back(squeezed(pair.substr(0, assign)), squeezed(pair.substr(assign + 2)));
      }
      rest = rest.substr(0, open);
    }
  }
  s.operand = squeezed(rest);
  return s;
}

void layOut(Block& block, const std::map<std::string, Block>& known) {
  std::uint32_t temp = 0, instance = 0;
  const bool isFb = block.name.starts_with("FB");
  for (Section section : {Section::In, Section::Out, Section::InOut, Section::Static, Section::Temp}) {
    std::uint32_t& at = section == Section::Temp ? temp : instance;
    at = (at + 15) / 16 * 16;
    for (Variable& v : block.variables) {
      if (v.section != section || (!isFb && section != Section::Temp)) continue;
      const int width = widthOfType(v.type);
      if (v.type.starts_with("FB") && known.contains(v.type)) {
        at = (at + 15) / 16 * 16;
        v.bit = at;
        at += known.at(v.type).instanceBytes * 8;
        continue;
      }
      if (width == 1) {
        v.bit = at;
        at += 1;
        continue;
      }
      at = (at + 7) / 8 * 8;
      if (width > 8) at = (at + 15) / 16 * 16;
      v.bit = at;
      at += static_cast<std::uint32_t>(width);
    }
  }
  block.instanceBytes = (instance + 15) / 16 * 2;
}

/// The bytes of a data block that is declared as one array of bytes: b : ARRAY [0 .. 99] OF BYTE.
std::size_t bytesOfArray(const std::string& type) {
  const std::size_t dots = type.find("..");
  if (dots == std::string::npos) return 0;
  return static_cast<std::size_t>(std::atoi(type.c_str() + dots + 2)) + 1;
}

struct SourceReader {
  Program program;
  std::string kind;
  Block block;
  int number = 0;
  bool isCode = false, isDeclared = false;
  Section section = Section::In;
  std::size_t bytes = 0;
  std::string instanceOf;

  void open(const std::string& line, const char* of) {
    std::string rest = squeezed(line.substr(std::strlen(of)));
    rest = rest.substr(0, rest.find(':'));
    kind = of;
    block = Block();
    block.name = rest;
    number = std::atoi(rest.c_str() + 2);
    isCode = isDeclared = false;
    bytes = 0;
    instanceOf.clear();
  }
  void close() {
    if (kind == "DATA_BLOCK") {
      if (!instanceOf.empty())
        bytes = program.blocks.contains(instanceOf) ? program.blocks[instanceOf].instanceBytes : 0;
      program.dataBlocks[number] = std::vector<std::uint8_t>(bytes);
      return;
    }
    layOut(block, program.blocks);
    for (std::size_t i = 0; i < block.statements.size(); ++i) {
      if (!block.statements[i].label.empty()) block.labels[block.statements[i].label] = i;
    }
    program.blocks[block.name] = block;
  }
  void declare(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos) return;
    const std::string type = squeezed(text.substr(colon + 1));
    if (kind == "DATA_BLOCK") {
      bytes = bytesOfArray(type);
      return;
    }
    block.variables.push_back({trimmed(text.substr(0, colon)), type, section, 0});
  }
  /// A line that is no statement and no declaration: true if it was understood.
  bool heading(const std::string& line) {
    for (const char* of : {"ORGANIZATION_BLOCK", "FUNCTION_BLOCK", "DATA_BLOCK", "FUNCTION"}) {
      if (line.starts_with(of)) return open(line, of), true;
    }
    if (line.starts_with("END_VAR") || line.starts_with("STRUCT") || line.starts_with("END_STRUCT") ||
        line.starts_with("VERSION") || line.starts_with("TITLE") || line.starts_with("NETWORK")) {
      isDeclared = false;
      if (line.starts_with("STRUCT")) isDeclared = true;
      return true;
    }
    if (line.starts_with("END_")) return close(), true;
    if (line == "BEGIN") return isCode = true, isDeclared = false, true;
    if (line.starts_with("VAR")) {
      section = line == "VAR_INPUT"    ? Section::In
                : line == "VAR_OUTPUT" ? Section::Out
                : line == "VAR_IN_OUT" ? Section::InOut
                : line == "VAR_TEMP"   ? Section::Temp
                                       : Section::Static;
      return isDeclared = true, true;
    }
    if (kind == "DATA_BLOCK" && !isDeclared && !isCode && line.starts_with("FB")) {
      instanceOf = squeezed(line);
      return true;
    }
    return false;
  }
};

double secondsIn(const std::string& text, double* milliseconds) {
  // 1D_1H_1M_1S_1MS in any selection
  double total = 0;
  std::size_t i = 0;
  while (i < text.size()) {
    if (text[i] == '_') {
      ++i;
      continue;
    }
    double value = 0;
    while (i < text.size() && (std::isdigit(static_cast<unsigned char>(text[i])) != 0)) {
      value = value * 10 + (text[i++] - '0');
    }
    std::string unit;
    while (i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0) {
      unit += static_cast<char>(std::toupper(static_cast<unsigned char>(text[i++])));
    }
    if (unit == "D") total += value * 86400000;
    if (unit == "H") total += value * 3600000;
    if (unit == "M") total += value * 60000;
    if (unit == "S") total += value * 1000;
    if (unit == "MS") total += value;
    if (unit.empty()) break;
  }
  *milliseconds = total;
  return total / 1000;
}

std::uint32_t s5time(double milliseconds) {
  const double bases[] = {10, 100, 1000, 10000};
  for (std::uint32_t code = 0; code < 4; ++code) {
    const auto units = static_cast<std::uint32_t>(milliseconds / bases[code]);
    if (units <= 999) return code << 12 | units / 100 << 8 | units / 10 % 10 << 4 | units % 10;
  }
  return 0x3999;
}

std::uint32_t daysSince1990(int year, int month, int day) {
  const int lengths[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  auto isLeap = [](int y) { return (y % 4 == 0 && y % 100 != 0) || y % 400 == 0; };
  int days = day - 1;
  for (int y = 1990; y < year; ++y) days += isLeap(y) ? 366 : 365;
  for (int m = 1; m < month; ++m) days += lengths[m - 1] + (m == 2 && isLeap(year) ? 1 : 0);
  return static_cast<std::uint32_t>(days);
}

std::uint32_t pointerConstant(const std::string& text) {  // M40.0, 30.0, DBX20.0
  const char* areas[] = {"P", "I", "Q", "M", "DBX", "DIX", "L"};
  std::size_t letters = 0;
  while (letters < text.size() && std::isalpha(static_cast<unsigned char>(text[letters])) != 0) ++letters;
  const std::string area = text.substr(0, letters);
  const std::size_t dot = text.find('.');
  const auto byte = static_cast<std::uint32_t>(std::atoi(text.c_str() + letters));
  const auto bit = static_cast<std::uint32_t>(std::atoi(text.c_str() + dot + 1));
  std::uint32_t pointer = byte * 8 + bit;
  for (std::uint32_t code = 0; code < 7; ++code) {
    if (area == areas[code]) pointer |= 0x80000000U | code << 24;
  }
  return pointer;
}

}  // namespace

int widthOfType(const std::string& type) {
  if (type == "BOOL") return 1;
  if (type == "BYTE" || type == "CHAR") return 8;
  if (type == "WORD" || type == "INT" || type == "S5TIME" || type == "DATE") return 16;
  if (type == "DWORD" || type == "DINT" || type == "REAL" || type == "TIME" || type == "TIME_OF_DAY") return 32;
  if (type == "POINTER") return 48;
  if (type == "ANY") return 80;
  return 0;
}

bool isConstantText(const std::string& text) {
  if (text.empty()) return false;
  const char c = text[0];
  if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '\'' || c == '+') return true;
  return text.find('#') != std::string::npos && c != '#' && text.find('[') == std::string::npos;
}

std::uint32_t constantValue(const std::string& given) {
  std::string text;
  const bool isText = given[0] == '\'';
  for (char c : given) {
    if (isText || c != '_' || given.starts_with("T#") || given.starts_with("S5T#")) text += c;
  }
  if (isText) {
    std::uint32_t value = 0;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) value = value << 8 | static_cast<unsigned char>(text[i]);
    return value;
  }
  const auto after = [&](std::size_t n) { return text.substr(n); };
  if (text.starts_with("P#")) return pointerConstant(after(2));
  if (text.starts_with("L#")) return static_cast<std::uint32_t>(std::atoll(text.c_str() + 2));
  if (text.starts_with("C#")) return static_cast<std::uint32_t>(std::strtoul(text.c_str() + 2, nullptr, 16));
  if (text.starts_with("2#")) return static_cast<std::uint32_t>(std::strtoul(text.c_str() + 2, nullptr, 2));
  for (const char* hex : {"B#16#", "W#16#", "DW#16#"}) {
    if (text.starts_with(hex))
      return static_cast<std::uint32_t>(std::strtoul(text.c_str() + std::strlen(hex), nullptr, 16));
  }
  if (text.starts_with("B#(")) {
    std::uint32_t value = 0;
    std::istringstream in(text.substr(3));
    for (std::string part; std::getline(in, part, ',');) {
      value = value << 8 | static_cast<std::uint32_t>(std::atoi(part.c_str()));
    }
    return value;
  }
  double ms = 0;
  if (text.starts_with("S5T#")) return secondsIn(after(4), &ms), s5time(ms);
  if (text.starts_with("T#")) {
    const bool isNegative = text[2] == '-';
    secondsIn(after(isNegative ? 3 : 2), &ms);
    const auto value = static_cast<std::uint32_t>(static_cast<std::int64_t>(ms));
    return isNegative ? 0 - value : value;
  }
  if (text.starts_with("D#")) {
    int year = 0, month = 0, day = 0;
    std::sscanf(text.c_str() + 2, "%d-%d-%d", &year, &month, &day);
    return daysSince1990(year, month, day);
  }
  if (text.starts_with("TOD#")) {
    int hour = 0, minute = 0;
    double second = 0;
    std::sscanf(text.c_str() + 4, "%d:%d:%lf", &hour, &minute, &second);
    return static_cast<std::uint32_t>((hour * 60 + minute) * 60000 + static_cast<int>(std::lround(second * 1000)));
  }
  if (text.find('.') != std::string::npos) {
    const float real = std::strtof(text.c_str(), nullptr);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &real, 4);
    return bits;
  }
  return static_cast<std::uint32_t>(std::atoi(text.c_str())) & 0xFFFF;
}

Program readProgram(const std::string& text) {
  SourceReader reader;
  std::istringstream in(text);
  std::string pending;
  for (std::string line; std::getline(in, line);) {
    line = line.substr(0, line.find("//"));
    line = trimmed(line);
    if (line.empty()) continue;
    if (trimmed(pending).empty() && reader.heading(line)) continue;
    pending += " " + line;
    // The parentheses of a call's list go over lines; others are statements of their own.
    const bool isList = pending.find("CALL") != std::string::npos;
    std::vector<std::string> parts = split(pending, ';', isList);
    pending = parts.back();
    parts.pop_back();
    for (const std::string& part : parts) {
      if (trimmed(part).empty()) continue;
      if (reader.isCode) {
        if (reader.kind != "DATA_BLOCK") reader.block.statements.push_back(readStatement(part));
      } else {
        reader.declare(part);
      }
    }
  }
  if (!trimmed(pending).empty()) reader.program.errors.push_back("left over: " + pending);
  return reader.program;
}

}  // namespace naive7
