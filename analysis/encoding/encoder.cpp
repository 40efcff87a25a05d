// The rounds of the encoder: encode a scan, learn from it, encode again with what was learned.
#include "analysis/encoding/encoder.hpp"

#include <algorithm>
#include <utility>

#include "analysis/encoding/scan_encoding.hpp"
#include "ir/check.hpp"
#include "ir/dialect.hpp"
#include "ir/s7200/event_cause.hpp"

namespace rungproof {

class EncodedScan::Impl {
 public:
  Impl(const Program& source, const EncoderOptions& given)
      : program(source), options(given), plan(source, given.isLeftOut), layout(plan) {
    layout.add(program, plan);
    for (const ExternalBytes& range : options.externals) {
      layout.beginAt(range.area, range.first);
      layout.beginAt(range.area, range.last + 1);
      if (range.lowBit > 0) layout.add(range.area, Width::Bit, range.first);
      if (range.highBit < 7) layout.add(range.area, Width::Bit, range.last);
    }
    for (const Operand& operand : options.observed) layout.add(operand.area, operand.width, operand.offset);
    if (options.trail && options.trail->isFollowed) {
      knowledge = *options.trail->knowledge;
      effects = options.trail->effects;
      encode();
      scan->close();
      return;
    }
    // On, unless the program overwrites it.
    const SystemBit& on = dialectOf(program.target).systemBits.alwaysOn;
    knowledge.constants = {{memoryPlace(on.area, on.byte, Width::Bit, on.bit), 1}};
    if (options.interrupts) {
      for (const auto& [event, attached] : attachmentsOf(plan)) {
        routines.routines.insert(attached.begin(), attached.end());
        routines.isOfDevices = routines.isOfDevices || isPulseEvent(event) || portEvent(event);
      }
    }
    routines.statements = options.statements;
    if (options.trail) effects = options.trail->effects;  // of whoever wants others
    if (!routines.routines.empty() && !effects) findEffects();
    for (int round = 0; !learn(); ++round) {
      if (round != roundLimit) continue;
      knowledge.followsPointers = routines.followsPointers = false;
      if (effects) findEffects();
    }
    knowledge.isFinal = true;
    if (options.trail) {
      options.trail->knowledge = std::make_shared<Knowledge>(knowledge);
      options.trail->effects = effects;
    }
    encode();
    scan->close();
  }

  const Program& program;
  EncoderOptions options;
  Plan plan;
  MemoryLayout layout;
  Knowledge knowledge;
  RoutineEffects::Given routines;                 ///< that interrupts run
  std::shared_ptr<const RoutineEffects> effects;  ///< nullptr: nothing is attached
  std::unique_ptr<ScanEncoding> scan;

 private:
  /// Rounds until pointers that still gain values are given up.
  static constexpr int roundLimit = 12;

  void encode() { scan = std::make_unique<ScanEncoding>(program, options, plan, layout, knowledge, effects.get()); }

  void findEffects() { effects = std::make_shared<const RoutineEffects>(plan, layout, routines); }

  /// Whether routines began in the last round as their effects say; if not, these are found anew.
  bool beganAsKnown() {
    if (!effects) return true;
    EntryValues known = effects->entry();
    if (!join(known, scan->entryValues())) return true;
    routines.entry = std::move(known);
    findEffects();
    return false;
  }

