// Blocks, instances and their memory.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/drawing/lower.hpp"
#include "frontend/graphical/drawn_blocks.hpp"
#include "frontend/graphical/drawn_build.hpp"
#include "frontend/graphical/drawn_lowering.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "ir/overlap.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

/// Element of the drawing of the first scan: a move or a set in the first scan (element 1).
void addFirst(Drawing& drawing, std::string_view mnemonic, Operands operands, Span span) {
  if (drawing.elements.empty()) {
    Element rail, first;
    rail.span = first.span = span;
    first.shape = Shape::Contact;
    first.desc = s7200Instructions().named("LD");
    first.operands = {s7200SystemBits.firstScan.operand()};
    first.operands[0].span = span;
    first.inputs = {{0, false}};
    drawing.elements = {rail, first};
  }
  Element element;
  element.shape = mnemonic == "S" ? Shape::Coil : Shape::Box;
  element.desc = s7200Instructions().named(mnemonic);
  for (Operand& operand : operands) operand.span = span;
  element.operands = std::move(operands);
  element.inputs = {{1, false}};
  element.span = span;
  drawing.elements.push_back(std::move(element));
}

}  // namespace

void buildDrawnProject(Program& program, DrawnProject& project) {
  if (!project.isEmpty()) DrawnBuild(program, project).run();
}

DrawnBuild::DrawnBuild(Program& program, DrawnProject& project)
    : program_(program), project_(project), sink_(program), memory_(program), tableSymbols_(program.symbols.size()) {}

void DrawnBuild::run() {
  for (DrawnBlock& block : project_.blocks) {
    const auto [found, isNew] = blocks_.emplace(foldedName(block.name), &block);
    if (!isNew) sink_.report(Syntax::BlockTwice, block.span, fmt::format("two blocks are named {}", block.name));
  }
  reserveLocated(project_.globals);
  for (const DrawnBlock& block : project_.blocks) reserveLocated(block.variables);
  noteMentions();
  addGlobals();
  buildPrograms();
}

void DrawnBuild::reserveLocated(const std::vector<DrawnVariable>& variables) {
  for (const DrawnVariable& variable : variables) {
    if (const auto address = locatedAddress(variable.address)) memory_.reserve(*address);
  }
}

void DrawnBuild::noteMentions() {
  const auto note = [&](const std::string& text) {
    const std::size_t last = text.rfind('.');
    if (last == std::string::npos || last == 0) return;
    const std::size_t before = text.rfind('.', last - 1);
    mentioned_.insert(foldedName(std::string_view(text).substr(before == std::string::npos ? 0 : before + 1)));
  };
  for (DrawnBlock& block : project_.blocks) {
    for (DrawnNetwork& network : block.networks) {
      for (DrawnElement& element : network.elements) {
        note(element.text);
        for (const DrawnPin& pin : element.inputs) note(pin.expression);
        if (element.kind != DrawnKind::Block || !element.text.empty()) continue;
        // A call that names the instance only: its type stands in the declaration.
        const std::string name = foldedName(element.instance);
        for (const std::vector<DrawnVariable>* list : {&block.variables, &project_.globals}) {
          for (const DrawnVariable& variable : *list) {
            if (element.text.empty() && foldedName(variable.name) == name) element.text = variable.typeName;
          }
        }
      }
    }
  }
}

bool DrawnBuild::isMentioned(std::string_view instance, std::string_view output) const {
  const std::size_t point = instance.rfind('.');
  return mentioned_.contains(foldedName(
      fmt::format("{}.{}", point == std::string_view::npos ? instance : instance.substr(point + 1), output)));
}

std::optional<Operand> DrawnBuild::temporary(IecType type) {
  auto place = memory_.allocate(type);
  if (!place && !isFullReported_) {
    isFullReported_ = true;
    sink_.report(Syntax::LocalTableFull, project_.blocks.empty() ? Span{} : project_.blocks.front().span,
                 "V memory of the CPU is too small for the variables of the project");
  }
  return place;
}

