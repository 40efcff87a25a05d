// One network of SimaticML (FlgNet) of an S7-300/400 as parts with pins, before it becomes statements: what flows into
// a pin, and where an output goes. Part of frontend/flgnet. Tested by tests/step7/drawing_test.cpp.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "frontend/step7/syntax.hpp"

namespace rungproof::flgnet {

using step7::Operand;

/// What stands at an input pin.
struct Pin {
  enum class Source : std::uint8_t {
    Open,
    Rail,   ///< power, or the constant TRUE
    Value,  ///< an operand
    Flow    ///< an output pin of another part
  };
  std::string name;  ///< in small letters
  Source source = Source::Open;
  bool isNegated = false;
  Operand value;
  std::size_t part = 0;  ///< Flow
  std::string from;      ///< Flow: name of its output pin
  Span span;
};

struct Output {
  std::string name;  ///< in small letters
  std::size_t readers = 0;
  std::vector<Operand> targets;  ///< operands that it is written to
};

/// Pins in the order of the file. The first with a name is found by it, of many as fast as of few.
template <class One>
class Pins {
 public:
  One& add(One one) {
    places_.emplace(one.name, list_.size());
    return list_.emplace_back(std::move(one));
  }
  const One* find(std::string_view name) const {
    const auto found = places_.find(name);
    return found == places_.end() ? nullptr : &list_[found->second];
  }
  /// The one with that name, made if there is none.
  One& named(const std::string& name) {
    const auto found = places_.find(name);
    if (found != places_.end()) return list_[found->second];
    One made;
    made.name = name;
    return add(std::move(made));
  }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  std::size_t size() const { return list_.size(); }
  const One& operator[](std::size_t i) const { return list_[i]; }

 private:
  std::vector<One> list_;
  std::map<std::string, std::size_t, std::less<>> places_;
};

struct Part {
  std::string name;  ///< "Contact", "Add"; of a call empty
  std::string type;  ///< "Int"; of a conversion "Int>DInt"
  std::size_t cardinality = 0;
  Operand instance;  ///< timer, counter, instance of a function block
  std::optional<step7::BlockName> callee;
  bool hasEno = true;                          ///< the editor has not switched it off
  std::set<std::string, std::less<>> negated;  ///< pins, in small letters
  Pins<Pin> inputs;
  Pins<Output> outputs;
  Span span;

  const Pin* input(std::string_view pin) const { return inputs.find(pin); }
  const Output* output(std::string_view pin) const { return outputs.find(pin); }
  bool isNegated(std::string_view pin) const { return negated.contains(pin); }
};

struct Circuit {
  std::vector<step7::Name> labels;
  std::vector<Part> parts;
  Span span;
};

}  // namespace rungproof::flgnet