  /// One round. True if it confirmed what it was built on; then the constants it found are adopted as well.
  bool learn() {
    encode();
    const TransitionSystem system = scan->system();
    VariableValues values = scan->keptValues(), later;
    for (const Cell& cell : scan->cells()) {
      const auto known = knowledge.values.find(cell.place);
      if (cell.kind == CellKind::State && known != knowledge.values.end()) values[cell.start] = known->second;
    }
    for (const Cell& cell : scan->cells()) {
      if (const auto known = knowledge.later.find(cell.place); known != knowledge.later.end())
        later[cell.start] = known->second;
    }
    std::map<Node, Walk> walks;
    closeValues(system, scan->pointerCells(), values, later, options.interruption, &walks);
    knowledge.walks.clear();
    for (const auto& [pointer, walk] : walks) {
      KnownWalk& known = knowledge.walks.emplace_back();
      known.together = walk.together;
      for (const Node n : walk.cells) {
        const auto cell = std::ranges::find(scan->cells(), n, &Cell::start);
        if (cell != scan->cells().end()) known.cells.push_back(cell->place);
      }
      if (known.cells.size() != walk.cells.size()) knowledge.walks.pop_back();
    }
    std::vector<Place> firstScans;
    const std::vector<Node> firsts = firstScansOf(system);
    for (const Cell& cell : scan->cells()) {
      if (std::find(firsts.begin(), firsts.end(), cell.start) != firsts.end()) firstScans.push_back(cell.place);
    }
    const bool areFirstScansNew = std::exchange(knowledge.firstScans, firstScans) != firstScans;
    const std::vector<Place> changing = refuted(values);
    for (const Place& place : changing) knowledge.constants.erase(place);
    const bool isNewFootprint = knowledge.footprints.merge(scan->footprints());
    const bool areEntriesKnown = beganAsKnown();
    bool isConfirmed = areEntriesKnown && changing.empty() && !isNewFootprint && !addTables() &&
                       (!areFirstScansNew || scan->pointerCells().empty());
    std::map<Place, std::uint64_t> found;
    for (const Cell& cell : scan->cells()) {
      if (cell.kind != CellKind::State) continue;
      const ValueSet& set = values.at(cell.start);
      const auto known = knowledge.values.find(cell.place);
      bool isNew = known == knowledge.values.end() || known->second != set;
      if (const auto after = later.find(cell.start); after != later.end()) {
        isNew = isNew || knowledge.later[cell.place] != after->second;
        knowledge.later[cell.place] = after->second;
      } else {
        isNew = knowledge.later.erase(cell.place) > 0 || isNew;
      }
      if (isNew && scan->reliesOnValues()) isConfirmed = false;
      knowledge.values[cell.place] = set;
      if (set.isSingle()) found.emplace(cell.place, set.facts().low);
    }
    if (isConfirmed) knowledge.constants.insert(found.begin(), found.end());
    return isConfirmed;
  }

  /// Adds the tables of devices, and what these name, that pointers lead to. Gives whether one was new.
  bool addTables() { return knowledge.tables.add(scan->tableTargets()); }

