// Reads a <FlgNet> as a circuit. Elements and attributes that are not known may change what it means: they are
// reported, as are parts that stand in no table, and nothing is made of the network. Part of frontend/flgnet.
#pragma once

#include <optional>

#include "frontend/flgnet/circuit.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof::flgnet {

/// Nothing if something was reported.
std::optional<Circuit> readCircuit(const XmlText& xml, const XmlText::Part& part, const pugi::xml_node& net,
                                   SyntaxSink& sink);

}  // namespace rungproof::flgnet
