// The action control of a chart: of each action whether it is active, over all its associations, then what it does. Q
// is NOT R AND (what any qualifier makes of its step), as the standard draws it.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "frontend/iec/iec_chart.hpp"
#include "frontend/iec/iec_tree.hpp"

namespace rungproof::iec {

namespace {

class ActionWriter {
 public:
  ActionWriter(const ChartSyntax& chart, BlockSyntax& block) : chart_(chart), block_(block) {}

  /// Of each action whether it is active, then what it does; FALSE variables and bodies that end come first.
  Statements run() {
    Statements made;
    std::vector<Control> controls = controlsOf();
    if (controls.empty()) return made;
    std::vector<const ChartStep*> remembered;
    for (const ChartStep& step : chart_.steps) {
      const bool hasEdge = std::ranges::any_of(step.actions, [](const ChartAction& a) {
        return a.qualifier == Qualifier::P || a.qualifier == Qualifier::P0 || a.qualifier == Qualifier::P1;
      });
      if (hasEdge) remembered.push_back(&step);
    }
    startEdges(remembered, made);
    std::map<std::string, ExprPtr> pulses;
    for (const Control& control : controls) writeControl(control, pulses[control.name], made);
    for (const Control& control : controls) {
      if (!control.isBody) writeVariable(control, made);
    }
    std::erase_if(controls, [](const Control& control) { return !control.isBody; });
    std::vector<const Control*> declared, byName;
    for (const Control& control : controls) declared.push_back(&control);
    byName = declared;
    std::ranges::stable_sort(byName, {}, [](const Control* c) { return foldedName(c->name); });
    Statements run = runBodies(declared, pulses);
    if (byName == declared) {
      for (Statement& s : run) made.push_back(std::move(s));
    } else {
      Statement order = ifOf(readingOf("iec-sfc-action-order", "alphabetical", chart_.span), runBodies(byName, pulses),
                             {chart_.span.file, chart_.span.offset, 0});
      order.hasElse = true;
      order.otherwise = std::move(run);
      made.push_back(std::move(order));
    }
    for (const ChartStep* step : remembered)
      made.push_back(assignmentOf(member(*step, "WAS"), active(*step), {step->span.file, step->span.offset, 0}));
    return made;
  }

 private:
  /// All associations of one action.
  struct Control {
    std::string name;
    bool isBody = false;
    std::vector<std::pair<const ChartStep*, const ChartAction*>> uses;
  };

  static ExprPtr member(const ChartStep& step, std::string_view name) { return pathOf({step.name, name}, step.span); }
  static ExprPtr active(const ChartStep& step) { return member(step, "X"); }

  /// Variables by their first association, bodies as they are declared.
  std::vector<Control> controlsOf() const {
    std::vector<Control> controls;
    const auto at = [&](const std::string& name) {
      return std::ranges::find_if(controls, [&](const Control& c) { return foldedName(c.name) == foldedName(name); });
    };
    for (const ChartBody& body : chart_.actions) controls.push_back({body.name, true, {}});
    for (const ChartStep& step : chart_.steps) {
      for (const ChartAction& action : step.actions) {
        auto found = at(action.name);
        if (found == controls.end()) found = controls.insert(found, {action.name, false, {}});
        found->uses.emplace_back(&step, &action);
      }
    }
    std::erase_if(controls, [](const Control& control) { return control.uses.empty(); });
    return controls;
  }

  /// By one reading the initial step has been active before the first scan, so that it is not activated in it.
  void startEdges(const std::vector<const ChartStep*>& remembered, Statements& made) {
    Statements started;
    for (const ChartStep* step : remembered) {
      if (step->isInitial)
        started.push_back(assignmentOf(member(*step, "WAS"), literalOf("TRUE", step->span), step->span));
    }
    if (started.empty()) return;
    const Span span{chart_.span.file, chart_.span.offset, 0};
    const std::string begun = hiddenVariable(block_, "begun", "BOOL", span);
    made.push_back(ifOf(andOf(notOf(pathOf({begun}, span)), readingOf("iec-sfc-initial-edge", "no", span)),
                        std::move(started), span));
    made.push_back(assignmentOf(pathOf({begun}, span), literalOf("TRUE", span), span));
  }

  static std::string variableOf(const Control& control, std::string_view what) {
    std::string name = fmt::format("__{}_{}", control.name, what);
    std::ranges::replace_if(
        name, [](char c) { return c == '.' || c == ' '; }, '_');
    return name;
  }
  void declare(const std::string& name, std::string_view type, Span span) {
    VariableSyntax made;
    made.name = name;
    made.type = std::make_shared<TypeSyntax>();
    made.type->name = type;
    made.type->span = made.span = span;
    block_.variables.push_back(std::move(made));
  }

