// Program instances: which of them run, in which scans and in which order, what is free in every scan, the entry block.
#include <limits>
#include <numeric>

#include "frontend/iec/iec_lowering.hpp"
#include "frontend/iec/iec_tree.hpp"

namespace rungproof::iec {

/// Located inputs, inputs of programs: any value in any scan.
void Lowering::freeVariable(const Type& type, std::uint32_t offset, Span span, bool isLocated) {
  if (type.bytes == 0) return;
  freed_.push_back({offset, type.bytes, span, isLocated});
}

bool Lowering::isFreed(std::uint32_t offset) const {
  return std::ranges::any_of(freed_, [&](const Freed& f) { return f.offset <= offset && offset < f.offset + f.bytes; });
}

/// A directive for each value: reports name what is free.
void Lowering::freeNamedVariables() {
  std::set<std::uint32_t> seen;
  for (const Symbol& symbol : program_.symbols) {
    const std::uint32_t offset = symbol.address.offset;
    const auto range =
        std::ranges::find_if(freed_, [&](const Freed& f) { return f.offset <= offset && offset < f.offset + f.bytes; });
    if (range == freed_.end() || !seen.insert(offset).second) continue;
    program_.directives.push_back({"external " + symbol.name, range->span, -1, 0});
    if (!range->isLocated) assumeType(symbol, range->span);
  }
}

/// What others write has a value of its type. Not so where an address stands behind it, which can give any pattern, and
/// where the program itself writes, because it may write another value.
void Lowering::assumeType(const Symbol& symbol, Span span) {
  const auto limits = program_.valueLimits.find(symbol.address.offset);
  if (limits == program_.valueLimits.end()) return;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(limits->second.width / 8); ++i) {
    const std::uint32_t at = symbol.address.offset + i;
    if (at < isWritten_.size() && isWritten_[at] != 0) return;
  }
  std::string name = "type_of_" + symbol.name;
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  std::string text;
  for (const auto& [low, high] : limits->second.runs) {
    if (!text.empty()) text += " or ";
    text += low == high ? fmt::format("{} = {}", symbol.name, low)
                        : fmt::format("{0} >= {1} and {0} <= {2}", symbol.name, low, high);
  }
  program_.directives.push_back({fmt::format("assume {}: {}", name, text), span, -1, 0});
}

/// Variables that VAR_ACCESS gives to others for writing.
void Lowering::freeAccessed() {
  Scope outside;
  for (const AccessSyntax& access : project_.accesses) {
    try {
      Expr path;
      path.kind = ExprKind::Path;
      path.span = access.path->span;
      const auto isProgram = [&](const PathPart& part) {
        return std::ranges::any_of(
            programs_, [&](const BlockInstance* p) { return foldedName(p->path) == foldedName(part.name); });
      };
      const ExprPtr whole = copyOf(*access.path);
      // In front of the program or the global variable stands the resource.
      const std::size_t first = whole->parts.size() > 1 && !isProgram(whole->parts[0]) ? 1 : 0;
      for (std::size_t i = first; i < whole->parts.size(); ++i) path.parts.push_back(std::move(whole->parts[i]));
      const Reference at = reference(outside, path);
      if (!at.indices.empty() || at.instance != nullptr || at.constant)
        refuse(access.span, "such a path is not modelled", Syntax::IecNotModelled);
      freeVariable(*at.type, at.offset, access.span);
    } catch (const Refused&) {
    }
  }
}

/// Globals that nobody writes and that have no initial value: a panel or another configuration writes them.
void Lowering::freeUnwrittenGlobals() {
  for (const auto& [name, variable] : globals_) {
    if (variable.type == nullptr || variable.constant || variable.instance != nullptr || !variable.elements.empty() ||
        variable.declared == nullptr || variable.declared->initial != nullptr)
      continue;
    const bool isOutput = variable.declared->address.size() > 1 && variable.declared->address[1] == 'Q';
    bool isWritten = isOutput;
    for (std::uint32_t i = variable.offset; i < variable.offset + variable.type->bytes && i < isWritten_.size(); ++i)
      isWritten = isWritten || isWritten_[i] != 0;
    if (!isWritten) freeVariable(*variable.type, variable.offset, variable.declared->span);
  }
}

