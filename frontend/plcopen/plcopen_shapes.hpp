// What lists of variables of PLCopen TC6 consist of, for both readers: of drawings and of structured text.
#pragma once

#include <array>
#include <string_view>

#include "frontend/xml/xml_shape.hpp"

namespace rungproof {

/// What else stands there may change what the variables mean. What stands in <type>, <documentation> and <addData> is
/// read elsewhere or says nothing. `initialValues`: the elements that may stand in <initialValue>.
constexpr std::array<XmlShape, 10> variableListShapes(std::string_view initialValues) {
  constexpr std::string_view attributes = "name globalId constant:b retain:b nonretain:b persistent:b nonpersistent:b";
  constexpr std::string_view children = "variable documentation addData";
  return {{{"localVars", attributes, children},
           {"tempVars", attributes, children},
           {"inputVars", attributes, children},
           {"outputVars", attributes, children},
           {"inOutVars", attributes, children},
           {"externalVars", attributes, children},
           {"globalVars", attributes, children},
           {"variable", "name globalId address group orderWithinParamSet", "type initialValue documentation addData"},
           {"initialValue", "", initialValues},
           {"simpleValue", "value", ""}}};
}

}  // namespace rungproof
