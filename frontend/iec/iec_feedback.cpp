// Which wires of a drawing close its loops.
#include "frontend/iec/iec_feedback.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "frontend/iec/iec_drawn_names.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

namespace {

using Wire = std::tuple<int, std::size_t, std::size_t>;  ///< consumer, pin, link
using Wires = std::set<Wire>;

template <class Network>
auto& linkOf(Network& network, const Wire& wire) {
  const auto& [consumer, pin, link] = wire;
  return network.elements[static_cast<std::size_t>(consumer)].inputs[pin].links[link];
}

class LoopOfGates {
 public:
  explicit LoopOfGates(const DrawnNetwork& network) : network_(network) {
    for (int i = 0; i < count(); ++i) isUsable_ = byId_.emplace(at(i).id, i).second && isUsable_;
    constexpr int most = 300;
    isUsable_ = isUsable_ && count() <= most && namesAreApart();
    if (isUsable_) findFeeders();
  }

  /// Whether there is a loop, and all of it are gates.
  bool hasLoop() const {
    if (!isUsable_) return false;
    bool any = false;
    for (int i = 0; i < count(); ++i) {
      if (!feeds(i, i)) continue;
      if (!isGate(at(i))) return false;
      any = true;
    }
    return any && !(instanceIs(true) && instanceIs(false));
  }

  Wires cutByNumber() const {
    const auto hasNumber = [&](int i) { return !feeds(i, i) || at(i).order > 0; };
    for (int i = 0; i < count(); ++i) {
      if (!hasNumber(i)) return cutByDemand();
    }
    return cutByRank([&](int i) { return std::tuple(at(i).order, i); });
  }
  Wires cutByPlace() const {
    return cutByRank([&](int i) { return std::tuple(at(i).x, at(i).y, i); });
  }

  /// The drawing without these wires; nothing: they come from several outputs, or a loop is left.
  std::optional<DrawnNetwork> cut(const Wires& wires, const std::string& variable) const {
    if (wires.empty()) return std::nullopt;
    DrawnNetwork made = network_;
    const DrawnLink source = linkOf(network_, *wires.begin());
    for (const Wire& wire : wires) {
      DrawnLink& link = linkOf(made, wire);
      if (link.from != source.from || link.pin != source.pin) return std::nullopt;
      link.from = "__" + variable;
      link.pin.clear();
    }
    const DrawnElement& gate = at(byId_.at(source.from));
    DrawnElement before;
    before.kind = DrawnKind::InVariable;
    before.id = "__" + variable;
    before.text = variable;
    before.span = gate.span;
    before.x = gate.x;
    before.y = gate.y;
    DrawnElement after = before;
    after.kind = DrawnKind::OutVariable;
    after.id += "_out";
    constexpr double last = 1e9;  // what reads the value of before stands in front of it
    after.x = after.y = last;
    DrawnPin& pin = after.inputs.emplace_back();
    pin.span = gate.span;
    pin.links.push_back(source);
    made.elements.push_back(std::move(before));
    made.elements.push_back(std::move(after));
    const LoopOfGates rest(made);
    for (int i = 0; i < rest.count(); ++i) {
      if (rest.feeds(i, i)) return std::nullopt;
    }
    return made;
  }

 private:
  /// Whether a function block takes a value of the loop (`behind`), or the loop one of a function block.
  bool instanceIs(bool behind) const {
    for (int i = 0; i < count(); ++i) {
      for (const DrawnPin& pin : at(i).inputs) {
        for (const DrawnLink& link : pin.links) {
          const int from = sourceOf(link);
          if (from < 0 || !isInstance(at(behind ? i : from))) continue;
          for (int gate = 0; gate < count(); ++gate) {
            if (!feeds(gate, gate)) continue;
            if (behind ? gate == from || feeds(gate, from) : gate == i || feeds(i, gate)) return true;
          }
        }
      }
    }
    return false;
  }

  int count() const { return static_cast<int>(network_.elements.size()); }
  const DrawnElement& at(int i) const { return network_.elements[static_cast<std::size_t>(i)]; }
  static bool isGate(const DrawnElement& element) {
    static const std::set<std::string> gates = {"AND", "OR", "XOR", "NOT"};
    const bool hasEnable =
        std::ranges::any_of(element.inputs, [](const DrawnPin& pin) { return foldedName(pin.name) == "EN"; });
    return element.kind == DrawnKind::Block && !isInstance(element) && !hasEnable &&
           gates.contains(foldedName(element.text));
  }
  /// Whether what arrives at it leaves it in the same evaluation.
  static bool passes(const DrawnElement& element) {
    return (element.kind == DrawnKind::Block && !isInstance(element)) || element.kind == DrawnKind::Contact ||
           element.kind == DrawnKind::Coil;
  }

