// Every descriptor against the manual's tables: the quick reference (names, groups, numbers of operands, times,
// editions) and the operand tables of chapter 6 (directions, types, areas, ranges of constants), row by row.
#include "ir/s7200/call_parameters.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "tsv.hpp"

namespace rungproof::tables {
namespace {

constexpr Cpu tabledCpus[] = {s7200Cpu("221"), s7200Cpu("222"), s7200Cpu("224"), s7200Cpu("224XP"), s7200Cpu("226")};

/// A row of the operand tables without its pins that a statement does not write.
struct OperandRow {
  std::string instruction, operand, direction, type, areas, source;
};

/// Rows of single instructions and operands. Box pins (@LAD, @FBD) are left out unless the instruction exists in
/// drawings only, inputs on the stack (@STACK0, power flow) always.
std::vector<OperandRow> operandRows() {
  std::vector<OperandRow> rows;
  for (const char* file : {"operands-a.tsv", "operands-b.tsv"}) {
    for (const Row& row : read(file)) {
      for (std::string instruction : split(row.at("instruction"), ',')) {
        if (instruction == "*") continue;
        if (const std::size_t colon = instruction.find(":IEC"); colon != std::string::npos)
          instruction.replace(colon, 4, ".IEC");
        const Desc* desc = s7200Instructions().named(instruction);
        EXPECT_NE(desc, nullptr) << instruction;
        if (desc == nullptr) continue;
        for (std::string operand : split(row.at("operand"), ',')) {
          const std::size_t at = operand.find('@');
          const bool boxPin = at != std::string::npos;
          if (boxPin && (!desc->drawingOnly || operand.substr(at) != "@LAD")) continue;
          if (boxPin) operand.erase(at);
          const bool boxInput = desc->drawingOnly && (row.at("areas").find("powerflow") != std::string::npos);
          if (boxInput) continue;
          rows.push_back(
              {instruction, operand, row.at("direction"), row.at("type"), row.at("areas"), row.at("source")});
        }
      }
    }
  }
  return rows;
}

std::string withoutBrackets(const std::string& text) { return text.substr(0, text.find('[')); }
std::string brackets(const std::string& text) {
  const std::size_t open = text.find('[');
  return open == std::string::npos ? std::string() : text.substr(open + 1, text.rfind(']') - open - 1);
}

/// Areas are separated by commas outside brackets.
std::vector<std::string> areasOf(const std::string& cell) {
  std::vector<std::string> areas;
  std::string area;
  int depth = 0;
  for (const char c : cell) {
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == ',' && depth == 0) {
      areas.push_back(area);
      area.clear();
    } else {
      area += c;
    }
  }
  areas.push_back(area);
  return areas;
}

struct AreaName {
  Forms form;
  Width width;  ///< told by the last letter; Bit if there is none
};
std::optional<AreaName> areaNamed(const std::string& name) {
  static const std::map<std::string, Forms> plain = {
      {"T", form::T},      {"C", form::C},      {"AC", form::AC},     {"HC", form::HC},
      {"*VD", form::PtrV}, {"*LD", form::PtrL}, {"*AC", form::PtrAC}, {"constant", form::Const}};
  static const std::map<std::string, Forms> lettered = {{"I", form::I}, {"Q", form::Q},   {"V", form::V},
                                                        {"M", form::M}, {"SM", form::SM}, {"S", form::S},
                                                        {"L", form::L}, {"AI", form::AI}, {"AQ", form::AQ}};
  if (const auto found = plain.find(name); found != plain.end()) return AreaName{found->second, Width::Bit};
  if (name.front() == '&') return AreaName{form::Address, Width::Bit};
  if (const auto found = lettered.find(name); found != lettered.end()) return AreaName{found->second, Width::Bit};
  const auto found = lettered.find(name.substr(0, name.size() - 1));
  if (found == lettered.end()) return std::nullopt;
  const char letter = name.back();
  return AreaName{found->second, letter == 'B' ? Width::Byte : letter == 'W' ? Width::Word : Width::DWord};
}

/// The forms that a row permits. For T and C as numbers ("constant[T0..T31]") the area itself.
Forms formsOf(const OperandRow& row, bool isNumberOperand) {
  Forms forms = 0;
  for (const std::string& cell : areasOf(row.areas)) {
    const std::string name = withoutBrackets(cell);
    if (name == "powerflow") continue;
    const std::optional<AreaName> area = areaNamed(name);
    EXPECT_TRUE(area.has_value()) << name;
    if (!area) continue;
    if (isNumberOperand && name == "constant")
      forms |= brackets(cell).front() == 'T' ? form::T : form::C;
    else
      forms |= area->form;
  }
  return forms;
}

std::vector<Type> typesOf(const std::string& cell) {
  const std::string name = withoutBrackets(cell);
  static const std::map<std::string, std::vector<Type>> types = {
      {"BOOL", {Type::Bool}},
      {"BYTE", {Type::Byte, Type::Interrupt}},
      {"WORD", {Type::Word, Type::Label, Type::Subroutine, Type::Timer, Type::Counter}},
      {"INT", {Type::Int}},
      {"DWORD", {Type::DWord}},
      {"DINT", {Type::DInt}},
      {"REAL", {Type::Real}},
      {"STRING", {Type::String}},
      {"CTU", {Type::Counter}},
      {"CTD", {Type::Counter}},
      {"CTUD", {Type::Counter}}};
  const auto found = types.find(name);
  EXPECT_NE(found, types.end()) << cell;
  return found == types.end() ? std::vector<Type>{} : found->second;
}

/// "[0..12|19..23]" or "[CPU221|CPU222:0;CPU224:0..5]": whether the number is permitted on that CPU; letters dropped.
bool permitted(std::string text, Cpu cpu, int number) {
  if (text.find("CPU") != std::string::npos) {
    for (const std::string& part : split(text, ';')) {
      const std::size_t colon = part.find(':');
      const std::vector<std::string> cpus = split(part.substr(0, colon), '|');
      if (std::any_of(cpus.begin(), cpus.end(), [&](const std::string& name) { return cpuOf(name) == cpu; }))
        text = part.substr(colon + 1);
    }
  }
  for (std::string part : split(text, '|')) {
    part.erase(std::remove_if(part.begin(), part.end(), [](char c) { return c == 'T' || c == 'C'; }), part.end());
    const std::size_t dots = part.find("..");
    const int low = std::stoi(part.substr(0, dots));
    const int high = dots == std::string::npos ? low : std::stoi(part.substr(dots + 2));
    if (number >= low && number <= high) return true;
  }
  return false;
}
/// Numbers of counters without ranges are limited by their area alone.
bool permitted(const OperandDesc& operand, Cpu cpu, int number) {
  if (operand.type == Type::Counter && !operand.hasRanges())
    return number >= 0 &&
           addressExists({cpu, Edition::Edition2004}, Area::C, Width::Word, static_cast<std::uint32_t>(number), 0);
  return std::any_of(operand.ranges.begin(), operand.ranges.end(), [&](const ValueRange& range) {
    return (range.cpus & cpuBit(cpu)) != 0 && number >= range.low && number <= range.high;
  });
}

const OperandDesc* operandNamed(const Desc& desc, const std::string& name) {
  for (std::size_t i = 0; i < desc.operandCount; ++i) {
    if (desc.operands[i].name == name) return &desc.operands[i];
  }
  return nullptr;
}

}  // namespace