  /// NOT R AND (what any association makes of it). A pulse of a body is kept apart: it has no final scan.
  void writeControl(const Control& control, ExprPtr& pulse, Statements& made) {
    const Span place = control.uses[0].second->span, span{place.file, place.offset, 0};
    const std::string q = variableOf(control, "active"), was = variableOf(control, "before");
    declare(q, "BOOL", span);
    declare(was, "BOOL", span);
    made.push_back(assignmentOf(pathOf({was}, span), pathOf({q}, span), span));
    ExprPtr reset, any;
    for (const auto& [step, use] : control.uses) {
      if (use->qualifier == Qualifier::R) reset = orOf(std::move(reset), active(*step));
    }
    for (std::size_t i = 0; i < control.uses.size(); ++i) {
      const auto& [step, use] = control.uses[i];
      const auto clock = [&](std::string_view compare) {
        return andOf(active(*step), binaryOf(compare, clockOf(*step, *use), copyOf(*use->time)));
      };
      const auto stored = [&](ExprPtr sets) {
        const std::string name = variableOf(control, fmt::format("stored_{}", i + 1));
        declare(name, "BOOL", use->span);
        ExprPtr value = orOf(pathOf({name}, use->span), std::move(sets));
        if (reset != nullptr) value = andOf(notOf(copyOf(*reset)), std::move(value));
        made.push_back(assignmentOf(pathOf({name}, use->span), std::move(value), use->span));
        return name;
      };
      /// Runs while the action is stored.
      const auto timed = [&](const std::string& name) {
        const std::string timer = variableOf(control, fmt::format("timer_{}", i + 1));
        declare(timer, "TON", use->span);
        ExprPtr call = callOf({timer}, use->span);
        addArgument(*call, pathOf({name}, use->span), "IN");
        addArgument(*call, copyOf(*use->time), "PT");
        made.push_back(callStatementOf(std::move(call)));
        return pathOf({timer, "Q"}, use->span);
      };
      switch (use->qualifier) {
        case Qualifier::N: any = orOf(std::move(any), active(*step)); break;
        case Qualifier::R: break;
        case Qualifier::S: any = orOf(std::move(any), pathOf({stored(active(*step))}, use->span)); break;
        case Qualifier::L: any = orOf(std::move(any), clock("<")); break;
        case Qualifier::D: any = orOf(std::move(any), clock(">=")); break;
        case Qualifier::DS: any = orOf(std::move(any), pathOf({stored(clock(">="))}, use->span)); break;
        case Qualifier::SD: any = orOf(std::move(any), timed(stored(active(*step)))); break;
        case Qualifier::SL: {
          const std::string name = stored(active(*step));
          any = orOf(std::move(any), andOf(pathOf({name}, use->span), notOf(timed(name))));
          break;
        }
        case Qualifier::P:
        case Qualifier::P1:
        case Qualifier::P0: {
          const bool isEnd = use->qualifier == Qualifier::P0;
          ExprPtr edge = isEnd ? andOf(member(*step, "WAS"), notOf(active(*step)))
                               : andOf(active(*step), notOf(member(*step, "WAS")));
          const bool isApart = control.isBody && use->qualifier != Qualifier::P;
          ExprPtr& into = isApart ? pulse : any;
          into = orOf(std::move(into), std::move(edge));
          break;
        }
      }
    }
    if (any == nullptr) any = literalOf("FALSE", span);
    if (reset != nullptr) any = andOf(notOf(copyOf(*reset)), std::move(any));
    made.push_back(assignmentOf(pathOf({q}, span), std::move(any), span));
  }

  ExprPtr clockOf(const ChartStep& step, const ChartAction& use) {
    const auto duration = constantDuration(block_, *use.time);
    if (duration) countClockTo(block_, step.name, *duration);
    return member(step, duration ? "CLOCK" : "T");
  }

  /// TRUE in each scan in which the action is active, FALSE in the one in which it ceases to be, and while R holds.
  void writeVariable(const Control& control, Statements& made) {
    const Span span = control.uses[0].second->span;
    ExprPtr ends = pathOf({variableOf(control, "before")}, span);
    for (const auto& [step, use] : control.uses) {
      if (use->qualifier == Qualifier::R) ends = orOf(std::move(ends), active(*step));
    }
    Statements on, off;
    on.push_back(assignmentOf(pathOf({control.name}, span), literalOf("TRUE", span), span));
    off.push_back(assignmentOf(pathOf({control.name}, span), literalOf("FALSE", span), span));
    Statement written = ifOf(pathOf({variableOf(control, "active")}, span), std::move(on), span);
    Branch& branch = written.branches.emplace_back();
    branch.condition = std::move(ends);
    branch.body = std::move(off);
    made.push_back(std::move(written));
  }

  /// The final scans by the reading that has them, then what is active.
  Statements runBodies(const std::vector<const Control*>& order, const std::map<std::string, ExprPtr>& pulses) {
    Statements made;
    const auto call = [&](const Control& control, ExprPtr condition, Span span) {
      Statements body;
      body.push_back(callStatementOf(callOf({control.name}, control.uses[0].second->span)));
      made.push_back(ifOf(std::move(condition), std::move(body), span));
    };
    for (const bool isFinal : {true, false}) {
      for (const Control* control : order) {
        const Span span = control->uses[0].second->span;
        const ExprPtr& pulse = pulses.at(control->name);
        ExprPtr runs = pathOf({variableOf(*control, "active")}, span);
        if (pulse != nullptr) runs = orOf(std::move(runs), copyOf(*pulse));
        if (!isFinal) {
          call(*control, std::move(runs), span);
          continue;
        }
        ExprPtr ends = andOf(pathOf({variableOf(*control, "before")}, span), notOf(std::move(runs)));
        call(*control, andOf(readingOf("iec-sfc-final-scan", "yes", span), std::move(ends)),
             {span.file, span.offset, 0});
      }
    }
    return made;
  }

  const ChartSyntax& chart_;
  BlockSyntax& block_;
};

}  // namespace

Statements actionStatements(const ChartSyntax& chart, BlockSyntax& block) { return ActionWriter(chart, block).run(); }

}  // namespace rungproof::iec
