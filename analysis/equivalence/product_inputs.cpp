// What of the world is the same for both programs: inputs, time, immediate reads and events in front of instructions
// that stand for each other.
#include <algorithm>
#include <map>

#include "analysis/encoding/device_writes.hpp"
#include "analysis/equivalence/product.hpp"

namespace rungproof {

namespace {

/// External values that come from the world, not from what the manual leaves undefined.
bool isOfTheWorld(External kind) {
  switch (kind) {
    case External::ImmediateInput:
    case External::AnalogInput:
    case External::ClockByte:
    case External::IntervalClock:
    case External::CalendarDay:
    case External::TimeOfDay:
    case External::TimerPhase:
    case External::ReceivedByte:
    case External::StationAddress: return true;
    default: return false;
  }
}

/// The area whose addresses number such values; nothing where no address does.
std::optional<Area> areaOfExternal(External kind) {
  switch (kind) {
    case External::ImmediateInput: return Area::I;
    case External::AnalogInput: return Area::AI;
    case External::TimerPhase: return Area::T;
    default: return std::nullopt;
  }
}

}  // namespace

bool ProgramProduct::isOldInput(const Place& place) {
  const auto isInput = [&](const Place& there) {
    return std::ranges::any_of(old_.encoding().cells(), [&](const Cell& cell) {
      const bool isSame = cell.place.isRegister == there.isRegister &&
                          (there.isRegister ? cell.place == there
                                            : cell.place.area == there.area && cell.place.at <= there.at &&
                                                  there.at + there.width <= cell.place.at + cell.place.width);
      return isSame && cell.kind == CellKind::Input;
    });
  };
  if (place.isRegister) {
    const std::optional<Place> there = oldRegister(place);
    return there && isInput(*there);
  }
  for (std::uint32_t i = 0; i < place.width; ++i) {
    const auto bit = options_.pairs.before(bitOf(place, i));
    if (!bit || (!options_.pairs.names(bitOf(place, i)) && !isInput(bitPlace(*bit)))) return false;
  }
  return true;
}

/// Whether a map gives a bit of SMB0 to it: that is renewed at the start of the scan, and stays until its end.
bool ProgramProduct::isStatusOfOld(const Place& place) const {
  if (place.isRegister) return false;
  const auto bit = options_.pairs.before(bitOf(place, 0));
  return bit && bit->area == Area::SM && bit->index < 8;
}

void ProgramProduct::replaceCells(SideCopy& copy) {
  const TimeModel& oldTime = old_.encoding().time();
  const TimeModel& newTime = new_.encoding().time();
  for (std::size_t i = 0; i < newTime.inputs().size(); ++i) copy.replace(newTime.inputs()[i], oldTime.inputs()[i]);
  for (const Cell& cell : new_.encoding().cells()) {
    if (cell.kind != CellKind::Input) continue;
    const Node value = oldValue(cell.place, isStatusOfOld(cell.place));
    if (value != noNode && isOldInput(cell.place)) copy.replace(cell.start, value);
  }
  std::map<std::string, std::string> namesOfCounts;  // in NEW, with what they are in OLD
  for (std::uint32_t counter = 0; counter < regInfo(Reg::HscCurrent).count; ++counter) {
    const auto there = options_.pairs.before(Address{Area::HC, counter});
    namesOfCounts[DeviceWrites::countName(counter)] =
        there && there->area == Area::HC ? DeviceWrites::countName(there->index) : "";
  }
  for (const auto& [name, node] : new_.encoding().deviceInputs()) {
    const auto& own = old_.encoding().deviceInputs();
    const auto renamed = namesOfCounts.find(name);
    const auto same = own.find(renamed == namesOfCounts.end() ? name : renamed->second);
    if (same != own.end() && old_.encoding().graph()[same->second].width == new_.encoding().graph()[node].width)
      copy.replace(node, same->second);
  }
  for (const auto& [word, node] : new_.encoding().analogInputs()) {
    const auto before = options_.pairs.before(Address{Area::AI, word});
    if (!before || before->area != Area::AI) continue;
    const auto& samples = old_.encoding().analogInputs();
    if (const auto sample = samples.find(before->index); sample != samples.end() && !copy.isReplaced(node))
      copy.replace(node, sample->second);
  }
}

/// External values inside the scan: the k-th of an instruction stands for the k-th of the instruction it is matched
/// with. What arrives at a port between scans belongs to no instruction.
void ProgramProduct::replaceExternals(SideCopy& copy) {
  using Site = std::tuple<External, std::uint32_t, std::uint32_t>;
  const auto isBetween = [&](const ExternalInput& e) {
    return e.site.kind == External::ReceivedByte && !options_.encoder.interruptsInside;
  };
  std::map<Site, std::vector<Node>> known;
  for (const ExternalInput& e : old_.encoding().externals())
    known[{e.site.kind, e.site.index, isBetween(e) ? noPartner : e.site.instruction}].push_back(e.node);
  std::map<Site, std::size_t> count;
  for (const ExternalInput& e : new_.encoding().externals()) {
    const bool isSharedUndefined = isUndefinedRead(e.site.kind) && sameInstructions_.contains(e.site.instruction);
    if (!isOfTheWorld(e.site.kind) && !isSharedUndefined && !isSame_) continue;
    const std::size_t k = count[{e.site.kind, e.site.index, isBetween(e) ? noPartner : e.site.instruction}]++;
    if (e.node == noNode || copy.isReplaced(e.node)) continue;
    std::uint32_t index = e.site.index;
    if (const auto area = areaOfExternal(e.site.kind)) {
      const auto before = options_.pairs.before(Address{*area, index});
      if (!before || before->area != *area) continue;
      index = before->index;
    }
    const std::uint32_t instruction = isBetween(e) ? noPartner : match_.beforeOf[e.site.instruction];
    if (instruction == noPartner && !isBetween(e)) continue;
    const auto found = known.find({e.site.kind, index, instruction});
    if (found == known.end() || k >= found->second.size() || found->second[k] == noNode) continue;
    const Node same = found->second[k];
    if (old_.encoding().graph()[same].width != new_.encoding().graph()[e.node].width) continue;
    copy.replace(e.node, same);
    if (isUndefinedRead(e.site.kind))
      sharedUndefined_.emplace(same, ExternalSite{e.site.kind, index, match_.beforeOf[e.site.instruction]});
  }
}

std::vector<ExternalSite> ProgramProduct::sharedUndefinedReads() {
  const Graph& graph = old_.encoding().graph();
  std::map<Node, Node> nextOf;
  for (const StateVariable& state : oldSystem_.states) nextOf.emplace(state.node, state.next);
  std::vector<Node> open = {oldRuns_};
  for (const Output& output : outputs_) open.push_back(output.oldValue);
  std::set<Node> seen;
  while (!open.empty()) {  // all that decides the outputs, through any number of scans
    const Node node = open.back();
    open.pop_back();
    if (node == noNode || !seen.insert(node).second) continue;
    open.insert(open.end(), graph[node].child.begin(), graph[node].child.end());
    if (const auto state = nextOf.find(node); state != nextOf.end()) open.push_back(state->second);
  }
  std::vector<ExternalSite> sites;
  for (const auto& [node, site] : sharedUndefined_) {
    if (seen.contains(node)) sites.push_back(site);
  }
  return sites;
}

/// The same event in front of instructions that stand for each other, and between scans.
void ProgramProduct::replaceSites(SideCopy& copy) {
  using Site = std::pair<int, std::uint32_t>;
  std::map<Site, std::vector<Node>> known;
  for (const SiteInput& site : old_.encoding().siteInputs()) known[{site.event, site.instruction}].push_back(site.node);
  std::map<Site, std::size_t> count;
  for (const SiteInput& site : new_.encoding().siteInputs()) {
    const std::size_t k = count[{site.event, site.instruction}]++;
    const bool isBetween = site.instruction == ScanPlace::afterProgram;
    const std::uint32_t there = isBetween ? site.instruction : match_.beforeOf[site.instruction];
    if (copy.isReplaced(site.node) || (!isBetween && there == noPartner)) continue;
    const std::optional<int> event = options_.pairs.eventBefore(site.event);
    if (!event) continue;
    const auto found = known.find({*event, there});
    if (found == known.end() || k >= found->second.size()) continue;
    const Node same = found->second[k];
    if (old_.encoding().graph()[same].width == new_.encoding().graph()[site.node].width) copy.replace(site.node, same);
  }
}

/// A bit of SMB0 of NEW that stands for an input of OLD: the panel shows OLD the clock that NEW has itself.
void ProgramProduct::findClocks() {
  EncodedScan& before = old_.encoding();
  std::vector<Address> given;
  for (const Cell& cell : before.cells()) {
    if (cell.kind != CellKind::Input || cell.place.isRegister) continue;
    for (std::uint32_t i = 0; i < cell.place.width; ++i) given.push_back(bitOf(cell.place, i));
  }
  for (const Address& address : given) {
    const std::optional<Address> after = options_.pairs.after(address);
    if (after && after->area == Area::SM && after->index < 8)
      clocks_.emplace_back(before.atStart(bitPlace(address)), new_.encoding().atEnd(bitPlace(*after)));
  }
}

void ProgramProduct::holdClocks(JoinedSystem& result) {
  Graph& graph = old_.encoding().graph();
  for (const auto& [input, clock] : clocks_)
    result.system.constraints.push_back(graph.equal({input}, {(*result.copy)(clock)}, 1).node);
}

/// An immediate read gives what the image has, and every read of an analog input in a scan the same.
void ProgramProduct::holdInputs(JoinedSystem& result) {
  Graph& graph = old_.encoding().graph();
  std::map<Address, Node, bool (*)(const Address&, const Address&)> samples(
      [](const Address& a, const Address& b) { return std::pair(a.area, a.index) < std::pair(b.area, b.index); });
  const auto hold = [&](const Address& address, Node value) {
    Node& sample = samples.try_emplace(address, noNode).first->second;
    if (sample == noNode) sample = address.area == Area::I ? old_.encoding().atStart(bitPlace(address)) : value;
    const Node same = graph.equal({sample}, {value}, graph[value].width).node;
    if (graph.truth({same}) != true) result.system.constraints.push_back(same);
  };
  const auto isRead = [](const ExternalInput& e) {
    return e.node != noNode && (e.site.kind == External::ImmediateInput || e.site.kind == External::AnalogInput);
  };
  for (const ExternalInput& e : old_.encoding().externals()) {
    if (isRead(e)) hold({*areaOfExternal(e.site.kind), e.site.index}, e.node);
  }
  for (const ExternalInput& e : new_.encoding().externals()) {
    if (!isRead(e)) continue;
    if (const auto before = options_.pairs.before(Address{*areaOfExternal(e.site.kind), e.site.index}))
      hold(*before, (*result.copy)(e.node));
  }
}

bool ProgramProduct::isSameProgram(const Side& before, const Side& after) const {
  const auto isWhole = [](const Side& side) { return side.unread == nullptr || side.unread->empty(); };
  const auto isAlike = [](const NetworkPair& pair) { return pair.isSame && *pair.before == *pair.after; };
  return before.program->pous.size() == after.program->pous.size() && std::ranges::all_of(match_.networks, isAlike) &&
         isWhole(before) && isWhole(after);
}

/// What many interrupts at one place leave is estimated with inputs of each program's own. Where one and the same
/// program runs on equal memory and every other input is equal too, it leaves the same.
void ProgramProduct::replaceEstimates(SideCopy& copy, const std::vector<bool>& isMerged) {
  if (!isSame_) return;
  const std::vector<Approximation>&before = old_.approximations(), &after = new_.approximations();
  std::set<Node> carriers;
  std::vector<std::pair<Node, Node>> pairs;
  for (std::size_t k = 0; k < after.size(); ++k) {
    if (after[k].place != nullptr || after[k].used == noNode) continue;
    if (k >= before.size() || before[k].reason != after[k].reason ||
        before[k].carriers.size() != after[k].carriers.size())
      return;
    for (std::size_t i = 0; i < after[k].carriers.size(); ++i) {
      carriers.insert(after[k].carriers[i]);
      pairs.emplace_back(after[k].carriers[i], before[k].carriers[i]);
    }
  }
  const Graph& from = new_.encoding().graph();
  std::map<Node, std::size_t> states;
  for (std::size_t i = 0; i < newSystem_.states.size(); ++i) states.emplace(newSystem_.states[i].node, i);
  std::vector<Node> open = newSystem_.constraints;
  open.push_back(newRuns_);
  for (const Output& output : outputs_) {
    if (output.newValue != noNode) open.push_back(output.newValue);
  }
  std::set<Node> seen;
  while (!open.empty()) {  // all that decides the outputs, through any number of scans
    const Node node = open.back();
    open.pop_back();
    if (node == noNode || !seen.insert(node).second) continue;
    open.insert(open.end(), from[node].child.begin(), from[node].child.end());
    if (from[node].op != Op::Variable) continue;
    const auto state = states.find(node);
    if (state == states.end()) {
      if (!carriers.contains(node) && !copy.isReplaced(node)) return;
      continue;
    }
    const std::size_t i = state->second;
    if (!partners_[i].isWorld && !kept_.contains(node) && !(isMerged[i] && isMergeable(i))) return;
    open.push_back(newSystem_.states[i].next);
  }
  for (const auto& [own, there] : pairs) {
    const bool isInput = from[own].op == Op::Variable && from[own].width == old_.encoding().graph()[there].width;
    if (isInput && !copy.isReplaced(own)) copy.replace(own, there);
  }
}

void ProgramProduct::noteEstimates(JoinedSystem& result) {
  Graph& graph = old_.encoding().graph();
  Graph::Bool used = graph.constant(false);
  for (const Approximation& approximation : old_.approximations()) {
    if (approximation.used != noNode) used = graph.lor(used, {approximation.used});
  }
  for (const Approximation& approximation : new_.approximations()) {
    if (approximation.used != noNode) used = graph.lor(used, {(*result.copy)(approximation.used)});
  }
  if (graph.truth(used) != false) result.usesEstimates = used.node;
}

}  // namespace rungproof
