// SimaticML, the XML of TIA Openness: blocks OB, FB, FC with ladder and FBD networks (FlgNet), data blocks, tag
// tables. Several files make a project: every block is exported into a file of its own.
//
// What a part is called there becomes its name in IEC 61131-3; a pin keeps its name or gets that of the standard.
// Names of global data are written DB.Member as in the program editor without quotation marks.
// Tested by tests/graphical/simatic_test.cpp and tests/graphical/damage_test.cpp.
#pragma once

#include "frontend/files/file_reader.hpp"
#include "frontend/graphical/drawn_model.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof {

void readSimatic(Program& program, const InputText& input, DrawnProject& project);

/// One <FlgNet>; parts that are not known are reported and damage the network. Instances of function blocks that
/// stand in data blocks of their own are appended to `instances`.
DrawnNetwork readFlgNet(const XmlText& xml, const XmlText::Part& part, const pugi::xml_node& net, SyntaxSink& sink,
                        std::vector<DrawnVariable>& instances);

}  // namespace rungproof
