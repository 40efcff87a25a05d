// Networks of SimaticML that are statement lists: <StatementList> with one <StlStatement> for each line becomes the
// statements of a source. What the tokens mean is general knowledge of TIA Openness. A token, an operand or an element
// that is not known spoils its statement and has a finding. Part of frontend/flgnet.
// Tested by tests/step7/statement_list_xml_test.cpp.
#pragma once

#include <functional>

#include "frontend/step7/syntax.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof::flgnet {

/// Appends the statements to the network. `isUnread` of the network is set where an element is not known. Comments go
/// to `comment`, which looks for what they say to the tool.
void readStatementList(const XmlText& xml, const XmlText::Part& part, const pugi::xml_node& list, SyntaxSink& sink,
                       step7::NetworkSyntax& network, const std::function<void(const pugi::xml_node&)>& comment);

}  // namespace rungproof::flgnet
