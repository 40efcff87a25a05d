// Copies the code and replaces what asks for the low bits of such a sum, or whether it fits.
#include "engine/lanes/narrowing.hpp"

#include <optional>
#include <unordered_map>

namespace rungproof::lanes {

using compiled::Code;
using compiled::CodeOp;
using compiled::Step;
using compiled::ValueId;

namespace {

constexpr std::uint64_t bitsBelow(int width) { return width >= 64 ? ~0ULL : (1ULL << width) - 1; }

class Narrowing {
 public:
  explicit Narrowing(const Code& code) : old_(code), new_(code), at_(code.steps.size()) { new_.steps.clear(); }

  Code take() {
    for (ValueId id = 0; id < old_.steps.size(); ++id) {
      const Step& s = old_.steps[id];
      const std::optional<ValueId> simpler = replaced(s);
      at_[id] = simpler ? *simpler : add(copied(s));
      if (s.op == CodeOp::Add || s.op == CodeOp::Sub) findSum(id);
    }
    return std::move(new_);
  }

 private:
  /// A sum or difference of two numbers of `width` bits with sign, made wider.
  struct Sum {
    ValueId a, b, result;
    std::uint8_t width;
    bool isDifference;
  };

  ValueId add(const Step& step) {
    new_.steps.push_back(step);
    return static_cast<ValueId>(new_.steps.size() - 1);
  }
  Step copied(Step s) const {
    const int operands = compiled::operandCount(s.op);
    if (operands > 0) s.a = at_[s.a];
    if (operands > 1) s.b = at_[s.b];
    if (operands > 2) s.c = at_[s.c];
    return s;
  }

  /// The width of which a value continues the sign; nothing: it is no such value.
  std::optional<std::uint8_t> signedWidth(const Step& s) const {
    return s.op == CodeOp::Signed ? std::optional(static_cast<std::uint8_t>(s.value)) : std::nullopt;
  }
  std::optional<ValueId> ownWidth(ValueId id, std::uint8_t width, std::uint8_t wide) {
    const Step& s = old_.steps[id];
    if (signedWidth(s) == width && s.width == wide) return at_[s.a];
    if (s.op != CodeOp::Constant) return std::nullopt;
    const std::uint64_t low = s.value & bitsBelow(width);
    const bool isNegative = (low >> (width - 1) & 1) != 0;
    if (s.value != (isNegative ? (low | ~bitsBelow(width)) & bitsBelow(wide) : low)) return std::nullopt;
    return add({.op = CodeOp::Constant, .width = width, .value = low});
  }
  void findSum(ValueId id) {
    const Step& s = old_.steps[id];
    const auto first = signedWidth(old_.steps[s.a]), second = signedWidth(old_.steps[s.b]);
    const std::uint8_t width = first.value_or(second.value_or(0));
    if (width < 2 || width >= s.width) return;
    const auto a = ownWidth(s.a, width, s.width), b = ownWidth(s.b, width, s.width);
    if (!a || !b) return;
    sums_[id] = {*a, *b, add({.op = s.op, .width = width, .a = *a, .b = *b}), width, s.op == CodeOp::Sub};
  }

  std::optional<ValueId> replaced(const Step& s) {
    if (s.op == CodeOp::Equal) {
      const auto fitting = fits(s.a, s.b);
      return fitting ? fitting : fits(s.b, s.a);
    }
    if (s.op != CodeOp::Extract && s.op != CodeOp::TestBit) return std::nullopt;
    const auto sum = sums_.find(s.a);
    const std::uint64_t count = s.op == CodeOp::TestBit ? 1 : s.width;
    if (sum == sums_.end() || s.value + count > sum->second.width) return std::nullopt;
    if (s.op == CodeOp::Extract && s.width == sum->second.width) return sum->second.result;
    Step own = s;
    own.a = sum->second.result;
    return add(own);
  }

  /// Whether `wide` is a sum and `low` its low bits with their sign. A sum overflows where its sign is none of those of
  /// its parts, a difference where both parts differ in sign and it has not that of the first.
  std::optional<ValueId> fits(ValueId low, ValueId wide) {
    const auto found = sums_.find(wide);
    const Step& continued = old_.steps[low];
    if (found == sums_.end() || continued.op != CodeOp::Signed) return std::nullopt;
    const Sum& sum = found->second;
    const Step& extracted = old_.steps[continued.a];
    const bool isSame = continued.value == sum.width && continued.width == old_.steps[wide].width &&
                        extracted.op == CodeOp::Extract && extracted.a == wide && extracted.value == 0 &&
                        extracted.width == sum.width;
    if (!isSame) return std::nullopt;
    const auto differ = [&](ValueId x, ValueId y) {
      return add({.op = CodeOp::BitXor, .width = sum.width, .a = x, .b = y});
    };
    const ValueId one = differ(sum.a, sum.isDifference ? sum.b : sum.result);
    const ValueId other = differ(sum.isDifference ? sum.a : sum.b, sum.result);
    const ValueId both = add({.op = CodeOp::BitAnd, .width = sum.width, .a = one, .b = other});
    const auto sign = static_cast<std::uint64_t>(sum.width - 1);
    const ValueId overflows = add({.op = CodeOp::TestBit, .width = 1, .a = both, .value = sign});
    return add({.op = CodeOp::Not, .a = overflows});
  }

  const Code& old_;
  Code new_;
  std::vector<ValueId> at_;  ///< by step: the new one
  std::unordered_map<ValueId, Sum> sums_;
};

}  // namespace

Code narrowedSums(const Code& code) { return Narrowing(code).take(); }

}  // namespace rungproof::lanes
