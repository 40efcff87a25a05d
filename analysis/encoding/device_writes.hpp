// What devices write while a request of the program runs, as inputs of the scan: the one place that says it for all.
//
//   RCV         byte 0 of the table: at most the maximum count; bytes 1 to that count: anything; at the end SMB86 or
//               SMB186 with one of e, t, c, p (001:3195-3223, 001:14286). Before the first RCV the status is any.
//   XMT         at the end SM4.5 or SM4.6 = 1 (001:14109); the table is only read.
//   NETR, NETW  at the end the status byte: done, no longer active, perhaps an error and its code (000:1113-1157,
//               001:3052-3065); NETR before: as many data bytes as were asked for.
//   GET, PUT    the same at the end (codes of their own); GET before: the bytes of the own data that its table named
//               when the request was made.
//   PLS         a train or profile ends: SM66.7 or SM76.7, SM66.4 or SM76.4 (001:4648-4650); while a profile runs its
//               segment in SMB166 or SMB176 (001:14367).
//   HSC         after HDEF the status bits 5 to 7, which mean something in interrupt routines only (001:4344); while
//               bit 7 of the control byte has enabled it the current value (001:4302), one for each scan.
//   SM31.7      cleared when the value has been saved (001:1649-1651).
//
// Devices write between scans: a request ends before any later scan, or never. Only what the program asks for costs
// anything. Covered by tests/environment/devices_test.cpp.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <vector>

#include "analysis/encoding/encoder.hpp"
#include "ir/s7200/call_contract.hpp"
#include "ir/s7200/device_end.hpp"

namespace rungproof {

/// Addresses in pointer form, by Instruction::id: of tables of devices to which pointers lead, and of the own data of
/// GET, to which a pointer in its table leads.
struct TableTargets {
  using Addresses = std::map<std::uint32_t, std::set<std::uint32_t>>;
  Addresses tables, buffers;

  /// Gives whether something was new.
  bool add(const TableTargets& more) {
    const auto join = [](Addresses& to, const Addresses& from) {
      bool isNew = false;
      for (const auto& [instruction, addresses] : from) {
        for (const std::uint32_t address : addresses) isNew = to[instruction].insert(address).second || isNew;
      }
      return isNew;
    };
    const bool hasTables = join(tables, more.tables);
    return join(buffers, more.buffers) || hasTables;
  }
};

class DeviceWrites {
 public:
  /// What the encoding gives.
  struct Source {
    std::function<Node(const Place&)> start;      ///< value that a cell has before devices write
    std::function<Node(std::string, int)> input;  ///< a fresh input of the scan
    /// A byte that the instruction's device writes and that is not followed, for that reason.
    std::function<Node(const Instruction*, std::string_view reason)> overwrite;
  };
  DeviceWrites(Graph& graph, const Plan& plan, const TableTargets& pointers, Source source);

  /// Requests that end before this scan: their registers. Call before anything else reads the machine.
  void begin(Machine<Graph>& machine);
  /// The value that the scan finds at a place of memory whose cell starts with `start`.
  Node seen(const Place& place, Node start);
  /// The current value of a high-speed counter that the scan finds where the last one has left `start`.
  Node counted(std::uint32_t counter, Node start);
  /// The input that says what a counter has counted.
  static std::string countName(std::uint32_t counter);
  /// Whether anything is ever written there.
  bool mayWrite(const Place& place);
  const std::vector<DeviceWrite>& writes() const { return writes_; }
  /// Whether the request that ends with that event ends before this scan; noNode: never.
  Node ends(int event) const;

 private:
  struct ByteWrite {
    Node guard;
    Node value;            ///< 8 bits
    unsigned mask = 0xFF;  ///< bits that are written
  };
  struct Table {
    const Instruction* instruction;
    std::uint32_t address;  ///< pointer form; isa::unknownAddress: any
    bool isFilled;          ///< by some request: NETR, RCV
  };

  void collect(const Plan& plan, const TableTargets& pointers);
  void addTables(std::vector<Table>& tables, const Instruction& instruction, const TableTargets& pointers);
  void beginPort(Machine<Graph>& machine, std::uint32_t port, PortUse use);
  void beginNetwork(Machine<Graph>& machine);
  void beginPulses(Machine<Graph>& machine, std::uint32_t output);
  const std::vector<ByteWrite>& writesTo(Area area, std::uint32_t byte);
  void statusWrites(std::uint32_t byte, std::vector<ByteWrite>& list);
  void receptionWrites(Area area, std::uint32_t byte, std::vector<ByteWrite>& list);
  void networkWrites(Area area, std::uint32_t byte, std::vector<ByteWrite>& list);
  void answerWrites(Area area, std::uint32_t byte, std::vector<ByteWrite>& list);
  Node isEntry(std::uint32_t entry, std::uint32_t address);
  Node runsAt(std::uint32_t address);
  bool isHead(Area area, std::uint32_t byte) const;
  void record(Area area, std::uint32_t byte, const ByteWrite& write);

  Node reg(Reg which, std::uint32_t index) { return source_.start(registerPlace(which, index)); }
  Node bitOf(Node n, int bit) {
    return graph_.make(Op::Extract, 1, n, noNode, noNode, static_cast<std::uint64_t>(bit));
  }
  Node both(Node a, Node b) { return graph_.make(Op::And, 1, a, b); }
  Node either(Node a, Node b) { return graph_.make(Op::Or, 1, a, b); }
  Node isNot(Node a) { return graph_.make(Op::Not, 1, a); }
  Node choose(Node condition, Node a, Node b, int width) { return graph_.make(Op::Ite, width, condition, a, b); }
  Node number(std::uint64_t value, int width) { return graph_.constantNode(value, width); }

  Graph& graph_;
  const Source source_;
  const Target target_;
  std::array<bool, 2> transmits_{}, receives_{};
  std::array<bool, pulseOutputCount> pulses_{};
  std::set<std::uint32_t> counters_;
  std::array<std::vector<Table>, 2> messages_;           ///< of RCV by port
  std::vector<Table> requests_;                          ///< of NETR, NETW, GET and PUT
  std::map<std::uint32_t, const Instruction*> buffers_;  ///< of GET by address
  std::map<int, Node> ends_;                             ///< by event
  std::map<std::uint32_t, Node> answered_;               ///< by network table: its request ends
  std::array<Node, pulseOutputCount> aborted_{noNode, noNode, noNode, noNode};
  std::map<std::pair<Area, std::uint32_t>, std::vector<ByteWrite>> known_;
  std::vector<DeviceWrite> writes_;
  std::map<std::uint32_t, Node> counts_;
};

/// Whether that high-speed counter can count: HDEF of it stands in the program; without, it stays 0 (001:4308). Mode 12
/// counts the pulses of an output, 0 for HSC0 and 1 for HSC3 (001:4237), and has none to count where nothing starts
/// them. A block without text may start them.
bool canCount(const Program& program, const CallContracts& hidden, std::uint32_t counter);

}  // namespace rungproof
