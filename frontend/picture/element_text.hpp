// What stands beside the symbol of an element: names and addresses of its operands, values of a scan, marks of
// findings. The words come from the descriptors of the instructions. Tested by tests/show/layout_test.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frontend/picture/picture.hpp"
#include "ir/drawing.hpp"
#include "ir/finding.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Power flow and values of one execution of a network, parallel to Drawing::elements (analysis of a run:
/// power_flow.hpp).
struct ElementFlow {
  Flow3 output = Flow3::Unknown;    ///< power at the output
  Flow3 state = Flow3::Unknown;     ///< contact closed, coil energised
  std::vector<std::string> values;  ///< by operand: "1", "-20", or empty
};

/// An operand as the picture names it.
struct OperandText {
  std::string symbol{};   ///< empty: none
  std::string address{};  ///< with "=value" behind it when a scan is shown
  bool isConstant = false;

  /// Both on one line: "Start:I0.0".
  std::string whole() const { return symbol.empty() ? address : symbol + ":" + address; }
};

/// Longest text of a label, in columns; longer ones end in "...".
inline constexpr int longestLabel = 36;

class ElementTexts {
 public:
  /// `pou`: the block of the network, for the names of local variables; may be nullptr, as may `program`.
  ElementTexts(const Program* program, const Pou* pou, const Drawing& drawing)
      : program_(program), pou_(pou), drawing_(drawing) {}

  /// Findings to be marked; each goes to the element whose place it lies in. Findings elsewhere are left out.
  void setFindings(const std::vector<const Finding*>& findings);
  void setFlow(const std::vector<ElementFlow>* flow) { flow_ = flow; }

  OperandText operand(int element, std::size_t index) const;
  /// "=12": value `index` of the element in the scan that is shown; empty: there is none.
  std::string value(int element, std::size_t index) const;
  Flow3 output(int element) const {
    return flow_ == nullptr || element < 0 ? Flow3::Unknown : (*flow_)[static_cast<std::size_t>(element)].output;
  }
  Flow3 state(int element) const {
    return flow_ == nullptr || element < 0 ? Flow3::Unknown : (*flow_)[static_cast<std::size_t>(element)].state;
  }
  bool showsScan() const { return flow_ != nullptr; }
  /// "^OUT001 LOG003", and the worst severity; empty: none.
  const std::string& mark(int element) const {
    return marks_.empty() || element < 0 ? noMark_ : marks_[static_cast<std::size_t>(element)].text;
  }
  int severity(int element) const {
    return marks_.empty() || element < 0 ? -1 : marks_[static_cast<std::size_t>(element)].severity;
  }
  const Program* program() const { return program_; }

 private:
  struct ElementMark {
    std::string text;
    int severity = -1;
  };
  const Program* program_;
  const Pou* pou_;
  const Drawing& drawing_;
  const std::vector<ElementFlow>* flow_ = nullptr;
  std::vector<ElementMark> marks_;
  std::string noMark_;
};

/// Text cut to `width` columns, with "..." at its end where something is missing.
std::string shortened(const std::string& text, int width = longestLabel);

}  // namespace rungproof