const DrawnBlock* DrawnBuild::blockNamed(std::string_view name) const {
  const auto found = blocks_.find(foldedName(name));
  return found == blocks_.end() || found->second->kind == DrawnBlockKind::Program ? nullptr : found->second;
}

VariablePlace* DrawnBuild::lookUp(DrawnCopy& copy, std::string_view name) {
  const std::string folded = foldedName(trimmed(name));
  const auto local = copy.places.find(folded);
  if (local != copy.places.end()) return &local->second;
  const auto global = globals_.find(folded);
  if (global != globals_.end()) return &global->second;
  for (const std::string& list : project_.globalLists) {
    if (folded.size() <= list.size() + 1 || folded[list.size()] != '.' || !folded.starts_with(foldedName(list)))
      continue;
    const auto listed = globals_.find(folded.substr(list.size() + 1));
    if (listed != globals_.end()) return &listed->second;
  }
  for (std::size_t i = 0; i < tableSymbols_; ++i) {
    const Symbol& symbol = program_.symbols[i];
    if (symbol.address.kind != OperandKind::Direct || foldedName(symbol.name) != folded) continue;
    const Width width = symbol.address.width;
    const IecType type = width == Width::Bit    ? IecType::Bool
                         : width == Width::Byte ? IecType::Byte
                         : width == Width::Word ? IecType::Word
                                                : IecType::Dword;
    return &globals_.emplace(folded, VariablePlace{type, symbol.address, std::nullopt, nullptr}).first->second;
  }
  return nullptr;
}

void DrawnBuild::addSymbol(const std::string& name, const Operand& place, Span span) {
  Symbol symbol;
  symbol.name = name;
  symbol.address = place;
  symbol.address.text = "";
  symbol.span = span;
  program_.symbols.push_back(std::move(symbol));
}

void DrawnBuild::addInitialValue(const VariablePlace& place, const DrawnVariable& variable) {
  if (variable.initial.empty() || place.copy != nullptr) return;
  const auto literal = iecLiteral(variable.initial);
  const bool isNumber = place.type == IecType::Real
                            ? literal && (literal->type == IecType::Real || literal->type == IecType::None)
                            : literal && literal->type != IecType::Real;
  if (place.type == IecType::String) return;
  if (!isNumber || (place.type != IecType::Real && !fits(literal->value, place.type))) {
    return sink_.report(Syntax::XmlStructure, variable.span,
                        fmt::format("initial value {} of {} is no {}", excerpt(variable.initial), variable.name,
                                    iecTypeName(place.type)));
  }
  std::int64_t value = literal->value;
  if (place.type == IecType::Real && literal->type == IecType::None)
    value = iecLiteral(fmt::format("{}.0", literal->value)).value_or(IecLiteral{}).value;
  if (value == 0) return;
  if (place.operand.area == Area::V) {
    DataInit init;
    init.offset = place.operand.offset;
    init.span = variable.span;
    if (place.type == IecType::Bool) {
      // Bits of one byte come together.
      for (DataInit& other : program_.data) {
        if (other.offset != init.offset || other.bytes.size() != 1) continue;
        other.bytes[0] = static_cast<std::uint8_t>(other.bytes[0] | (1U << place.operand.bit));
        return;
      }
      init.bytes = {static_cast<std::uint8_t>(1U << place.operand.bit)};
    } else {
      for (int shift = 8 * (bytes(place.operand.width) - 1); shift >= 0; shift -= 8)
        init.bytes.push_back(static_cast<std::uint8_t>(value >> shift));
    }
    program_.data.push_back(std::move(init));
    return;
  }
  if (isInputArea(place.operand.area)) return;  // read from outside before anybody looks
  if (place.type == IecType::Bool)
    addFirst(firstScan_, "S", {place.operand, constant(1)}, variable.span);
  else
    addFirst(firstScan_, moveOf(place.type),
             {constant(value, place.type == IecType::Real ? ConstantForm::Real : ConstantForm::Decimal), place.operand},
             variable.span);
}

