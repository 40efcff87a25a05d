// Reading the lines of an export text.
#include "program_text.hpp"

#include <bit>
#include <sstream>
#include <stdexcept>

namespace rungproof::referee {
namespace {

const std::map<std::string, Area>& areaNames() {
  static const std::map<std::string, Area> names = {
      {"I", Area::I},   {"Q", Area::Q},          {"M", Area::M},         {"V", Area::V}, {"S", Area::S},
      {"SM", Area::SM}, {"AI", Area::AI},        {"T", Area::T},         {"C", Area::C}, {"HC", Area::HC},
      {"AC", Area::AC}, {"INT_", Area::Routine}, {"SBR_", Area::Routine}};
  return names;
}

Operand number(std::int64_t value) {
  Operand o;
  o.area = Area::Number;
  o.value = value;
  return o;
}

const std::map<std::string, Op>& plainNames() {
  static const std::map<std::string, Op> names = {{"NOT", Op::Not},
                                                  {"EU", Op::EdgeUp},
                                                  {"ED", Op::EdgeDown},
                                                  {"=", Op::Assign},
                                                  {"=I", Op::Assign},
                                                  {"S", Op::Set},
                                                  {"R", Op::Reset},
                                                  {"ALD", Op::AndLoad},
                                                  {"OLD", Op::OrLoad},
                                                  {"LPS", Op::Push},
                                                  {"LRD", Op::Top},
                                                  {"LPP", Op::Pop},
                                                  {"CTU", Op::CountUp},
                                                  {"CTD", Op::CountDown},
                                                  {"CTUD", Op::CountUpDown},
                                                  {"TON", Op::OnDelay},
                                                  {"TONR", Op::RetentiveOnDelay},
                                                  {"TOF", Op::OffDelay},
                                                  {"ATCH", Op::Attach},
                                                  {"DTCH", Op::Detach},
                                                  {"CEVNT", Op::ClearEvents},
                                                  {"ENI", Op::Enable},
                                                  {"DISI", Op::Disable},
                                                  {"CRETI", Op::ReturnFromInterrupt},
                                                  {"RCV", Op::Receive},
                                                  {"XMT", Op::Transmit},
                                                  {"NETR", Op::NetRead},
                                                  {"NETW", Op::NetWrite},
                                                  {"HDEF", Op::DefineCounter},
                                                  {"HSC", Op::HighSpeed},
                                                  {"PLS", Op::PulseOutput},
                                                  {"TODR", Op::ReadClock},
                                                  {"END", Op::End},
                                                  {"STOP", Op::Stop},
                                                  {"CALL", Op::Call},
                                                  {"CRET", Op::ReturnIf},
                                                  {"+I", Op::AddInteger},
                                                  {"NOP", Op::Nop}};
  return names;
}

bool readContact(const std::string& name, Instruction& i) {
  static const std::map<std::string, Joint> joints = {{"LD", Joint::Load}, {"A", Joint::And}, {"O", Joint::Or}};
  for (const auto& [prefix, joint] : joints) {
    if (name.compare(0, prefix.size(), prefix) != 0) continue;
    std::string rest = name.substr(prefix.size());
    i.joint = joint;
    i.negated = !rest.empty() && rest[0] == 'N';
    if (i.negated) rest.erase(0, 1);
    i.immediate = rest == "I";
    if (rest.empty() || rest == "I") {
      i.op = Op::Contact;
      return true;
    }
  }
  return false;
}

bool readComparison(const std::string& name, Instruction& i) {
  static const std::map<std::string, Relation> relations = {{"=", Relation::Equal},   {"<>", Relation::NotEqual},
                                                            {"<", Relation::Less},    {"<=", Relation::LessEqual},
                                                            {">", Relation::Greater}, {">=", Relation::GreaterEqual}};
  const std::size_t at = name.find_first_of("=<>");
  if (at == std::string::npos || at < 2) return false;
  const std::string head = name.substr(0, at - 1);
  i.width = name[at - 1];
  i.relation = relations.at(name.substr(at));
  if (head != "LD" && head != "A" && head != "O") return false;
  i.joint = head == "LD" ? Joint::Load : head == "A" ? Joint::And : Joint::Or;
  i.op = Op::Compare;
  return true;
}

Instruction instructionOf(const std::string& line) {
  Instruction i;
  i.text = line;
  std::istringstream words(line);
  std::string name;
  std::string operands;
  words >> name;
  std::getline(words, operands);
  std::istringstream list(operands);
  std::string one;
  for (Operand* to : {&i.a, &i.b}) {
    if (!std::getline(list, one, ',')) break;
    const std::size_t first = one.find_first_not_of(' ');
    if (first != std::string::npos) *to = operandOf(one.substr(first, one.find_last_not_of(' ') - first + 1));
  }
  if (const auto plain = plainNames().find(name); plain != plainNames().end()) {
    i.op = plain->second;
    i.immediate = name == "=I";
    return i;
  }
  if (readComparison(name, i) || readContact(name, i)) return i;
  const std::string stem = name.substr(0, 3);
  if (name.size() == 4 && (stem == "MOV" || stem == "INC" || stem == "DEC")) {
    i.op = stem == "MOV" ? Op::Move : stem == "INC" ? Op::Increment : Op::Decrement;
    i.width = name[3];
    return i;
  }
  throw std::invalid_argument("the referee does not know " + line);
}

void notePool(const Instruction& i, std::vector<int>& pool) {
  for (const Operand* o : {&i.a, &i.b}) {
    if (o->area == Area::Number && o->value >= 0 && o->value < 256) pool.push_back(static_cast<int>(o->value));
  }
}

}  // namespace

Operand operandOf(const std::string& text) {
  if (text.empty()) throw std::invalid_argument("an operand is missing");
  if (text.compare(0, 3, "16#") == 0) return number(std::stoll(text.substr(3), nullptr, 16));
  if (text[0] == '&') return number(0x08000000 + operandOf(text.substr(1)).offset);
  if (std::string("+-0123456789").find(text[0]) != std::string::npos) {
    if (text.find('.') == std::string::npos) return number(std::stoll(text));
    return number(std::bit_cast<std::uint32_t>(std::stof(text)));
  }
  std::size_t digits = text.find_first_of("0123456789");
  if (digits == std::string::npos) throw std::invalid_argument("the referee does not know the operand " + text);
  std::string area = text.substr(0, digits);
  Operand o;
  if (areaNames().count(area) == 0 || area == "AI") {
    const char width = area.back();
    o.bytes = width == 'B' ? 1 : width == 'W' ? 2 : width == 'D' ? 4 : 0;
    area.pop_back();
  }
  const auto known = areaNames().find(area);
  if (known == areaNames().end()) throw std::invalid_argument("the referee does not know the operand " + text);
  o.area = known->second;
  std::size_t used = 0;
  o.offset = std::stoi(text.substr(digits), &used);
  if (digits + used < text.size() && text[digits + used] == '.') o.bit = text[digits + used + 1] - '0';
  return o;
}

Program programOf(const std::string& text) {
  Program program;
  std::vector<Instruction>* block = nullptr;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, 3, "//@") == 0) {
      program.properties.push_back(line.substr(3));
      continue;
    }
    if (line.empty() || line == "BEGIN" || line.compare(0, 7, "Network") == 0 || line.compare(0, 4, "END_") == 0)
      continue;
    const std::size_t colon = line.find(':');
    if (line.compare(0, 18, "ORGANIZATION_BLOCK") == 0) {
      block = &program.main;
    } else if (line.compare(0, 15, "INTERRUPT_BLOCK") == 0) {
      block = &program.interrupts[std::stoi(line.substr(colon + 4))];
    } else if (line.compare(0, 16, "SUBROUTINE_BLOCK") == 0) {
      block = &program.subroutines[std::stoi(line.substr(colon + 4))];
    } else if (block != nullptr) {
      block->push_back(instructionOf(line));
      Instruction& i = block->back();
      const bool remembers = i.op == Op::EdgeUp || i.op == Op::EdgeDown;
      if (remembers) i.edge = program.edges++;
      notePool(i, program.pool);
    }
  }
  if (program.pool.empty()) program.pool.push_back(1);
  return program;
}

}  // namespace rungproof::referee
