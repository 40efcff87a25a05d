// Which attributes and elements a format has, as far as a drawing is read: whatever else stands there may change what
// the drawing means, so it is an error and the network is not read. Each format states its shapes in one table.
// Tested by tests/graphical.
#pragma once

#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof {

/// An element by its name without prefix. Attributes and children are separated by blanks. An attribute may state its
/// values: "edge:none|rising|falling"; ":b" a truth value, ":n" a whole number, ":d" a number. Attributes with a prefix
/// are those of other name spaces and always allowed. Elements without a shape are not looked into.
struct XmlShape {
  std::string_view name;
  std::string_view attributes;
  std::string_view children;
};

struct ShapeFault {
  pugi::xml_node node;
  std::string message;
};

/// What does not fit in an element and in all elements below it that have a shape, in the order of the text.
std::vector<ShapeFault> faultsOf(const pugi::xml_node& node, std::span<const XmlShape> shapes);

}  // namespace rungproof
