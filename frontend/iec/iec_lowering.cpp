// Projects: variables and their places, instances, routines, the entry block.
#include "frontend/iec/iec_lowering.hpp"

#include <set>
#include <utility>

#include "frontend/iec/iec_suppressions.hpp"
#include "frontend/iec/iec_value_limits.hpp"
#include "ir/iec/cpu.hpp"
#include "ir/iec/dialect.hpp"
#include "ir/iec/walk.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof::iec {

Lowering::Lowering(Program& program, const ProjectSyntax& project, std::uint32_t file)
    : program_(program), project_(project), sink_(program, file), types_(project, sink_) {
  for (const BlockSyntax& block : project.blocks) {
    if (!blocks_.emplace(foldedName(block.name), &block).second)
      error(Syntax::BlockTwice, block.span, fmt::format("two blocks are named {}", excerpt(block.name)));
  }
}

void Lowering::error(Syntax code, Span span, std::string message) { sink_.report(code, span, std::move(message)); }

void Lowering::refuse(Span span, std::string message, Syntax code) {
  error(code, span, std::move(message));
  throw Refused{};
}

std::uint32_t Lowering::allocate(std::uint32_t bytes) {
  const std::uint32_t offset = next_;
  if (bytes > mostBytes - next_) {
    if (!std::exchange(isFull_, true))
      error(Syntax::IecNotModelled, Span{sink_.file(), 0, 0},
            fmt::format("all variables together have more than {} bytes", mostBytes));
    throw Refused{};
  }
  next_ += bytes;
  initial_.resize(next_);
  return offset;
}

void Lowering::run() {
  const auto asksEnabled = [&](const Expr& expr) {
    asksEnabled_ = asksEnabled_ || (expr.parts.size() > 1 && foldedName(expr.parts.back().name) == "ENO");
  };
  for (const BlockSyntax& block : project_.blocks) {
    eachStatementOf(block,
                    [&](const Statement& one, const Statements&, std::size_t) { eachExpression(one, asksEnabled); });
  }
  declareGlobals();
  findSharedAddresses();
  findChangingPresets();
  makePrograms();
  program_.target = Target(static_cast<Cpu>(firstIecCpu), Edition::Iec);
  chooseMachine();
  freeUnwrittenGlobals();
  freeAccessed();
  nameVariables();
  freeNamedVariables();
  nameOperands();
  findKeptLimits(program_, initial_);
  program_.data.push_back({0, initial_, {}});
  for (const Directive& directive : project_.directives) program_.directives.push_back(directive);
}

void Lowering::declareGlobals() {
  for (const VariableSyntax& variable : project_.globals) {
    try {
      const auto [at, isNew] = globals_.emplace(foldedName(variable.name), makeVariable(variable, ""));
      if (!isNew)
        error(Syntax::IecName, variable.span, fmt::format("two global variables are named {}", excerpt(variable.name)));
      if (at->second.constant) types_.constants[at->first] = *at->second.constant;
    } catch (const Refused&) {
    }
  }
}