const TaskSyntax* Lowering::taskOf(const InstanceSyntax& instance) const {
  const auto task = std::ranges::find_if(
      project_.tasks, [&](const TaskSyntax& t) { return foldedName(t.name) == foldedName(instance.task); });
  return instance.task.empty() || task == project_.tasks.end() ? nullptr : &*task;
}

/// A scan is as long as the greatest common divisor of the intervals.
void Lowering::checkTasks(const std::vector<const InstanceSyntax*>& instances) {
  std::int64_t interval = 0;
  for (const InstanceSyntax* instance : instances) {
    const TaskSyntax* task = taskOf(*instance);
    if (task == nullptr) continue;
    if (task->intervalMs) interval = std::gcd(interval, *task->intervalMs);
  }
  if (interval > 0) program_.taskMs = static_cast<std::uint32_t>(std::min<std::int64_t>(interval, 0x7FFFFFFF));
}

/// The event of a task: it is asked once in a scan, for all programs of the task.
Lowering::TaskEvent* Lowering::eventOf(const TaskSyntax& task) {
  for (TaskEvent& event : events_) {
    if (event.task == &task) return &event;
  }
  return &events_.emplace_back(TaskEvent{&task, allocate(1), allocate(1)});
}

/// Whether the event has come since the scan before: a rising edge, as R_TRIG finds it.
void Lowering::askEvents() {
  const Type& boolean = *elementaryType("BOOL");
  Scope outside;
  for (const TaskEvent& event : events_) {
    const auto asked = [&] { valueAs(outside, *event.task->single, boolean); };
    asked();
    load(boolean, event.memory);
    emit("NOT", {1});
    emit("AND", {1});
    store(boolean, event.due);
    asked();
    store(boolean, event.memory);
  }
}

