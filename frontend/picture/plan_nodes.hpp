// What is to be laid out: the elements of a network as nodes with the size and the texts of their symbols, for ladder
// or for FBD. The layout (placement.hpp) knows nothing of instructions; it sees nodes, their inputs and their sizes.
// Tested by tests/show/layout_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frontend/picture/element_text.hpp"
#include "frontend/picture/picture.hpp"
#include "ir/drawing.hpp"

namespace rungproof {

enum class NodeKind : std::uint8_t {
  Rail,     ///< where power comes from; never drawn as a node
  Contact,  ///< in line: one input, one output on the same row
  Join,     ///< branches that meet; takes no column
  Leaf,     ///< a name at the left end of a wire (FBD)
  Box,
  Coil,    ///< stands in the last column
  Heading  ///< a bracket on the left rail
};

struct NodeInput {
  int from = 0;  ///< index of an earlier node
  bool negated = false;
  std::string pin{};  ///< Box: name inside the frame, may be empty
};

/// A pin without power flow: its name inside the frame and the operand outside of it.
struct DataPin {
  std::string name;
  std::string operand;
  bool isConstant = false;
};

struct PlanNode {
  NodeKind kind = NodeKind::Rail;
  int element = -1;                  ///< in the drawing; -1 for nodes that the form of drawing adds
  std::vector<NodeInput> inputs{};   ///< topmost first
  std::string sign{};                ///< Contact, Coil, Heading
  std::vector<std::string> above{};  ///< lines above the symbol, topmost first; the first may be a symbol's name
  bool namedAbove = false;           ///< above[0] is a symbol's name
  std::vector<std::string> below{};
  std::string mark{};  ///< findings, below the symbol; empty: none
  int severity = -1;
  std::string name{};       ///< Box
  std::string note{};       ///< Box: small text in its lower right corner, "100 ms"
  std::string outputPin{};  ///< Box: name of the power output; empty and hasOutput: unnamed
  bool hasOutput = true;
  bool isLast = false;  ///< Box: stands in the last column, as coils do
  std::vector<DataPin> left{};
  std::vector<DataPin> right{};
  Flow3 output = Flow3::Unknown;  ///< power on the output wire
  Flow3 state = Flow3::Unknown;   ///< contact closed, coil energised
};

struct PlanNodes {
  std::vector<PlanNode> nodes;
  bool hasRails = true;
  std::string reason;  ///< why this form cannot show the network; empty: it can
};

/// The network as ladder: And gates become series, negated wires NOT contacts. Gives a reason where that would change
/// the meaning.
PlanNodes ladderNodes(const Drawing& drawing, const ElementTexts& texts);

/// The network as FBD: contacts become names on the pins of gates, compare contacts and edges boxes, coils boxes.
PlanNodes fbdNodes(const Drawing& drawing, const ElementTexts& texts);

}  // namespace rungproof
