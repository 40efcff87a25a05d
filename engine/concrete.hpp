// Concrete: the domain of plain numbers, the reference. Its Store holds the whole machine state as bytes and
// numbers; values that the program does not determine come from an Outside, errors go to it.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ir/machine/machine.hpp"

namespace rungproof {

/// What lies outside the program: the stimulus, devices, and the receiver of run-time errors.
class Outside {
 public:
  virtual ~Outside() = default;
  /// Value of an external site, `width` bits.
  virtual std::uint64_t external(const ExternalSite& site, int width) = 0;
  virtual void report(Hazard hazard, const Instruction* place) = 0;
  /// Interrupt queues, timed interrupts and the watchdog live outside the program.
  virtual void signal(Signal, std::uint32_t /*index*/) {}
};

class Concrete {
 public:
  using Bool = bool;
  using Bits = std::uint64_t;

  /// Concrete pointers have one target, so the list of several is never filled.
  struct Targets {
    constexpr bool empty() const { return true; }
    const PointerTarget<Concrete>* begin() const { return nullptr; }
    const PointerTarget<Concrete>* end() const { return nullptr; }
  };

  /// All state: bytes of the areas, numbers of the registers.
  class Store {
   public:
    Store() = default;
    explicit Store(const Plan& plan);

    Bits load(Area area, std::uint32_t bitOffset, int width) const {
      const std::vector<std::uint8_t>& bytes = areas_[static_cast<std::size_t>(area)];
      if (area == Area::DB) bitOffset = blocks_->bitPlace(bitOffset);
      const std::uint32_t byte = bitOffset / 8;
      if (width == 1) return byte < bytes.size() ? bytes[byte] >> (bitOffset % 8) & 1U : 0U;
      Bits value = 0;
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(width) / 8; ++i)
        value = value << 8 | (byte + i < bytes.size() ? bytes[byte + i] : 0U);
      return value;
    }
    void save(Area area, std::uint32_t bitOffset, int width, Bits value, Bool guard) {
      if (!guard) return;
      std::vector<std::uint8_t>& bytes = areas_[static_cast<std::size_t>(area)];
      if (area == Area::DB) bitOffset = blocks_->bitPlace(bitOffset);
      const std::uint32_t byte = bitOffset / 8;
      if (width == 1) {
        if (byte >= bytes.size()) return;
        const auto mask = static_cast<std::uint8_t>(1U << (bitOffset % 8));
        bytes[byte] = static_cast<std::uint8_t>((value & 1) != 0 ? bytes[byte] | mask : bytes[byte] & ~mask);
        return;
      }
      const std::uint32_t count = static_cast<std::uint32_t>(width) / 8;
      for (std::uint32_t i = 0; i < count; ++i) {
        if (byte + i < bytes.size()) bytes[byte + i] = static_cast<std::uint8_t>(value >> (8 * (count - 1 - i)));
      }
    }
    Bits get(Reg reg, std::uint32_t index) const {
      if (isTerminal(reg)) return terminals(reg)[index / 8] >> (index % 8) & 1U;
      return registers_[first_[static_cast<std::size_t>(reg)] + index];
    }
    void set(Reg reg, std::uint32_t index, Bits value, Bool guard) {
      if (!guard) return;
      if (isTerminal(reg)) {
        std::uint8_t& byte = terminals(reg)[index / 8];
        const auto mask = static_cast<std::uint8_t>(1U << (index % 8));
        byte = static_cast<std::uint8_t>((value & 1) != 0 ? byte | mask : byte & ~mask);
        return;
      }
      registers_[first_[static_cast<std::size_t>(reg)] + index] = static_cast<std::uint32_t>(value);
    }
    /// The terminals of inputs or outputs, eight to a byte as in their images.
    using Terminals = std::array<std::uint8_t, regInfo(Reg::PhysicalInput).count / 8>;
    static constexpr bool isTerminal(Reg reg) { return reg == Reg::PhysicalInput || reg == Reg::PhysicalOutput; }
    Terminals& terminals(Reg reg) { return reg == Reg::PhysicalInput ? inputs_ : outputs_; }
    const Terminals& terminals(Reg reg) const { return reg == Reg::PhysicalInput ? inputs_ : outputs_; }
    std::vector<std::uint8_t>& area(Area area) { return areas_[static_cast<std::size_t>(area)]; }
    const std::vector<std::uint8_t>& area(Area area) const { return areas_[static_cast<std::size_t>(area)]; }
    std::uint32_t count(Reg reg) const {
      return first_[static_cast<std::size_t>(reg) + 1] - first_[static_cast<std::size_t>(reg)];
    }

    /// All registers but the terminals in one row, and where in it one stands.
    std::span<std::uint32_t> registers() { return registers_; }
    std::span<const std::uint32_t> registers() const { return registers_; }
    std::size_t indexOf(Reg reg, std::uint32_t index) const { return first_[static_cast<std::size_t>(reg)] + index; }

    const BlockMap& blocks() const { return *blocks_; }

    friend bool operator==(const Store& a, const Store& b) {
      return a.areas_ == b.areas_ && a.registers_ == b.registers_ && a.inputs_ == b.inputs_ && a.outputs_ == b.outputs_;
    }

   private:
    std::array<std::vector<std::uint8_t>, areaCount> areas_;
    std::array<std::uint32_t, static_cast<std::size_t>(Reg::count) + 1> first_{};
    std::vector<std::uint32_t> registers_;
    Terminals inputs_{}, outputs_{};
    std::shared_ptr<const BlockMap> blocks_;  ///< S7-300/400 only
  };

  explicit Concrete(Outside& outside) : outside_(&outside) {}