/// The instances that the configuration names; without one every program once; of blocks alone the only one.
void Lowering::makePrograms() {
  std::vector<const InstanceSyntax*> named;
  for (const InstanceSyntax& instance : project_.instances) named.push_back(&instance);
  checkTasks(named);
  const auto add = [&](const BlockSyntax& block, const std::string& path, const InstanceSyntax* instance) {
    BlockInstance* made = makeInstance(block, path);
    programs_.push_back(made);
    for (const VariableSyntax& variable : block.variables) {
      const bool isInput = variable.section == Section::Input || variable.section == Section::InOut;
      const auto found = made->names.find(foldedName(variable.name));
      if (!isInput || found == made->names.end() || found->second.type == nullptr) continue;
      if (variable.section == Section::InOut) {  // nobody connects it: a variable of its own
        try {
          found->second.offset = allocate(found->second.type->bytes);
        } catch (const Refused&) {
        }
        made->hasInOut = false;
      }
      const bool isConnected = instance != nullptr && instance->connections != nullptr &&
                               std::ranges::any_of(instance->connections->arguments, [&](const Argument& argument) {
                                 return foldedName(argument.name) == foldedName(variable.name);
                               });
      if (variable.address.empty() && !isConnected)
        freeVariable(*found->second.type, made->placeFromOutside(found->first), variable.span);
    }
    ProgramRun run{instance};
    if (const TaskSyntax* task = instance != nullptr ? taskOf(*instance) : nullptr; task != nullptr) {
      run.priority = task->priority;
      if (task->single != nullptr) run.event = eventOf(*task);
      run.isCyclic = task->intervalMs.has_value();
      if (task->intervalMs) run.every = static_cast<std::uint32_t>(*task->intervalMs / *program_.taskMs);
      if (run.every > 1) {
        run.counter = allocate(4);
        run.phase = allocate(4);
        const Type& number = *elementaryType("UDINT");
        program_.symbols.push_back(
            {instance->name + ".PHASE", direct(Area::V, widthOfBits(number.width), run.phase), "", instance->span});
        program_.valueTypes[run.phase] = ValueType::Unsigned;
        program_.valueLimits[run.phase] = {.width = number.width, .runs = {{1, run.every}}};
        writeInitial(number, run.phase, {&number, 1});
        freeVariable(number, run.phase, instance->span);
      }
    } else if (program_.taskMs) {
      run.priority = std::numeric_limits<std::int64_t>::max();  // without a task: in the background
    }
    runs_.push_back(run);
  };
  for (const InstanceSyntax* instance : named) {
    const auto block = blocks_.find(foldedName(instance->type));
    if (block == blocks_.end() || block->second->kind != BlockKind::Program) {
      error(Syntax::IecName, instance->span, fmt::format("there is no program {}", excerpt(instance->type)));
      continue;
    }
    add(*block->second, instance->name, instance);
  }
  if (named.empty()) {
    for (const BlockSyntax& block : project_.blocks) {
      if (block.kind == BlockKind::Program) add(block, block.name, nullptr);
    }
  }
  std::vector<const BlockSyntax*> own;
  for (const BlockSyntax& block : project_.blocks) {
    if (block.kind == BlockKind::FunctionBlock && !block.isLibrary) own.push_back(&block);
  }
  if (programs_.empty() && own.size() == 1) add(*own[0], own[0]->name, nullptr);
  if (programs_.empty()) {
    const Span place = project_.blocks.empty() ? Span{sink_.file(), 0, 0} : project_.blocks[0].span;
    error(Syntax::IecNoProgram, place, "no program is there that could run");
  }
  const std::vector<BlockInstance*> all = programs_;
  for (BlockInstance* program : all) makeRoutine(*program);
  if (!all.empty()) makeMain();
  // A block that nobody calls is made once, so that it is checked.
  for (const BlockSyntax& block : project_.blocks) {
    if (block.isLibrary || madeBlocks_.contains(&block) || block.kind == BlockKind::Program) continue;
    try {
      BlockInstance* made =
          block.kind == BlockKind::Function ? functionNamed(foldedName(block.name)) : makeInstance(block, block.name);
      if (made == nullptr) continue;
      for (const VariableSyntax& variable : block.variables) {
        const auto found = made->names.find(foldedName(variable.name));
        if (variable.section != Section::InOut || found == made->names.end() || found->second.type == nullptr) continue;
        found->second.offset = allocate(found->second.type->bytes);
      }
      makeRoutine(*made);
    } catch (const Refused&) {
    }
  }
}

/// Inputs that the configuration connects, the body, outputs.
void Lowering::callProgram(std::size_t number) {
  BlockInstance& program = *programs_[number];
  const ProgramRun& run = runs_[number];
  const int skip = newLabel();
  const Type& counter = *elementaryType("UDINT");
  const bool isPeriodic = run.event == nullptr || run.isCyclic;
  if (run.isInterruptible) {
    emit("READING", {static_cast<std::int64_t>(Choice::IecPreemption), 0});
    jumpIfFalse(skip);
  }
  const bool mayWait = run.event != nullptr || run.every > 1 || run.isInterruptible;
  if (run.event != nullptr || run.every > 1) {
    if (run.event != nullptr) load(*elementaryType("BOOL"), run.event->due);
    if (isPeriodic && run.every > 1) {
      load(counter, run.counter);
      constant(0, 32);
      emit("EQ", {32, 0});
    } else if (isPeriodic) {
      constant(1, 1);
    }
    if (run.event != nullptr && isPeriodic) emit("OR", {1});
    jumpIfFalse(skip);
  }
  Scope outside, inner;
  inner.self = &program;
  if (run.instance != nullptr && run.instance->connections != nullptr) {
    bindInputs(outside, program, *run.instance->connections, inner);
  }
  emit("CAL", {program.routine});
  if (run.instance != nullptr && run.instance->connections != nullptr)
    readOutputs(outside, program, *run.instance->connections);
  if (mayWait) label(skip);
}