void DrawnBuild::declareInstance(VariablePlace& place, const DrawnVariable& variable, const std::string& path) {
  const StandardBlock standard = standardBlockNamed(variable.typeName);
  const auto found = blocks_.find(foldedName(variable.typeName));
  if (found != blocks_.end() && found->second->kind == DrawnBlockKind::FunctionBlock) {
    if (std::find(open_.begin(), open_.end(), found->first) != open_.end()) {
      sink_.report(Syntax::XmlStructure, variable.span,
                   fmt::format("{} contains an instance of itself", variable.typeName));
      return;
    }
    place.copy = newCopy(*found->second, path);
    addPou(*place.copy, PouKind::Subroutine);
    return;
  }
  if (standard == StandardBlock::None) {
    return sink_.report(Syntax::XmlStructure, variable.span,
                        fmt::format("type {} of {} is not known", excerpt(variable.typeName), variable.name));
  }
  copies_.push_back(std::make_unique<DrawnCopy>());
  copies_.back()->path = path;
  copies_.back()->standard = standard;
  place.copy = copies_.back().get();
}

void DrawnBuild::declare(DrawnCopy& copy, const DrawnVariable& variable, const std::string& path) {
  if (variable.section == DrawnSection::External) return;
  const std::string folded = foldedName(variable.name);
  VariablePlace place;
  place.type = variable.type;
  if (variable.type == IecType::None) {
    declareInstance(place, variable, path);
    if (place.copy == nullptr) return;
  } else if (variable.isConstant || variable.section == DrawnSection::Constant) {
    place.constant = iecLiteral(variable.initial);
    if (place.constant && place.constant->type == IecType::None && variable.type != IecType::Real)
      place.constant->type = variable.type;
    if (!place.constant)
      return sink_.report(Syntax::XmlStructure, variable.span,
                          fmt::format("constant {} has no value that can be read", variable.name));
  } else if (!variable.address.empty()) {
    const auto address = locatedAddress(variable.address);
    const bool fitsType =
        address &&
        (address->width == widthOf(variable.type) ||
         (address->width == Width::Bit && hasBitAndWord(address->area) && widthOf(variable.type) == Width::Word));
    if (!fitsType) {
      return sink_.report(
          Syntax::XmlStructure, variable.span,
          address ? fmt::format("{} is {}, but {} has another width", variable.name, iecTypeName(variable.type),
                                variable.address)
                  : fmt::format("address {} of {} cannot be read", excerpt(variable.address), variable.name));
    }
    place.operand = *address;
  } else {
    const auto address =
        variable.type == IecType::String ? memory_.allocate(IecType::String, 80) : temporary(variable.type);
    if (!address) return;
    place.operand = *address;
  }
  place.operand.text = path;
  const bool isNew = copy.places.emplace(folded, place).second;
  if (!isNew)
    return sink_.report(Syntax::XmlStructure, variable.span, fmt::format("{} is declared twice", variable.name));
  if (place.copy == nullptr && !place.constant) {
    addSymbol(path, place.operand, variable.span);
    addInitialValue(place, variable);
  }
}

void DrawnBuild::addGlobals() {
  DrawnCopy all;
  for (const DrawnVariable& variable : project_.globals) declare(all, variable, variable.name);
  globals_ = std::move(all.places);
}

DrawnCopy* DrawnBuild::newCopy(const DrawnBlock& block, const std::string& path) {
  copies_.push_back(std::make_unique<DrawnCopy>());
  DrawnCopy* copy = copies_.back().get();
  copy->path = path;
  copy->block = &block;
  open_.push_back(foldedName(block.name));
  const std::string prefix = path.empty() ? "" : path + ".";
  for (const DrawnVariable& variable : block.variables) declare(*copy, variable, prefix + variable.name);
  if (block.returnType != IecType::None) {
    DrawnVariable result;
    result.name = block.name;
    result.section = DrawnSection::Return;
    result.type = block.returnType;
    result.span = block.span;
    declare(*copy, result, prefix + block.name);
  }
  open_.pop_back();
  return copy;
}

