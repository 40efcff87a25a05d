// Recorder: the domain of values that are steps of machine code to come (ir/domain.hpp). Running the meanings of a
// program's instructions over it records what they do, simplified: constants, values that are known twice, what was
// stored and is read again.
//
// What the compiled form does not do - fatal errors and those that OB121 or OB122 takes, devices, pointers that may
// lead into any area - is a Leave: the scan in which it happens is run by the reference engine from its start.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "engine/compiled/code.hpp"
#include "engine/concrete.hpp"

namespace rungproof {
template <class D>
struct Spot;
}

namespace rungproof::compiled {

/// Which values that the walk keeps are other ones at the end of a loop than at its beginning. A recording takes those
/// for unchanged that it does not find here; where it was wrong about one, the program is recorded anew.
struct LoopFacts {
  std::map<std::vector<std::uint32_t>, std::set<std::size_t>> changed;  ///< by calls on the way and place of the loop
  bool isComplete = true;
};

class Recorder {
 public:
  struct Bool {
    ValueId id = 0;
  };
  struct Bits {
    ValueId id = 0;
  };
  using Targets = std::vector<PointerTarget<Recorder>>;  ///< empty: pointers are followed as computed addresses
  class Store;

  Recorder();

  Code code;
  const Bool* guard = nullptr;  ///< of the machine that runs over this domain
  Store* store = nullptr;       ///< its memory
  bool hasParts = false;        ///< instructions that only some runs execute are branched around
  bool isAlwaysOn = false;      ///< the program leaves SM0.0 alone
  bool isAround = false;        ///< what is recorded is no instruction of the program: it may move any register
  struct OpenCall {
    Bool condition;
    std::uint32_t firstLocal;  ///< byte of local memory
  };
  std::vector<OpenCall> calls{};  ///< that are done for runs that do not take them too
  LoopFacts* loops = nullptr;     ///< what earlier recordings of this program have found

  // ---- Domain interface; laws in ir/domain.hpp -----------------------------------------------------
  Bool constant(bool v) const { return {v ? 1U : 0U}; }
  Bool lnot(Bool a);
  Bool land(Bool a, Bool b);
  Bool lor(Bool a, Bool b);
  Bool lxor(Bool a, Bool b);
  Bool select(Bool c, Bool a, Bool b);
  std::optional<bool> truth(Bool a) const;
  Bits literal(std::uint64_t v, int w);
  std::optional<std::uint64_t> known(Bits a) const;
  Bits add(Bits a, Bits b, int w);
  Bits sub(Bits a, Bits b, int w);
  Bits mul(Bits a, Bits b, int w);
  Bits udiv(Bits a, Bits b, int w);
  Bits urem(Bits a, Bits b, int w);
  Bits sdiv(Bits a, Bits b, int w);
  Bits srem(Bits a, Bits b, int w);
  Bits band(Bits a, Bits b, int w);
  Bits bor(Bits a, Bits b, int w);
  Bits bxor(Bits a, Bits b, int w);
  Bits bnot(Bits a, int w);
  Bits shl(Bits a, Bits n, int w);
  Bits lshr(Bits a, Bits n, int w);
  Bool equal(Bits a, Bits b, int w);
  Bool ult(Bits a, Bits b, int w);
  Bool ule(Bits a, Bits b, int w) { return lnot(ult(b, a, w)); }
  Bool slt(Bits a, Bits b, int w);
  Bool sle(Bits a, Bits b, int w) { return lnot(slt(b, a, w)); }
  Bits select(Bool c, Bits a, Bits b, int w);
  Bits zext(Bits a, int, int) { return a; }
  Bits sext(Bits a, int from, int to);
  Bits extract(Bits a, int high, int low);
  Bits concat(Bits high, int highWidth, Bits low, int lowWidth);
  Bool bit(Bits a, int i);
  Bits fromBool(Bool a, int w);
  /// For one use only: it is cheaper to make than to keep.
  Bits freshFromBool(Bool a, int w);
  Bits radd(Bits a, Bits b);
  Bits rsub(Bits a, Bits b);
  Bits rmul(Bits a, Bits b);
  Bits rdiv(Bits a, Bits b);
  Bits rfunction(std::uint64_t f, Bits a);
  Bool requal(Bits a, Bits b);
  Bool rless(Bits a, Bits b);
  Bool rlegal(Bits a);
  Bits rfromInt(Bits a);
  Bits rtoInt(Bits a, bool round);
  /// Runs that compute with LREAL are left to the reference engine.
  Bits longReal(std::uint64_t, Bits, Bits, int width) { return cannotFollow(width); }
  Bits longReal(std::uint64_t, Bits, int width) { return cannotFollow(width); }