/// By one reading the variables of subranges that hold 0 start with it; what nobody gives a first value to.
void Lowering::startSubranges() {
  std::erase_if(openStarts_, [&](const auto& start) { return isFreed(start.second); });
  if (openStarts_.empty()) return;
  const Type& boolean = *elementaryType("BOOL");
  const std::uint32_t hasBegun = allocate(1);
  const int end = newLabel();
  load(boolean, hasBegun);
  emit("NOT", {1});
  emit("READING", {static_cast<std::int64_t>(Choice::IecSubrangeStart), 1});
  emit("AND", {1});
  jumpIfFalse(end);
  for (const auto& [type, offset] : openStarts_) {
    constant(0, type->width);
    store(*type, offset);
  }
  label(end);
  constant(1, 1);
  store(boolean, hasBegun);
}

/// By the reading `any` a task of a longer interval may begin in any scan of it: its program's PHASE is the number of
/// that scan.
void Lowering::startPhases() {
  if (std::ranges::none_of(runs_, [](const ProgramRun& run) { return run.every > 1; })) return;
  const Type& counter = *elementaryType("UDINT");
  const Type& boolean = *elementaryType("BOOL");
  const std::uint32_t hasBegun = allocate(1);
  const int end = newLabel();
  load(boolean, hasBegun);
  emit("NOT", {1});
  emit("READING", {static_cast<std::int64_t>(Choice::IecPhase), 1});
  emit("AND", {1});
  jumpIfFalse(end);
  for (const ProgramRun& run : runs_) {
    if (run.every <= 1) continue;
    constant(run.every + 1, 32);
    load(counter, run.phase);
    emit("SUB", {32});
    constant(run.every, 32);
    emit("MOD", {32, 0});
    store(counter, run.counter);
  }
  label(end);
  constant(1, 1);
  store(boolean, hasBegun);
}

namespace {

/// The bytes that an instruction reads or writes.
struct Touched {
  std::set<std::uint32_t> read, written;
};

void addTouched(const Instruction& instruction, Touched& touched) {
  for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
    const Operand& operand = instruction.operands[i];
    if (operand.area != Area::V || operand.kind != OperandKind::Direct) continue;
    const OperandDesc& desc = instruction.desc->operands[i];
    const bool isRow = desc.count.operand >= 0;
    const auto count = isRow ? static_cast<std::uint32_t>(instruction.operands[i + 1].value)
                             : static_cast<std::uint32_t>(std::max(rungproof::bytes(operand.width), 1));
    for (std::uint32_t at = operand.offset; at < operand.offset + count; ++at) {
      if (desc.direction != Direction::Out) touched.read.insert(at);
      if (desc.direction != Direction::In) touched.written.insert(at);
    }
  }
}

}  // namespace

/// Of each program whether it writes what a task of another priority reads or writes, or the reverse.
std::vector<bool> Lowering::interruptible() const {
  std::vector<bool> result(runs_.size(), false);
  if (std::ranges::all_of(runs_, [&](const ProgramRun& run) { return run.priority == runs_[0].priority; }))
    return result;
  std::map<int, const Pou*> routines;
  for (const Pou& pou : program_.pous) routines[pou.number] = &pou;
  std::vector<Touched> touched(runs_.size());
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    std::set<int> seen;
    const auto walk = [&](const auto& self, int number) -> void {
      const auto routine = routines.find(number);
      if (routine == routines.end() || !seen.insert(number).second) return;
      for (const Network& network : routine->second->networks) {
        for (const Instruction& one : network.instructions) {
          addTouched(one, touched[i]);
          if (one.desc->control == Control::Call) self(self, static_cast<int>(one.operands[0].value));
        }
      }
    };
    walk(walk, programs_[i]->routine);
  }
  const auto meets = [](const std::set<std::uint32_t>& written, const Touched& other) {
    return std::ranges::any_of(written,
                               [&](std::uint32_t at) { return other.read.contains(at) || other.written.contains(at); });
  };
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const InstanceSyntax* instance = runs_[i].instance;  // what it is given is copied in front of it and behind it
    result[i] = instance != nullptr && instance->connections != nullptr;
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      if (runs_[i].priority != runs_[k].priority &&
          (meets(touched[i].written, touched[k]) || meets(touched[k].written, touched[i])))
        result[i] = true;
    }
  }
  return result;
}

