// SFC 20 BLKMOV and SFC 21 FILL (002:2412-2424; lengths, errors and what is not allowed: general knowledge). BLKMOV
// copies as many bytes as the shorter side has, from the lower end; FILL writes its pattern over the target again and
// again, the last time perhaps in part. An interrupt may come between two bytes. Open, and any value: what overlapping
// sides give, what elements without a size of their own (STRING, VOID) give, and how much is written before an error.
// Tested by tests/step7/block_transfer_test.cpp.
#pragma once

#include "ir/s7300/system_args.hpp"

namespace rungproof {

template <class D>
class BlockTransfer {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  explicit BlockTransfer(SystemArgs<D>& args) : a_(args) {}

  /// Numbers of the parameters: the source, RET_VAL, the target. `repeats`: FILL.
  void run(std::uint32_t source, std::uint32_t result, std::uint32_t target, bool repeats) {
    const auto from = a_.targets(source), to = a_.targets(target);
    if (!from || !to || accesses(*from, *to) > mostAccesses) return unbounded(result, to);
    Bool fails = a_.no(), isOpen = a_.no();
    for (const AnyTarget<D>& t : *to) {
      for (const AnyTarget<D>& f : *from) {
        const Bool condition = a_.d.land(t.condition, f.condition);
        if (const auto known = a_.d.truth(condition); known && !*known) continue;
        const bool isUnstated = f.isOpen || t.isOpen;
        const bool isError = f.fails || t.fails || !t.row.isWritable || isTornBits(f) || isTornBits(t);
        if (isUnstated) isOpen = a_.d.lor(isOpen, condition);
        if (!isUnstated && isError) fails = a_.d.lor(fails, condition);
        a_.m.when(condition, [&] {
          if (isUnstated || isError)
            a_.spoil(t);
          else
            copy(f.row, t.row, repeats);
        });
      }
    }
    const Bits error = a_.d.bor(a_.any(16), a_.number(0x8000, 16), 16);
    const Bool isStated = a_.d.lnot(isOpen);
    a_.set(result, a_.d.select(fails, error, a_.orAny(isStated, a_.number(0, 16), 16), 16));
    a_.finish(a_.orAny(isStated, a_.d.lnot(fails)));
  }

 private:
  static constexpr std::size_t mostAccesses = std::size_t{1} << 17;

  /// Rows of bits are whole bytes.
  static bool isTornBits(const AnyTarget<D>& t) {
    return t.type == AnyType::Bool && (t.count % 8 != 0 || t.row.bit != 0);
  }
  static std::size_t accesses(const std::vector<AnyTarget<D>>& from, const std::vector<AnyTarget<D>>& to) {
    std::size_t sum = 0;
    for (const AnyTarget<D>& t : to) sum += from.size() * t.row.length;
    return sum;
  }

  void unbounded(std::uint32_t result, const std::optional<std::vector<AnyTarget<D>>>& to) {
    if (!to) {
      a_.d.havoc(a_.m);
    } else {
      for (const AnyTarget<D>& t : *to) {
        a_.m.when(t.condition, [&] {
          for (std::uint32_t k = 0; k < t.row.length; ++k) a_.save(t.row, k, Width::Byte, a_.d.unresolved(a_.m, 8));
        });
      }
    }
    a_.set(result, a_.d.unresolved(a_.m, 16));
    a_.finish(a_.anyBit());
  }

  void copy(const ByteRow& from, const ByteRow& to, bool repeats) {
    const std::uint32_t count = repeats ? to.length : std::min(from.length, to.length);
    const std::uint32_t read = std::min(from.length, count);
    const bool meet = from.area == to.area && from.offset < to.offset + count && to.offset < from.offset + read;
    for (std::uint32_t k = 0; k < count; ++k) {
      if (k > 0 && a_.between) a_.between();
      a_.save(to, k, Width::Byte, meet ? a_.anyAt(to, k, 8) : a_.load(from, k % from.length, Width::Byte));
    }
  }

  SystemArgs<D>& a_;
};

}  // namespace rungproof