Variable Lowering::makeVariable(const VariableSyntax& syntax, const std::string& path) {
  if (syntax.isRetain) {
    const std::uint32_t first = next_;
    VariableSyntax plain = syntax;
    plain.isRetain = false;
    Variable kept = makeVariable(plain, path);
    kept.declared = &syntax;
    if (next_ > first) program_.retained.emplace_back(first, next_ - 1);
    return kept;
  }
  Variable made;
  made.declared = &syntax;
  made.type = types_.resolve(*syntax.type);
  if (made.type == nullptr) throw Refused{};
  const Initial* initial = syntax.initial != nullptr ? syntax.initial.get() : made.type->initial;
  const std::string full = path.empty() ? syntax.name : path + "." + syntax.name;
  if (made.type->kind == Kind::Block) {
    made.instance = makeInstance(*made.type->block, full);
    if (made.type->block->isLibrary && made.type->block->name == "__STEP")
      steps_.emplace_back(made.instance, syntax.longestClock);
    if (initial != nullptr && initial->isStructure) {
      for (const auto& [field, value] : initial->fields) {
        const auto member = made.instance->memberNamed(foldedName(field));
        if (member == made.instance->names.end())
          refuse(value.span, fmt::format("block {} has no variable {}", made.type->name, excerpt(field)),
                 Syntax::IecName);
        initialize(*member->second.type, member->second.offset, &value);
        const auto preset = value.value != nullptr ? types_.integer(*value.value) : std::nullopt;
        if (foldedName(field) == "PT" && made.instance->longestPreset)
          made.instance->longestPreset =
              preset ? std::optional(std::max(*made.instance->longestPreset, *preset)) : std::nullopt;
      }
    }
    return made;
  }
  if (made.type->kind == Kind::Array && made.type->element->kind == Kind::Block) {
    const auto& [low, high] = made.type->bounds[0];
    if (made.type->bounds.size() != 1 || high - low > 1000)
      refuse(syntax.span, "such an array of blocks is not modelled", Syntax::IecNotModelled);
    for (std::int64_t i = low; i <= high; ++i)
      made.elements.push_back(makeInstance(*made.type->element->block, fmt::format("{}[{}]", full, i)));
    return made;
  }
  if (syntax.isConstant && initial != nullptr && initial->value != nullptr && made.type->isValue()) {
    made.constant = types_.constant(*initial->value);
    if (!made.constant) refuse(initial->span, "the value of a constant is no constant expression");
    expectInitial(*made.constant, *made.type, initial->span);
    if (made.constant->type == nullptr && !made.constant->isReal)
      made.constant->type = made.type->kind == Kind::Real ? nullptr : made.type;
    return made;
  }
  if (!syntax.address.empty()) {
    const auto offset = located(syntax, *made.type);
    if (!offset) refuse(syntax.span, fmt::format("{} is no address", excerpt(syntax.address)));
    made.offset = *offset;
  } else {
    made.offset = allocate(made.type->bytes);
  }
  initialize(*made.type, made.offset, initial);
  if (syntax.type->form == TypeForm::Named && foldedName(syntax.type->name).starts_with(panelPrefix))
    freeVariable(*made.type, made.offset, syntax.span);
  return made;
}

void Lowering::initialize(const Type& type, std::uint32_t offset, const Initial* initial) {
  if (initial == nullptr) initial = type.initial;
  const bool fits = initial == nullptr || initial->isRow == (type.kind == Kind::Array);
  if (!fits || (initial != nullptr && initial->isStructure != (type.kind == Kind::Struct)))
    refuse(initial->span, fmt::format("this is no value of type {}", type.name));
  if (type.kind == Kind::Array) {
    std::uint32_t at = offset;
    const std::uint32_t size = type.element->bytes;
    std::vector<const Initial*> given;
    std::uint64_t values = 0;
    for (std::size_t i = 0; initial != nullptr && i < initial->row.size(); ++i) values += initial->row[i].first;
    if (size > 0 && values > type.bytes / size)
      refuse(initial->span, fmt::format("{} initial values are given for {} elements", values, type.bytes / size));
    for (std::size_t i = 0; initial != nullptr && i < initial->row.size(); ++i) {
      for (std::uint32_t k = 0; k < initial->row[i].first && given.size() * size < type.bytes; ++k)
        given.push_back(&initial->row[i].second);
    }
    for (std::size_t i = 0; size > 0 && i < type.bytes / size; ++i, at += size)
      initialize(*type.element, at, i < given.size() ? given[i] : nullptr);
    return;
  }
  if (type.kind == Kind::Struct) {
    for (const Field& field : type.fields) {
      const Initial* own = field.declared->initial.get();
      if (initial != nullptr) {
        for (const auto& [name, value] : initial->fields) {
          if (foldedName(name) == foldedName(field.name)) own = &value;
        }
      }
      initialize(*field.type, offset + field.offset, own);
    }
    return;
  }
  if (isText(&type)) {
    if (initial != nullptr && initial->value != nullptr) writeTextInitial(offset, type.bytes, *initial->value);
    return;
  }
  if (!type.isValue()) return;
  if (initial == nullptr || initial->value == nullptr) {
    if (!type.isLong() && (type.low > 0 || type.high < 0 || isSubrange(type)))
      writeInitial(type, offset, {&type, type.low});
    if (isSubrange(type) && type.low < 0 && type.high >= 0)
      openStarts_.emplace_back(&type, offset);
    else if (type.kind == Kind::Enum && !type.items.empty())
      writeInitial(type, offset, {&type, type.items[0].second});
    return;
  }
  const auto value = types_.constant(*initial->value);
  if (!value) {
    std::string reason = "an initial value is a constant";
    if (initial->value->kind == ExprKind::Literal) static_cast<void>(literalValue(*initial->value, reason));
    refuse(initial->span, reason);
  }
  expectInitial(*value, type, initial->span);
  tellPattern(*value, type, initial->span);
  writeInitial(type, offset, *value);
}