DrawnCopy* DrawnBuild::functionCopy(const DrawnBlock& block) {
  const std::string name = foldedName(block.name);
  if (std::find(open_.begin(), open_.end(), name) != open_.end()) return nullptr;
  const auto found = functions_.find(name);
  if (found != functions_.end()) return found->second;
  DrawnCopy* copy = newCopy(block, block.name);
  functions_[name] = copy;
  const std::string pou = sink_.pou();
  addPou(*copy, PouKind::Subroutine);
  sink_.setPlace(pou, 0);
  return copy;
}

/// Local variables of a function and temporary ones begin every call with their initial values.
void DrawnBuild::restoreLocals(DrawnCopy& copy, Pou& pou) {
  Drawing drawing;
  drawing.elements.emplace_back();
  drawing.elements[0].span = copy.block->span;
  for (const DrawnVariable& variable : copy.block->variables) {
    const bool isFresh = variable.section == DrawnSection::Temp ||
                         (variable.section == DrawnSection::Local && copy.block->kind == DrawnBlockKind::Function);
    const auto place = copy.places.find(foldedName(variable.name));
    if (!isFresh || place == copy.places.end() || place->second.copy != nullptr || place->second.constant ||
        place->second.type == IecType::String)
      continue;
    if (variable.section == DrawnSection::Temp && variable.initial.empty()) continue;
    const auto literal = iecLiteral(variable.initial);
    const std::int64_t value = literal ? literal->value : 0;
    Element element;
    element.span = variable.span;
    element.inputs = {{0, false}};
    if (place->second.type == IecType::Bool) {
      element.shape = Shape::Coil;
      element.desc = s7200Instructions().named("=");
      element.inputs[0].negated = value == 0;
      element.operands = {place->second.operand};
    } else {
      element.shape = Shape::Box;
      element.desc = s7200Instructions().named(moveOf(place->second.type));
      element.operands = {
          constant(value, place->second.type == IecType::Real ? ConstantForm::Real : ConstantForm::Decimal),
          place->second.operand};
    }
    for (Operand& operand : element.operands) operand.span = variable.span;
    drawing.elements.push_back(std::move(element));
  }
  if (drawing.elements.size() == 1) return;
  Network network;
  network.number = 0;
  network.form = copy.block->form;
  network.title = "Local variables begin anew";
  network.span = copy.block->span;
  lowerInto(network, std::move(drawing));
  pou.networks.push_back(std::move(network));
}

