// Operands and instructions for the statements of the naive interpreter.
#include "tests/agreement7/ir_of_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "ir/block_map.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/cpu.hpp"
#include "ir/s7300/isa.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/pointer_parameter.hpp"

namespace rungproof::agreement7 {
namespace {

Width widthOf(int bitCount) {
  return bitCount == 1 ? Width::Bit : bitCount == 8 ? Width::Byte : bitCount == 16 ? Width::Word : Width::DWord;
}

Operand through(Reach reach, Area area, Width width, std::uint32_t offset = 0, unsigned bit = 0) {
  Operand operand = direct(area, width, offset, bit);
  operand.kind = OperandKind::Indirect;
  operand.reach = Shared<Reach>(std::move(reach));
  return operand;
}

Operand typed(std::int64_t value, const std::string& text, Width width = Width::Word) {
  Operand operand = constant(value, ConstantForm::Typed);
  operand.text = text;
  operand.width = width;
  return operand;
}

int numberOfName(const std::string& name) {  // "FC5", "FB2", "OB1"
  if (name.starts_with("SFC")) return blockNumber(BlockType::Sfc, std::atoi(name.c_str() + 3));
  const BlockType type = name.starts_with("FC")   ? BlockType::Fc
                         : name.starts_with("FB") ? BlockType::Fb
                                                  : BlockType::Ob;
  return blockNumber(type, std::atoi(name.c_str() + 2));
}

struct Letters {
  Area area;
  Width width;
  bool isData, inDi;
};

bool readLetters(const std::string& letters, Letters& out) {
  struct Row {
    const char* prefix;
    Area area;
    bool isData, inDi;
  };
  static const std::array<Row, 8> rows = {{{"PI", Area::PI, false, false},
                                           {"PQ", Area::PQ, false, false},
                                           {"DB", Area::DB, true, false},
                                           {"DI", Area::DB, true, true},
                                           {"I", Area::I, false, false},
                                           {"Q", Area::Q, false, false},
                                           {"M", Area::M, false, false},
                                           {"L", Area::L, false, false}}};
  for (const Row& row : rows) {
    if (!letters.starts_with(row.prefix)) continue;
    const std::string rest = letters.substr(std::string(row.prefix).size());
    out = {row.area, Width::Bit, row.isData, row.inDi};
    if (rest == (row.isData ? "X" : "")) return true;
    if (rest == "B") return out.width = Width::Byte, true;
    if (rest == "W") return out.width = Width::Word, true;
    if (rest == "D") return out.width = Width::DWord, true;
  }
  return false;
}

struct Binder {
  const naive7::Program& program;
  const naive7::Block& block;
  std::vector<naive7::Variable> parameters;  ///< of the block, in the order IN, OUT, IN_OUT
  std::map<std::string, std::int64_t> labels;
  std::string* faults;

  bool isFb() const { return block.name.starts_with("FB"); }

  Operand ofVariable(const naive7::Variable& v, std::uint32_t index) const {
    const bool isPointer = v.type == "ANY" || v.type == "POINTER";
    if (isPointer && !isFb()) return through({Way::Handed, false, false, index, {}}, Area::DB, Width::Byte);
    const int count = isPointer ? 8 : naive7::widthOfType(v.type);
    const Width width = widthOf(count == 0 ? 1 : count);
    if (v.section == naive7::Section::Temp) return direct(Area::L, width, v.bit / 8, v.bit % 8);
    const bool isNumber = v.type == "TIMER" || v.type == "COUNTER";
    if (isFb() && !isNumber)
      return through({Way::Instance, false, false, 0, {}}, Area::DB, width, v.bit / 8, v.bit % 8);
    const Area area = v.type == "TIMER" ? Area::T : v.type == "COUNTER" ? Area::C : Area::DB;
    return through({Way::Parameter, false, false, index, {}}, area, isNumber ? Width::Bit : width);
  }

  Operand local(const std::string& name) const {
    for (std::uint32_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].name == name) return ofVariable(parameters[i], i);
    }
    for (const naive7::Variable& v : block.variables) {
      if (v.name == name) return ofVariable(v, 0);
    }
    *faults += "no local name " + name + "\n";
    return {};
  }

  static std::pair<std::uint32_t, unsigned> place(const std::string& text) {
    const std::size_t dot = text.find('.');
    return {static_cast<std::uint32_t>(std::atoi(text.c_str())),
            dot == std::string::npos ? 0U : static_cast<unsigned>(std::atoi(text.c_str() + dot + 1))};
  }

