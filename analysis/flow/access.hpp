// Access lists: for every instruction the places it reads and writes, derived from its descriptor and its operands.
// Rules on data flow and the cross reference are questions to this table. Effects that the operands do not show are
// part of it where the manual states them: the current value that R clears (001:2791), the step bit that SCRT resets
// (001:5834), the low word that MUL and DIV read (001:4881, 001:4890), elements behind a block's first one.
// Tested by tests/rules/access_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ir/machine/plan.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Access::operand of an effect that no operand shows.
inline constexpr std::uint8_t impliedOperand = 0xFF;

/// Where a place lies that only the running program knows.
enum class Pointed : std::uint8_t {
  Anywhere,  ///< wherever a pointer can lead
  InArea,    ///< S7-300/400: in Access::area: [AR1,P#0.0] with an area, the open data block, static data
  OfCall     ///< S7-300/400: what a call gives for a formal parameter; an access of that call
};

/// A row of elements of one width that an instruction reads or writes; sixteen bytes, as a long program has millions.
struct Access {
  std::uint32_t instruction = 0;  ///< Instruction::id
  std::uint32_t offset = 0;       ///< first byte, or first number for T, C, AC and HC
  std::uint16_t count = 1;        ///< elements that are touched for certain; bits for S, R and SHRB
  std::uint16_t most = 1;         ///< elements that may be touched (N from memory, strings, tables)
  std::uint8_t operand = 0;       ///< index in Instruction::operands, or impliedOperand
  std::uint8_t bit = 0;           ///< first bit
  Area area : 6 = Area::V;        ///< through a pointer: the area that holds the pointer, or see `pointed`
  Pointed pointed : 2 = Pointed::Anywhere;
  Width width : 3 = Width::Bit;  ///< T and C: Bit is the timer or counter bit, Word its current value
  bool write : 1 = false;
  bool conditional : 1 = false;  ///< only with power flow; otherwise in every execution
  bool viaPointer : 1 = false;   ///< the place is what the pointer at area/offset points to
  bool isBox : 1 = false;        ///< the number of a timer or counter box
  bool maybe : 1 = false;        ///< the direction is not known (parameter of a block without text)

  bool byNumber() const { return addressedByNumber(area); }
  /// Bytes (numbers for T, C, AC, HC) from `offset` that `elements` elements cover.
  std::uint32_t length(std::uint32_t elements) const {
    if (elements == 0) return 0;
    if (byNumber()) return elements;
    return width == Width::Bit ? (bit + elements - 1) / 8 + 1 : elements * static_cast<std::uint32_t>(bytes(width));
  }
  std::uint32_t certainLength() const { return length(count); }
  std::uint32_t possibleLength() const { return length(most); }
};

/// All accesses of a program in program order. Where those of an instruction begin is marked for every fourth one.
class AccessTable {
 public:
  AccessTable(const Program& program, const Plan& plan);

  std::span<const Access> all() const { return std::span(accesses_).first(accesses_.size() - 1); }
  /// Accesses of the instruction with that id.
  std::span<const Access> of(std::uint32_t instruction) const {
    const Access* first = accesses_.data() + marks_[instruction / markEvery];
    while (first->instruction < instruction) ++first;
    const Access* last = first;
    while (last->instruction == instruction) ++last;
    return {first, last};
  }

 private:
  static constexpr std::uint32_t markEvery = 4;
  std::vector<Access> accesses_;      ///< one more at the end, of no instruction
  std::vector<std::uint32_t> marks_;  ///< where the accesses of each markEvery-th instruction begin
};

/// Number of a constant count operand (N of S, R, BMB, FILL ...: a byte), or nothing if it comes from memory.
std::optional<int> constantCount(const Operand& operand);
/// The first element as an address: "VW10", "Q0.3", "T37".
std::string accessName(const Access& access);
/// All elements that are touched for certain: "VW10", "VB0 to VB3", "Q0.3 to Q1.2".
std::string accessRange(const Access& access);

}  // namespace rungproof
