// From the operand as written to the operand of the IR: names are looked up in the block, in the data blocks, in the
// symbol tables. Tested by tests/step7/bind_test.cpp.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "frontend/step7/type_table.hpp"
#include "ir/operand.hpp"

namespace rungproof::step7 {

/// What an operand of a block can refer to.
struct BlockScope {
  BlockKey key;
  std::string name;
  std::shared_ptr<const s7300::Structure> parameters;  ///< of an FB its instance
  std::shared_ptr<const s7300::Structure> temporary;
  std::shared_ptr<const s7300::Structure> constants = std::make_shared<s7300::Structure>();
  std::map<std::string, std::int64_t> labels{};  ///< with their ordinals
  std::uint32_t localBytes = 0;                  ///< highest byte of L that was named, and one
};

/// Of every OB (002:2015).
inline constexpr std::uint32_t startInformationBytes = 20;
/// The first byte of L behind the declared data, and behind the start information.
std::uint32_t freeLocalByte(const BlockScope& scope);

struct BoundOperand {
  rungproof::Operand operand;
  std::optional<s7300::Type> type{};    ///< of a declared name
  std::optional<BlockKey> block{};      ///< the operand names a block
  std::optional<Constant> constant{};   ///< the operand is a constant
  std::string fault{};                  ///< why it cannot be bound
  std::uint32_t dataBlock = 0;          ///< of a fault: the data block in which the place would be; 0: not known
  Syntax code = Syntax::NameUndefined;  ///< of the fault
  Span faultSpan{};
  std::string_view help{};  ///< what to do about it, where the rule does not know
};

class OperandBinder {
 public:
  OperandBinder(const BlockCatalogue& catalogue, TypeTable& types) : catalogue_(catalogue), types_(types) {}

  BoundOperand bind(const Operand& operand, BlockScope& scope);

 private:
  BoundOperand address(const Operand& operand, BlockScope& scope);
  BoundOperand local(const Operand& operand, BlockScope& scope, const std::vector<PathStep>& path);
  BoundOperand constantField(const Operand& operand, const s7300::Field& field);
  BoundOperand symbol(const Operand& operand, BlockScope& scope);
  BoundOperand namedAddress(const Operand& operand, BlockScope& scope);
  BoundOperand dataField(const Operand& operand, BlockKey block);
  BoundOperand indirect(const Operand& operand, BlockScope& scope);
  BoundOperand parameterAddress(const Operand& operand, BlockScope& scope);
  std::uint32_t dataBlockOf(const Operand& operand) const;
  BoundOperand blockNamed(BlockKey key, const Operand& operand);

  const BlockCatalogue& catalogue_;
  TypeTable& types_;
};

/// The IR's number of an S7-300/400 block.
int irNumber(BlockKey key);
/// POINTER, ANY.
bool isPointerKind(s7300::TypeKind kind);
/// Whether the field stands for a place that a call hands over by reference: TIMER, COUNTER, BLOCK_xx.
bool isNumberType(s7300::TypeKind kind);

}  // namespace rungproof::step7