  Operand memory(const std::string& text) const {
    if (text.starts_with("#")) return local(text.substr(1));
    const std::size_t open = text.find('[');
    if (open != std::string::npos) return indirect(text.substr(0, open), text.substr(open + 1, text.size() - open - 2));
    if ((text[0] == 'T' || text[0] == 'C') && text.size() > 1 && std::isdigit(static_cast<unsigned char>(text[1])) != 0)
      return direct(text[0] == 'T' ? Area::T : Area::C, Width::Bit, place(text.substr(1)).first);
    std::string rest = text;
    std::uint32_t number = 0;
    const std::size_t dot = text.find('.');
    const bool isFull = text.starts_with("DB") && dot != std::string::npos && dot + 1 < text.size() &&
                        std::isalpha(static_cast<unsigned char>(text[dot + 1])) != 0;
    if (isFull) {
      number = static_cast<std::uint32_t>(std::atoi(text.c_str() + 2));
      rest = text.substr(dot + 1);
    }
    std::size_t end = 0;
    while (end < rest.size() && std::isalpha(static_cast<unsigned char>(rest[end])) != 0) ++end;
    Letters letters{};
    if (!readLetters(rest.substr(0, end), letters)) {
      *faults += "no operand " + text + "\n";
      return {};
    }
    const auto [byte, bit] = place(rest.substr(end));
    if (isFull) return direct(Area::DB, letters.width, dataByte(number, byte), bit);
    if (letters.isData)
      return through({Way::OpenBlock, letters.inDi, false, 0, {}}, Area::DB, letters.width, byte, bit);
    return direct(letters.area, letters.width, byte, bit);
  }

  Operand indirect(const std::string& before, const std::string& inside) const {
    const bool byRegister = inside.starts_with("AR1,") || inside.starts_with("AR2,");
    const auto [byte, bit] = byRegister ? place(inside.substr(6)) : std::pair<std::uint32_t, unsigned>{0, 0U};
    const bool byAr2 = byRegister && inside[2] == '2';
    if (byRegister && (before.empty() || before == "B" || before == "W" || before == "D")) {
      const Width width = before.empty()  ? Width::Bit
                          : before == "B" ? Width::Byte
                          : before == "W" ? Width::Word
                                          : Width::DWord;
      return through({Way::Crossing, false, byAr2, 0, {}}, Area::M, width, byte, bit);
    }
    Operand pointer;
    if (!byRegister) pointer = memory(inside);
    if (before == "T" || before == "C")
      return through({Way::Pointer, false, false, 0, pointer}, before == "T" ? Area::T : Area::C, Width::Bit);
    if (before == "DB" || before == "DI" || before == "FC")
      return through({Way::Pointer, before == "DI", false, 0, pointer}, Area::DB, Width::Byte);
    Letters letters{};
    if (!readLetters(before, letters)) {
      *faults += "no operand " + before + "[" + inside + "]\n";
      return {};
    }
    if (byRegister) return through({Way::Register, letters.inDi, byAr2, 0, {}}, letters.area, letters.width, byte, bit);
    return through({Way::Pointer, letters.inDi, false, 0, pointer}, letters.area, letters.width);
  }

  Operand value(const std::string& text) const {
    if (text == "TRUE" || text == "FALSE") return typed(text == "TRUE" ? 1 : 0, text, Width::Bit);
    if (naive7::isConstantText(text)) {
      const bool isShort = text.find_first_of("#'.") == std::string::npos || text.starts_with("W#") ||
                           text.starts_with("B#16") || text.starts_with("S5T#") || text.starts_with("C#");
      return typed(naive7::constantValue(text), text, isShort ? Width::Word : Width::DWord);
    }
    return memory(text);
  }

