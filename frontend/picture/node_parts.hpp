// Parts of nodes that ladder and FBD share.
#pragma once

#include "frontend/picture/box_form.hpp"
#include "frontend/picture/plan_nodes.hpp"

namespace rungproof {

/// How many inputs each element feeds.
std::vector<int> usesOf(const Drawing& drawing);

/// A node with what the texts say of the element: findings, power, state.
PlanNode nodeOf(const ElementTexts& texts, int element);

/// Adds symbol and address of an operand above the node.
void addAbove(PlanNode& node, const OperandText& text);

/// The block that a CALL names, or nullptr.
const Pou* calleeOf(const ElementTexts& texts, const Element& element);

/// A box with its name and data pins, still without inputs. `isOutputUsed`: something is wired to its power output.
PlanNode boxNode(const ElementTexts& texts, const Element& element, int index, bool isOutputUsed);

/// Names of the power inputs of a box.
std::vector<std::string> powerPinsOf(const ElementTexts& texts, const Element& element);

}  // namespace rungproof