/// Refuses a value of a declaration that no variable of the type can hold.
void Lowering::expectInitial(const Value& value, const Type& type, Span span) {
  if (type.kind == Kind::Real) {
    if (value.isReal && !isWithinReal(value.real, type.width))
      refuse(span, fmt::format("the number is too large for {}", type.name));
    return;
  }
  expectFits(value, type, span);
  const bool isOutside = value.isHuge || value.number < type.low || value.number > type.high;
  if (isSubrange(type) && !type.isLong() && isOutside)
    refuse(span, fmt::format("{} is not within {}..{}", value.number, type.low, type.high));
}

void Lowering::writeInitial(const Type& type, std::uint32_t offset, const Value& value) {
  std::uint64_t bits = static_cast<std::uint64_t>(value.number);
  if (type.kind == Kind::Real) {
    const double real = value.isReal ? value.real : static_cast<double>(value.number);
    bits = static_cast<std::uint64_t>(realPattern(real, type.width));
  }
  if (type.kind == Kind::Time && type.isLong() && value.type != nullptr && !value.type->isLong()) bits *= 1'000'000;
  for (std::uint32_t i = 0; i < type.bytes; ++i)
    initial_[offset + i] = static_cast<std::uint8_t>(bits >> (8 * (type.bytes - 1 - i)));
}

/// Whether an instance of the block has one of the same block in it.
bool Lowering::containsItself(const BlockSyntax& block) const {
  std::set<const BlockSyntax*> met;
  std::vector<const BlockSyntax*> open = {&block};
  while (!open.empty()) {
    const BlockSyntax& one = *open.back();
    open.pop_back();
    for (const VariableSyntax& variable : one.variables) {
      const TypeSyntax* type = variable.type.get();
      while (type != nullptr && type->form == TypeForm::Array) type = type->element.get();
      const auto found = type == nullptr ? blocks_.end() : blocks_.find(foldedName(type->name));
      const bool isInstance = variable.section != Section::External && variable.section != Section::InOut;
      if (found == blocks_.end() || !isInstance) continue;
      if (found->second == &block) return true;
      if (met.insert(found->second).second) open.push_back(found->second);
    }
  }
  return false;
}