  // ---- What the machine asks for beyond values ------------------------------------------------------
  Bits external(const ExternalSite& site, int width);
  void report(Hazard hazard, Bool condition, const Instruction* place);
  void signal(Signal, std::uint32_t, Bool condition) { leave(condition); }
  /// Whether a run that meets this error leaves the compiled code there.
  bool leavesAt(Hazard hazard) const { return hazardInfo(hazard).kind == HazardClass::Fatal; }
  Bool targets(Machine<Recorder>& machine, Bits pointer, Width width, Ref<Recorder>& ref);
  std::optional<std::vector<std::uint64_t>> locations(Machine<Recorder>&, Bits) { return std::nullopt; }
  std::optional<std::vector<std::uint64_t>> locationsInBlock(Machine<Recorder>&, Bits, Width) { return std::nullopt; }
  Bits unresolved(Machine<Recorder>&, int width) { return cannotFollow(width); }
  void havoc(Machine<Recorder>&) { cannotFollow(1); }
  /// Element of what targets() found.
  Bits loadAt(const Ref<Recorder>& ref, int element, Width width);
  void saveAt(const Ref<Recorder>& ref, int element, Width width, Bits value);
  /// S7-300/400: whether a place is found by its address; where no access may reach it, the code is left.
  bool follows(Machine<Recorder>& machine, Bits location, Width width, Spot<Recorder>& spot);
  Bits loadComputed(const Spot<Recorder>& spot, Width width);
  void saveComputed(const Spot<Recorder>& spot, Width width, Bits value);
  /// The compiled form has no answer; the value is never used.
  Bits cannotFollow(int width);

  /// Where `condition` holds the scan is one for the reference engine; from here on it is false.
  void leave(Bool condition);
  /// What is recorded next runs only where `condition` is `value`.
  void assume(Bool condition, bool value);

  /// Which runs must find that byte of local memory written that those of `guard` write: what a call that a run does
  /// not take leaves in the memory of its block, nobody reads.
  Bool guardOfLocal(Bool guard, std::uint32_t byte);
  /// A number as runs of the guard see it.
  Bits ofGuard(Bits number) const;

  // ---- Steps -----------------------------------------------------------------------------------------
  ValueId add(const Step& step);
  /// The value of that step, perhaps one that is there already.
  ValueId make(const Step& step);
  const Step& at(ValueId id) const { return code.steps[id]; }
  /// Values are not looked up from here on: a block begins that several ways lead to.
  void forgetValues() {
    forgetKnown();
    replaced_.clear();
  }
  /// Branches to `mark` where a condition that is not yet known holds (BranchIf) or not; what follows is recorded for
  /// the others.
  void branch(CodeOp op, Bool condition, std::uint64_t mark);
  /// A part begins that only runs with `condition` take; gives what ends it.
  struct Part {
    std::size_t first;
    std::unordered_map<ValueId, ValueId> replaced;
    std::uint64_t mark;
  };
  Part beginPart(Bool condition);
  void endPart(Part part);
  /// The steps from `first` on, and the error sites from `site` on, have not been recorded.
  void takeBack(std::size_t first, std::size_t site);

 private:
  /// Bytes that addresses lead to: the first one in its area, and how many.
  struct Row {
    Bits first, count;
  };
  /// `a` and `b` of `width` bits, of which a wider sum is made.
  struct NarrowSum {
    Bits a, b;
    int width;
  };
  std::optional<NarrowSum> narrowSum(Bits wide);
  std::optional<Bool> fits(Bits continued, Bits exact);
  bool isZeroAt(ValueId id, int i) const;
  Bits behindPatches(Bits a, int i) const;
  std::optional<Row> rowOf(Machine<Recorder>& machine, Area area, Bits block);
  void reaches(Area area, std::uint32_t first, std::uint32_t count, bool isWritten);
  struct StepHash {
    std::size_t operator()(const Step& s) const;
  };
  struct StepEqual {
    bool operator()(const Step& x, const Step& y) const;
  };
  ValueId resolved(ValueId id) const {
    const auto found = replaced_.find(id);
    return found == replaced_.end() ? id : found->second;
  }
  Bits word(CodeOp op, int w, Bits a, Bits b, std::uint64_t value = 0);
  Bool compare(CodeOp op, int w, Bits a, Bits b);
  bool isOpposite(ValueId a, ValueId b) const {
    return (at(a).op == CodeOp::Not && at(a).a == b) || (at(b).op == CodeOp::Not && at(b).a == a);
  }
  void forgetKnown() {
    known_.clear();
    selects_.clear();
  }
  static std::uint64_t pairOf(ValueId a, ValueId b) { return std::uint64_t{a} << 32 | b; }
  /// Of a conjunction each part with the other one; else nothing.
  std::vector<std::pair<ValueId, ValueId>> partsOf(ValueId condition) const;
  /// Two conditions that are one and the same apart from a part that one has and the other has not.
  struct Forked {
    Bool common, own;  ///< `own`: of the first
  };
  std::optional<Forked> forked(ValueId first, ValueId second) const;
  std::optional<Bool> absorbed(CodeOp op, ValueId a, ValueId b);
  std::optional<Bool> orderOf(ValueId a, ValueId b);
  Bool under(Bool value, ValueId condition, bool isTrue, int depth);
  /// What is asked of a number, except where `unless` holds: then the answer is no.
  struct NumberTest {
    Step test;
    ValueId unless;
  };
  std::optional<NumberTest> numberTest(ValueId id) const;
  Bool chosen(Bool c, Bool a, Bool b);
  std::optional<bool> impliedBy(ValueId condition, ValueId asked) const;
  std::optional<Bool> oneTest(ValueId condition, ValueId on, ValueId off);

