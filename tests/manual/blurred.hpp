// Blurred: plain numbers that never admit to being known, with a type of their own for truth values and the width kept
// in every vector. Meanings run on it take the ways they take for a solver: both sides of every condition, all rounds
// of every loop, several targets of a pointer. The bench compares the result with Concrete; a width that does not fit
// aborts.
#pragma once

#include <vector>

#include "engine/concrete.hpp"

namespace rungproof::manual {

class Blurred {
 public:
  struct Bool {
    bool v = false;
  };
  struct Bits {
    std::uint64_t v = 0;
    int w = 0;
  };
  using Targets = std::vector<PointerTarget<Blurred>>;

  class Store {
   public:
    explicit Store(Concrete::Store& inner) : inner_(&inner) {}
    Bits load(Area area, std::uint32_t bitOffset, int width) const {
      return {inner_->load(area, bitOffset, width), width};
    }
    void save(Area area, std::uint32_t bitOffset, int width, Bits value, Bool guard) {
      CHECK(value.w == width, "width of a saved value");
      inner_->save(area, bitOffset, width, value.v, guard.v);
    }
    Bits get(Reg reg, std::uint32_t index) const { return {inner_->get(reg, index), regInfo(reg).width}; }
    void set(Reg reg, std::uint32_t index, Bits value, Bool guard) {
      CHECK(value.w == regInfo(reg).width, "width of a register's value");
      inner_->set(reg, index, value.v, guard.v);
    }

   private:
    Concrete::Store* inner_;
  };

  explicit Blurred(Outside& outside) : outside_(&outside), plain_(outside) {}

  Bool constant(bool v) const { return {v}; }
  Bool lnot(Bool a) const { return {!a.v}; }
  Bool land(Bool a, Bool b) const { return {a.v && b.v}; }
  Bool lor(Bool a, Bool b) const { return {a.v || b.v}; }
  Bool lxor(Bool a, Bool b) const { return {a.v != b.v}; }
  Bool select(Bool c, Bool a, Bool b) const { return c.v ? a : b; }
  std::optional<bool> truth(Bool) const { return std::nullopt; }
  std::optional<std::uint64_t> known(Bits) const { return std::nullopt; }

  Bits literal(std::uint64_t v, int w) const { return {v & Concrete::mask(w), w}; }
  Bits add(Bits a, Bits b, int w) const { return {plain_.add(in(a, w), in(b, w), w), w}; }
  Bits sub(Bits a, Bits b, int w) const { return {plain_.sub(in(a, w), in(b, w), w), w}; }
  Bits mul(Bits a, Bits b, int w) const { return {plain_.mul(in(a, w), in(b, w), w), w}; }
  Bits udiv(Bits a, Bits b, int w) const { return {plain_.udiv(in(a, w), in(b, w), w), w}; }
  Bits urem(Bits a, Bits b, int w) const { return {plain_.urem(in(a, w), in(b, w), w), w}; }
  Bits sdiv(Bits a, Bits b, int w) const { return {plain_.sdiv(in(a, w), in(b, w), w), w}; }
  Bits srem(Bits a, Bits b, int w) const { return {plain_.srem(in(a, w), in(b, w), w), w}; }
  Bits band(Bits a, Bits b, int w) const { return {in(a, w) & in(b, w), w}; }
  Bits bor(Bits a, Bits b, int w) const { return {in(a, w) | in(b, w), w}; }
  Bits bxor(Bits a, Bits b, int w) const { return {in(a, w) ^ in(b, w), w}; }
  Bits bnot(Bits a, int w) const { return {plain_.bnot(in(a, w), w), w}; }
  Bits shl(Bits a, Bits n, int w) const { return {plain_.shl(in(a, w), in(n, w), w), w}; }
  Bits lshr(Bits a, Bits n, int w) const { return {plain_.lshr(in(a, w), in(n, w), w), w}; }
  Bool equal(Bits a, Bits b, int w) const { return {in(a, w) == in(b, w)}; }
  Bool ult(Bits a, Bits b, int w) const { return {in(a, w) < in(b, w)}; }
  Bool ule(Bits a, Bits b, int w) const { return {in(a, w) <= in(b, w)}; }
  Bool slt(Bits a, Bits b, int w) const { return {plain_.slt(in(a, w), in(b, w), w)}; }
  Bool sle(Bits a, Bits b, int w) const { return {plain_.sle(in(a, w), in(b, w), w)}; }
  Bits select(Bool c, Bits a, Bits b, int w) const {
    in(a, w);
    in(b, w);
    return c.v ? a : b;
  }
  Bits zext(Bits a, int from, int to) const { return {in(a, from), to}; }
  Bits sext(Bits a, int from, int to) const { return {plain_.sext(in(a, from), from, to), to}; }
  Bits extract(Bits a, int high, int low) const {
    CHECK(low >= 0 && low <= high && high < a.w, "bits of an extract");
    return {plain_.extract(a.v, high, low), high - low + 1};
  }
  Bits concat(Bits high, int highWidth, Bits low, int lowWidth) const {
    return {plain_.concat(in(high, highWidth), highWidth, in(low, lowWidth), lowWidth), highWidth + lowWidth};
  }
  Bool bit(Bits a, int i) const {
    CHECK(i >= 0 && i < a.w, "number of a bit");
    return {plain_.bit(a.v, i)};
  }
  Bits fromBool(Bool a, int w) const { return {a.v ? 1U : 0U, w}; }

