// Inputs for what devices write, byte by byte, made when the byte is first touched.
#include "analysis/encoding/device_writes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ir/check.hpp"
#include "ir/s7200/isa/comm.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t longestMessage = 255;                     // 001:3195
constexpr std::uint32_t dataAt = 7, longestData = 16;             // of a network table (000:1113-1157)
constexpr std::uint32_t mostRead = 222;                           // by GET
constexpr std::uint64_t endedItself = 0x27, endedByCount = 0x02;  // e, t, c, p; c (001:14286)
constexpr std::uint64_t anyStatus = 0xE7;                         // bits 4 and 3 are always 0
constexpr std::array<std::uint32_t, 6> counterStatus = {36, 46, 56, 136, 146, 156};
constexpr unsigned counterBits = 0xE0;
constexpr std::uint32_t saveByte = 31, saveBit = 7;
constexpr std::string_view unknownTable = "writes later through a pointer whose targets could not be found";
constexpr std::string_view headOverwritten = "writes later into the status byte of another request";

bool isConstantPort(const Instruction& instruction) {
  return instruction.operands.size() == 2 && instruction.operands[1].kind == OperandKind::Constant &&
         (instruction.operands[1].value == 0 || instruction.operands[1].value == 1);
}

}  // namespace

DeviceWrites::DeviceWrites(Graph& graph, const Plan& plan, const TableTargets& pointers, Source source)
    : graph_(graph), source_(std::move(source)), target_(plan.program->target) {
  collect(plan, pointers);
}

void DeviceWrites::collect(const Plan& plan, const TableTargets& pointers) {
  for (const Flow& flow : plan.flows) {
    for (const FlowStep& step : flow.steps) {
      const Instruction& instruction = *step.instruction;
      const Role role = roleOf(instruction);
      const auto number = [&](std::size_t i) { return static_cast<std::uint32_t>(instruction.operands[i].value); };
      if ((role == Role::Xmt || role == Role::Rcv) && isConstantPort(instruction)) {
        (role == Role::Xmt ? transmits_ : receives_)[number(1)] = true;
        if (role == Role::Rcv) addTables(messages_[number(1)], instruction, pointers);
      } else if (role == Role::Netr || role == Role::Netw || role == Role::Get || role == Role::Put) {
        addTables(requests_, instruction, pointers);
        const auto found = pointers.buffers.find(instruction.id);
        if (found == pointers.buffers.end()) continue;
        for (const std::uint32_t address : found->second) buffers_.emplace(address, &instruction);
      } else if (role == Role::Pls && !instruction.operands.empty() && number(0) < pulses_.size()) {
        pulses_[number(0)] = true;
      } else if (role == Role::Hdef && !instruction.operands.empty() && number(0) < counterStatus.size()) {
        counters_.insert(number(0));
      }
    }
  }
}

/// The same address once: what is written there does not depend on who asked.
void DeviceWrites::addTables(std::vector<Table>& tables, const Instruction& instruction, const TableTargets& pointers) {
  if (instruction.operands.empty()) return;
  const bool isFilled = roleOf(instruction) == Role::Netr || roleOf(instruction) == Role::Rcv;
  const auto add = [&](std::uint32_t address) {
    const auto same = std::ranges::find(tables, address, &Table::address);
    if (same == tables.end())
      tables.push_back({&instruction, address, isFilled});
    else
      same->isFilled = same->isFilled || isFilled;
  };
  const Operand& operand = instruction.operands[0];
  if (operand.kind == OperandKind::Direct) add(pointer::encode(operand.area, operand.offset));
  if (const auto found = pointers.tables.find(instruction.id); found != pointers.tables.end()) {
    for (const std::uint32_t address : found->second) add(address);
  }
}

// ---- Ends ------------------------------------------------------------------------------------------------

