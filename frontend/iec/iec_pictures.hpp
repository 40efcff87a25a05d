// LD and FBD bodies of IEC 61131-3 as they were drawn: each circuit becomes a drawing whose contacts and pins name
// variables, with the places at which the lowering finds their values. Tested by tests/iec/picture_test.cpp.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "frontend/graphical/drawn_circuit.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

/// The picture of results that are computed one behind the other; `isInstance(element)`: a function block.
std::shared_ptr<const CircuitPicture> pictureOf(const DrawnCircuit& circuit, const std::vector<int>& results, Form form,
                                                const std::function<bool(const DrawnElement&)>& isInstance);

}  // namespace rungproof::iec