  /// An actual parameter for an ANY or a POINTER.
  Operand pointer(const std::string& text) const {
    naive7::AnyText any;
    Operand place, operand;
    Reach reach{Way::PointerTo, false, false, 0, {}};
    const bool isConstant = naive7::readAny(text, any);
    const std::uint32_t area = any.address >> 24 & 7, byte = (any.address & 0x7FFFF) >> 3;
    if (isConstant && any.block == 0 && (area == 4 || area == 5)) {  // in the block that is open
      place = memory(fmt::format("{}{}", area == 4 ? "DBB" : "DIB", byte));
      reach.anyType = static_cast<std::uint8_t>(any.type);
      reach.anyCount = static_cast<std::uint16_t>(any.count);
    } else if (isConstant) {
      const bool isLocal = (any.address >> 24 & 7) == 6;  // area V for the block that is called
      place = typed(any.address | (isLocal ? 0x01000000U : 0U), text, Width::DWord);
      place.offset = static_cast<std::uint32_t>(any.block);
      reach.anyType = static_cast<std::uint8_t>(any.type);
      reach.anyCount = static_cast<std::uint16_t>(any.count);
    } else {
      place = memory(text);
      static const std::map<std::string, std::uint8_t> codes = {{"BOOL", 1},     {"BYTE", 2},      {"WORD", 4},
                                                                {"INT", 5},      {"DWORD", 6},     {"DINT", 7},
                                                                {"TIMER", 0x1D}, {"COUNTER", 0x1C}};
      static constexpr std::uint8_t byWidth[] = {1, 2, 4, 6};
      reach.anyType = byWidth[static_cast<std::size_t>(place.width)];
      reach.anyCount = 1;
      if (place.area == Area::T) reach.anyType = 0x1D;
      if (place.area == Area::C) reach.anyType = 0x1C;
      for (const naive7::Variable& v : block.variables) {
        if (!text.starts_with("#") || v.name != text.substr(1)) continue;
        if (v.type == "ANY" || v.type == "POINTER") return place;
        reach.anyType = codes.at(v.type);
      }
    }
    operand = place;
    reach.pointer = place;
    operand.kind = OperandKind::Address;
    operand.reach = Shared<Reach>(std::move(reach));
    return operand;
  }

  /// P##name.
  Operand addressOf(const std::string& name) const {
    Operand operand = local(name);
    operand.kind = OperandKind::Address;
    return operand;
  }

  bool isObject(const std::string& operand, const char* type) const {
    if (operand.empty()) return false;
    if (operand[0] != '#') {
      return operand[0] == type[0] && operand.size() > 1 &&
             (operand[1] == '[' || std::isdigit(static_cast<unsigned char>(operand[1])) != 0);
    }
    return std::ranges::any_of(
        parameters, [&](const naive7::Variable& v) { return v.name == operand.substr(1) && v.type == type; });
  }

  void append(Network& network, const std::string& mnemonic, Operands operands) const {
    const Desc* desc = s7300Instructions().named(mnemonic);
    if (desc == nullptr) {
      *faults += "no instruction " + mnemonic + "\n";
      return;
    }
    Instruction instruction;
    instruction.desc = desc;
    instruction.operands = std::move(operands);
    network.instructions.push_back(std::move(instruction));
  }

  Operand label(const std::string& name) const {
    if (!labels.contains(name)) *faults += "no label " + name + "\n";
    return typed(labels.contains(name) ? labels.at(name) : 0, name);
  }

  void call(const naive7::Statement& s, Network& network) const {
    std::string target = s.operand, instance;
    if (const std::size_t comma = target.find(','); comma != std::string::npos) {
      instance = target.substr(comma + 1);
      target = target.substr(0, comma);
    }
    Operands operands;
    if (target.find('[') != std::string::npos) return append(network, s.op, {memory(target)});
    Operand multi;
    if (target.starts_with("#")) {
      for (const naive7::Variable& v : block.variables) {
        if (v.name != target.substr(1)) continue;
        multi = through({Way::Instance, false, false, 0, {}}, Area::DB, Width::Byte, v.bit / 8);
        target = v.type;
        break;
      }
    }
    operands.push_back(typed(numberOfName(target), target));
    if (multi.kind != OperandKind::Missing) {
      operands.push_back(multi);
    } else if (!instance.empty()) {
      operands.push_back(
          direct(Area::DB, Width::Byte, dataByte(static_cast<std::uint32_t>(std::atoi(instance.c_str() + 2)), 0)));
    }
    if (const auto callee = program.blocks.find(target); callee != program.blocks.end()) {
      for (const naive7::Variable& v : parametersOf(callee->second)) {
        const auto given = std::ranges::find(s.actuals, v.name, [](const auto& pair) { return pair.first; });
        const bool isPointer = v.type == "ANY" || v.type == "POINTER";
        operands.push_back(given == s.actuals.end() ? Operand{}
                           : isPointer              ? pointer(given->second)
                                                    : value(given->second));
      }
    } else if (const s7300::LibraryBlock* library = libraryOf(numberOfName(target))) {
      const auto interface = s7300::interfaceOf(*library);
      for (const s7300::Field& field : interface->fields) {
        const auto given = std::ranges::find(s.actuals, field.name, [](const auto& pair) { return pair.first; });
        if (given == s.actuals.end()) {
          *faults += "no parameter " + field.name + "\n";
          continue;
        }
        const bool isAny = field.type.kind == s7300::TypeKind::Any;
        operands.push_back(isAny ? pointer(given->second) : value(given->second));
      }
    }
    append(network, s.op, std::move(operands));
  }

