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
  used.looked = seen.size();
  return used;
}

WrittenNames::WrittenNames(const DrawnCircuit& circuit) : circuit_(&circuit) {
  for (int i = 0; i < circuit.count(); ++i) {
    const DrawnElement& e = circuit.element(i);
    if (e.kind != DrawnKind::Contact && e.kind != DrawnKind::InVariable && e.kind != DrawnKind::InOutVariable) continue;
    std::set<std::string> names;
    addNames(e.text, names);
    for (const std::string& name : names) unwritten_.insert({circuit.circuitOf(i), name});
  }
}

void WrittenNames::note(int result) {
  const DrawnElement& e = circuit_->element(result);
  const bool isBlock = e.kind == DrawnKind::Block;
  const bool writes =
      e.kind == DrawnKind::Coil || e.kind == DrawnKind::OutVariable || e.kind == DrawnKind::InOutVariable || isBlock;
  if (!writes) return;
  const int circuit = circuit_->circuitOf(result);
  std::set<std::string> names;
  if (!isBlock) addNames(e.text, names);
  for (const DrawnPin& pin : e.outputs) addNames(pin.expression, names);
  for (const std::string& name : names) {
    if (unwritten_.erase({circuit, name}) > 0) written_[circuit].push_back(name);
  }
}

bool WrittenNames::areReadAt(int element) {
  const auto written = written_.find(circuit_->circuitOf(element));
  if (written == written_.end()) return false;
  Reading& reading = readings_[element];
  if (reading.names.empty()) reading.names = namesUsed(*circuit_, element).read;
  const std::vector<std::string>& names = written->second;
  for (; !reading.isOfWritten && reading.asked < names.size(); ++reading.asked)
    reading.isOfWritten = reading.names.contains(names[reading.asked]);
  return reading.isOfWritten;
}

bool ordersDiffer(const DrawnCircuit& circuit, const std::vector<int>& order, const std::vector<int>& other) {
  std::map<int, std::size_t> place;
  for (std::size_t k = 0; k < other.size(); ++k) place[other[k]] = k;
  // By name: the places in `other`, one behind the last user so far and one behind the last writer.
  struct Last {
    std::size_t user = 0, writer = 0;
  };
  std::map<std::string, Last> last;
  std::size_t looked = 0;
  const std::size_t most = 1'000'000 + 64 * static_cast<std::size_t>(circuit.count());
  for (const int i : order) {
    const NamesUsed used = namesUsed(circuit, i);
    looked += used.looked;
    if (looked > most) return true;  // both orders are written, which says nothing wrong
    const std::size_t end = place[i] + 1;
    for (const std::string& name : used.written) {
      if (end < last[name].user) return true;
    }
    for (const std::string& name : used.read) {
      if (end < last[name].writer) return true;
    }
    for (const std::string& name : used.written) last[name].writer = std::max(last[name].writer, end);
    for (const std::set<std::string>* names : {&used.written, &used.read}) {
      for (const std::string& name : *names) last[name].user = std::max(last[name].user, end);
    }
  }
  return false;
}

}  // namespace rungproof::iec