  bool constant(bool v) const { return v; }
  bool lnot(bool a) const { return !a; }
  bool land(bool a, bool b) const { return a && b; }
  bool lor(bool a, bool b) const { return a || b; }
  bool lxor(bool a, bool b) const { return a != b; }
  bool select(bool c, bool a, bool b) const { return c ? a : b; }
  std::optional<bool> truth(bool a) const { return a; }

  static constexpr Bits mask(int w) { return w >= 64 ? ~0ULL : (1ULL << w) - 1; }
  static constexpr std::int64_t toSigned(Bits a, int w) { return static_cast<std::int64_t>(a << (64 - w)) >> (64 - w); }

  Bits literal(std::uint64_t v, int w) const { return v & mask(w); }
  std::optional<std::uint64_t> known(Bits a) const { return a; }
  Bits add(Bits a, Bits b, int w) const { return (a + b) & mask(w); }
  Bits sub(Bits a, Bits b, int w) const { return (a - b) & mask(w); }
  Bits mul(Bits a, Bits b, int w) const { return (a * b) & mask(w); }
  Bits udiv(Bits a, Bits b, int w) const { return b == 0 ? mask(w) : a / b; }
  Bits urem(Bits a, Bits b, int) const { return b == 0 ? a : a % b; }
  Bits sdiv(Bits a, Bits b, int w) const {
    const std::int64_t x = toSigned(a, w), y = toSigned(b, w);
    if (y == 0) return x < 0 ? 1 : mask(w);
    return static_cast<Bits>(y == -1 ? -static_cast<Bits>(x) : static_cast<Bits>(x / y)) & mask(w);
  }
  Bits srem(Bits a, Bits b, int w) const {
    const std::int64_t x = toSigned(a, w), y = toSigned(b, w);
    if (y == 0) return a;
    return static_cast<Bits>(y == -1 ? 0 : x % y) & mask(w);
  }
  Bits band(Bits a, Bits b, int) const { return a & b; }
  Bits bor(Bits a, Bits b, int) const { return a | b; }
  Bits bxor(Bits a, Bits b, int) const { return a ^ b; }
  Bits bnot(Bits a, int w) const { return ~a & mask(w); }
  Bits shl(Bits a, Bits n, int w) const { return n >= static_cast<Bits>(w) ? 0 : (a << n) & mask(w); }
  Bits lshr(Bits a, Bits n, int w) const { return n >= static_cast<Bits>(w) ? 0 : a >> n; }
  bool equal(Bits a, Bits b, int) const { return a == b; }
  bool ult(Bits a, Bits b, int) const { return a < b; }
  bool ule(Bits a, Bits b, int) const { return a <= b; }
  bool slt(Bits a, Bits b, int w) const { return toSigned(a, w) < toSigned(b, w); }
  bool sle(Bits a, Bits b, int w) const { return toSigned(a, w) <= toSigned(b, w); }
  Bits select(bool c, Bits a, Bits b, int) const { return c ? a : b; }
  Bits zext(Bits a, int, int) const { return a; }
  Bits sext(Bits a, int from, int to) const { return static_cast<Bits>(toSigned(a, from)) & mask(to); }
  Bits extract(Bits a, int high, int low) const { return a >> low & mask(high - low + 1); }
  Bits concat(Bits high, int, Bits low, int lowWidth) const { return high << lowWidth | low; }
  bool bit(Bits a, int i) const { return (a >> i & 1) != 0; }
  Bits fromBool(bool a, int) const { return a ? 1 : 0; }

  static float real(Bits a) { return std::bit_cast<float>(static_cast<std::uint32_t>(a)); }
  /// Every NaN has the one pattern 16#7FC00000, so that results do not depend on the host.
  static Bits pattern(float a) { return std::isnan(a) ? 0x7FC00000U : std::bit_cast<std::uint32_t>(a); }
  Bits radd(Bits a, Bits b) const { return pattern(real(a) + real(b)); }
  Bits rsub(Bits a, Bits b) const { return pattern(real(a) - real(b)); }
  Bits rmul(Bits a, Bits b) const { return pattern(real(a) * real(b)); }
  Bits rdiv(Bits a, Bits b) const { return pattern(real(a) / real(b)); }
  Bits rfunction(std::uint64_t f, Bits a) const;
  bool requal(Bits a, Bits b) const { return real(a) == real(b); }
  bool rless(Bits a, Bits b) const { return real(a) < real(b); }
  bool rlegal(Bits a) const { return std::isfinite(real(a)); }
  Bits rfromInt(Bits a) const { return pattern(static_cast<float>(static_cast<std::int32_t>(a))); }
  /// REAL to a signed 64-bit number; values beyond its range saturate. round: halves away from zero.
  Bits rtoInt(Bits a, bool round) const;

  /// Every NaN has the one pattern 16#7FF8000000000000.
  static Bits longPattern(double a) { return std::isnan(a) ? 0x7FF8000000000000U : std::bit_cast<std::uint64_t>(a); }
  static double longReal(Bits a) { return std::bit_cast<double>(a); }
  Bits longReal(std::uint64_t which, Bits a, Bits b, int width) const;
  Bits longReal(std::uint64_t which, Bits a, int width) const { return longReal(which, a, 0, width); }

  Bits external(const ExternalSite& site, int width) { return outside_->external(site, width) & mask(width); }
  void report(Hazard hazard, bool, const Instruction* place) { outside_->report(hazard, place); }
  void signal(Signal which, std::uint32_t index, bool guard) {
    if (guard) outside_->signal(which, index);
  }
  bool targets(Machine<Concrete>&, Bits, Width, Ref<Concrete>&) { return false; }
  Bits unresolved(Machine<Concrete>&, int) { return 0; }
  void havoc(Machine<Concrete>&) {}

 private:
  Outside* outside_;
};

static_assert(Domain<Concrete>);

}  // namespace rungproof
