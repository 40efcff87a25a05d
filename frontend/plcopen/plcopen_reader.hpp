// PLCopen TC6 XML 2.0 and 2.01 as OpenPLC Editor, Beremiz and CODESYS write it: types, variables, configurations and
// the bodies LD, FBD and IL. CODESYS keeps programs and global variables in <addData>; they are read there as well.
// Tested by tests/graphical/plcopen_test.cpp and tests/graphical/damage_test.cpp.
#pragma once

#include "frontend/files/file_reader.hpp"
#include "frontend/graphical/drawn_model.hpp"
#include "frontend/xml/xml_shape.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof {

/// Reads one file into `project`; what cannot be read becomes a finding of the program.
void readPlcopen(Program& program, const InputText& input, DrawnProject& project);

/// One <LD> or <FBD> element.
DrawnNetwork readPlcopenBody(const XmlText& xml, const XmlText::Part& part, const pugi::xml_node& body,
                             std::string_view text);

/// What stands in such an element that its reader does not know: the body is not read then.
std::vector<ShapeFault> plcopenFaults(const pugi::xml_node& body);

/// The lines of a text inside the file as comments, each without the blanks around it; lines that speak to the tool
/// (//@) go to `directives`.
void readComment(Span span, std::string_view text, std::vector<Comment>& lines, std::vector<Directive>& directives);

/// Instruction list of IEC 61131-3 as elements: every stored result is a circuit. Lines that are not known are
/// reported and damage the network.
DrawnNetwork readInstructionList(Program& program, Span span, std::string_view text, const std::string& pou);

}  // namespace rungproof