  Bits safe(Bits address);
  std::optional<Bits> onlyLowDiffers(Bits whole, Bits patched);
  Bits loadPlace(Area area, Bits address, int width);
  void savePlace(Area area, Bits address, int width, Bits value);

  std::optional<Step> place_;       ///< last access to a computed address `a` of `area` where `b` stands
  bool hasReadOnlyBlocks_ = false;  ///< of which an address may name one
  std::unordered_map<Step, ValueId, StepHash, StepEqual> known_;
  std::unordered_map<std::uint64_t, ValueId> selects_;  ///< Select by its condition and what it is without
  std::unordered_map<std::uint64_t, ValueId> constants_;
  std::unordered_map<ValueId, ValueId> replaced_;  ///< conditions that are known where the code is
};

/// Which bytes the program touches bit by bit, and which as parts of words.
struct AccessCount {
  std::uint32_t bits = 0;
  std::uint32_t words = 0;
  bool isSingle = true;  ///< no bit but the lowest
};

/// The memory as recorded code sees it: the last value of each place is known until somebody else may have written it.
class Recorder::Store {
 public:
  /// `model`: a state of the program, for the sizes and for registers that never change.
  Store(Recorder& recorder, const Concrete::Store& model, const std::vector<SlotByte>& slots);

  Bits load(Area area, std::uint32_t bitOffset, int width);
  void save(Area area, std::uint32_t bitOffset, int width, Bits value, Bool guard);
  Bits get(Reg reg, std::uint32_t index);
  void set(Reg reg, std::uint32_t index, Bits value, Bool guard);

  /// The bytes of a data block as they stand in Area::DB.
  const BlockMap& blocks() const { return model_.blocks(); }
  /// Bytes of local memory become 0.
  void clear(Area area, std::uint32_t byte, std::uint32_t count);
  /// All or one area may have been written by others.
  void forget();
  /// Only some runs have done the steps from `first` on. Bits that they do not touch and that stand in memory stay
  /// known.
  void forgetSince(std::size_t first);
  void forget(Area area);

  std::uint32_t size(Area area) const { return sizes_[static_cast<std::size_t>(area)]; }
  const std::vector<std::vector<AccessCount>>& accesses() const { return accesses_; }

 private:
  /// A byte of memory that is known to be eight bits of a value.
  struct Part {
    std::uint32_t epoch = 0;
    ValueId value = 0;
    std::uint8_t low = 0;
  };
  struct Known {
    std::uint32_t epoch = 0;
    ValueId value = 0;
  };
  Part& part(Area area, std::uint32_t byte) { return parts_[static_cast<std::size_t>(area)][byte]; }
  std::uint32_t epoch(Area area) const { return epochs_[static_cast<std::size_t>(area)]; }
  std::optional<std::uint32_t> slotOf(Area area, std::uint32_t byte) const;
  Bits loadByte(Area area, std::uint32_t byte);
  void saveByte(Area area, std::uint32_t byte, Bits value);
  Bits loadWhole(Area area, std::uint32_t byte, int count);
  void saveWhole(Area area, std::uint32_t byte, int count, Bits value);
  void saveBit(Area area, std::uint32_t byte, std::uint32_t bit, Bool value);
  Bool loadSlot(std::uint32_t slot);
  void forgetSlots(std::uint32_t first);
  void saveSlot(std::uint32_t slot, Bool value);
  bool isFixed(Area area, std::uint32_t bitOffset) const { return d_.isAlwaysOn && area == Area::SM && bitOffset == 0; }
  void noteBit(Area area, std::uint32_t bitOffset);
  void noteByte(Area area, std::uint32_t byte);
  bool isHere(Reg reg) const;
  Bits loadPlace(Area area, std::uint32_t bitOffset, int width);

  Recorder& d_;
  const Concrete::Store& model_;
  std::array<std::uint32_t, areaCount> sizes_;
  std::array<std::vector<std::uint32_t>, areaCount> slotOf_;  ///< by byte: number of its first slot + 1, 0: none
  std::array<std::vector<Part>, areaCount> parts_;
  std::array<std::uint32_t, areaCount> epochs_{};
  std::vector<Known> bits_;  ///< by slot
  std::uint32_t bitEpoch_ = 1;
  std::vector<Known> registers_;  ///< by index among all registers
  std::uint32_t epoch_ = 1;
  ValueId loadedSince_ = 0;  ///< of bits that are known by earlier steps, only those are that stand in memory
  std::vector<std::vector<AccessCount>> accesses_;
};

static_assert(Domain<Recorder>);

}  // namespace rungproof::compiled