  static const s7300::LibraryBlock* libraryOf(int number) {
    return s7300::libraryBlock(blockTypeOf(number), static_cast<std::uint32_t>(numberOfBlock(number)));
  }

  static std::vector<naive7::Variable> parametersOf(const naive7::Block& block) {
    std::vector<naive7::Variable> list;
    for (naive7::Section section : {naive7::Section::In, naive7::Section::Out, naive7::Section::InOut}) {
      for (const naive7::Variable& v : block.variables) {
        if (v.section == section) list.push_back(v);
      }
    }
    return list;
  }

  void statement(const naive7::Statement& s, Network& network) const {
    if (!s.label.empty()) append(network, "LABEL", {label(s.label)});
    const std::string &op = s.op, &o = s.operand;
    if (op == "@") return append(network, "BLD", {typed(254, "254")});
    if (op == "CALL" || op == "UC" || op == "CC") return call(s, network);
    if (op[0] == 'J' || op == "LOOP") return append(network, op, {label(o)});
    static const std::array<std::string, 10> conditions = {"BR",  "OV", "OS", "UO",  "==0",
                                                           "<>0", ">0", "<0", ">=0", "<=0"};
    if (const auto found = std::ranges::find(conditions, o); found != conditions.end())
      return append(network, op, {typed(found - conditions.begin(), o, Width::Bit)});
    if (op == "O" && o.empty()) return append(network, "OR", {});
    if ((op == "L" || op == "T") && o == "STW") return append(network, op + " STW", {});
    if (op == "L" && (o == "DBNO" || o == "DINO" || o == "DBLG" || o == "DILG")) return append(network, "L " + o, {});
    if ((op == "LAR1" || op == "TAR1") && o == "AR2") return append(network, op + " AR2", {});
    if (op == "L" && o.starts_with("P##")) return append(network, op, {addressOf(o.substr(3))});
    if (op == "L" || op == "LC" || op == "R" || op == "FR" || op == "S") {
      for (const char* type : {"TIMER", "COUNTER"}) {
        if (isObject(o, type)) return append(network, op + " " + type[0], {memory(o)});
      }
    }
    if (op == "OPN" && o.find('[') == std::string::npos) {
      Operand opened = direct(Area::DB, Width::Byte, dataByte(static_cast<std::uint32_t>(std::atoi(o.c_str() + 2)), 0));
      if (o.starts_with("DI")) opened.reach = Shared<Reach>(Reach{Way::OpenBlock, true, false, 0, {}});
      return append(network, op, {opened});
    }
    if (o.empty() || op.starts_with("NOP")) return append(network, op, {});
    append(network, op, {value(o)});
  }
};

DataType typeOf(const std::string& name) {
  static const std::map<std::string, DataType> types = {{"BOOL", DataType::Bool},   {"BYTE", DataType::Byte},
                                                        {"WORD", DataType::Word},   {"INT", DataType::Int},
                                                        {"DWORD", DataType::DWord}, {"DINT", DataType::DInt},
                                                        {"TIMER", DataType::Timer}, {"COUNTER", DataType::Counter},
                                                        {"ANY", DataType::Any},     {"POINTER", DataType::Pointer}};
  const auto found = types.find(name);
  return found == types.end() ? DataType::Instance : found->second;
}