/// A body that is not read may write every variable it names, except its inputs; one that names another block may write
/// anything. A verdict that depends on it is NOT COVERED.
void DrawnBuild::addUncovered(DrawnCopy& copy, Pou& pou) {
  const UncoveredBody& body = *copy.block->uncovered;
  sink_.setNetwork(1);
  sink_.report(Syntax::BodyNotCovered, body.span,
               fmt::format("the body of {} is written in {} and is not covered", copy.block->name, body.language));
  Network network;
  network.number = 1;
  network.span = body.span;
  network.form = Form::Fbd;
  network.complete = false;
  network.mayWrite.emplace();
  bool isClosed = true;
  std::set<std::string> seen, inputs;
  for (const DrawnVariable& variable : copy.block->variables) {
    if (variable.section == DrawnSection::Input) inputs.insert(foldedName(variable.name));
  }
  const auto hide = [&](const VariablePlace& place) {
    const Area area = place.operand.area;
    isClosed = isClosed && place.copy == nullptr;
    if (place.copy != nullptr || place.constant || place.operand.kind != OperandKind::Direct || isInputArea(area))
      return;
    if (seen.insert(toString(place.operand)).second) network.mayWrite->push_back(place.operand);
  };
  for (std::size_t at = 0; at < body.text.size();) {
    const auto isPart = [](char c) {
      return isLetter(c) || isDigit(c) || c == '_' || c == '.' || c == '%' ||
             (static_cast<unsigned char>(c) & 0x80) != 0;
    };
    if (!isPart(body.text[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < body.text.size() && isPart(body.text[end])) ++end;
    const std::string_view word(body.text.data() + at, end - at);
    at = end;
    if (const auto address = locatedAddress(word)) hide({IecType::None, *address, std::nullopt, nullptr});
    const VariablePlace* place = lookUp(copy, word);
    if (place == nullptr) place = lookUp(copy, word.substr(0, word.find('.')));
    isClosed = isClosed && (place != nullptr || !blocks_.contains(foldedName(word)));
    if (place != nullptr && !inputs.contains(foldedName(word))) hide(*place);
  }
  for (const DrawnVariable& variable : copy.block->variables) {
    if (variable.section != DrawnSection::Output && variable.section != DrawnSection::InOut) continue;
    const auto place = copy.places.find(foldedName(variable.name));
    if (place != copy.places.end()) hide(place->second);
  }
  const auto result = copy.places.find(foldedName(copy.block->name));
  if (result != copy.places.end()) hide(result->second);
  if (!isClosed) network.mayWrite.reset();
  pou.networks.push_back(std::move(network));
}

void DrawnBuild::buildBody(DrawnCopy& copy, Pou& pou) {
  const DrawnBlock& block = *copy.block;
  open_.push_back(foldedName(block.name));
  sink_.setPlace(pou.name, 0);
  nextLabel_ = 0;
  if (block.uncovered) {
    addUncovered(copy, pou);
  } else {
    restoreLocals(copy, pou);
    for (const DrawnNetwork& network : block.networks) DrawnBlocks::prepare(*this, copy, network);
    DrawnLowering lowering(*this, copy, pou);
    for (const DrawnNetwork& network : block.networks) lowering.body(network, block.form);
  }
  open_.pop_back();
}

void DrawnBuild::addPou(DrawnCopy& copy, PouKind kind) {
  Pou pou;
  pou.kind = kind;
  pou.span = copy.block->span;
  pou.title = copy.block->title.empty() ? copy.block->name : copy.block->title;
  pou.comments = copy.block->comments;
  if (kind == PouKind::Main) {
    pou.name = "MAIN";
    pou.number = 1;
  } else {
    const auto number = memory_.subroutine();
    if (!number) {
      copy.isBroken = true;
      sink_.report(Syntax::XmlStructure, copy.block->span,
                   fmt::format("the CPU has no subroutine left for {}: every instance of a function block needs one",
                               copy.path));
      return;
    }
    copy.number = *number;
    pou.number = *number;
    pou.name = copy.path;
  }
  buildBody(copy, pou);
  program_.pous.push_back(std::move(pou));
}

void DrawnBuild::addMainOf(const std::vector<DrawnCopy*>& programs, Span span) {
  Pou main;
  main.kind = PouKind::Main;
  main.name = "MAIN";
  main.number = 1;
  main.title = "Programs in the order of the tasks";
  main.span = span;
  int number = 0;
  for (const DrawnCopy* copy : programs) {
    if (copy->isBroken) continue;
    Drawing drawing;
    Element rail, call;
    rail.span = call.span = copy->block->span;
    call.shape = Shape::Box;
    call.desc = s7200Instructions().named("CALL");
    call.operands = {constant(copy->number)};
    call.operands[0].span = call.span;
    call.inputs = {{0, false}};
    drawing.elements = {rail, call};
    Network network;
    network.number = ++number;
    network.title = copy->path;
    network.form = copy->block->form;
    network.span = copy->block->span;
    lowerInto(network, std::move(drawing));
    main.networks.push_back(std::move(network));
  }
  program_.pous.push_back(std::move(main));
}

/// Whoever runs the program writes the variable: any value in any scan.
void DrawnBuild::freeVariable(const DrawnVariable& variable, const VariablePlace& place) {
  if (variable.isConstant || !variable.address.empty() || place.copy != nullptr || place.constant) return;
  Operand first = place.operand;
  first.text = "";
  std::string text = "external " + toString(first);
  if (variable.type == IecType::String) {
    Operand last = first;
    last.offset += 80;
    text += ".." + toString(last);
  }
  program_.directives.push_back({std::move(text), variable.span});
}

/// Inputs of a program that have no address, and what it shares with whoever runs it.
void DrawnBuild::freeInputs(const DrawnCopy& program) {
  for (const DrawnVariable& variable : program.block->variables) {
    if (variable.section != DrawnSection::Input && variable.section != DrawnSection::InOut) continue;
    const auto place = program.places.find(foldedName(variable.name));
    if (place != program.places.end()) freeVariable(variable, place->second);
  }
}

/// Global variables that no instruction writes and that nothing gives a value at the start: a panel or another
/// configuration writes them, or nobody needs them.
void DrawnBuild::freeGlobals() {
  const auto isWritten = [&](const Operand& place) {
    for (const Pou& pou : program_.pous) {
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) {
          for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
            const bool isRead =
                i < instruction.desc->operandCount && instruction.desc->operands[i].direction == Direction::In;
            if (!isRead && overlaps(instruction.operands[i], place)) return true;
          }
        }
      }
    }
    return false;
  };
  for (const DrawnVariable& variable : project_.globals) {
    const auto place = globals_.find(foldedName(variable.name));
    if (place == globals_.end() || !variable.initial.empty() || isWritten(place->second.operand)) continue;
    freeVariable(variable, place->second);
  }
}