TEST(InstructionTable, NamesGroupsEditionsAndTimesOfTheQuickReference) {
  const std::vector<Row> rows = read("stl-quick-reference.tsv");
  ASSERT_EQ(rows.size(), 250U);
  for (const Row& row : rows) {
    const std::string& mnemonic = row.at("mnemonic");
    SCOPED_TRACE(mnemonic + " " + row.at("source"));
    const Desc* desc = s7200Instructions().named(mnemonic);
    EXPECT_NE(desc, nullptr);
    if (desc == nullptr) continue;
    EXPECT_EQ(desc->group, row.at("group"));
    EXPECT_EQ(desc->familyName(), row.at("family"));
    EXPECT_EQ(desc->since2004, row.at("edition") == "2004 only");
    const std::string& time = row.at("base_us");
    EXPECT_EQ(desc->time, time.empty() ? 0U : static_cast<unsigned>(std::stod(time) * 100 + 0.5));
    EXPECT_FALSE(desc->meaning.empty());
    EXPECT_FALSE(desc->manual.empty());
    EXPECT_FALSE(desc->drawingOnly);
    const std::size_t operands = row.at("operands").empty() ? 0 : split(row.at("operands"), ',').size();
    if (mnemonic != "CALL") {
      EXPECT_EQ(desc->operandCount, operands) << row.at("operands");
    }
  }
}

TEST(InstructionTable, NothingBeyondTheQuickReferenceButBoxes) {
  const std::vector<Row> rows = read("stl-quick-reference.tsv");
  for (const Desc& desc : s7200Instructions().all()) {
    if ((desc.cpus & s7200Cpus) == 0) continue;  // tests/smart
    const bool isListed =
        std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.at("mnemonic") == desc.stl; });
    EXPECT_NE(isListed, desc.drawingOnly) << desc.stl;
  }
}