void DeviceWrites::begin(Machine<Graph>& machine) {
  for (std::uint32_t port = 0; port < 2; ++port) {
    if (transmits_[port]) beginPort(machine, port, PortUse::Transmission);
    if (receives_[port]) beginPort(machine, port, PortUse::Reception);
  }
  if (!requests_.empty()) beginNetwork(machine);
  for (std::uint32_t output = 0; output < pulseOutputCount; ++output) {
    if (pulses_[output]) beginPulses(machine, output);
  }
  // The status shows the end to the engine: it is written even where the program does not look.
  for (std::uint32_t i = 0; i < 2; ++i) {
    if (transmits_[i]) writesTo(Area::SM, 4);
    if (receives_[i]) writesTo(Area::SM, receiveStatus(i));
  }
  for (std::uint32_t i = 0; i < pulseOutputCount; ++i) {
    if (pulses_[i]) writesTo(Area::SM, pulseStatus(i));
  }
  for (const auto& [address, end] : answered_) writesTo(*pointer::areaOf(address), pointer::offsetOf(address));
}

void DeviceWrites::beginPort(Machine<Graph>& machine, std::uint32_t port, PortUse use) {
  const bool sends = use == PortUse::Transmission;
  const Node runs = bitOf(reg(Reg::PortBusy, port), static_cast<int>(use));
  const Node end = both(runs, source_.input(fmt::format("port {}: {} ends", port, sends ? "XMT" : "RCV"), 1));
  ends_[eventOfEnd(use, port)] = end;
  machine.when({end}, [&] { endPortUse(machine, port, use); });
}

/// At one address at most one request ends: the first one.
void DeviceWrites::beginNetwork(Machine<Graph>& machine) {
  const std::uint32_t entries = networkRequests(target_);
  for (const Table& table : requests_) {
    if (table.address == isa::unknownAddress) continue;
    const Node runs = runsAt(table.address);
    const std::string name =
        addressName(*pointer::areaOf(table.address), Width::Byte, pointer::offsetOf(table.address));
    answered_[table.address] = both(runs, source_.input(fmt::format("request of {} ends", name), 1));
  }
  for (const auto& [address, end] : answered_) {
    Node before = number(0, 1);
    for (std::uint32_t entry = 0; entry < entries; ++entry) {
      const Node here = isEntry(entry, address);
      machine.when({both(end, both(here, isNot(before)))}, [&] { endNetworkRequest(machine, entry); });
      before = either(before, here);
    }
  }
}

void DeviceWrites::beginPulses(Machine<Graph>& machine, std::uint32_t output) {
  const Node runs = both(reg(Reg::PulseBusy, output), isNot(reg(Reg::PulseIsPwm, output)));
  const Node end = both(runs, source_.input(fmt::format("PTO{} ends", output), 1));
  const Node single = graph_.make(Op::Equal, 1, reg(Reg::PulseSegments, output), number(0, 8));
  ends_[eventOfTrain(output)] = end;
  aborted_[output] = both(both(end, isNot(single)), source_.input(fmt::format("PTO{} is aborted", output), 1));
  machine.when({end}, [&] { endPulseTrain(machine, output); });
}

Node DeviceWrites::ends(int event) const {
  const auto found = ends_.find(event);
  return found == ends_.end() ? noNode : found->second;
}

// ---- Bytes -----------------------------------------------------------------------------------------------

Node DeviceWrites::isEntry(std::uint32_t entry, std::uint32_t address) {
  if (address == 0) return number(0, 1);  // an entry without a request; a pointer to IB0 gives none
  return graph_.make(Op::Equal, 1, reg(Reg::NetTable, entry), number(address, 32));
}

Node DeviceWrites::runsAt(std::uint32_t address) {
  Node runs = number(0, 1);
  for (std::uint32_t entry = 0; entry < networkRequests(target_); ++entry) runs = either(runs, isEntry(entry, address));
  return runs;
}

/// Whether a network request has its status byte there.
bool DeviceWrites::isHead(Area area, std::uint32_t byte) const {
  return std::ranges::any_of(requests_, [&](const Table& t) { return t.address == pointer::encode(area, byte); });
}

