// LaneLayout: where the state of a group of traces stands that run side by side. Every piece of state that the code
// touches has a row: the same piece of all traces of the group, in the form (Rep) in which vector instructions compute
// with it. Where the code computes with truth values only, a group has 256 traces, with a bit for each. Otherwise it
// has 64, of which a truth value is a double word pair and numbers stand in registers of 512 bits; or 32 with a byte of
// eight equal bits for each truth value, where the processor has 256 bits only. Covered by tests/lanes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "engine/compiled/code.hpp"
#include "engine/concrete.hpp"

namespace rungproof::lanes {

using compiled::Code;
using compiled::CodeOp;
using compiled::Step;
using compiled::ValueId;

/// A value of all traces of a group: truth values, or numbers of 8, 16, 32 or 64 bits.
enum class Rep : std::uint8_t { Truth, Byte, Word, Double, Quad };

/// How a group stands in memory.
enum class Form : std::uint8_t {
  Bits,   ///< 256 traces, a bit of each
  Bytes,  ///< 32 traces, truth values are bytes; registers of 256 bits
  Wide    ///< 64 traces, truth values are bits; registers of 512 bits
};

/// A register of 256 bits; a row of Form::Wide is one of 512 bits, or 64 bits of a truth value.
inline constexpr std::size_t rowBytes = 32, wideBytes = 64, wideTruthBytes = 8;
inline constexpr std::size_t mostPieces = 8;
/// Registers that a value takes.
constexpr std::size_t pieceCount(Rep rep) {
  return rep <= Rep::Byte ? 1 : std::size_t{1} << (static_cast<int>(rep) - static_cast<int>(Rep::Byte));
}
/// The narrowest form that holds so many bits; one bit is a truth value.
constexpr Rep repFor(int width) {
  return width <= 1    ? Rep::Truth
         : width <= 8  ? Rep::Byte
         : width <= 16 ? Rep::Word
         : width <= 32 ? Rep::Double
                       : Rep::Quad;
}
/// The same for a number: a bit takes a byte.
constexpr Rep numberFor(int width) { return std::max(repFor(width), Rep::Byte); }
constexpr Rep wider(Rep rep) { return static_cast<Rep>(static_cast<int>(rep) + 1); }
constexpr Rep narrower(Rep rep) { return static_cast<Rep>(static_cast<int>(rep) - 1); }
constexpr int bitsOf(Rep rep) { return rep == Rep::Truth ? 1 : 4 << static_cast<int>(rep); }

/// Where the number of a trace stands in a row of Form::Bytes: numbers are widened half by half within 128 bits, as the
/// processor's instructions for that do, so that no value crosses the middle of a register.
constexpr std::size_t elementOf(Rep rep, std::size_t lane) {
  if (rep <= Rep::Byte) return lane;
  const std::size_t perHalf = 128 / static_cast<std::size_t>(bitsOf(rep));
  // The element one form narrower, its register, and the place in its half of it.
  const std::size_t from = elementOf(narrower(rep), lane), halfBefore = 2 * perHalf;
  const std::size_t piece = from / (2 * halfBefore), half = from / halfBefore % 2, at = from % halfBefore;
  return (2 * piece + at / perHalf) * 2 * perHalf + half * perHalf + at % perHalf;
}

/// A row of the state.
struct Row {
  std::size_t at = 0;
  Rep rep = Rep::Truth;
};

/// Bytes of an area that computed addresses reach: a row for each of them, one behind the other.
struct ReachedRows {
  std::uint32_t first = 0, count = 0;
  std::size_t at = 0;
};

/// Bits of a value of recorded code.
constexpr int widthOf(const Step& s) {
  if (isTruth(s.op)) return 1;
  return s.op == CodeOp::Join ? s.width + static_cast<int>(s.value) : s.width;
}

/// The same of a constant: as many as it takes.
constexpr int bitsNeeded(const Step& s) {
  return s.op == CodeOp::Constant ? std::max(1, static_cast<int>(std::bit_width(s.value))) : widthOf(s);
}

/// Whether a step makes local memory 0, as it is when a block begins: that says nothing of how the bytes are used.
constexpr bool isClearing(const Step& s, const Code& code) {
  const Step& given = code.steps[s.a];
  return s.op == CodeOp::StoreMemory && s.area == Area::L && given.op == CodeOp::Constant && given.value == 0;
}

class LaneLayout {
 public:
  /// `isWide`: the processor has registers of 512 bits.
  LaneLayout(const Code& code, const std::vector<bool>& isNeeded, const Concrete::Store& model, bool isWide);

