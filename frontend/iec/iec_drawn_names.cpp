// From the texts and lines of elements to names.
#include "frontend/iec/iec_drawn_names.hpp"

#include <algorithm>
#include <map>

#include "frontend/iec/iec_lowering.hpp"

namespace rungproof::iec {

bool isInstance(const DrawnElement& element) {
  if (isStandardFunction(foldedName(element.text))) return false;  // some editors number them as instances
  return element.kind == DrawnKind::Block && !element.instance.empty() &&
         element.instance.find('?') == std::string::npos;
}

void addNames(const std::string& text, std::set<std::string>& names) {
  std::string name;
  bool isPart = false;
  for (const char c : text + " ") {
    const bool isLetter = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '%' || c == '#';
    if (isLetter && !isPart) name += c;
    if (isLetter) continue;
    if (!name.empty()) names.insert(foldedName(name));
    name.clear();
    isPart = c == '.';
  }
}

NamesUsed namesUsed(const DrawnCircuit& circuit, int result) {
  NamesUsed used;
  std::vector<int> open{result};
  std::set<int> seen{result};
  const auto reach = [&](int i) {
    if (i != DrawnCircuit::nothing && seen.insert(i).second) open.push_back(i);
  };
  while (!open.empty()) {
    const int i = open.back();
    open.pop_back();
    const DrawnElement& e = circuit.element(i);
    if (e.kind == DrawnKind::Contact || e.kind == DrawnKind::InVariable || e.kind == DrawnKind::InOutVariable)
      addNames(e.text, used.read);
    const bool writes =
        e.kind == DrawnKind::Coil || e.kind == DrawnKind::OutVariable || e.kind == DrawnKind::InOutVariable;
    if (writes && i == result) addNames(e.text, used.written);
    if (isInstance(e)) {
      addNames(e.instance, used.read);
      addNames(e.instance, used.written);
    }
    for (const DrawnPin& pin : e.inputs) {
      addNames(pin.expression, used.read);
      for (const DrawnLink& link : pin.links) reach(circuit.sourceOf(link));
    }
    for (const DrawnPin& pin : e.outputs) addNames(pin.expression, used.written);
    if (e.kind == DrawnKind::Continuation) reach(circuit.connectorOf(i));
  }
  return used;
}

bool ordersDiffer(const DrawnCircuit& circuit, const std::vector<int>& order, const std::vector<int>& other) {
  std::map<int, std::size_t> place;
  for (std::size_t k = 0; k < other.size(); ++k) place[other[k]] = k;
  struct Users {
    std::vector<std::size_t> writers, all;  ///< by place in `order`
  };
  std::map<std::string, Users> users;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const NamesUsed used = namesUsed(circuit, order[k]);
    for (const std::string& name : used.written) users[name].writers.push_back(k);
    for (const std::string& name : used.written) users[name].all.push_back(k);
    for (const std::string& name : used.read) users[name].all.push_back(k);
  }
  return std::ranges::any_of(users, [&](const auto& row) {
    const Users& of = row.second;
    return std::ranges::any_of(of.writers, [&](std::size_t writer) {
      return std::ranges::any_of(of.all, [&](std::size_t one) {
        return (writer < one) != (place[order[writer]] < place[order[one]]) && writer != one;
      });
    });
  });
}

}  // namespace rungproof::iec