  /// The kept value is written behind all results: none of them may change what the loop reads, or pass it over.
  bool namesAreApart() const {
    std::set<std::string> read, written;
    for (const DrawnElement& element : network_.elements) {
      using enum DrawnKind;
      const bool isOther = element.kind == Connector || element.kind == Continuation || element.kind == Jump ||
                           element.kind == Label || element.kind == Return || element.kind == InOutVariable;
      if (isOther) return false;
      if (element.kind == InVariable || element.kind == Contact) addNames(element.text, read);
      if (element.kind == OutVariable || element.kind == Coil) addNames(element.text, written);
      if (isInstance(element)) addNames(element.instance, written);
      for (const DrawnPin& pin : element.inputs) addNames(pin.expression, read);
      for (const DrawnPin& pin : element.outputs) addNames(pin.expression, written);
    }
    return std::ranges::none_of(written, [&](const std::string& name) { return read.contains(name); });
  }

  void findFeeders() {
    const auto size = static_cast<std::size_t>(count());
    feeds_.assign(size, std::vector<bool>(size, false));
    for (int i = 0; i < count(); ++i) {
      std::vector<int> open = {i};
      while (!open.empty()) {
        const int to = open.back();
        open.pop_back();
        for (const DrawnPin& pin : at(to).inputs) {
          for (const DrawnLink& link : pin.links) {
            const int from = sourceOf(link);
            if (from < 0 || !passes(at(from)) || feeds(from, i)) continue;
            feeds_[static_cast<std::size_t>(from)][static_cast<std::size_t>(i)] = true;
            open.push_back(from);
          }
        }
      }
    }
  }
  /// Whether a value of `from` reaches `to` in one evaluation.
  bool feeds(int from, int to) const {
    return !feeds_.empty() && feeds_[static_cast<std::size_t>(from)][static_cast<std::size_t>(to)];
  }
  int sourceOf(const DrawnLink& link) const {
    const auto found = byId_.find(link.from);
    return found == byId_.end() ? -1 : found->second;
  }
  template <class Visit>
  void eachWireInto(int consumer, Visit visit) const {
    for (std::size_t p = 0; p < at(consumer).inputs.size(); ++p) {
      for (std::size_t l = 0; l < at(consumer).inputs[p].links.size(); ++l) {
        const int from = sourceOf(at(consumer).inputs[p].links[l]);
        if (from >= 0 && passes(at(from))) visit(from, Wire{consumer, p, l});
      }
    }
  }

  /// Wires of loops from a gate that is not evaluated before the one that takes them.
  template <class Rank>
  Wires cutByRank(Rank rank) const {
    Wires found;
    for (int i = 0; i < count(); ++i) {
      eachWireInto(i, [&](int from, const Wire& wire) {
        if (feeds(i, from) && rank(from) >= rank(i)) found.insert(wire);
      });
    }
    return found;
  }

  /// From each result back to what it needs: a gate that waits for itself takes its value of before.
  Wires cutByDemand() const {
    std::vector<int> results;
    for (int i = 0; i < count(); ++i) {
      const DrawnKind kind = at(i).kind;
      if (kind == DrawnKind::OutVariable || kind == DrawnKind::Coil || isInstance(at(i))) results.push_back(i);
    }
    std::ranges::stable_sort(results, {}, [&](int i) { return std::tuple(at(i).y, at(i).x); });
    Wires found;
    std::vector<int> state(static_cast<std::size_t>(count()), 0);
    const auto ask = [&](const auto& self, int i) -> void {
      state[static_cast<std::size_t>(i)] = 1;
      eachWireInto(i, [&](int from, const Wire& wire) {
        const int met = state[static_cast<std::size_t>(from)];
        if (met == 1) found.insert(wire);
        if (met == 0) self(self, from);
      });
      state[static_cast<std::size_t>(i)] = 2;
    };
    for (const int result : results) {
      if (state[static_cast<std::size_t>(result)] == 0) ask(ask, result);
    }
    return found;
  }

  const DrawnNetwork& network_;
  std::map<std::string, int> byId_;
  std::vector<std::vector<bool>> feeds_;
  bool isUsable_ = true;
};

}  // namespace

std::optional<FeedbackNetworks> withFeedback(const DrawnNetwork& network, const std::string& variable) {
  const LoopOfGates loop(network);
  if (!loop.hasLoop()) return std::nullopt;
  const Wires first = loop.cutByNumber(), second = loop.cutByPlace();
  auto byNumber = loop.cut(first, variable), left = loop.cut(second, variable);
  if (!byNumber || !left) return std::nullopt;
  return FeedbackNetworks{std::move(*byNumber), std::move(*left), first == second};
}

}  // namespace rungproof::iec