const std::vector<DeviceWrites::ByteWrite>& DeviceWrites::writesTo(Area area, std::uint32_t byte) {
  static const std::vector<ByteWrite> none;
  const bool hasTables = !requests_.empty() || !messages_[0].empty() || !messages_[1].empty();
  if (area != Area::SM && !hasTables) return none;
  // Its write depends on the bit itself: the cell of the bit comes first.
  if (area == Area::SM && byte == saveByte && savesMemory(target_))
    source_.start(memoryPlace(Area::SM, saveByte, Width::Bit, saveBit));
  if (const auto found = known_.find({area, byte}); found != known_.end()) return found->second;
  std::vector<ByteWrite> list;
  if (area == Area::SM) statusWrites(byte, list);
  receptionWrites(area, byte, list);
  networkWrites(area, byte, list);
  answerWrites(area, byte, list);
  std::erase_if(list, [&](const ByteWrite& write) { return graph_.truth({write.guard}) == false; });
  for (const ByteWrite& write : list) record(area, byte, write);
  return known_[{area, byte}] = std::move(list);
}

void DeviceWrites::record(Area area, std::uint32_t byte, const ByteWrite& write) {
  if (write.mask == 0xFF) {
    writes_.push_back({direct(area, Width::Byte, byte), write.guard, write.value});
    return;
  }
  for (unsigned bit = 0; bit < 8; ++bit) {
    if ((write.mask >> bit & 1U) != 0)
      writes_.push_back({direct(area, Width::Bit, byte, bit), write.guard, bitOf(write.value, static_cast<int>(bit))});
  }
}

void DeviceWrites::statusWrites(std::uint32_t byte, std::vector<ByteWrite>& list) {
  for (std::uint32_t port = 0; port < 2; ++port) {
    if (byte == receiveStatus(port)) {
      const Node any = source_.input(fmt::format("status of RCV at port {}", port), 8);
      const Node own = graph_.make(Op::And, 8, any, number(endedItself, 8));
      const Node isNone = graph_.make(Op::Equal, 1, own, number(0, 8));
      list.push_back({reg(Reg::FirstScan, 0), graph_.make(Op::And, 8, any, number(anyStatus, 8))});
      if (receives_[port])
        list.push_back(
            {ends_.at(eventOfEnd(PortUse::Reception, port)), choose(isNone, number(endedByCount, 8), own, 8)});
    }
    if (byte == 4 && transmits_[port])
      list.push_back({ends_.at(eventOfEnd(PortUse::Transmission, port)), number(0xFF, 8), 1U << transmitterBit(port)});
  }
  for (std::uint32_t output = 0; output < pulseOutputCount; ++output) {
    if (!pulses_[output]) continue;
    const Node end = ends_.at(eventOfTrain(output));
    if (byte == pulseStatus(output)) {
      const Node isLast = isNot(reg(Reg::PulsePending, output));
      list.push_back({end, choose(isLast, number(0xFF, 8), number(0, 8), 8), 1U << pulseIdle});
      list.push_back({aborted_[output], number(0xFF, 8), 1U << pulseAborted});
    }
    if (byte == segmentByte(output)) {
      const Node segments = reg(Reg::PulseSegments, output);
      const Node any = source_.input(fmt::format("segment of PTO{}", output), 8);
      const Node isNone = graph_.make(Op::Equal, 1, any, number(0, 8));
      const Node isLegal = both(graph_.make(Op::Ule, 1, any, segments), isNot(isNone));
      const Node runs = both(reg(Reg::PulseBusy, output), isNot(graph_.make(Op::Equal, 1, segments, number(0, 8))));
      list.push_back({runs, choose(isLegal, any, segments, 8)});
    }
  }
  for (const std::uint32_t counter : counters_) {
    if (byte != counterStatus[counter]) continue;
    const Node isDefined = isNot(graph_.make(Op::Equal, 1, reg(Reg::HscMode, counter), number(0, 8)));
    list.push_back({isDefined, source_.input(fmt::format("status of HSC{}", counter), 8), counterBits});
  }
  if (byte == saveByte && savesMemory(target_)) {
    const Node asked = source_.start(memoryPlace(Area::SM, saveByte, Width::Bit, saveBit));
    list.push_back({both(asked, source_.input("value is saved", 1)), number(0, 8), 1U << saveBit});
  }
}

