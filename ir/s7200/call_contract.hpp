// What a call of a block without text may do. Three kinds of blocks have none: those of a library or wizard
// (ir/s7200/library_block.hpp), those that a password protects, and those that no file of the project holds. The first
// write their outputs and the buffers that their parameters name; the second the outputs of their table; the third
// whatever place the call gives them. Everything else - other memory, devices, interrupts - is taken to stay alone,
// which is an assumption (Choice::MissingBlocks) that reports name. Engine and encoder make such a call in
// callByContract(); UnreadCode says what stays open. Tested by tests/smart/contract_test.cpp.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ir/machine/library_effect.hpp"
#include "ir/s7200/args.hpp"
#include "ir/s7200/library_block.hpp"

namespace rungproof {

/// A row of bits of memory.
struct MemoryRow {
  Area area = Area::V;
  std::uint32_t first = 0;  ///< bit, counted from the start of the area
  std::uint32_t count = 0;
};

struct CallContract {
  enum class Source : std::uint8_t {
    Library,  ///< the manual
    Table,    ///< the declarations of the protected block
    Operands  ///< nothing but the call
  };
  struct Output {
    std::uint32_t place;  ///< in the operand list of CALL
    DataType type;
  };

  std::string name;  ///< "MBUS_MSG", "SBR21"
  Source source = Source::Operands;
  std::size_t given = 0;  ///< parameters of the call
  std::vector<Output> outputs;
  std::vector<MemoryRow> memory;   ///< that it may write in the call, and V also between two scans
  std::vector<MemoryRow> touched;  ///< the part of it that instructions of the program touch
  bool fillsAnyV = false;          ///< writes V memory whose place stands in no text
  bool mayDoAnything = false;      ///< nothing says what it is for: no output, no place to write to
  bool isUndefined = false;        ///< a name that no table, file or manual knows
  bool keepsAccumulators = false;  ///< Modbus saves them (001:10704); others destroy them (001:6769, 001:10038)
  std::uint32_t ownBytes = 0;      ///< V memory of the library that no setting places
};

/// The contracts of all calls of blocks without text.
class CallContracts {
 public:
  explicit CallContracts(const Program& program);

  bool empty() const { return contracts_.empty(); }
  /// nullptr: the block has a text, or the instruction is no call.
  const CallContract* of(const Instruction& call) const {
    const auto found = contracts_.find(call.id);
    return found == contracts_.end() ? nullptr : &found->second;
  }
  const std::map<std::uint32_t, CallContract>& all() const { return contracts_; }  ///< by Instruction::id

 private:
  std::map<std::uint32_t, CallContract> contracts_;
};

/// The call with power flow: outputs, touched memory, accumulators, status bits and ENO (001:6769) get values from
/// outside (External::LibraryOutput; index: the place of a parameter, or a LibraryEffect).
template <class D>
void callByContract(Machine<D>& m, const Instruction& instruction, const CallContract& contract) {
  const auto bitOf = [&](Area area, std::uint32_t at, unsigned bit) {
    return m.externalBit(External::LibraryOutput, LibraryEffect{area, at, bit}.index());
  };
  for (const CallContract::Output& output : contract.outputs) {
    const auto value = m.external(External::LibraryOutput, output.place, bits(widthOf(output.type)));
    Args<D> args(m, instruction, *instruction.desc);
    args.storeParameter(output.place, output.type, value);
  }
  for (const MemoryRow& row : contract.touched) {
    for (std::uint32_t bit = row.first; bit < row.first + row.count;) {
      const bool isByte = bit % 8 == 0 && bit + 8 <= row.first + row.count;
      if (isByte)
        m.save(row.area, bit / 8, Width::Byte,
               m.external(External::LibraryOutput, LibraryEffect{row.area, bit / 8}.index(), 8));
      else
        m.saveBit(row.area, bit / 8, bit % 8, bitOf(row.area, bit / 8, bit % 8));
      bit += isByte ? 8 : 1;
    }
  }
  for (std::uint32_t n = 0; n < 4 && !contract.keepsAccumulators; ++n)
    m.set(Reg::Accumulator, n, m.external(External::LibraryOutput, LibraryEffect{Area::AC, n}.index(), 32));
  for (unsigned bit = 0; bit < 8; ++bit) m.setSm(1, bit, bitOf(Area::SM, 1, bit));
  m.setBit(Reg::Eno, 0, bitOf(Area::AC, LibraryEffect::eno, 0));
}

}  // namespace rungproof