BlockInstance* Lowering::makeInstance(const BlockSyntax& block, std::string path) {
  constexpr int deepest = 32;
  constexpr std::size_t most = 50'000;
  if (depth_ >= deepest || instances_.size() >= most) {
    if (std::exchange(isTooNested_, true)) throw Refused{};
    if (containsItself(block)) refuse(block.span, fmt::format("instances of {} contain each other", block.name));
    refuse(block.span, depth_ >= deepest
                           ? fmt::format("instances of {} stand in more than {} others", block.name, deepest)
                           : fmt::format("the program has more than {} instances of blocks", most));
  }
  ++depth_;
  BlockInstance& made = instances_.emplace_back();
  made.block = &block;
  made.path = std::move(path);
  for (const VariableSyntax& variable : block.variables) {
    const std::string name = foldedName(variable.name);
    try {
      if (variable.section == Section::External) {
        const auto global = globals_.find(name);
        if (global == globals_.end()) {
          Variable& own = made.names[name] = makeVariable(variable, made.path);
          freeVariable(*own.type, own.offset, variable.span);
        } else {
          made.names[name] = global->second;
        }
        continue;
      }
      if (variable.section == Section::InOut) {
        made.hasInOut = true;
        Variable formal;
        formal.type = types_.resolve(*variable.type);
        formal.declared = &variable;
        if (formal.type == nullptr) throw Refused{};
        made.names[name] = formal;
        continue;
      }
      const auto [at, isNew] = made.names.emplace(name, makeVariable(variable, made.path));
      if (!isNew)
        error(Syntax::IecName, variable.span, fmt::format("two variables are named {}", excerpt(variable.name)));
      // What an output of a library's block begins with nobody knows.
      if (isNew && block.isContract && at->second.type->kind != Kind::Block)
        freeVariable(*at->second.type, at->second.offset, variable.span);
      if (isNew && variable.edge != EdgeOf::None) {
        if (at->second.type->kind != Kind::Bool) refuse(variable.span, "R_EDGE and F_EDGE belong to a BOOL");
        made.edges[name] = {at->second.offset, allocate(1), variable.edge == EdgeOf::Rising};
        at->second.offset = allocate(1);
      }
    } catch (const Refused&) {
    }
  }
  if (block.kind == BlockKind::Function && block.result != nullptr) {
    Variable& result = made.names[foldedName(block.name)];
    result.type = types_.resolve(*block.result);
    if (result.type != nullptr) result.offset = allocate(result.type->bytes);
  }
  const std::string name = foldedName(block.name);
  if (asksEnabled_ && block.kind == BlockKind::FunctionBlock && !made.names.contains("ENO")) made.enabled = allocate(1);
  if (block.isLibrary && (name == "TON" || name == "TOF" || name == "TP")) timers_.push_back(&made);
  --depth_;
  return &made;
}

BlockInstance* Lowering::functionNamed(const std::string& name) {
  const auto block = blocks_.find(name);
  if (block == blocks_.end() || block->second->kind != BlockKind::Function) return nullptr;
  BlockInstance*& made = functions_[name];
  if (made == nullptr) made = makeInstance(*block->second, block->second->name);
  const auto result = made->names.find(name);
  if (result == made->names.end() || result->second.type == nullptr) throw Refused{};
  return made;
}

/// At the begin of a body: inputs with R_EDGE or F_EDGE show an edge of what is given, as R_TRIG and F_TRIG find it.
void Lowering::findEdges(const BlockInstance& instance) {
  const Type& boolean = *elementaryType("BOOL");
  for (const auto& [name, edge] : instance.edges) {
    const auto given = [&] {
      load(boolean, edge.given);
      if (!edge.isRising) emit("NOT", {1});
    };
    given();
    load(boolean, edge.memory);
    emit("NOT", {1});
    emit("AND", {1});
    store(boolean, instance.names.at(name).offset);
    given();
    store(boolean, edge.memory);
  }
}