  Bits radd(Bits a, Bits b) const { return {plain_.radd(in(a, 32), in(b, 32)), 32}; }
  Bits rsub(Bits a, Bits b) const { return {plain_.rsub(in(a, 32), in(b, 32)), 32}; }
  Bits rmul(Bits a, Bits b) const { return {plain_.rmul(in(a, 32), in(b, 32)), 32}; }
  Bits rdiv(Bits a, Bits b) const { return {plain_.rdiv(in(a, 32), in(b, 32)), 32}; }
  Bits rfunction(std::uint64_t f, Bits a) const { return {plain_.rfunction(f, in(a, 32)), 32}; }
  Bool requal(Bits a, Bits b) const { return {plain_.requal(in(a, 32), in(b, 32))}; }
  Bool rless(Bits a, Bits b) const { return {plain_.rless(in(a, 32), in(b, 32))}; }
  Bool rlegal(Bits a) const { return {plain_.rlegal(in(a, 32))}; }
  Bits rfromInt(Bits a) const { return {plain_.rfromInt(in(a, 32)), 32}; }
  Bits rtoInt(Bits a, bool round) const { return {plain_.rtoInt(in(a, 32), round), 64}; }
  Bits longReal(std::uint64_t f, Bits a, Bits b, int w) const {
    return {plain_.longReal(f, in(a, a.w), in(b, b.w), w), w};
  }
  Bits longReal(std::uint64_t f, Bits a, int w) const { return {plain_.longReal(f, in(a, a.w), w), w}; }

  Bits external(const ExternalSite& site, int width) {
    return {outside_->external(site, width) & Concrete::mask(width), width};
  }
  void report(Hazard hazard, Bool happens, const Instruction* place) {
    if (happens.v) outside_->report(hazard, place);
  }
  /// The true target among two that the pointer does not name.
  Bool targets(Machine<Blurred>& machine, Bits pointer, Width width, Ref<Blurred>& ref) {
    const auto address = static_cast<std::uint32_t>(in(pointer, 32));
    const bool legal = pointer::isLegal(machine.target, address, width);
    ref.targets.push_back({{false}, Area::V, 700});
    if (legal) ref.targets.push_back({{true}, *pointer::areaOf(address), pointer::offsetOf(address)});
    ref.targets.push_back({{false}, Area::M, 0});
    return {legal};
  }
  std::optional<std::vector<std::uint64_t>> locations(Machine<Blurred>&, Bits) { return std::nullopt; }
  std::optional<std::vector<std::uint64_t>> locationsInBlock(Machine<Blurred>&, Bits, Width) { return std::nullopt; }
  Bits unresolved(Machine<Blurred>&, int width) { return {0, width}; }
  void havoc(Machine<Blurred>&) {}

 private:
  static std::uint64_t in(Bits a, int w) {
    CHECK(a.w == w && (a.v & ~Concrete::mask(w)) == 0, "width of an operand");
    return a.v;
  }
  Outside* outside_;
  Concrete plain_;
};

static_assert(Domain<Blurred>);

}  // namespace rungproof::manual