void DeviceWrites::receptionWrites(Area area, std::uint32_t byte, std::vector<ByteWrite>& list) {
  for (std::uint32_t port = 0; port < 2; ++port) {
    for (const Table& table : messages_[port]) {
      const Node runs = bitOf(reg(Reg::PortBusy, port), static_cast<int>(PortUse::Reception));
      const Node isHere = graph_.make(Op::Equal, 1, reg(Reg::PortTable, port * 2 + 1), number(table.address, 32));
      const Node guard = messages_[port].size() == 1 ? runs : both(runs, isHere);
      if (table.address == isa::unknownAddress) {
        list.push_back({both(runs, isHere), source_.overwrite(table.instruction, unknownTable)});
        continue;
      }
      const std::uint32_t first = pointer::offsetOf(table.address);
      if (pointer::areaOf(table.address) != area || byte < first || byte - first > longestMessage) continue;
      const Node limit = reg(Reg::PortLimit, port), index = number(byte - first, 8);
      const std::string text = fmt::format("port {}: {} of the message in {}", port,
                                           addressName(area, Width::Byte, byte), addressName(area, Width::Byte, first));
      const Node any =
          isHead(area, byte) ? source_.overwrite(table.instruction, headOverwritten) : source_.input(text, 8);
      const bool isCount = byte == first;
      list.push_back({both(guard, graph_.make(Op::Ule, 1, index, limit)),
                      isCount ? choose(graph_.make(Op::Ule, 1, any, limit), any, limit, 8) : any});
    }
  }
}

void DeviceWrites::networkWrites(Area area, std::uint32_t byte, std::vector<ByteWrite>& list) {
  const std::uint32_t entries = networkRequests(target_);
  for (const Table& table : requests_) {
    if (table.address == isa::unknownAddress) {
      list.push_back({runsAt(table.address), source_.overwrite(table.instruction, unknownTable)});
      continue;
    }
    const std::uint32_t first = pointer::offsetOf(table.address);
    if (pointer::areaOf(table.address) != area || byte < first || byte >= first + dataAt + longestData) continue;
    const std::string name = addressName(area, Width::Byte, byte);
    if (byte == first) {
      // D A E 0 and the code, which tells of an error if there is one; whether D comes with an error too is left open.
      const Node isError = source_.input(fmt::format("error of {}", name), 1);
      const Node code = source_.input(fmt::format("error code of {}", name), 4);
      const Node isDone = either(isNot(isError), source_.input(fmt::format("{} is done all the same", name), 1));
      const Node isCode = both(graph_.make(Op::Ule, 1, number(1, 4), code),
                               graph_.make(Op::Ule, 1, code, number(lastNetworkError(target_), 4)));
      const Node low = choose(isError, choose(isCode, code, number(1, 4), 4), number(0, 4), 4);
      const Node high = graph_.make(Op::Concat, 2, isDone, number(0, 1));
      const Node middle = graph_.make(Op::Concat, 4, high, graph_.make(Op::Concat, 2, isError, number(0, 1)));
      list.push_back({answered_.at(table.address), graph_.make(Op::Concat, 8, middle, low)});
    } else if (byte >= first + dataAt && table.isFilled) {
      Node guard = number(0, 1);
      for (std::uint32_t entry = 0; entry < entries; ++entry) {
        const Node reads = both(isEntry(entry, table.address), isNot(reg(Reg::NetIsWrite, entry)));
        const Node inside = graph_.make(Op::Ult, 1, number(byte - first - dataAt, 8), reg(Reg::NetLength, entry));
        guard = either(guard, both(reads, inside));
      }
      const std::string text = fmt::format("answer in {} of {}", name, addressName(area, Width::Byte, first));
      list.push_back(
          {guard, isHead(area, byte) ? source_.overwrite(table.instruction, headOverwritten) : source_.input(text, 8)});
    }
  }
}