  /// What all traces have in common in a scan, in front of the rows.
  struct Head {
    std::array<std::uint32_t, 3> ticks{};  ///< by LoadTicks
    std::uint64_t mostTime = 0;            ///< 10 ns
  };

  Form form = Form::Bytes;
  std::size_t lanes = 32;
  std::size_t truthBytes = rowBytes, pieceBytes = rowBytes;  ///< of a truth value of all, of a register of numbers
  std::size_t stateEnd = 0;  ///< up to here rows hold state; behind them is room for a scan
  std::size_t size = 0;

  std::size_t slot(std::uint64_t number) const { return slots_ + truthBytes * number; }
  std::size_t error(std::uint64_t site) const { return errors_ + truthBytes * site; }
  std::size_t pending(std::uint64_t mark) const { return pending_ + truthBytes * mark; }
  std::size_t kept(std::size_t number) const { return kept_ + pieceBytes * number; }
  std::size_t keptTruth(std::size_t number) const { return keptTruths_ + truthBytes * number; }
  std::size_t active() const { return active_; }  ///< traces that run
  std::size_t left() const { return active_ + truthBytes; }
  std::size_t scratch(std::size_t operand) const { return scratch_ + pieceBytes * mostPieces * operand; }
  Row state(std::uint64_t number) const { return states_[number]; }
  /// Registers of the machine; nothing: the code does not touch it.
  std::optional<Row> reg(std::size_t index) const { return registers_[index]; }
  /// The row of just those bytes, or nothing.
  std::optional<Row> cell(Area area, std::uint32_t byte, int bytes) const;
  /// All rows that begin at one of so many bytes.
  std::vector<Row> rowsWithin(Area area, std::uint32_t first, std::uint32_t count) const;
  /// Rows of single bytes.
  const ReachedRows& reached(Area area) const { return reached_[static_cast<std::size_t>(area)]; }
  /// Room for so many rows and truth values that the emitter wants to keep from block to block.
  void keepRows(std::size_t count, std::size_t truths);

  struct Cell {
    Area area;
    std::uint32_t byte;
    int bytes;
    std::size_t at;
  };
  const std::vector<Cell>& cells() const { return cells_; }
  std::size_t registerCount() const { return registers_.size(); }

 private:
  void placeMemory(const Code& code, const std::vector<bool>& isNeeded);
  /// Room for so many values.
  std::size_t rows(std::size_t count, Rep rep) {
    if (rep != Rep::Truth) size = (size + pieceBytes - 1) / pieceBytes * pieceBytes;
    const std::size_t at = size;
    size += count * (rep == Rep::Truth ? truthBytes : pieceBytes * pieceCount(rep));
    return at;
  }

  std::size_t slots_ = 0, errors_ = 0, pending_ = 0, kept_ = 0, keptTruths_ = 0, active_ = 0, scratch_ = 0;
  std::vector<Row> states_;
  std::vector<std::optional<Row>> registers_;
  std::vector<Cell> cells_;
  std::unordered_map<std::uint64_t, std::size_t> cellAt_;  ///< by area and byte: index in cells_
  std::array<ReachedRows, areaCount> reached_{};
};

/// The number of one trace in a row.
std::uint64_t numberIn(const std::uint8_t* rows, Row row, std::size_t lane, Form form);
void setNumberIn(std::uint8_t* rows, Row row, std::size_t lane, Form form, std::uint64_t value);

}  // namespace rungproof::lanes