/// Locals of functions and VAR_TEMP begin anew in every call.
void Lowering::freshLocals(Scope& scope) {
  findEdges(*scope.self);
  const BlockSyntax& block = *scope.self->block;
  const bool isFunction = block.kind == BlockKind::Function;
  const auto fresh = [&](auto&& self, const Type& type, std::uint32_t offset) -> void {
    if (isText(&type)) {
      const TextAt start = freshText(type.bytes);
      std::copy_n(initial_.begin() + offset, type.bytes, initial_.begin() + start.offset);
      return emitTexts("COPY.TEXT", {start, {offset, type.bytes}});
    }
    if (type.isValue()) {
      std::int64_t value = 0;
      for (std::uint32_t i = 0; i < type.bytes; ++i)
        value = static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << 8 | initial_[offset + i]);
      constant(value, type.width);
      return store(type, offset);
    }
    if (type.kind == Kind::Struct) {
      for (const Field& field : type.fields) self(self, *field.type, offset + field.offset);
    } else if (type.kind == Kind::Array && type.element->bytes > 0) {
      if (type.bytes / type.element->bytes > 1000)
        refuse(block.span, "a temporary array of such a length is not modelled", Syntax::IecNotModelled);
      for (std::uint32_t at = 0; at < type.bytes; at += type.element->bytes) self(self, *type.element, offset + at);
    }
  };
  for (const VariableSyntax& variable : block.variables) {
    const bool isFresh = variable.section == Section::Temp ||
                         (isFunction && (variable.section == Section::Local || variable.section == Section::Output));
    const auto found = scope.self->names.find(foldedName(variable.name));
    if (!isFresh || found == scope.self->names.end() || found->second.type == nullptr || found->second.constant)
      continue;
    fresh(fresh, *found->second.type, found->second.offset);
  }
  if (isFunction) {
    const Variable& result = scope.self->names.at(foldedName(block.name));
    if (result.type != nullptr) fresh(fresh, *result.type, result.offset);
  }
}

/// All that a statement may write which was not lowered; nothing: it may write anything.
std::optional<Operands> Lowering::writtenBy(Scope& scope, const Statement& one) {
  if (one.kind == StatementKind::Line) return writtenByLine(scope, one);
  // To read a property that was left out is a call.
  std::set<std::string> leftOut;
  for (const BlockSyntax& block : project_.blocks) {
    for (const ActionSyntax& action : block.actions) {
      if (!action.isChart) leftOut.insert(foldedName(action.name));
    }
  }
  bool mayCall = false;
  if (one.value != nullptr && !leftOut.empty()) {
    eachPart(*one.value, [&](const Expr& expr) {
      for (const PathPart& part : expr.parts) mayCall = mayCall || leftOut.contains(foldedName(part.name));
    });
  }
  if (mayCall) return std::nullopt;
  const bool isBounded = one.kind == StatementKind::Assign ? !calls(*one.value) : one.kind == StatementKind::Unread;
  return isBounded && one.target != nullptr ? placesOf(scope, *one.target) : std::nullopt;
}

/// The places of a variable; nothing if they are not known.
std::optional<Operands> Lowering::placesOf(Scope& scope, const Expr& path) {
  if (path.kind != ExprKind::Path) return std::nullopt;
  const std::size_t before = program_.findings.size();
  std::optional<Operands> written;
  try {
    const Reference target = reference(scope, path);
    if (target.indices.empty() && target.type->isValue() && !target.constant) {
      Operands& places = written.emplace();
      for (std::uint32_t i = 0; i < target.type->bytes; ++i)
        places.push_back(direct(Area::V, Width::Byte, target.offset + i));
    }
  } catch (const Refused&) {
    program_.findings.resize(before);
  }
  return written;
}

void Lowering::makeRoutine(BlockInstance& instance) {
  instance.routine = nextRoutine_++;
  instance.isOpen = true;
  ++openRoutines_;
  madeBlocks_.insert(instance.block);
  Pou pou;
  pou.name = instance.path;
  pou.number = instance.routine;
  pou.span = instance.block->span;
  pou.isBuiltIn = instance.block->isLibrary;
  Scope scope;
  scope.self = &instance;
  writeRoutine(std::move(pou), scope, instance.block->body);
  for (const ActionSyntax& action : instance.block->actions) {  // one that nobody calls is made so that it is checked
    if (!instance.hasInOut && !instance.actions.contains(foldedName(action.name))) makeAction(instance, action);
  }
  --openRoutines_;
  instance.isOpen = false;
}

void Lowering::makeAction(BlockInstance& instance, const ActionSyntax& action) {
  Pou pou;
  pou.name = fmt::format("{}.{}", instance.path, action.name);
  pou.number = instance.actions[foldedName(action.name)] = nextRoutine_++;
  pou.span = action.span;
  Scope scope;
  scope.self = &instance;
  scope.action = &action;
  openActions_.insert(&action);
  writeRoutine(std::move(pou), scope, action.body);
  openActions_.erase(&action);
}

