// The naive interpreter: signatures, memory, pointers and ranges (001:1459-1478).
#include <map>

#include "naive.hpp"

namespace rungproof::naive {

namespace {

/// Bytes of each area of a CPU 226 (table 6-2); T and C: numbers.
std::uint32_t sizeOf(Area area) {
  switch (area) {
    case Area::V: return 10240;
    case Area::I:
    case Area::Q: return 16;
    case Area::M:
    case Area::S: return 32;
    case Area::SM: return 550;
    case Area::T:
    case Area::C: return 256;
    default: return 64;  // L, AI, AQ
  }
}
bool isNumbered(Area area) { return area == Area::T || area == Area::C; }

int bytesOf(char letter) {
  switch (letter) {
    case 'w':
    case 'W':
    case 'q':
    case 't':
    case 'f': return 2;
    case 'd':
    case 'D':
    case 'r':
    case 'R':
    case 'm': return 4;
    default: return 1;
  }
}

/// Area of the number in the highest byte of a pointer. The manual leaves the form open; it is that of MOVD &.
std::optional<Area> areaOfTag(std::uint32_t tag) {
  static const std::map<std::uint32_t, Area> areas = {{0, Area::I}, {1, Area::Q},  {2, Area::AI}, {3, Area::AQ},
                                                      {4, Area::M}, {5, Area::SM}, {6, Area::S},  {8, Area::V},
                                                      {9, Area::T}, {10, Area::C}};
  const auto found = areas.find(tag);
  return found == areas.end() ? std::nullopt : std::optional(found->second);
}

std::map<std::string, std::string_view> allSignatures() {
  std::map<std::string, std::string_view> all = {{"LDI", "x"},        {"LDNI", "x"},       {"AI", "x"},
                                                 {"ANI", "x"},        {"OI", "x"},         {"ONI", "x"},
                                                 {"LD", "x"},         {"LDN", "x"},        {"A", "x"},
                                                 {"AN", "x"},         {"O", "x"},          {"ON", "x"},
                                                 {"NOT", ""},         {"EU", ""},          {"ED", ""},
                                                 {"NOP", "k"},        {"=", "X"},          {"=I", "X"},
                                                 {"S", "Xb"},         {"R", "Xb"},         {"SI", "Xb"},
                                                 {"RI", "Xb"},        {"ALD", ""},         {"OLD", ""},
                                                 {"LPS", ""},         {"LRD", ""},         {"LPP", ""},
                                                 {"LDS", "k"},        {"AENO", ""},        {"SR", "X"},
                                                 {"RS", "X"},         {"TODR", "p"},       {"TODW", "p"},
                                                 {"TODRX", "p"},      {"TODWX", "p"},      {"GPA", "Bk"},
                                                 {"SPA", "bk"},       {"BTI", "bW"},       {"ITB", "wB"},
                                                 {"ITD", "wD"},       {"DTI", "dW"},       {"DTR", "dR"},
                                                 {"ROUND", "rD"},     {"TRUNC", "rD"},     {"BCDI", "W"},
                                                 {"IBCD", "W"},       {"SEG", "bB"},       {"ENCO", "wB"},
                                                 {"DECO", "bW"},      {"ATH", "ppb"},      {"HTA", "ppb"},
                                                 {"ITA", "wpb"},      {"DTA", "dpb"},      {"RTA", "rpb"},
                                                 {"ITS", "wbS"},      {"DTS", "dbS"},      {"RTS", "rbS"},
                                                 {"STI", "sbW"},      {"STD", "sbD"},      {"STR", "sbR"},
                                                 {"CTU", "kw"},       {"CTD", "kw"},       {"CTUD", "kw"},
                                                 {"CTU.IEC", "kwXW"}, {"CTD.IEC", "kwXW"}, {"CTUD.IEC", "kwXXW"},
                                                 {"+I", "wW"},        {"-I", "wW"},        {"*I", "wW"},
                                                 {"/I", "wW"},        {"+D", "dD"},        {"-D", "dD"},
                                                 {"*D", "dD"},        {"/D", "dD"},        {"MUL", "wD"},
                                                 {"DIV", "wD"},       {"+R", "rR"},        {"-R", "rR"},
                                                 {"*R", "rR"},        {"/R", "rR"},        {"SQRT", "rR"},
                                                 {"SIN", "rR"},       {"COS", "rR"},       {"TAN", "rR"},
                                                 {"LN", "rR"},        {"EXP", "rR"},       {"INCB", "B"},
                                                 {"INCW", "W"},       {"INCD", "D"},       {"DECB", "B"},
                                                 {"DECW", "W"},       {"DECD", "D"},       {"PID", "pk"},
                                                 {"ENI", ""},         {"DISI", ""},        {"ATCH", "kk"},
                                                 {"DTCH", "k"},       {"CEVNT", "k"},      {"INVB", "B"},
                                                 {"INVW", "W"},       {"INVD", "D"},       {"ANDB", "bB"},
                                                 {"ANDW", "wW"},      {"ANDD", "dD"},      {"ORB", "bB"},
                                                 {"ORW", "wW"},       {"ORD", "dD"},       {"XORB", "bB"},
                                                 {"XORW", "wW"},      {"XORD", "dD"},      {"MOVB", "bB"},
                                                 {"MOVW", "wW"},      {"MOVD", "dD"},      {"MOVR", "rR"},
                                                 {"BIR", "bB"},       {"BIW", "bB"},       {"BMB", "ppb"},
                                                 {"BMW", "qqb"},      {"BMD", "mmb"},      {"SWAP", "W"},
                                                 {"END", ""},         {"MEND", ""},        {"STOP", ""},
                                                 {"WDR", ""},         {"FOR", "Www"},      {"NEXT", ""},
                                                 {"JMP", "k"},        {"LBL", "k"},        {"LSCR", "k"},
                                                 {"SCRT", "k"},       {"CSCRE", ""},       {"SCRE", ""},
                                                 {"DLED", "b"},       {"SHRB", "xXb"},     {"SLEN", "sB"},
                                                 {"SCPY", "sS"},      {"SCAT", "sS"},      {"SSCPY", "sbbS"},
                                                 {"SFND", "ssB"},     {"CFND", "ssB"},     {"ATT", "wt"},
                                                 {"LIFO", "tW"},      {"FIFO", "tW"},      {"FILL", "wqb"},
                                                 {"FND=", "fwW"},     {"FND<>", "fwW"},    {"FND<", "fwW"},
                                                 {"FND>", "fwW"},     {"TON", "kw"},       {"TOF", "kw"},
                                                 {"TONR", "kw"},      {"TON.IEC", "kwXW"}, {"TOF.IEC", "kwXW"},
                                                 {"TP.IEC", "kwXW"},  {"BITIM", "D"},      {"CITIM", "dD"},
                                                 {"CALL", "k"},       {"CRET", ""},        {"RET", ""}};
  // Of the S7-200 SMART.
  for (const char* logic : {"NAND", "NOR", "NXOR"}) {
    all[std::string(logic) + "B"] = "bB";
    all[std::string(logic) + "W"] = "wW";
    all[std::string(logic) + "D"] = "dD";
  }
  all["BCDDI"] = all["DIBCD"] = "D";
  all["ABSI"] = "wW";
  all["ABSDI"] = "dD";
  all["ABSR"] = all["ARCSIN"] = all["ARCCOS"] = all["ARCTAN"] = "rR";
  for (const char* shift : {"SL", "SR", "RL", "RR"}) {
    all[std::string(shift) + "B"] = "Bb";
    all[std::string(shift) + "W"] = "Wb";
    all[std::string(shift) + "D"] = "Db";
  }
  for (const char* joint : {"LD", "A", "O"}) {
    for (const char* relation : {"=", "<>", "<", "<=", ">", ">="}) {
      for (const auto& [type, operands] :
           std::map<std::string, std::string_view>{{"B", "bb"}, {"W", "ww"}, {"D", "dd"}, {"R", "rr"}}) {
        all[joint + type + relation] = operands;
      }
    }
    all[std::string(joint) + "S="] = all[std::string(joint) + "S<>"] = "sS";
  }
  return all;
}

}  // namespace

std::optional<std::string_view> signatureOf(const std::string& mnemonic) {
  static const auto all = allSignatures();
  const auto found = all.find(mnemonic);
  return found == all.end() ? std::nullopt : std::optional(found->second);
}

/// Follows the pointers of an instruction; false if one of them does not lead to a whole element of that width.
bool Interpreter::follow(const Instruction& i, std::string_view signature) {
  followed_.clear();
  bool legal = true;
  for (std::size_t k = 0; k < i.operands.size() && k < signature.size(); ++k) {
    const Operand& o = i.operands[k];
    if (o.kind != OperandKind::Indirect) continue;
    Operand holder = o;
    holder.kind = OperandKind::Direct;
    const std::uint32_t pointer = read(holder, 4);
    const std::optional<Area> area = areaOfTag(pointer >> 24);
    std::uint32_t offset = pointer & 0xFFFFFF;
    const auto bytes = static_cast<std::uint32_t>(bytesOf(signature[k]));
    bool good = area.has_value();
    if (good && isNumbered(*area)) {  // the step from one current value to the next is 2 (001:1478)
      good = bytes == 2 && offset % 2 == 0 && offset / 2 < sizeOf(*area);
      offset /= 2;
    } else if (good) {
      const bool analog = *area == Area::AI || *area == Area::AQ;
      good = offset + bytes <= sizeOf(*area) && (!analog || (bytes == 2 && offset % 2 == 0));
    }
    if (good) followed_[&o] = {*area, offset};
    legal = legal && good;
  }
  return legal;
}

Interpreter::Place Interpreter::placeOf(const Operand& o) const {
  const auto found = followed_.find(&o);
  return found == followed_.end() ? Place{o.area, o.offset} : found->second;
}

bool Interpreter::fits(const Operand& o, int count, int bytes) const {
  if (o.kind == OperandKind::Text) return true;
  const Place place = placeOf(o);
  const std::uint32_t size = sizeOf(place.area);
  const std::uint32_t step = isNumbered(place.area) ? 1 : static_cast<std::uint32_t>(bytes);
  return place.offset + static_cast<std::uint32_t>(count) * step <= size;
}

std::optional<std::string> Interpreter::stringAt(const Operand& o) {
  if (o.kind == OperandKind::Text) return o.text;
  const int length = static_cast<int>(read(o, 1));
  if (length > 254 || !fits(o, length + 1, 1)) return std::nullopt;
  std::string text;
  for (int k = 1; k <= length; ++k) text += static_cast<char>(read(o, 1, k));
  return text;
}

std::uint32_t Interpreter::read(const Operand& o, int bytes, int element) {
  const std::uint32_t mask = bytes == 4 ? 0xFFFFFFFFU : (1U << bytes * 8) - 1;
  if (o.kind == OperandKind::Constant) return static_cast<std::uint32_t>(o.value) & mask;
  if (o.kind == OperandKind::Text) {
    const auto at = static_cast<std::size_t>(element);
    return at == 0               ? static_cast<std::uint32_t>(o.text.size())
           : at <= o.text.size() ? static_cast<std::uint8_t>(o.text[at - 1])
                                 : 0;
  }
  if (o.kind == OperandKind::Address) {
    for (std::uint32_t tag = 0; tag < 16; ++tag) {
      if (areaOfTag(tag) == o.area) return tag << 24 | (isNumbered(o.area) ? 2 * o.offset : o.offset);
    }
  }
  const Place place = placeOf(o);
  const auto n = static_cast<std::uint32_t>(element);
  if (place.area == Area::T) return static_cast<std::uint16_t>(timer[place.offset + n]);
  if (place.area == Area::C) return static_cast<std::uint16_t>(counter[place.offset + n]);
  if (place.area == Area::AC) return accumulator[place.offset] & mask;
  if (place.area == Area::HC) return highSpeed[place.offset];
  std::uint32_t value = 0;
  for (int k = 0; k < bytes; ++k)
    value = value << 8 | memory[place.area][place.offset + static_cast<std::uint32_t>(element * bytes + k)];
  return value;
}

void Interpreter::write(const Operand& o, int bytes, std::uint32_t value, int element) {
  const Place place = placeOf(o);
  const auto n = static_cast<std::uint32_t>(element);
  if (place.area == Area::T) {
    timer[place.offset + n] = static_cast<std::int16_t>(value);
  } else if (place.area == Area::C) {
    counter[place.offset + n] = static_cast<std::int16_t>(value);
  } else if (place.area == Area::AC) {
    const std::uint32_t mask = bytes == 4 ? 0xFFFFFFFFU : (1U << bytes * 8) - 1;
    accumulator[place.offset] = (accumulator[place.offset] & ~mask) | (value & mask);
  } else {
    for (int k = bytes - 1; k >= 0; --k) {
      memory[place.area][place.offset + static_cast<std::uint32_t>(element * bytes + k)] =
          static_cast<std::uint8_t>(value);
      value >>= 8;
    }
  }
}

bool Interpreter::bitAt(Area area, std::uint32_t byte, unsigned bit) const {
  return (memory.at(area)[byte] >> bit & 1) != 0;
}
void Interpreter::putBit(Area area, std::uint32_t byte, unsigned bit, bool value) {
  std::uint8_t& cell = memory[area][byte];
  cell = static_cast<std::uint8_t>(value ? cell | 1U << bit : cell & ~(1U << bit));
}
bool Interpreter::readBit(const Operand& o) {
  if (o.area == Area::T) return timerBit[o.offset];
  if (o.area == Area::C) return counterBit[o.offset];
  return bitAt(o.area, o.offset, o.bit);
}
void Interpreter::writeBit(const Operand& o, bool value) {
  if (o.area == Area::T)
    timerBit[o.offset] = value;
  else if (o.area == Area::C)
    counterBit[o.offset] = value;
  else
    putBit(o.area, o.offset, o.bit, value);
}

/// An error that lets the program go on: the box has no ENO; codes of Table C-2 set SM4.3 (001:2347).
bool Interpreter::fail(std::string_view code) {
  errors.emplace_back(code);
  eno = false;
  if (!code.empty() && !code.starts_with("SM")) putBit(Area::SM, 4, 3, true);
  return true;
}
/// An error of Table C-1: the CPU stops, the contact has no result. No ENO is printed for contacts; the engine drops it
/// with every error.
bool Interpreter::fatal(std::string_view code) {
  errors.emplace_back(code);
  eno = false;
  stopped = true;
  return true;
}

}  // namespace rungproof::naive