void DrawnBuild::buildPrograms() {
  std::vector<DrawnInstance> instances;
  for (const DrawnInstance& instance : project_.instances) {
    const auto found = blocks_.find(foldedName(instance.type));
    if (found != blocks_.end() && found->second->kind == DrawnBlockKind::Program)
      instances.push_back(instance);
    else
      sink_.report(
          Syntax::XmlStructure, instance.span,
          fmt::format("task program {} is of type {}, which does not exist", instance.name, excerpt(instance.type)));
  }
  const bool isAssigned = !instances.empty();
  for (const DrawnBlock& block : project_.blocks) {
    if (block.kind != DrawnBlockKind::Program || isAssigned) continue;
    instances.push_back({block.name, block.name, block.span});
  }
  std::vector<DrawnCopy*> programs;
  for (const DrawnInstance& instance : instances) {
    const DrawnBlock& block = *blocks_.at(foldedName(instance.type));
    DrawnCopy* copy = newCopy(block, instances.size() == 1 ? "" : instance.name);
    addPou(*copy, instances.size() == 1 ? PouKind::Main : PouKind::Subroutine);
    programs.push_back(copy);
    freeInputs(*copy);
  }
  if (instances.size() > 1) addMainOf(programs, instances.front().span);
  // A block that nobody calls stands in the program once, so that it is checked; so do those of a library.
  for (const DrawnBlock& block : project_.blocks) {
    const bool isCopied =
        std::any_of(copies_.begin(), copies_.end(), [&](const auto& copy) { return copy->block == &block; });
    if (isCopied && !instances.empty()) continue;
    if (block.kind == DrawnBlockKind::Function) functionCopy(block);
    if (block.kind == DrawnBlockKind::FunctionBlock) addPou(*newCopy(block, block.name), PouKind::Subroutine);
  }
  if (!firstScan_.elements.empty()) {
    const auto main = std::find_if(program_.pous.begin(), program_.pous.end(),
                                   [](const Pou& pou) { return pou.kind == PouKind::Main; });
    if (main != program_.pous.end()) {
      Network network;
      network.number = 0;
      network.title = "Initial values";
      network.form = main->networks.empty() ? Form::Ladder : main->networks.front().form;
      network.span = firstScan_.elements[0].span;
      lowerInto(network, std::move(firstScan_));
      main->networks.insert(main->networks.begin(), std::move(network));
    }
  }
  freeGlobals();
  for (Directive& directive : project_.directives) program_.directives.push_back(std::move(directive));
}

}  // namespace rungproof