Pou pouOf(const naive7::Program& program, const naive7::Block& block, std::string& faults) {
  Pou pou;
  pou.name = block.name;
  pou.number = numberOfName(block.name);
  pou.type = blockTypeOf(pou.number);
  pou.kind = pou.type != BlockType::Ob        ? PouKind::Subroutine
             : numberOfBlock(pou.number) == 1 ? PouKind::Main
                                              : PouKind::Interrupt;
  pou.localBytes = pou.type == BlockType::Ob ? 64 : 0;
  pou.instanceBytes = block.instanceBytes;
  Binder binder{program, block, Binder::parametersOf(block), {}, &faults};
  for (const naive7::Statement& s : block.statements) {
    if (!s.label.empty()) binder.labels.emplace(s.label, static_cast<std::int64_t>(binder.labels.size()));
  }
  const auto declare = [&](const naive7::Variable& v, std::uint32_t index) {
    static const std::map<naive7::Section, VarSection> sections = {{naive7::Section::In, VarSection::Input},
                                                                   {naive7::Section::Out, VarSection::Output},
                                                                   {naive7::Section::InOut, VarSection::InOut},
                                                                   {naive7::Section::Static, VarSection::Static},
                                                                   {naive7::Section::Temp, VarSection::Temp}};
    LocalVariable variable;
    variable.name = v.name;
    variable.section = sections.at(v.section);
    variable.type = typeOf(v.type);
    variable.address = binder.ofVariable(v, index);
    variable.size = static_cast<std::uint32_t>(naive7::widthOfType(v.type)) / 8;
    variable.pointerByte = v.bit / 8;
    if (v.type.starts_with("FB")) {
      variable.instanceOf = numberOfName(v.type);
      variable.size = program.blocks.at(v.type).instanceBytes;
    }
    if (v.section == naive7::Section::Temp)
      pou.localBytes = std::max(pou.localBytes, (v.bit / 8 + std::max(variable.size, 1U) + 1) / 2 * 2);
    pou.locals.push_back(variable);
  };
  for (std::uint32_t i = 0; i < binder.parameters.size(); ++i) declare(binder.parameters[i], i);
  for (naive7::Section section : {naive7::Section::Static, naive7::Section::Temp}) {
    for (const naive7::Variable& v : block.variables) {
      if (v.section == section && !v.type.starts_with("ARRAY")) declare(v, 0);
    }
  }
  Network network;
  network.number = 1;
  for (const naive7::Statement& s : block.statements) binder.statement(s, network);
  pou.networks.push_back(std::move(network));
  return pou;
}

/// The built-in blocks that are called.
void addLibrary(Program& program) {
  std::vector<Pou> blocks;
  for (const Pou& pou : program.pous) {
    for (const Instruction& instruction : pou.networks[0].instructions) {
      if (instruction.desc->control != Control::BlockCall || instruction.operands[0].kind != OperandKind::Constant)
        continue;
      const int number = static_cast<int>(instruction.operands[0].value);
      const s7300::LibraryBlock* library = Binder::libraryOf(number);
      const auto isThis = [&](const Pou& other) { return other.number == number; };
      if (library == nullptr || program.subroutine(number) != nullptr || std::ranges::any_of(blocks, isThis)) continue;
      Pou& block = blocks.emplace_back();
      block.kind = PouKind::Subroutine;
      block.type = library->type;
      block.number = number;
      block.name = library->name;
      block.isBuiltIn = true;
      block.networks.emplace_back();
      const auto interface = s7300::interfaceOf(*library);
      for (const s7300::Field& field : interface->fields) {
        const std::uint64_t size = s7300::sizeOf(field.type);
        const Width width = size == 2                                  ? Width::Word
                            : field.type.kind == s7300::TypeKind::Bool ? Width::Bit
                                                                       : Width::DWord;
        LocalVariable& local = block.locals.emplace_back();
        local.name = field.name;
        local.section = field.section == s7300::Section::Input ? VarSection::Input : VarSection::Output;
        local.type = field.type.kind == s7300::TypeKind::Any ? DataType::Any : DataType::Int;
        local.size = width == Width::Bit ? 0 : static_cast<std::uint32_t>(size);
        local.address = through({Way::Parameter, false, false, static_cast<std::uint32_t>(block.locals.size() - 1), {}},
                                Area::DB, width);
      }
    }
  }
  std::ranges::move(blocks, std::back_inserter(program.pous));
}

}  // namespace

Program irOf(const naive7::Program& program, bool is400, std::string& faults) {
  Program result;
  result.target.cpu = is400 ? step7Cpu("417") : step7Cpu("319-3");
  result.target.edition = Edition::Step7;
  for (const auto& [name, block] : program.blocks) {
    Pou pou = pouOf(program, block, faults);
    result.pous.insert(pou.kind == PouKind::Main ? result.pous.begin() : result.pous.end(), std::move(pou));
  }
  for (const auto& [number, bytes] : program.dataBlocks) {
    DataBlock data;
    data.number = static_cast<std::uint32_t>(number);
    data.bytes = bytes;
    result.dataBlocks.push_back(std::move(data));
  }
  addLibrary(result);
  placeHandedPointers(result);
  result.number();
  return result;
}

}  // namespace rungproof::agreement7