TEST(InstructionTable, OperandsAgreeWithTheManualRowByRow) {
  for (const OperandRow& row : operandRows()) {
    if (row.instruction == "CALL" && row.operand != "SBR_N") continue;
    SCOPED_TRACE(row.instruction + " " + row.operand + " " + row.type + " " + row.source);
    const OperandDesc* operand = operandNamed(*s7200Instructions().named(row.instruction), row.operand);
    ASSERT_NE(operand, nullptr);
    const Direction direction = row.direction == "in"    ? Direction::In
                                : row.direction == "out" ? Direction::Out
                                                         : Direction::InOut;
    EXPECT_EQ(operand->direction, direction);
    const bool isNumber = operand->type == Type::Timer || operand->type == Type::Counter;
    EXPECT_EQ(operand->forms, formsOf(row, isNumber));
    for (const std::string& cell : areasOf(row.areas)) {
      const std::string name = withoutBrackets(cell);
      const std::optional<AreaName> area = areaNamed(name);
      const bool hasLetter = area && area->width != Width::Bit;
      if (hasLetter) {
        EXPECT_EQ(area->width, widthOf(operand->type)) << name;
      }
      if (name != "constant") continue;
      const std::string ranges = brackets(cell);
      if (operand->type != Type::Counter) {
        EXPECT_EQ(operand->hasRanges(), !ranges.empty());
      }
      if (ranges.empty()) continue;
      for (const Cpu cpu : tabledCpus) {
        for (int number = -300; number <= 300; ++number) {
          EXPECT_EQ(permitted(*operand, cpu, number), permitted(ranges, cpu, number)) << cpuName(cpu) << " " << number;
        }
      }
    }
  }
}

TEST(InstructionTable, TypesAgreeWithOneRowOfTheManual) {
  // Moves of words and double words have one row for each signed and unsigned type.
  std::map<std::pair<std::string, std::string>, std::vector<Type>> types;
  for (const OperandRow& row : operandRows()) {
    std::vector<Type>& list = types[{row.instruction, row.operand}];
    const std::vector<Type> more = typesOf(row.type);
    list.insert(list.end(), more.begin(), more.end());
  }
  for (const auto& [key, list] : types) {
    if (key.first == "CALL" && key.second != "SBR_N") continue;
    const OperandDesc* operand = operandNamed(*s7200Instructions().named(key.first), key.second);
    ASSERT_NE(operand, nullptr) << key.first << " " << key.second;
    EXPECT_NE(std::find(list.begin(), list.end(), operand->type), list.end()) << key.first << " " << key.second;
  }
}

TEST(InstructionTable, EveryOperandHasARowAndEveryBufferItsLength) {
  const std::vector<OperandRow> rows = operandRows();
  for (const Desc& desc : s7200Instructions().all()) {
    if ((desc.cpus & s7200Cpus) == 0) continue;
    for (std::size_t i = 0; i < desc.operandCount; ++i) {
      const OperandDesc& operand = desc.operands[i];
      if (operand.type == Type::Parameter) continue;
      const auto row = std::find_if(rows.begin(), rows.end(), [&](const OperandRow& r) {
        return r.instruction == desc.stl && r.operand == operand.name;
      });
      ASSERT_NE(row, rows.end()) << desc.stl << " " << operand.name;
      const std::size_t open = row->type.find('[');
      const bool isBuffer = open != std::string::npos;
      EXPECT_EQ(operand.buffer.low != 1 || operand.buffer.high != 1, isBuffer) << desc.stl << " " << operand.name;
      const std::string length = isBuffer ? brackets(row->type) : std::string();
      if (length.empty()) continue;
      const std::size_t dots = length.find("..");
      EXPECT_EQ(operand.buffer.high, std::stoi(dots == std::string::npos ? length : length.substr(dots + 2)))
          << desc.stl << " " << operand.name;
    }
  }
}

TEST(CallParameters, FormsAgreeWithTable678) {
  static const std::map<std::string, VarSection> sections = {
      {"IN", VarSection::Input}, {"IN_OUT", VarSection::InOut}, {"OUT", VarSection::Output}};
  static const std::map<std::string, DataType> types = {
      {"BOOL", DataType::Bool},   {"BYTE", DataType::Byte}, {"WORD", DataType::Word},    {"INT", DataType::Int},
      {"DWORD", DataType::DWord}, {"DINT", DataType::DInt}, {"STRING", DataType::String}};
  int count = 0;
  for (const OperandRow& row : operandRows()) {
    if (row.instruction != "CALL" || row.operand == "SBR_N") continue;
    SCOPED_TRACE(row.operand + " " + row.type);
    ++count;
    const VarSection section = sections.at(row.operand);
    EXPECT_EQ(parameterForms(section, types.at(row.type)), formsOf(row, false));
    const bool hasSm = row.areas.find("SM") != std::string::npos;
    const std::uint32_t first = row.areas.find("[30..]") == std::string::npos ? 0 : 30;
    if (hasSm) {
      EXPECT_EQ(firstParameterSm(section), first);
    }
    for (const std::string& cell : areasOf(row.areas)) {
      const std::optional<AreaName> area = areaNamed(withoutBrackets(cell));
      const bool isBare = !area || area->width == Width::Bit || area->form == form::AI || area->form == form::AQ;
      if (!isBare) {
        EXPECT_EQ(area->width, widthOf(types.at(row.type))) << cell;
      }
      if (area) {
        EXPECT_EQ(area->form & s7200Instructions().named("CALL")->operands[1].forms, area->form) << cell;
      }
    }
  }
  EXPECT_EQ(count, 19) << "7 types as IN, 6 each as IN_OUT and OUT";
}

}  // namespace rungproof::tables
