// Fields of special memory by instruction, and tables.
#include "analysis/equivalence/device_requests.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "ir/s7200/args.hpp"
#include "ir/s7200/event_cause.hpp"
#include "ir/s7200/isa/ethernet.hpp"
#include "ir/s7200/isa/hsc.hpp"

namespace rungproof {

namespace {

/// A field of special memory that an instruction takes; `update`: bit of the control byte that lets it, -1: always.
struct TakenField {
  std::uint32_t byte;
  Width width;
  int update = -1;
};

constexpr std::uint64_t setupBits = 0x07;  ///< of a counter's control byte, those that HDEF reads (001:4279)
constexpr int networkHead = 7;             ///< bytes of a network table before the data (000:1113)

bool hasConstant(const Instruction& instruction, std::size_t i, std::uint64_t most) {
  return i < instruction.operands.size() && instruction.operands[i].kind == OperandKind::Constant &&
         static_cast<std::uint64_t>(instruction.operands[i].value) <= most;
}
std::uint32_t constantAt(const Instruction& instruction, std::size_t i) {
  return static_cast<std::uint32_t>(instruction.operands[i].value);
}

struct Addressee {
  Device device;
  std::uint32_t number;
};

std::optional<Addressee> addresseeOf(const Instruction& instruction) {
  const Role role = roleOf(instruction);
  switch (role) {
    case Role::Hdef:
    case Role::Hsc:
      if (hasConstant(instruction, 0, isa::hscCount - 1)) return Addressee{Device::Counter, constantAt(instruction, 0)};
      return std::nullopt;
    case Role::Pls:
      if (hasConstant(instruction, 0, pulseOutputCount - 1))
        return Addressee{Device::PulseOutput, constantAt(instruction, 0)};
      return std::nullopt;
    case Role::Xmt:
    case Role::Rcv:
    case Role::Netr:
    case Role::Netw: {
      const bool isPort = role == Role::Xmt || role == Role::Rcv;
      if (hasConstant(instruction, 1, 1))
        return Addressee{isPort ? Device::Port : Device::Network, constantAt(instruction, 1)};
      return std::nullopt;
    }
    case Role::Get:
    case Role::Put: return Addressee{Device::Ethernet, 0};
    case Role::Todw: return Addressee{Device::Clock, 0};
    default: return std::nullopt;
  }
}

/// The control byte first.
std::vector<TakenField> fieldsOf(const Addressee& to, Role role) {
  switch (to.device) {
    case Device::Counter: {
      const std::uint32_t control = isa::hscControl[to.number];
      if (role == Role::Hdef) return {{control, Width::Byte}};
      return {{control, Width::Byte}, {control + 1, Width::DWord, 6}, {control + 5, Width::DWord, 5}};
    }
    case Device::PulseOutput: {
      const std::uint32_t control = pulseControl(to.number);
      return {{control, Width::Byte},
              {control + 1, Width::Word, 0},
              {control + 3, Width::Word, 1},
              {control + 5, Width::DWord, 2},
              {profileWord(to.number), Width::Word, 5}};
    }
    case Device::Port: {
      const std::uint32_t control = portControl(to.number), receive = to.number == 0 ? 87 : 187;
      if (role == Role::Xmt) return {{control, Width::Byte}};
      return {{control, Width::Byte},     {receive, Width::Byte},     {receive + 1, Width::Byte},
              {receive + 2, Width::Byte}, {receive + 3, Width::Word}, {receive + 5, Width::Word},
              {receive + 7, Width::Byte}};
    }
    case Device::Network: return {{portControl(to.number), Width::Byte}};
    case Device::Ethernet:
    case Device::Clock: return {};
  }
  return {};
}

/// Bytes `first` to `last` of the table at operand 0. What XMT, NETW and PUT send decides nothing about the device.
struct TakenTable {
  int first = 0, last = -1;
};

TakenTable tableOf(const Instruction& instruction) {
  switch (roleOf(instruction)) {
    case Role::Xmt: return {0, 0};  // how many characters (001:3194)
    case Role::Netr:
    case Role::Netw: return {1, networkHead - 1};  // byte 0 is the status, which the request writes
    case Role::Get:
    case Role::Put: return {1, isa::requestTableBytes - 1};
    case Role::Todw: return {0, instruction.desc->operands[0].buffer.high - 1};
    default: return {};
  }
}

template <class Visit>
void eachRequest(const Program& program, const Visit& visit) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if (const std::optional<Addressee> to = addresseeOf(instruction)) visit(instruction, *to);
      }
    }
  }
}

}  // namespace