/// Each statement is a network, so that what cannot be lowered spares the others.
void Lowering::writeRoutine(Pou pou, Scope& scope, const Statements& body) {
  const BlockInstance& instance = *scope.self;
  Network* const outer = network_;
  const Span at = span_;
  const int labels = std::exchange(nextLabel_, 0);
  std::vector<Shown> shown = std::exchange(shown_, {});
  const bool wasDrawn = std::exchange(isDrawn_, false);
  auto constants = types_.constants;
  for (const auto& [name, variable] : instance.names) {
    if (variable.constant) types_.constants[name] = *variable.constant;
  }
  pou.kind = PouKind::Subroutine;
  pou.isInstance = true;
  const auto write = [&](Span span, auto&& make) {
    Network network;
    network.number = static_cast<int>(pou.networks.size()) + 1;
    network.span = span;
    network_ = &network;
    span_ = span;
    sink_.setPlace(pou.name, network.number);
    try {
      make();
    } catch (const Refused&) {
      network.instructions.clear();
      network.complete = false;
    }
    sink_.setPlace("", 0);
    if (!network.complete || !network.instructions.empty()) pou.networks.push_back(std::move(network));
  };
  if (scope.action == nullptr) {
    write(instance.block->span, [&] {
      if (!instance.block->isWhole) throw Refused{};
      freshLocals(scope);
    });
    if (!instance.block->unread.empty()) {
      write(instance.block->span, [&] {
        refuse(instance.block->span,
               fmt::format("the body of {} is written in {}, which is not read yet", instance.block->name,
                           instance.block->unread),
               Syntax::IecNotModelled);
      });
    }
  }
  beginList(scope, body);
  for (std::size_t k = 0; k < body.size(); ++k) {
    const Statement& one = body[k];
    if (one.circuit != 0) {
      k = writeCircuit(pou, scope, body, k, write) - 1;
      continue;
    }
    if (one.kind == StatementKind::Line) {
      if (!one.line->label.empty())
        write(Span{one.span.file, one.span.offset, 0}, [&] { listLabel(scope, *one.line); });
      write(one.span, [&] { listLine(scope, one); });
    } else {
      write(one.span, [&] { statement(scope, one); });
    }
    if (!one.picture.empty() && !pou.networks.empty()) {
      const std::uint32_t file = program_.sources->add(fmt::format("chart of {}", pou.name), one.picture);
      pou.networks.back().span = {file, 0, static_cast<std::uint32_t>(one.picture.size())};
    }
    if (!pou.networks.empty() && !pou.networks.back().complete) pou.networks.back().mayWrite = writtenBy(scope, one);
  }
  endList(scope);
  program_.pous.push_back(std::move(pou));
  network_ = outer;
  span_ = at;
  nextLabel_ = labels;
  shown_ = std::move(shown);
  isDrawn_ = wasDrawn;
  types_.constants = std::move(constants);
}

/// The smallest that holds all variables.
void Lowering::chooseMachine() {
  for (std::size_t i = 0; i < cpu_rows::iec.size(); ++i) {
    program_.target = Target(static_cast<Cpu>(firstIecCpu + i), Edition::Iec);
    if (cpu_rows::iec[i].bytes >= next_) return;
  }
  error(Syntax::IecNotModelled, Span{sink_.file(), 0, 0}, "the variables take more than a million bytes");
}

void buildIecProgram(Program& program, ProjectSyntax& project) {
  if (project.isEmpty()) return;
  const std::uint32_t file = project.blocks.empty() ? 0 : project.blocks[0].span.file;
  addStandardBlocks(program, project);
  addContracts(program, project);
  Lowering(program, project, file).run();
  addSuppressions(program, project);
  program.syntax = std::make_shared<const ProjectSyntax>(std::move(project));
}

}  // namespace rungproof::iec