  /// Constants of the round that do not stay what they are.
  std::vector<Place> refuted(const VariableValues& values) {
    std::vector<Place> result;
    ValueEvaluator evaluator(scan->graph, values);
    for (std::size_t i = 0; i < scan->cells().size(); ++i) {
      const Cell cell = scan->cells()[i];
      if (cell.kind != CellKind::Constant) continue;
      const Node next = scan->value(cell.place);
      if (next == cell.start) continue;
      const ValueSet set = evaluator.valuesOf(next, scan->graph.constantNode(1, 1), valueLimit);
      if (!set.isSingle() || set.facts().low != scan->graph[cell.start].value) result.push_back(cell.place);
    }
    return result;
  }
};

EncodedScan::EncodedScan(const Program& program, const EncoderOptions& options)
    : impl_(std::make_unique<Impl>(program, options)) {}
EncodedScan::~EncodedScan() = default;
EncodedScan::EncodedScan(EncodedScan&&) noexcept = default;
EncodedScan& EncodedScan::operator=(EncodedScan&&) noexcept = default;

Graph& EncodedScan::graph() const { return impl_->scan->graph; }
const Plan& EncodedScan::plan() const { return impl_->plan; }
TimeModel& EncodedScan::time() const { return impl_->scan->time; }
const EncoderOptions& EncodedScan::options() const { return impl_->options; }

bool EncodedScan::holds(const Place& place) const {
  if (place.isRegister) return place.at < registerCount(regInfo(place.reg), impl_->plan);
  return impl_->layout.holds(place.area, place.byte(), (place.width + 7U) / 8U);
}

Node EncodedScan::atEnd(const Place& place) { return impl_->scan->value(place); }

Node EncodedScan::atEnd(const Operand& operand, int width) {
  CHECK(operand.kind == OperandKind::Direct, "only direct operands have a value of their own");
  const auto low = [&](Node n) { return graph().make(Op::Extract, width, n); };
  switch (operand.area) {
    case Area::T: {
      if (operand.offset >= plan().timerCount) return graph().constantNode(0, width);
      const Reg reg = timerRegister(width == 1 ? Width::Bit : width == 32 ? Width::DWord : Width::Word);
      return graph().make(Op::Zext, width, atEnd(registerPlace(reg, operand.offset)));
    }
    case Area::PI: {
      const auto word = [&](std::uint32_t byte) { return impl_->scan->analogInput(byte); };
      if (width == 32) return graph().make(Op::Concat, 32, word(operand.offset), word(operand.offset + 2));
      return width == 16 ? word(operand.offset)
                         : graph().make(Op::Extract, width, word(operand.offset), noNode, noNode, 8);
    }
    case Area::C:
      if (operand.offset >= plan().counterCount) return graph().constantNode(0, width);
      return atEnd(registerPlace(width == 1 ? Reg::CounterBit : Reg::CounterCurrent, operand.offset));
    case Area::AC: return low(atEnd(registerPlace(Reg::Accumulator, operand.offset)));
    case Area::HC: return low(atEnd(registerPlace(Reg::HscCurrent, operand.offset)));
    case Area::AI: return impl_->scan->analogInput(operand.offset);
    default: {
      return atEnd(memoryPlace(operand.area, operand.offset, widthOfBits(width), operand.bit));
    }
  }
}

Node EncodedScan::atStart(const Place& place) { return impl_->scan->start(place); }
Node EncodedScan::firstScan() const { return impl_->scan->start(registerPlace(Reg::FirstScan, 0)); }
Node EncodedScan::halted() const { return impl_->scan->halted(); }
Node EncodedScan::faulted() const { return impl_->scan->faulted(); }
TransitionSystem EncodedScan::system() { return impl_->scan->system(); }

const std::vector<HazardRecord>& EncodedScan::hazards() const { return impl_->scan->hazards; }
const std::vector<BitWrite>& EncodedScan::bitWrites() const { return impl_->scan->bitWrites(); }
const std::vector<Approximation>& EncodedScan::approximations() const { return impl_->scan->approximations; }
const std::vector<ExternalInput>& EncodedScan::externals() const { return impl_->scan->externals; }
const std::map<std::uint32_t, Node>& EncodedScan::analogInputs() const { return impl_->scan->analogInputs(); }
const std::map<std::string, Node>& EncodedScan::deviceInputs() const { return impl_->scan->deviceInputs; }
const std::vector<DeviceWrite>& EncodedScan::deviceWrites() const { return impl_->scan->devices().writes(); }
const std::vector<TickSite>& EncodedScan::tickSites() const { return impl_->scan->tickSites; }
const std::vector<SiteInput>& EncodedScan::siteInputs() const { return impl_->scan->siteInputs; }
const std::vector<EventSite>& EncodedScan::eventSites() const { return impl_->scan->eventSites; }
const std::vector<Cell>& EncodedScan::cells() const { return impl_->scan->cells(); }
ToldFacts EncodedScan::toldFacts() const { return impl_->scan->toldFacts(); }
const std::vector<KeptCell>& EncodedScan::keptCells() const { return impl_->scan->keptCells; }
std::vector<const BoundarySite*> EncodedScan::boundaries() const {
  std::vector<const BoundarySite*> all;
  for (const TickSite& t : tickSites()) all.push_back(&t.where);
  for (const EventSite& e : eventSites()) all.push_back(&e.where);
  return all;
}
const std::vector<Node>& EncodedScan::visits(std::uint32_t instruction) const {
  static const std::vector<Node> none;
  const auto found = impl_->scan->visits.find(instruction);
  return found == impl_->scan->visits.end() ? none : found->second;
}
std::vector<Place> EncodedScan::places() const { return impl_->scan->places(); }

}  // namespace rungproof