void RequestRecord::at(Machine<Graph>& m, const Instruction& instruction) {
  const std::optional<Addressee> to = addresseeOf(instruction);
  if (!to) return;
  Graph& graph = m.d;
  const Role role = roleOf(instruction);
  const Graph::Bool runs = graph.land(m.guard, m.powerFlow());
  if (graph.truth(runs) == false) return;
  DeviceRequest request{&instruction, to->device, to->number, runs.node, {}};
  const auto take = [&](Graph::Bits value, int width, Graph::Bool isUsed) {
    request.settings.push_back(graph.select(isUsed, value, graph.literal(0, width), width).node);
  };
  const Graph::Bool always = graph.constant(true);
  take(graph.literal(static_cast<std::uint64_t>(role), 8), 8, always);
  // The same numbers mean other inputs of a counter and other pulses in another series of CPUs.
  if (to->device == Device::Counter || to->device == Device::PulseOutput)
    take(graph.literal(static_cast<std::uint64_t>(cpuRow(m.target.cpu).series), 8), 8, always);
  if (role == Role::Hdef && instruction.operands.size() == 2)
    take(graph.literal(static_cast<std::uint64_t>(instruction.operands[1].value), 8), 8, always);
  const std::vector<TakenField> fields = fieldsOf(*to, role);
  const auto fieldAt = [&](const TakenField& field) { return m.load(Area::SM, field.byte, field.width); };
  const Graph::Bits control = fields.empty() ? graph.literal(0, 8) : fieldAt(fields[0]);
  for (const TakenField& field : fields) {
    if (role == Role::Hdef)
      take(graph.band(control, graph.literal(setupBits, 8), 8), 8, always);
    else
      take(fieldAt(field), bits(field.width), field.update < 0 ? always : graph.bit(control, field.update));
  }
  const TakenTable table = tableOf(instruction);
  if (table.last >= 0) {
    const Instruction* last = std::exchange(m.current, &instruction);  // whose pointer is followed
    Args<Graph> a(m, instruction, *instruction.desc);
    a.resolve();
    const int end = std::min(table.last + 1, a.room(0, Width::Byte, table.last + 1));
    for (int k = table.first; k < end; ++k) take(a.element(0, k, Width::Byte), 8, always);
    m.current = last;
  }
  requests_.push_back(std::move(request));
}

void observeRequests(EncoderOptions& options, const Program& program) {
  eachRequest(program, [&](const Instruction& instruction, const Addressee& to) {
    for (const TakenField& field : fieldsOf(to, roleOf(instruction)))
      options.observed.push_back(direct(Area::SM, field.width, field.byte));
    const TakenTable table = tableOf(instruction);
    if (table.last < 0 || instruction.operands[0].kind != OperandKind::Direct) return;
    const Operand& first = instruction.operands[0];
    for (int k = 0; k <= table.last; ++k) {
      const std::uint32_t byte = first.offset + static_cast<std::uint32_t>(k);
      if (byte < areaSize(program.target, first.area))
        options.observed.push_back(direct(first.area, Width::Byte, byte));
    }
  });
}

bool sendsMessages(const Program& program) {
  bool found = false;
  eachRequest(program, [&](const Instruction& instruction, const Addressee&) {
    const Role role = roleOf(instruction);
    found = found || role == Role::Xmt || role == Role::Netw || role == Role::Put;
  });
  return found;
}

UsedPulses pulseOutputsOf(const Program& program) {
  UsedPulses found{};
  eachRequest(program, [&](const Instruction&, const Addressee& to) {
    if (to.device == Device::PulseOutput) found.at(to.number) = true;
  });
  return found;
}

bool usesPulses(const Program& before, const Program& after) {
  const auto isAny = [](const UsedPulses& used) { return std::ranges::any_of(used, std::identity{}); };
  return isAny(pulseOutputsOf(before)) || isAny(pulseOutputsOf(after));
}

bool isDeviceEvent(int event) { return isPulseEvent(event) || portEvent(event) || counterEvent(event); }

}  // namespace rungproof
