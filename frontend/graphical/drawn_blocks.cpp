// Calls of function blocks.
#include "frontend/graphical/drawn_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/graphical/drawn_functions.hpp"

namespace rungproof {

namespace {

const DrawnPin* pinNamed(const DrawnElement& element, std::initializer_list<std::string_view> names) {
  for (const DrawnPin& pin : element.inputs) {
    const std::string name = foldedName(pin.name);
    for (const std::string_view wanted : names) {
      if (name == wanted) return &pin;
    }
  }
  return nullptr;
}

bool isTimer(StandardBlock block) {
  return block == StandardBlock::Ton || block == StandardBlock::Tof || block == StandardBlock::Tp;
}
bool isCounter(StandardBlock block) {
  return block == StandardBlock::Ctu || block == StandardBlock::Ctd || block == StandardBlock::Ctud;
}

/// The constant at PT, in ms; nothing if it is a variable or cannot be read.
std::optional<std::int64_t> constantPreset(DrawnBuild& build, DrawnCopy& copy, const DrawnNetwork& network,
                                           const DrawnElement& element) {
  const DrawnPin* pt = pinNamed(element, {"PT"});
  if (pt == nullptr) return std::nullopt;
  std::string text = pt->expression;
  if (pt->links.size() == 1) {
    for (const DrawnElement& source : network.elements) {
      if (source.id == pt->links[0].from && source.kind == DrawnKind::InVariable) text = source.text;
    }
  }
  if (const auto literal = iecLiteral(text)) return literal->value;
  const VariablePlace* place = build.lookUp(copy, text);
  if (place != nullptr && place->constant) return place->constant->value;
  return std::nullopt;
}

Operand timerOperand(const DrawnCopy& instance) {
  return direct(Area::T, Width::Bit, static_cast<std::uint32_t>(instance.number));
}

}  // namespace

bool DrawnBlocks::hasMemory(const DrawnBuild& build, const DrawnElement& element) {
  return build.blockNamed(element.text) != nullptr || standardBlockNamed(element.text) != StandardBlock::None;
}

void DrawnBlocks::prepare(DrawnBuild& build, DrawnCopy& copy, const DrawnNetwork& network) {
  for (const DrawnElement& element : network.elements) {
    if (element.kind != DrawnKind::Block || build.blockNamed(element.text) != nullptr) continue;
    const StandardBlock type = standardBlockNamed(element.text);
    VariablePlace* place = type == StandardBlock::None ? nullptr : build.lookUp(copy, element.instance);
    if (place == nullptr || place->copy == nullptr || place->copy->standard != type) continue;
    DrawnCopy& instance = *place->copy;
    if (instance.number >= 0 || instance.isBroken || !instance.places.empty()) continue;
    const auto bit = [&](std::string_view name) {
      if (const auto address = build.temporary(IecType::Bool))
        instance.places[std::string(name)] = VariablePlace{IecType::Bool, *address, std::nullopt, nullptr};
    };
    if (isTimer(type)) {
      const auto ms = constantPreset(build, copy, network, element);
      const auto chosen = build.memory().timerFor(ms.value_or(0));
      if (!chosen) {
        instance.isBroken = true;
        build.sink().operand(element, fmt::format("no timer of the CPU can count {} ms: presets go up to {} steps of "
                                                  "1, 10 or 100 ms, and every timer exists once",
                                                  ms.value_or(0), largestPreset));
        continue;
      }
      instance.number = chosen->number;
      instance.resolution = chosen->resolution;
      if (type == StandardBlock::Tp)
        bit("Q");
      else
        instance.places["Q"] = VariablePlace{IecType::Bool, timerOperand(instance), std::nullopt, nullptr};
      const bool wantsTime = build.isMentioned(element.instance, "ET") ||
                             std::any_of(element.outputs.begin(), element.outputs.end(), [&](const DrawnPin& pin) {
                               return foldedName(pin.name) == "ET" && !pin.expression.empty();
                             });
      const bool hasLine =
          std::any_of(network.elements.begin(), network.elements.end(), [&](const DrawnElement& other) {
            return std::any_of(other.inputs.begin(), other.inputs.end(), [&](const DrawnPin& pin) {
              return std::any_of(pin.links.begin(), pin.links.end(), [&](const DrawnLink& link) {
                return link.from == element.id && foldedName(link.pin) == "ET";
              });
            });
          });
      if (wantsTime || hasLine) {
        if (const auto address = build.temporary(IecType::Time))
          instance.places["ET"] = VariablePlace{IecType::Time, *address, std::nullopt, nullptr};
      }
    } else if (isCounter(type)) {
      if (const auto address = build.temporary(IecType::Int))
        instance.places["CV"] = VariablePlace{IecType::Int, *address, std::nullopt, nullptr};
      bit(type == StandardBlock::Ctud ? "QU" : "Q");
      if (type == StandardBlock::Ctud) bit("QD");
    } else {
      bit(type == StandardBlock::Sr || type == StandardBlock::Rs ? "Q1" : "Q");
    }
  }
}

const DrawnPin* DrawnBlocks::pin(const DrawnElement& element, std::initializer_list<std::string_view> names) const {
  return pinNamed(element, names);
}

std::optional<Wire> DrawnBlocks::powerIn(const DrawnElement& element, std::initializer_list<std::string_view> names,
                                         bool isRequired) {
  const DrawnPin* found = pin(element, names);
  const bool isOpen = found == nullptr || (found->links.empty() && found->expression.empty());
  if (isOpen && !isRequired) return Wire{0, true};
  return l_.powerAt(element, found, *names.begin());
}

bool DrawnBlocks::isAsked(int i, const DrawnElement& element, std::string_view name) const {
  for (const DrawnCircuit::Consumer& consumer : l_.circuit_->consumersOf(i)) {
    const std::string asked = foldedName(consumer.link->pin);
    if (asked == name || (asked.empty() && (name.front() == 'Q'))) return true;
  }
  return std::any_of(element.outputs.begin(), element.outputs.end(),
                     [&](const DrawnPin& out) { return foldedName(out.name) == name && !out.expression.empty(); });
}

/// Makes an output available to those who asked for it, and writes it where the drawing says so at the pin.
void DrawnBlocks::deliver(int i, const DrawnElement& element, std::string_view name, const VariablePlace& place) {
  if (!isAsked(i, element, name)) return;
  DrawnValue value = l_.readPlace(place, element);
  l_.fresh_ = 0;
  for (const DrawnPin& out : element.outputs) {
    if (foldedName(out.name) != name) continue;
    if (out.negated && value.isPower()) value.wire = l_.inverted(value.wire);
    if (out.expression.empty()) continue;
    if (const auto target = l_.resolve(out.expression, element)) l_.moveTo(*target, value, l_.rail(), element);
  }
  l_.states_[static_cast<std::size_t>(i)].outputs.emplace_back(std::string(name), value);
}

std::optional<Operand> DrawnBlocks::presetOf(const DrawnElement& element, const DrawnCopy& instance,
                                             DrawnValue& value) {
  const DrawnPin* pt = pin(element, {"PT"});
  if (pt == nullptr || (pt->links.empty() && pt->expression.empty())) {
    l_.sink_.operand(element, "input PT is left open");
    return std::nullopt;
  }
  value = l_.input(element, *pt);
  if (!value.isData() || widthOf(value.type == IecType::None ? IecType::Time : value.type) != Width::DWord ||
      value.type == IecType::Real) {
    if (value.kind != DrawnValue::Kind::Nothing) l_.sink_.operand(element, "PT must be a TIME");
    return std::nullopt;
  }
  if (value.operand.kind == OperandKind::Constant) {
    const std::int64_t ms = value.operand.value;
    if (ms >= 0 && ms % instance.resolution == 0 && ms / instance.resolution <= largestPreset)
      return constant(ms / instance.resolution);
    l_.sink_.operand(element, fmt::format("{} ms cannot be counted by {}, which has steps of {} ms", ms,
                                          toString(timerOperand(instance)), instance.resolution));
    return std::nullopt;
  }
  l_.sink_.operand(element, fmt::format("PT is a variable, and {} counts in steps of {} ms: give PT a literal",
                                        toString(timerOperand(instance)), instance.resolution));
  return std::nullopt;
}

bool DrawnBlocks::elapsedTime(const DrawnElement& element, DrawnCopy& instance, const DrawnValue& preset) {
  const auto place = instance.places.find("ET");
  if (place == instance.places.end()) return true;
  if (instance.standard == StandardBlock::Tp) {
    l_.sink_.operand(element, "ET of a TP is not kept on the S7-200");
    return false;
  }
  const Operand& time = place->second.operand;
  l_.box("ITD", {timerOperand(instance), time}, l_.rail());
  if (instance.resolution != 1) l_.box("*D", {constant(instance.resolution), time}, l_.rail());
  // A TON counts on behind its preset.
  if (instance.standard == StandardBlock::Ton)
    l_.box("MOVD", {preset.operand, time}, l_.compare("LDD>", time, preset.operand, l_.rail()));
  return true;
}

/// The latch is set by the rising edge and held until the timer has run out; the output is the latch while it has not.
/// An edge right after the end finds the timer still on and sets it back.
void DrawnBlocks::pulse(DrawnCopy& instance, const Operand& preset, Wire in) {
  const Operand latch = l_.temporary(IecType::Bool);
  const Operand start = l_.temporary(IecType::Bool);
  const Operand number = timerOperand(instance);
  const auto stillOn = [&](Wire input) { return l_.add(Shape::Contact, "LDN", {number}, {input}); };
  l_.assign(start, l_.edge(in, DrawnEdge::Rising));
  l_.assign(latch, l_.gate(Shape::Or, {stillOn(l_.contact(latch, l_.rail())), l_.contact(start, l_.rail())}));
  l_.coil("R", {number, constant(1)}, l_.contact(number, l_.contact(start, l_.rail())));
  l_.add(Shape::Box, "TON", {number, preset}, {l_.contact(latch, l_.rail())});
  l_.assign(instance.places.at("Q").operand, stillOn(l_.contact(latch, l_.rail())));
}

bool DrawnBlocks::timer(const DrawnElement& element, DrawnCopy& instance, Wire in) {
  DrawnValue value;
  const std::optional<Operand> preset = presetOf(element, instance, value);
  if (!preset) return false;
  if (instance.standard == StandardBlock::Tp) {
    pulse(instance, *preset, in);
  } else {
    l_.add(Shape::Box, instance.standard == StandardBlock::Ton ? "TON" : "TOF", {timerOperand(instance), *preset},
           {in});
  }
  return elapsedTime(element, instance, value);
}

bool DrawnBlocks::counter(const DrawnElement& element, DrawnCopy& instance, const Counted& in) {
  const DrawnPin* pv = pin(element, {"PV"});
  if (pv == nullptr || (pv->links.empty() && pv->expression.empty())) {
    l_.sink_.operand(element, "input PV is left open");
    return false;
  }
  const DrawnValue value = l_.input(element, *pv);
  if (value.kind == DrawnValue::Kind::Nothing) return false;
  const std::optional<Operand> preset = l_.widened(value, Arithmetic::Int, l_.rail(), element);
  if (!preset) return false;
  const Operand& count = instance.places.at("CV").operand;
  const auto bitOf = [&](Wire wire) {
    const Operand bit = l_.temporary(IecType::Bool);
    l_.assign(bit, wire);
    return bit;
  };
  const auto edgeOf = [&](const std::optional<Wire>& wire) {
    return wire ? std::optional(bitOf(l_.edge(*wire, DrawnEdge::Rising))) : std::nullopt;
  };
  // Edges count in every scan, also while the counter is reset or loaded.
  const auto load = in.load ? std::optional(bitOf(*in.load)) : std::nullopt;
  const auto reset = in.reset ? std::optional(bitOf(*in.reset)) : std::nullopt;
  const auto up = edgeOf(in.up), down = edgeOf(in.down);
  /// Edges of both inputs in one scan cancel each other.
  const auto alone = [&](const Operand& one, const std::optional<Operand>& other) {
    const Wire wire = l_.contact(one, l_.rail());
    return other ? l_.gate(Shape::And, {wire, l_.inverted(l_.contact(*other, l_.rail()))}) : wire;
  };
  constexpr std::int64_t most = 32767;
  if (up) l_.box("+I", {constant(1), count}, l_.compare("LDW<", count, constant(most), alone(*up, down)));
  if (down) l_.box("-I", {constant(1), count}, l_.compare("LDW>", count, constant(0), alone(*down, up)));
  if (load) l_.box("MOVW", {*preset, count}, l_.contact(*load, l_.rail()));
  if (reset) l_.box("MOVW", {constant(0), count}, l_.contact(*reset, l_.rail()));
  const auto assign = [&](std::string_view name, std::string_view relation, const Operand& limit) {
    l_.assign(instance.places.at(std::string(name)).operand, l_.compare(relation, count, limit, l_.rail()));
  };
  if (up) assign(down ? "QU" : "Q", "LDW>=", *preset);
  if (down) assign(up ? "QD" : "Q", "LDW<=", constant(0));
  return true;
}

bool DrawnBlocks::standard(int i, const DrawnElement& element, DrawnCopy& instance, Wire& enable) {
  if (instance.isBroken || instance.places.empty()) return false;
  // All inputs first: they are computed whether the block is executed or not.
  std::vector<Wire> in;
  const auto read = [&](std::initializer_list<std::string_view> names, bool isRequired) {
    const auto wire = powerIn(element, names, isRequired);
    in.push_back(wire.value_or(Wire{0, true}));
    return wire.has_value();
  };
  bool isGood = false;
  switch (instance.standard) {
    case StandardBlock::Ton:
    case StandardBlock::Tof:
    case StandardBlock::Tp: isGood = read({"IN"}, true); break;
    case StandardBlock::Ctu: isGood = read({"CU"}, true) && read({"R", "RESET"}, false); break;
    case StandardBlock::Ctd: isGood = read({"CD"}, true) && read({"LD", "LOAD"}, false); break;
    case StandardBlock::Ctud:
      isGood = read({"CU"}, false) && read({"CD"}, false) && read({"R", "RESET"}, false) && read({"LD", "LOAD"}, false);
      break;
    case StandardBlock::Sr: isGood = read({"S1", "SET1", "S"}, true) && read({"R", "RESET", "R1"}, false); break;
    case StandardBlock::Rs: isGood = read({"S", "SET", "S1"}, true) && read({"R1", "RESET1", "R"}, false); break;
    default: isGood = read({"CLK"}, true); break;
  }
  if (!isGood) return false;
  const bool isGuarded = !l_.isTrue(enable);
  int label = 0;
  Operand enableBit;
  if (isGuarded) {
    for (Wire& wire : in) {
      if (wire.from != 0) wire = l_.throughMemory(wire);
    }
    enableBit = l_.temporary(IecType::Bool);
    l_.assign(enableBit, enable);
    label = l_.build_.newLabel();
    l_.coil("JMP", {constant(label)}, l_.inverted(l_.contact(enableBit, l_.rail())));
  }
  Wire edge;
  switch (instance.standard) {
    case StandardBlock::Ton:
    case StandardBlock::Tof:
    case StandardBlock::Tp: isGood = timer(element, instance, in[0]); break;
    case StandardBlock::Ctu: isGood = counter(element, instance, {.up = in[0], .reset = in[1]}); break;
    case StandardBlock::Ctd: isGood = counter(element, instance, {.down = in[0], .load = in[1]}); break;
    case StandardBlock::Ctud:
      isGood = counter(element, instance, {.up = in[0], .down = in[1], .reset = in[2], .load = in[3]});
      break;
    case StandardBlock::Sr:
    case StandardBlock::Rs: {
      const Operand bit = instance.places.at("Q1").operand;
      const Wire held = l_.contact(bit, l_.rail());
      const Wire off = l_.inverted(in[1]);
      const Wire on = instance.standard == StandardBlock::Sr
                          ? l_.gate(Shape::Or, {in[0], l_.gate(Shape::And, {held, off})})
                          : l_.gate(Shape::And, {l_.gate(Shape::Or, {in[0], held}), off});
      l_.assign(bit, on);
      break;
    }
    default:
      edge = l_.edge(in[0], instance.standard == StandardBlock::RTrig ? DrawnEdge::Rising : DrawnEdge::Falling);
      if (isGuarded || l_.circuit_->isCut(i) || l_.build_.isMentioned(element.instance, "Q"))
        l_.assign(instance.places.at("Q").operand, edge);
      break;
  }
  if (isGuarded) {
    l_.add(Shape::Coil, "LBL", {constant(label)}, {});
    enable = l_.contact(enableBit, l_.rail());
  }
  if (!isGood) return false;
  const bool isEdge = instance.standard == StandardBlock::RTrig || instance.standard == StandardBlock::FTrig;
  if (isEdge && !isGuarded) {
    DrawnValue value = l_.power(edge);
    for (const DrawnPin& out : element.outputs) {
      if (foldedName(out.name) != "Q") continue;
      if (out.negated) value.wire = l_.inverted(value.wire);
      if (out.expression.empty()) continue;
      if (const auto target = l_.resolve(out.expression, element)) l_.moveTo(*target, value, l_.rail(), element);
    }
    l_.states_[static_cast<std::size_t>(i)].outputs.emplace_back("Q", value);
    return true;
  }
  for (const auto& [name, place] : instance.places) {
    if (!l_.circuit_->isCut(i)) deliver(i, element, name, place);
  }
  return true;
}

bool DrawnBlocks::project(int i, const DrawnElement& element, const DrawnBlock& block, DrawnCopy& instance,
                          Wire enable) {
  // Inputs in the order of the drawing, then the call, then what comes back.
  std::vector<std::pair<const DrawnPin*, VariablePlace>> inOuts;
  for (const DrawnPin& in : element.inputs) {
    const std::string name = foldedName(in.name);
    if (name == "EN" || (in.links.empty() && in.expression.empty())) continue;
    const auto place = instance.places.find(name);
    if (place == instance.places.end()) {
      l_.sink_.operand(element, fmt::format("{} has no input {}", block.name, in.name));
      return false;
    }
    const DrawnValue value = l_.input(element, in);
    if (value.kind == DrawnValue::Kind::Nothing) return false;
    l_.moveTo(place->second, value, l_.rail(), element);
    const bool isInOut =
        std::any_of(block.variables.begin(), block.variables.end(), [&](const DrawnVariable& variable) {
          return variable.section == DrawnSection::InOut && foldedName(variable.name) == name;
        });
    if (isInOut) inOuts.emplace_back(&in, place->second);
  }
  Operand number = constant(instance.number);
  number.text = block.name;
  l_.box("CALL", {number}, enable);
  for (const auto& [in, place] : inOuts) {
    std::string text = in->expression;
    if (in->links.size() == 1) {
      const int from = l_.circuit_->sourceOf(in->links[0]);
      if (from != DrawnCircuit::nothing && l_.circuit_->element(from).kind != DrawnKind::Block)
        text = l_.circuit_->element(from).text;
    }
    if (text.empty()) {
      l_.sink_.operand(element, fmt::format("in-out parameter {} needs a variable", in->name));
      return false;
    }
    const auto actual = l_.resolve(text, element);
    if (!actual) return false;
    const DrawnValue back = l_.readPlace(place, element);
    l_.moveTo(*actual, back, back.isPower() ? l_.rail() : enable, element);
  }
  const bool isFunction = block.kind == DrawnBlockKind::Function;
  for (const DrawnPin& out : element.outputs) {
    const std::string name = foldedName(out.name);
    if (name == "ENO") continue;
    auto place = instance.places.find(name);
    if (place == instance.places.end() && isFunction) place = instance.places.find(foldedName(block.name));
    if (place == instance.places.end()) {
      l_.sink_.operand(element, fmt::format("{} has no output {}", block.name, out.name));
      return false;
    }
    if (l_.circuit_->isCut(i) && out.expression.empty()) continue;
    bool isWanted = !out.expression.empty();
    for (const DrawnCircuit::Consumer& consumer : l_.circuit_->consumersOf(i))
      isWanted = isWanted || consumer.link->pin.empty() || foldedName(consumer.link->pin) == name;
    if (!isWanted) continue;
    DrawnValue value = l_.readPlace(place->second, element);
    l_.fresh_ = 0;
    if (isFunction && value.isPower()) value.wire = l_.throughMemory(value.wire);
    if (isFunction && value.isData()) {
      const Operand own = l_.temporary(value.type);
      l_.moveTo(VariablePlace{value.type, own, std::nullopt, nullptr}, value, enable, element);
      value.operand = own;
    }
    if (out.negated && value.isPower()) value.wire = l_.inverted(value.wire);
    if (!out.expression.empty()) {
      if (const auto target = l_.resolve(out.expression, element)) l_.moveTo(*target, value, enable, element);
    }
    l_.states_[static_cast<std::size_t>(i)].outputs.emplace_back(name, value);
  }
  return true;
}

bool DrawnBlocks::call(int i, const DrawnElement& element, Wire& enable) {
  const DrawnBlock* block = l_.build_.blockNamed(element.text);
  if (block != nullptr && block->kind == DrawnBlockKind::Function) {
    DrawnCopy* copy = l_.build_.functionCopy(*block);
    if (copy == nullptr) l_.sink_.circuit(element, "the function calls itself");
    return copy != nullptr && !copy->isBroken && project(i, element, *block, *copy, enable);
  }
  if (element.instance.empty()) {
    l_.sink_.operand(element, "it needs an instance");
    return false;
  }
  const VariablePlace* place = l_.build_.lookUp(l_.copy_, element.instance);
  const bool isSame = place != nullptr && place->copy != nullptr && place->copy->block == block &&
                      (block != nullptr || place->copy->standard == standardBlockNamed(element.text));
  if (!isSame) {
    l_.sink_.operand(element, fmt::format("{} is not declared as an instance of {}", element.instance, element.text));
    return false;
  }
  if (place->copy->isBroken) return false;
  return block != nullptr ? project(i, element, *block, *place->copy, enable)
                          : standard(i, element, *place->copy, enable);
}

bool DrawnLowering::block(int i, const DrawnElement& e) {
  Wire enable = rail();
  for (const DrawnPin& pin : e.inputs) {
    if (foldedName(pin.name) != "EN" || (pin.links.empty() && pin.expression.empty())) continue;
    const auto wire = powerAt(e, &pin, "EN");
    if (!wire) return false;
    enable = *wire;
  }
  fresh_ = 0;
  State& state = states_[static_cast<std::size_t>(i)];
  if (DrawnBlocks::hasMemory(build_, e)) {
    if (!DrawnBlocks(*this).call(i, e, enable)) return false;
    state.outputs.emplace_back("ENO", power(enable));
    return true;
  }
  if (!DrawnFunctions::isKnown(e.text)) {
    sink_.circuit(e, fmt::format("{} is neither a standard block nor a block of the project", e.text));
    return false;
  }
  // A number with one reader goes straight into the reader's variable.
  std::optional<VariablePlace> target;
  int reader = DrawnCircuit::nothing;
  const DrawnPin* out = nullptr;
  for (const DrawnPin& pin : e.outputs) {
    if (out == nullptr && foldedName(pin.name) != "ENO") out = &pin;
  }
  if (out != nullptr && !out->expression.empty()) {
    target = resolve(out->expression, e);
    if (!target) return false;
  } else {
    int readers = 0;
    for (const DrawnCircuit::Consumer& consumer : circuit_->consumersOf(i)) {
      if (foldedName(consumer.link->pin) == "ENO") continue;
      ++readers;
      reader = consumer.element;
    }
    const bool isVariable = readers == 1 && circuit_->element(reader).kind == DrawnKind::OutVariable &&
                            !circuit_->element(reader).negated && circuit_->element(reader).inputs[0].links.size() == 1;
    if (isVariable) target = resolve(circuit_->element(reader).text, circuit_->element(reader));
    if (!isVariable || !target) reader = DrawnCircuit::nothing;
  }
  DrawnValue value = DrawnFunctions(*this, e, enable).run(target ? &*target : nullptr);
  if (value.kind == DrawnValue::Kind::Nothing) return false;
  const bool isInPlace = target && value.isData() && value.operand.kind == OperandKind::Direct &&
                         value.operand.area == target->operand.area && value.operand.offset == target->operand.offset &&
                         value.operand.width == target->operand.width;
  if (isInPlace && reader != DrawnCircuit::nothing) states_[static_cast<std::size_t>(reader)].isWritten = true;
  for (const DrawnPin& pin : e.outputs) {
    const std::string name = foldedName(pin.name);
    if (name == "ENO") continue;
    DrawnValue one = value;
    if (pin.negated && one.isPower()) one.wire = inverted(one.wire);
    if (!pin.expression.empty() && !(isInPlace && &pin == out)) {
      if (const auto place = resolve(pin.expression, e)) moveTo(*place, one, enable, e);
    }
    state.outputs.emplace_back(name, one);
  }
  if (out == nullptr) state.outputs.emplace_back("", value);
  state.outputs.emplace_back("ENO", power(enable));
  return true;
}

}  // namespace rungproof
