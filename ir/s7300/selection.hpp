// FC 22 LIMIT, FC 25 MAX, FC 27 MIN and FC 36 SEL: values that are given by ANY and are of one type. What is not stated
// is any value: other types, a lower limit above the upper one, and of REAL numbers those that are
// none, infinite or too small, and -0.
// Tested by tests/step7/selection_test.cpp.
#pragma once

#include "ir/s7300/system_args.hpp"

namespace rungproof {

template <class D>
class Selection {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  explicit Selection(SystemArgs<D>& args) : a_(args), d_(args.d), stated_(args.yes()), fails_(args.no()) {}

  void limit() {
    if (!begin({0, 1, 2, 3}, isNumber)) return;
    const Bits low = read(0), in = read(1), high = read(2);
    stated_ = d_.land(stated_, d_.lnot(less(high, low)));
    end(3, d_.select(less(in, low), low, d_.select(less(high, in), high, in, width_), width_));
  }
  /// MAX; `least`: MIN.
  void extreme(bool least) {
    if (!begin({0, 1, 2, 3}, isNumber)) return;
    Bits best = read(0);
    for (const std::uint32_t i : {1U, 2U}) {
      const Bits next = read(i);
      best = d_.select(least ? less(next, best) : less(best, next), next, best, width_);
    }
    end(3, best);
  }
  void select() {
    if (!begin({1, 2, 3}, isElementary)) return;
    const Bits zero = read(1), one = read(2);
    end(3, d_.select(a_.isSet(0), one, zero, width_));
  }

 private:
  static bool isNumber(AnyType type) { return type == AnyType::Int || type == AnyType::DInt || type == AnyType::Real; }
  static bool isElementary(AnyType type) {
    return type == AnyType::Bool || (elementBytes(type) > 0 && elementBytes(type) <= 4);
  }

  /// Finds where the parameters lie, and their type; where that fails the block ends with any result.
  bool begin(std::initializer_list<std::uint32_t> parameters, bool (*isLegal)(AnyType)) {
    bool isKnown = true;
    for (const std::uint32_t p : parameters) {
      auto found = a_.targets(p);
      isKnown = isKnown && found && !found->empty();
      targets_[p] = found ? std::move(*found) : std::vector<AnyTarget<D>>();
    }
    const std::uint32_t result = *(parameters.end() - 1);
    if (isKnown) {
      type_ = targets_[*parameters.begin()][0].type;
      isKnown = isLegal(type_);
    }
    if (!isKnown) {
      if (targets_[result].empty()) a_.d.havoc(a_.m);
      for (const AnyTarget<D>& t : targets_[result]) a_.m.when(t.condition, [&] { a_.spoil(t); });
      a_.finish(a_.anyBit());
      return false;
    }
    isReal_ = type_ == AnyType::Real;
    widthOfElement_ = type_ == AnyType::Bool     ? Width::Bit
                      : elementBytes(type_) == 1 ? Width::Byte
                      : elementBytes(type_) == 2 ? Width::Word
                                                 : Width::DWord;
    width_ = bits(widthOfElement_);
    return true;
  }

  Bits read(std::uint32_t parameter) {
    Bits value = a_.number(0, width_);
    for (const AnyTarget<D>& t : targets_[parameter]) {
      if (!isOfType(t) || t.fails) {
        note(t);
        continue;
      }
      value = d_.select(t.condition, a_.load(t.row, 0, widthOfElement_), value, width_);
    }
    if (!isReal_) return value;
    const Bool isSmall = d_.equal(d_.extract(value, 30, 23), a_.number(0, 8), 8);
    const Bool isZero = d_.equal(value, a_.number(0), 32);
    stated_ = d_.land(stated_, d_.land(d_.rlegal(value), d_.lor(d_.lnot(isSmall), isZero)));
    return value;
  }

  void end(std::uint32_t result, Bits value) {
    for (const AnyTarget<D>& t : targets_[result]) {
      if (!isOfType(t) || t.fails || !t.row.isWritable) note(t);
    }
    const Bool isGood = d_.land(stated_, d_.lnot(fails_));
    const Bits written = a_.orAny(isGood, value, width_);
    for (const AnyTarget<D>& t : targets_[result]) {
      a_.m.when(t.condition, [&] {
        if (isOfType(t) && !t.fails && t.row.isWritable)
          a_.save(t.row, 0, widthOfElement_, written);
        else
          a_.spoil(t);
      });
    }
    a_.finish(a_.orAny(stated_, d_.lnot(fails_)));
  }

  bool isOfType(const AnyTarget<D>& t) const { return t.type == type_ && t.count == 1 && !t.isOpen; }
  void note(const AnyTarget<D>& t) {
    if (isOfType(t))
      fails_ = d_.lor(fails_, t.condition);
    else
      stated_ = d_.land(stated_, d_.lnot(t.condition));
  }
  Bool less(Bits x, Bits y) { return isReal_ ? d_.rless(x, y) : d_.slt(x, y, width_); }

  SystemArgs<D>& a_;
  D& d_;
  std::array<std::vector<AnyTarget<D>>, 4> targets_;
  AnyType type_ = AnyType::Void;
  Width widthOfElement_ = Width::Bit;
  int width_ = 1;
  bool isReal_ = false;
  Bool stated_, fails_;
};

}  // namespace rungproof
