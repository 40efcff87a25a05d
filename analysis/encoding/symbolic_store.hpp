// Graph::Store: the state of the machine as graph nodes while one scan is encoded. Memory is kept bit by bit, each bit
// as "bit k of that node", so a word read folds back to the word last written and single bits stay cheap. What is
// touched for the first time becomes a cell: a variable for its value at the start of the scan, made by a CellSource
// that knows initial values, inputs and constants. Untouched memory costs nothing.
// Covered by tests/encoder/store_test.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "analysis/encoding/memory_layout.hpp"
#include "analysis/graph/graph.hpp"

namespace rungproof {

/// A part of the machine's state: a run of bits of a memory area, or a register.
struct Place {
  bool isRegister = false;
  Area area = Area::V;
  Reg reg = Reg::Accumulator;
  std::uint32_t at = 0;  ///< memory: most significant bit, counted as byte * 8 + (7 - bit); register: index
  std::uint8_t width = 1;

  friend bool operator==(const Place&, const Place&) = default;
  friend auto operator<=>(const Place&, const Place&) = default;
  std::uint32_t byte() const { return at / 8; }
  std::uint32_t bit() const { return 7 - at % 8; }
};
Place memoryPlace(Area area, std::uint32_t byte, Width width, std::uint32_t bit = 0);
Place registerPlace(Reg reg, std::uint32_t index);
/// "V10.3", "VW10", "T37.value", "AC0".
std::string nameOf(const Place& place);

enum class CellKind : std::uint8_t {
  State,    ///< keeps its value from scan to scan
  Input,    ///< any value at the start of each scan
  Constant  ///< has one value in every scan
};

/// A place that the scan touched, with its value at the start of the scan.
struct Cell {
  Place place;
  CellKind kind;
  Node start;
};

/// Gives a place its value at the start of the scan.
class CellSource {
 public:
  virtual ~CellSource() = default;
  virtual Cell cellAt(const Place& place) = 0;
  /// What the scan finds at a cell of memory: its start, and what was written from outside since the scan before.
  virtual Node atScan(const Cell& cell) { return cell.start; }
  /// Byte of local memory whose block was entered with `entry` (the number given to enterFrame).
  virtual Node localByte(std::uint32_t entry, std::uint32_t byte) = 0;
  /// The machine reads or writes once more; may throw to end that. One instruction can do so very often.
  virtual void accessed() {}
};

/// A write to a single bit of memory: which instruction, what, and under which guard.
struct BitWrite {
  const Instruction* instruction;
  Place place;
  Node value;
  Node guard;
};

/// Places that an instruction touched.
struct Touch {
  Place place;
  bool isWrite;
};

class Graph::Store {
 public:
  Store(Graph& graph, const MemoryLayout& layout, CellSource& source, const Plan& plan);

  /// `offset` is byte * 8 + bit for width 1 and byte * 8 for whole bytes, as Machine counts.
  Bits load(Area area, std::uint32_t offset, int width);
  void save(Area area, std::uint32_t offset, int width, Bits value, Bool guard);
  Bits get(Reg reg, std::uint32_t index);
  void set(Reg reg, std::uint32_t index, Bits value, Bool guard);

  /// Value of any place now.
  Node value(const Place& place);
  /// Puts a value where `guard` holds, as a write.
  void replace(const Place& place, Node value, Bool guard);
  /// A byte of local memory is unknown again, its block having been entered.
  void forgetLocal(std::uint32_t base, std::uint32_t byte, std::uint32_t entry);
  /// Any value may stand in any place that a pointer can reach, where `guard` holds; fresh(place) makes the values.
  void havoc(Bool guard, std::function<Node(const Place&)> fresh);

  /// What has a value except local memory: runs of bits of one node, and registers.
  std::vector<Place> places() const;
  /// Cells in the order of first touch.
  const std::vector<Cell>& cells() const { return cells_; }
  /// A cell for a place that has a value but none at the start of the scan.
  void add(const Cell& cell) { cells_.push_back(cell); }
  const std::vector<BitWrite>& bitWrites() const { return bitWrites_; }
  /// The machine that uses the store: its current instruction is recorded with writes, and since a value that is
  /// read matters only under the guard, reads are simplified by it.
  void follow(const Machine<Graph>* machine) { machine_ = machine; }
  /// Asked for every place that is read or written while set.
  void observe(std::function<void(const Touch&)> observer) { observer_ = std::move(observer); }

 private:
  /// Bit `low` of a node; noNode: not touched yet.
  struct BitRef {
    Node node = noNode;
    std::uint32_t low = 0;
  };
  struct Havoc {
    Node guard;
    std::function<Node(const Place&)> fresh;
  };
  std::vector<BitRef>& bitsOf(Area area);
  /// Bits of data blocks stand in the one row of all blocks; outside they are named by block and byte.
  std::uint32_t inRow(Area area, std::uint32_t at) const { return area == Area::DB ? blocks_->bitPlace(at) : at; }
  std::uint32_t named(Area area, std::uint32_t at) const {
    return area == Area::DB ? blocks_->dataByteAt(at / 8) * 8 + at % 8 : at;
  }
  void touch(Area area, std::uint32_t first, int width);
  void touchRegister(Reg reg, std::uint32_t index);
  Node join(Area area, std::uint32_t first, int width);
  void put(Area area, std::uint32_t first, int width, Node value);
  Node read(Node value) { return machine_ == nullptr ? value : graph_.given(value, machine_->guard.node); }
  void note(const Place& place, bool isWrite) const {
    source_.accessed();
    if (observer_) observer_({place, isWrite});
  }

  Graph& graph_;
  const MemoryLayout& layout_;
  std::shared_ptr<const BlockMap> blocks_;
  CellSource& source_;
  std::array<std::vector<BitRef>, areaCount> bits_;
  std::array<std::vector<Node>, static_cast<std::size_t>(Reg::count)> registers_;
  /// By byte of L: number of the block entry, and the byte in the block's local memory.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> localEntry_;
  std::vector<Cell> cells_;
  std::vector<BitWrite> bitWrites_;
  std::vector<Havoc> havocs_;
  const Machine<Graph>* machine_ = nullptr;
  std::function<void(const Touch&)> observer_;
};

}  // namespace rungproof
