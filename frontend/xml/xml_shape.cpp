// Walks over the elements that have a shape.
#include "frontend/xml/xml_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "frontend/stl/syntax_sink.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof {

namespace {

/// Calls `visit` with each of the words between separators until it answers true.
template <class Visit>
bool anyWord(std::string_view words, char separator, Visit visit) {
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(separator));
    if (!word.empty() && visit(word)) return true;
    words.remove_prefix(std::min(words.size(), word.size() + 1));
  }
  return false;
}

bool isTruth(std::string_view value) { return value == "true" || value == "false" || value == "1" || value == "0"; }

bool isNumber(std::string_view value, bool isWhole) {
  if (isWhole) {
    int number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    return error == std::errc() && end == value.data() + value.size();
  }
  double number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  return error == std::errc() && end == value.data() + value.size();
}

bool isAllowed(std::string_view values, std::string_view value) {
  if (values == "b") return isTruth(value);
  if (values == "n" || values == "d") return isNumber(value, values == "n");
  return anyWord(values, '|', [&](std::string_view word) { return word == value; });
}

void checkElement(const pugi::xml_node& node, const XmlShape& shape, std::vector<ShapeFault>& faults) {
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string_view name = attribute.name(), value = attribute.value();
    if (name.starts_with("xmlns") || name.find(':') != std::string_view::npos) continue;
    bool isKnown = false;
    const bool fits = anyWord(shape.attributes, ' ', [&](std::string_view word) {
      const std::size_t colon = word.find(':');
      if (word.substr(0, colon) != name) return false;
      isKnown = true;
      return colon == std::string_view::npos || isAllowed(word.substr(colon + 1), value);
    });
    if (fits) continue;
    faults.push_back({node, isKnown ? fmt::format("{}=\"{}\" is not known at <{}>", name, excerpt(value), shape.name)
                                    : fmt::format("attribute {} is not known at <{}>", excerpt(name), shape.name)});
  }
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() != pugi::node_element) continue;
    const std::string_view name = localName(child);
    if (!anyWord(shape.children, ' ', [&](std::string_view word) { return word == name; }))
      faults.push_back({child, fmt::format("element <{}> is not known in <{}>", excerpt(name), shape.name)});
  }
}

}  // namespace

std::vector<ShapeFault> faultsOf(const pugi::xml_node& node, std::span<const XmlShape> shapes) {
  std::vector<ShapeFault> faults;
  const auto shapeOf = [&](const pugi::xml_node& at) {
    return std::find_if(shapes.begin(), shapes.end(), [&](const XmlShape& s) { return s.name == localName(at); });
  };
  bool isKnown = false;
  for (pugi::xml_node at = node; at; at = nextWithin(node, at, isKnown)) {
    const auto shape = at.type() == pugi::node_element ? shapeOf(at) : shapes.end();
    isKnown = shape != shapes.end();
    if (isKnown) checkElement(at, *shape, faults);
  }
  return faults;
}

}  // namespace rungproof
