// One network of SimaticML (FlgNet) of an S7-300/400 as parts with pins, before it becomes statements: what flows into
// a pin, and where an output goes. Part of frontend/flgnet. Tested by tests/step7/drawing_test.cpp.
#pragma once

#include <optional>
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

struct Part {
  std::string name;  ///< "Contact", "Add"; of a call empty
  std::string type;  ///< "Int"; of a conversion "Int>DInt"
  std::size_t cardinality = 0;
  Operand instance;  ///< timer, counter, instance of a function block
  std::optional<step7::BlockName> callee;
  bool hasEno = true;                ///< the editor has not switched it off
  std::vector<std::string> negated;  ///< pins, in small letters
  std::vector<Pin> inputs;
  std::vector<Output> outputs;
  Span span;

  const Pin* input(std::string_view pin) const;
  const Output* output(std::string_view pin) const;
  bool isNegated(std::string_view pin) const;
};

struct Circuit {
  std::vector<step7::Name> labels;
  std::vector<Part> parts;
  Span span;
};

}  // namespace rungproof::flgnet
