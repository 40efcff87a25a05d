// What both programs ask of their devices, request by request, and which outputs depend on what comes of it.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/equivalence/product.hpp"
#include "analysis/proof/question_system.hpp"

namespace rungproof {

namespace {

/// The requests to one device, in the order of the scan.
using Requests = std::map<std::pair<Device, std::uint32_t>, std::vector<const DeviceRequest*>>;

}  // namespace

std::string nameOf(const PulseSignal& signal) {
  return "PLS" + std::to_string(signal.output) + '.' + std::string(pulseNumberName(signal.number));
}

std::vector<PulseSignal> comparedPulses(const Operands& observed, const AddressPairs& pairs, std::uint32_t latency,
                                        const UsedPulses& isUsed, const std::array<PulseForm, 2>& forms) {
  std::vector<PulseSignal> signals;
  if (!observed.empty() || latency > 0) return signals;
  for (std::uint32_t output = 0; output < isUsed.size(); ++output) {
    const Address address{Area::Q, pulseOutputs[output].point};
    const bool isGivenAway = pairs.after(address) != address && !pairs.isSeparate();
    if (!isUsed[output] || isGivenAway) continue;
    for (const PulseNumber number : pulseNumbers) {
      if (number == PulseNumber::Frequency && !forms[0].hasFrequency && !forms[1].hasFrequency) continue;
      signals.push_back({output, number});
    }
  }
  return signals;
}

void ProgramProduct::addPulses() {
  UsedPulses isUsed{};
  for (const RequestRecord* side : {&oldRequests_, &newRequests_}) {
    for (const DeviceRequest& request : side->requests()) {
      if (request.device == Device::PulseOutput) isUsed.at(request.number) = true;
    }
  }
  for (const PulseSignal& signal :
       comparedPulses(options_.observed, options_.pairs, options_.latency, isUsed, pulseForms_)) {
    const auto valueIn = [&](EncodedScan& encoding, const PulseForm& form) {
      return pulseNumber(
                 encoding.graph(), signal.number, form,
                 [&](Reg reg) {
                   return Graph::Bits{encoding.atEnd(registerPlace(reg, reg == Reg::Running ? 0 : signal.output))};
                 })
          .node;
    };
    Output& output = outputs_.emplace_back();
    output.oldValue = valueIn(old_.encoding(), pulseForms_[0]);
    output.newValue = valueIn(new_.encoding(), pulseForms_[1]);
    output.pulses = signal;
  }
}

/// Ports whose characters are events: those come as the control byte says, without any request.
std::vector<std::uint32_t> ProgramProduct::usedPorts() {
  std::vector<std::uint32_t> ports;
  for (const std::uint32_t port : {0U, 1U}) {
    const int character = port == 0 ? 8 : 25;
    const auto isUsed = [&](const SiteInput& site) { return site.event == character; };
    if (std::ranges::any_of(old_.encoding().siteInputs(), isUsed) ||
        std::ranges::any_of(new_.encoding().siteInputs(), isUsed))
      ports.push_back(port);
  }
  return ports;
}

/// The k-th request to a device in OLD and in NEW.
void ProgramProduct::compareRequests(JoinedSystem& result) {
  Graph& graph = old_.encoding().graph();
  int number = 0;
  const auto add = [&](RequestDifference difference) {
    difference.number = ++number;
    if (graph.truth({difference.differs}) != false) result.requests.push_back(difference);
  };
  Requests before, after;
  for (const DeviceRequest& request : oldRequests_.requests())
    before[{request.device, request.number}].push_back(&request);
  for (const DeviceRequest& request : newRequests_.requests()) {
    std::uint32_t number = request.number;
    if (request.device == Device::Counter) {
      const auto there = options_.pairs.before(Address{Area::HC, number});
      number = there && there->area == Area::HC ? there->index : number;
    }
    after[{request.device, number}].push_back(&request);
  }
  for (const auto& [device, own] : after) before.try_emplace(device);
  for (const auto& [device, olds] : before) {
    const std::vector<const DeviceRequest*>& news = after[device];
    for (std::size_t k = 0; k < std::max(olds.size(), news.size()); ++k) {
      if (k >= news.size()) {
        add({olds[k]->instruction, nullptr, -1, olds[k]->runs});
        continue;
      }
      const Graph::Bool runs{(*result.copy)(news[k]->runs)};
      if (k >= olds.size()) {
        add({nullptr, news[k]->instruction, -1, runs.node});
        continue;
      }
      Graph::Bool isSame = graph.constant(olds[k]->settings.size() == news[k]->settings.size());
      for (std::size_t i = 0; i < std::min(olds[k]->settings.size(), news[k]->settings.size()); ++i) {
        const Node mine = olds[k]->settings[i], theirs = (*result.copy)(news[k]->settings[i]);
        const bool isAsWide = graph[mine].width == graph[theirs].width;
        isSame =
            graph.land(isSame, isAsWide ? graph.equal({mine}, {theirs}, graph[mine].width) : graph.constant(false));
      }
      const Graph::Bool other = graph.land({olds[k]->runs}, graph.lnot(isSame));
      add({olds[k]->instruction, news[k]->instruction, -1, graph.lor(graph.lxor({olds[k]->runs}, runs), other).node});
    }
  }
  for (const std::uint32_t port : usedPorts()) {
    if (!old_.encoding().holds(portPlace(port)) || !new_.encoding().holds(portPlace(port))) {
      add({nullptr, nullptr, static_cast<int>(port), graph.constant(true).node});
      continue;
    }
    const Node mine = old_.encoding().atEnd(portPlace(port));
    const Node theirs = (*result.copy)(new_.encoding().atEnd(portPlace(port)));
    add({nullptr, nullptr, static_cast<int>(port), graph.lnot(graph.equal({mine}, {theirs}, 8)).node});
  }
}

std::string requestText(const RequestDifference& request, const Program& before, const Program& after) {
  constexpr std::string_view sequel = "what comes of it may differ";
  if (request.before != nullptr && request.after != nullptr)
    return fmt::format("{} may ask for something else than {}, or at another time: {}",
                       placeText(after, *request.after), placeText(before, *request.before), sequel);
  if (request.after != nullptr)
    return fmt::format("OLD asks for nothing like {}: {}", placeText(after, *request.after), sequel);
  if (request.before != nullptr)
    return fmt::format("NEW asks for nothing like {}: {}", placeText(before, *request.before), sequel);
  return fmt::format("SMB{} may differ: what arrives at port {} may be read otherwise",
                     portControl(static_cast<std::uint32_t>(request.port)), request.port);
}

std::vector<Question> requestQuestions(const JoinedSystem& joined) {
  std::vector<Question> questions;
  for (const RequestDifference& request : joined.requests)
    questions.push_back({fmt::format("request{} differs", request.number), request.differs});
  return questions;
}

std::vector<bool> ProgramProduct::dependsOnDevices(const JoinedSystem& joined) {
  const Graph& graph = old_.encoding().graph();
  const bool setsClock = [&] {
    const auto sets = [](const DeviceRequest& request) { return request.device == Device::Clock; };
    return std::ranges::any_of(oldRequests_.requests(), sets) || std::ranges::any_of(newRequests_.requests(), sets);
  }();
  std::set<Node> answers;
  for (const auto& [name, node] : old_.encoding().deviceInputs()) answers.insert(node);
  for (const SiteInput& site : old_.encoding().siteInputs()) {
    if (isDeviceEvent(site.event)) answers.insert(site.node);
  }
  for (const ExternalInput& e : old_.encoding().externals()) {
    if (setsClock && e.site.kind == External::ClockByte && e.node != noNode) answers.insert(e.node);
  }
  std::map<Node, Node> next;
  for (const StateVariable& state : joined.system.states) next.emplace(state.node, state.next);
  const auto depends = [&](std::vector<Node> open) {
    std::set<Node> seen;
    while (!open.empty()) {  // through any number of scans
      const Node node = open.back();
      open.pop_back();
      if (node == noNode || !seen.insert(node).second) continue;
      if (answers.contains(node)) return true;
      open.insert(open.end(), graph[node].child.begin(), graph[node].child.end());
      if (const auto state = next.find(node); state != next.end()) open.push_back(state->second);
    }
    return false;
  };
  std::vector<Node> common;
  for (const Node constraint : joined.system.constraints) {
    const auto& total = joined.system.totalConstraints;
    if (std::ranges::find(total, constraint) == total.end()) common.push_back(constraint);
  }
  std::vector<bool> result;
  if (answers.empty()) return std::vector<bool>(outputs_.size() + 1, false);
  for (const Output& output : outputs_) {
    std::vector<Node> roots = common;
    roots.push_back(output.oldValue);
    roots.push_back((*joined.copy)(output.newValue));
    result.push_back(depends(std::move(roots)));
  }
  common.push_back(oldRuns_);
  common.push_back((*joined.copy)(newRuns_));
  result.push_back(depends(std::move(common)));
  return result;
}

}  // namespace rungproof
