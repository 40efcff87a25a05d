// Mutated: the domain of plain numbers with one change of one operation (mutant.hpp). Every operation is told where it
// stands in the text of the meaning; without an active mutant it gives what Concrete gives.
#pragma once

#include "engine/concrete.hpp"
#include "tests/mutation/mutant.hpp"

namespace rungproof::mutation {

class Mutated {
 public:
  using Bool = bool;
  using Bits = std::uint64_t;

  struct Targets {
    bool empty() const { return true; }
    const PointerTarget<Mutated>* begin() const { return nullptr; }
    const PointerTarget<Mutated>* end() const { return nullptr; }
  };

  class Store {
   public:
    explicit Store(Concrete::Store& inner) : inner_(&inner) {}
    Bits load(Area area, std::uint32_t bitOffset, int width, Where at = Where::current()) const;
    void save(Area area, std::uint32_t bitOffset, int width, Bits value, Bool guard, Where at = Where::current());
    Bits get(Reg reg, std::uint32_t index, Where at = Where::current()) const;
    void set(Reg reg, std::uint32_t index, Bits value, Bool guard, Where at = Where::current());

   private:
    Concrete::Store* inner_;
  };

  explicit Mutated(Outside& outside) : outside_(&outside), plain_(outside) {}

  Bool constant(bool v, Where at = Where::current()) const;
  Bool lnot(Bool a, Where at = Where::current()) const;
  Bool land(Bool a, Bool b, Where at = Where::current()) const;
  Bool lor(Bool a, Bool b, Where at = Where::current()) const;
  Bool lxor(Bool a, Bool b, Where at = Where::current()) const;
  Bool select(Bool c, Bool a, Bool b, Where at = Where::current()) const;
  std::optional<bool> truth(Bool a) const { return a; }

  Bits literal(std::uint64_t v, int w, Where at = Where::current()) const;
  std::optional<std::uint64_t> known(Bits a) const { return a; }
  Bits add(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits sub(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits mul(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits udiv(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits urem(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits sdiv(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits srem(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits band(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits bor(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits bxor(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits bnot(Bits a, int w, Where at = Where::current()) const;
  Bits shl(Bits a, Bits n, int w, Where at = Where::current()) const;
  Bits lshr(Bits a, Bits n, int w, Where at = Where::current()) const;
  Bool equal(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bool ult(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bool ule(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bool slt(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bool sle(Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits select(Bool c, Bits a, Bits b, int w, Where at = Where::current()) const;
  Bits zext(Bits a, int from, int to, Where at = Where::current()) const;
  Bits sext(Bits a, int from, int to, Where at = Where::current()) const;
  Bits extract(Bits a, int high, int low, Where at = Where::current()) const;
  Bits concat(Bits high, int highWidth, Bits low, int lowWidth, Where at = Where::current()) const;
  Bool bit(Bits a, int i, Where at = Where::current()) const;
  Bits fromBool(Bool a, int w, Where at = Where::current()) const;

  Bits radd(Bits a, Bits b, Where at = Where::current()) const;
  Bits rsub(Bits a, Bits b, Where at = Where::current()) const;
  Bits rmul(Bits a, Bits b, Where at = Where::current()) const;
  Bits rdiv(Bits a, Bits b, Where at = Where::current()) const;
  Bits rfunction(std::uint64_t f, Bits a, Where at = Where::current()) const;
  Bool requal(Bits a, Bits b, Where at = Where::current()) const;
  Bool rless(Bits a, Bits b, Where at = Where::current()) const;
  Bool rlegal(Bits a, Where at = Where::current()) const;
  Bits rfromInt(Bits a, Where at = Where::current()) const;
  Bits rtoInt(Bits a, bool round, Where at = Where::current()) const;
  /// Of no family that is mutated here.
  Bits longReal(std::uint64_t f, Bits a, Bits b, int w) const { return plain_.longReal(f, a, b, w); }
  Bits longReal(std::uint64_t f, Bits a, int w) const { return plain_.longReal(f, a, w); }

  Bits external(const ExternalSite& site, int width, Where at = Where::current());
  void report(Hazard hazard, Bool happens, const Instruction* place, Where at = Where::current());
  void signal(Signal which, std::uint32_t index, Bool guard, Where at = Where::current());
  bool targets(Machine<Mutated>&, Bits, Width, Ref<Mutated>&) { return false; }
  Bits unresolved(Machine<Mutated>&, int) { return 0; }
  void havoc(Machine<Mutated>&) {}

  /// Asked for by the bench and the plant.
  void begins() { Mutation::instance().beginInstruction(); }
  void advances(const Desc* timer) { Mutation::instance().advances(timer); }

 private:
  Outside* outside_;
  Concrete plain_;
};

static_assert(Domain<Mutated>);

}  // namespace rungproof::mutation