/// The own data of GET, as long and from where the request has found it.
void DeviceWrites::answerWrites(Area area, std::uint32_t byte, std::vector<ByteWrite>& list) {
  for (const auto& [address, instruction] : buffers_) {
    if (address == 0) continue;
    Node guard = number(0, 1);
    for (std::uint32_t entry = 0; entry < networkRequests(target_); ++entry) {
      const Node buffer = reg(Reg::NetBuffer, entry), own = number(address, 32);
      if (address == isa::unknownAddress) {
        guard = either(guard, isNot(graph_.make(Op::Equal, 1, buffer, number(0, 32))));
      } else if (pointer::areaOf(address) == area && byte >= pointer::offsetOf(address) &&
                 byte - pointer::offsetOf(address) < mostRead) {
        const Node inside =
            graph_.make(Op::Ult, 1, number(byte - pointer::offsetOf(address), 8), reg(Reg::NetLength, entry));
        guard = either(guard, both(graph_.make(Op::Equal, 1, buffer, own), inside));
      }
    }
    if (graph_.truth({guard}) == false) continue;
    if (address == isa::unknownAddress) {
      list.push_back({guard, source_.overwrite(instruction, unknownTable)});
      continue;
    }
    const std::string text = fmt::format("answer in {}", addressName(area, Width::Byte, byte));
    list.push_back(
        {guard, isHead(area, byte) ? source_.overwrite(instruction, headOverwritten) : source_.input(text, 8)});
  }
}

bool DeviceWrites::mayWrite(const Place& place) {
  if (place.area == Area::SM &&
      smRow(target_, place.byte(), place.width == 1 ? place.bit() : 0).source == SmSource::Device)
    return true;
  for (std::uint32_t byte = place.byte(); byte <= (place.at + place.width - 1U) / 8; ++byte) {
    if (!writesTo(place.area, byte).empty()) return true;
  }
  return false;
}

Node DeviceWrites::seen(const Place& place, Node start) {
  if (place.width == 1) {
    Node value = start;
    for (const ByteWrite& write : writesTo(place.area, place.byte())) {
      if ((write.mask >> place.bit() & 1U) != 0)
        value = choose(write.guard, bitOf(write.value, static_cast<int>(place.bit())), value, 1);
    }
    return value;
  }
  if (!mayWrite(place)) return start;  // the cell stays in one piece
  Node result = noNode;
  for (int done = 0; done < place.width; done += 8) {
    const auto low = static_cast<std::uint64_t>(place.width - 8 - done);
    Node part = graph_.make(Op::Extract, 8, start, noNode, noNode, low);
    for (const ByteWrite& write : writesTo(place.area, place.byte() + static_cast<std::uint32_t>(done) / 8)) {
      CHECK(write.mask == 0xFF, "bits that a device writes alone are cells of one bit");
      part = choose(write.guard, write.value, part, 8);
    }
    result = result == noNode ? part : graph_.make(Op::Concat, done + 8, result, part);
  }
  return result;
}

std::string DeviceWrites::countName(std::uint32_t counter) { return fmt::format("HC{} of the scan", counter); }

Node DeviceWrites::counted(std::uint32_t counter, Node start) {
  const auto [place, isNew] = counts_.try_emplace(counter, noNode);
  if (isNew) place->second = choose(reg(Reg::HscEnabled, counter), source_.input(countName(counter), 32), start, 32);
  return place->second;
}

bool canCount(const Program& program, const CallContracts& hidden, std::uint32_t counter) {
  constexpr std::int64_t countsPulseOutput = 12;
  const auto isThere = [&](auto&& isWanted) {
    for (const Pou& pou : program.pous) {  // what is not encoded as well
      for (const Network& network : pou.networks) {
        if (std::ranges::any_of(network.instructions, isWanted)) return true;
      }
    }
    return false;
  };
  const auto defines = [&](const Instruction& i, bool byPulses) {
    return roleOf(i) == Role::Hdef && i.operands.size() > 1 && i.operands[0].value == counter &&
           (i.operands[1].value == countsPulseOutput) == byPulses;
  };
  if (isThere([&](const Instruction& i) { return defines(i, false); })) return true;
  const std::int64_t output = counter == 0 ? 0 : 1;
  return isThere([&](const Instruction& i) { return defines(i, true); }) &&
         (!hidden.empty() || isThere([&](const Instruction& i) {
           return roleOf(i) == Role::Pls && !i.operands.empty() && i.operands[0].value == output;
         }));
}

}  // namespace rungproof