void Lowering::callTasks(const std::vector<std::size_t>& order) {
  for (const std::size_t number : order) callProgram(number);
}

/// Time passes for the timers, then the programs that are due run in their order. All are due in the first scan.
void Lowering::makeMain() {
  Pou pou;
  pou.kind = PouKind::Main;
  pou.name = "CYCLE";
  pou.isBuiltIn = true;
  pou.span = programs_[0]->block->span;
  Network network;
  network.number = 1;
  network.span = {pou.span.file, pou.span.offset, 0};
  network_ = &network;
  span_ = network.span;
  for (const BlockInstance* timer : timers_) {
    if (!timer->isCalled) continue;
    emit("PASS");
    last().operands.push_back(direct(Area::V, Width::Byte, timer->names.at("STATE").offset));
    last().operands.push_back(direct(Area::V, Width::DWord, timer->names.at("ELAPSED").offset));
    // One ms more than PT: by one reading a timer ends when its time exceeds PT.
    const std::int64_t longest = timer->longestPreset.value_or(0x7FFFFFFF);
    last().operands.push_back(rungproof::constant(std::clamp<std::int64_t>(longest + 1, 1, 0x7FFFFFFF)));
  }
  for (const auto& [step, longest] : steps_) {
    const auto pass = [&](const char* clock, std::int64_t limit) {
      emit("PASS");
      last().operands.push_back(direct(Area::V, Width::Byte, step->names.at("X").offset));
      last().operands.push_back(direct(Area::V, Width::DWord, step->names.at(clock).offset));
      last().operands.push_back(rungproof::constant(limit));
    };
    pass("T", 0x7FFFFFFF);
    if (longest > 0) pass("CLOCK", std::min<std::int64_t>(longest, 0x7FFFFFFF));
  }
  std::vector<std::size_t> declared;
  for (std::size_t i = 0; i < programs_.size(); ++i) declared.push_back(i);
  std::vector<std::size_t> byPriority = declared;
  std::ranges::stable_sort(byPriority, {}, [&](std::size_t i) { return runs_[i].priority; });
  try {
    const std::vector<bool> shares = interruptible();
    for (std::size_t i = 0; i < runs_.size(); ++i) runs_[i].isInterruptible = shares[i];
    joinInputs();
    startPhases();
    startSubranges();
    askEvents();
    if (byPriority == declared) {
      callTasks(declared);
    } else {
      const int other = newLabel(), end = newLabel();
      emit("READING", {static_cast<std::int64_t>(Choice::IecTaskOrder), 1});
      jumpIfFalse(other);
      callTasks(declared);
      jump(end);
      label(other);
      callTasks(byPriority);
      label(end);
    }
    const Type& counter = *elementaryType("UDINT");
    for (const ProgramRun& run : runs_) {
      if (run.every <= 1) continue;
      load(counter, run.counter);
      constant(1, 32);
      emit("ADD", {32});
      constant(run.every, 32);
      emit("MOD", {32, 0});
      store(counter, run.counter);
    }
  } catch (const Refused&) {
    network.instructions.clear();
    network.complete = false;
  }
  pou.networks.push_back(std::move(network));
  network_ = nullptr;
  program_.pous.insert(program_.pous.begin(), std::move(pou));
}

}  // namespace rungproof::iec
