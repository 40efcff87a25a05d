// `rungproof show`: networks as ladder, FBD or STL, as text or SVG; with --at the power flow of one scan of a recorded
// run.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <memory>
#include <set>

#include "engine/instruction_recorder.hpp"
#include "engine/stimulus.hpp"
#include "frontend/command.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/input/project_argument.hpp"
#include "frontend/linting/lint_run.hpp"
#include "frontend/picture/network_view.hpp"
#include "frontend/simulation/scan_lengths.hpp"
#include "frontend/simulation/stimulus_reader.hpp"
#include "frontend/simulation/trace_file.hpp"
#include "frontend/step7/source_writer.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "ir/iec/cpu.hpp"
#include "ir/iec/syntax.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/cpu.hpp"

namespace rungproof {

namespace {

struct ShowArguments {
  std::vector<std::string> files;
  std::string form;  ///< empty: as it was drawn
  bool svg = false;
  bool ascii = false;
  bool noFindings = false;
  bool list = false;
  std::vector<std::string> networks;
  std::vector<std::string> pous;
  std::string output;
  std::string at;
  int width = 100;
};

/// "3" or "2-5".
struct NumberRange {
  int low = 0;
  int high = 0;
};

std::optional<NumberRange> rangeNamed(std::string_view text) {
  NumberRange range;
  const char* const end = text.data() + text.size();
  auto [next, error] = std::from_chars(text.data(), end, range.low);
  if (error != std::errc()) return std::nullopt;
  range.high = range.low;
  if (next != end && *next == '-') {
    const auto second = std::from_chars(next + 1, end, range.high);
    if (second.ec != std::errc()) return std::nullopt;
    next = second.ptr;
  }
  return next == end && range.low <= range.high ? std::optional(range) : std::nullopt;
}

/// The run whose scan is lit.
struct LitScan {
  std::string trace;
  std::uint64_t scan = 0;
};

std::optional<LitScan> scanNamed(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) return std::nullopt;
  LitScan lit{text.substr(0, colon), 0};
  const char* const end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data() + colon + 1, end, lit.scan);
  return error == std::errc() && next == end && lit.scan > 0 ? std::optional(lit) : std::nullopt;
}

/// Whether the line of a transition, `x => (A, B)`, leads to the step.
bool leadsTo(std::string_view transition, std::string_view step) {
  constexpr std::string_view ends = " ,()>";
  for (std::size_t at = transition.rfind('>'); at < transition.size(); ++at) {
    at = transition.find(step, at);
    if (at == std::string_view::npos) return false;
    const std::size_t end = at + step.size();
    if (ends.find(transition[at - 1]) != ends.npos &&
        (end == transition.size() || ends.find(transition[end]) != ends.npos))
      return true;
  }
  return false;
}

/// A chart as a picture, from the lines that show it as text: steps below each other, at their right what they do, and
/// on the line that leaves a step its transitions as bars. `isLit`: stars mark the active steps.
Picture chartPicture(const std::vector<std::string>& lines, bool isLit) {
  constexpr int left = 2, boxHeight = 3, middle = left + 6;
  Picture picture;
  const auto wire = [&](int x0, int y0, int x1, int y1) {
    picture.wires.push_back({x0, y0, x1, y1, 0, Flow3::Unknown});
  };
  const auto label = [&](LabelRole role, int x, int y, std::string text) {
    picture.width = std::max(picture.width, x + static_cast<int>(text.size()) + 1);
    picture.labels.push_back({role, -1, x, y, std::move(text)});
  };
  int row = 0, below = -1;  // where the line of the step above begins
  std::vector<std::string> leaving;
  for (const std::string& line : lines) {
    const bool isActive = isLit && line.starts_with("* ");
    const std::string text(trimmed(std::string_view(line).substr(isLit ? 2 : 0)));
    if (text.starts_with("| ")) {
      wire(middle - 2, row, middle + 2, row);
      label(LabelRole::Symbol, middle + 4, row, text.substr(2));
      wire(middle, below, middle, row);
      leaving.push_back(text);
      row += 2;
      continue;
    }
    const bool isInitial = text.starts_with("[[");
    const std::size_t end = text.find(']');
    const std::string name = text.substr(isInitial ? 2 : 1, end - (isInitial ? 2 : 1));
    const int width = std::max(static_cast<int>(name.size()) + 4, 13);
    if (below >= 0) ++row;
    if (std::ranges::any_of(leaving, [&](const std::string& one) { return leadsTo(one, name); }))
      wire(middle, below, middle, row);
    leaving.clear();
    const Flow3 state = !isLit ? Flow3::Unknown : isActive ? Flow3::On : Flow3::Off;
    if (isInitial) {
      picture.symbols.push_back({SymbolKind::Box, -1, left - 1, row, width + 2, boxHeight + 2, "", state});
      ++row;
    }
    picture.symbols.push_back({SymbolKind::Box, -1, left, row, width, boxHeight, "", state});
    label(LabelRole::BoxName, left + 2, row + 1, name);
    const std::size_t actions = text.find_first_not_of("] ", end);
    if (actions != std::string::npos) label(LabelRole::Note, left + width + 3, row + 1, text.substr(actions));
    row += boxHeight + (isInitial ? 1 : 0);
    below = row - 1;
    ++row;
  }
  picture.height = row;
  picture.width = std::max(picture.width, 40);
  return picture;
}

class Show {
 public:
  Show(const ShowArguments& arguments, const Context& context) : arguments_(arguments), context_(context) {}

  Exit run() {
    readArguments();
    if (!failures_.empty()) return failAll(context_, failures_);
    if (arguments_.list) return showTree();
    std::vector<BlockView> blocks;
    std::string text;
    bool isWhole = true;
    const std::vector<std::vector<std::string>> programs = groupByProgram(context_, arguments_.files);
    const bool hasHeadings =
        !isSvg_ && programs.size() > 1 && std::ranges::all_of(programs, [](const std::vector<std::string>& files) {
          return isProjectProgram(files.front());
        });
    for (const std::vector<std::string>& files : programs) {
      const ProgramInput input = readInput(context_, files);
      const UnreadCode unread(input.program);
      isWhole = isWhole && !unread.isRefused();
      if (!unread.empty()) printUnread(context_, "show", input.program, unread, files);
      if (lit_ && !unread.empty())
        failures_.push_back({"no scan is lit: " + unread.texts().front(), files.front()});
      else
        addProgram(input, files, blocks);
      if (!failures_.empty()) return failAll(context_, failures_);
      if (!hasHeadings) continue;
      text += fmt::format("{}{}\n\n{}", text.empty() ? "" : "\n", files.front(), viewOf(blocks));
      blocks.clear();
    }
    if (const auto failure = unusedSelection()) return context_.fail(*failure);
    if (!hasHeadings) text = isSvg_ ? viewSvg(blocks) : viewOf(blocks);
    if (!context_.write({"", arguments_.output}, text)) return Exit::Failed;
    return isWhole ? Exit::Clean : Exit::Failed;
  }

 private:
  std::string viewOf(const std::vector<BlockView>& blocks) const {
    return viewText(blocks, {arguments_.ascii, context_.color && arguments_.output.empty()});
  }

  Exit showTree() {
    std::string text;
    for (const std::string& name : arguments_.files) {
      std::vector<std::string> files = projectsIn(name);
      if (const auto argument = files.empty() ? projectArgument(name) : std::nullopt) files.push_back(argument->file);
      if (files.empty())
        return context_.fail(
            {"--list prints the tree of a STEP 7 project", name, "name a .s7p file, its folder or its archive"});
      for (const std::string& file : files)
        text += projectTree(*s7project::s7ProjectOf(file, *encodingNamed(context_.settings.text(Opt::Encoding))));
    }
    return context_.write({"", arguments_.output}, text) ? Exit::Clean : Exit::Failed;
  }

  void readArguments() {
    options_.form = arguments_.form == "fbd"                               ? Form::Fbd
                    : arguments_.form == "stl" || arguments_.form == "awl" ? Form::Stl
                                                                           : Form::Ladder;
    if (arguments_.form == "awl") options_.mnemonics = step7::MnemonicSet::German;
    options_.width = arguments_.width;
    isSvg_ = arguments_.svg || context_.outputs.front().name == "svg" || arguments_.output.ends_with(".svg");
    if (isSvg_ && arguments_.ascii) failures_.push_back({"--ascii is a form of text, not of SVG"});
    for (const std::string& text : arguments_.networks) {
      if (const auto range = rangeNamed(text))
        ranges_.push_back(*range);
      else
        failures_.push_back(
            {fmt::format("'{}' is no network number", text), {}, "write a number or a range, such as 3 or 2-5"});
    }
    if (arguments_.at.empty()) return;
    lit_ = scanNamed(arguments_.at);
    if (!lit_)
      failures_.push_back(
          {fmt::format("'{}' names no scan of a trace", arguments_.at), {}, "write TRACE:SCAN, such as run.csv:12"});
  }

  void addProgram(const ProgramInput& input, const std::vector<std::string>& files, std::vector<BlockView>& blocks) {
    const Program& program = input.program;
    std::optional<InstructionRecorder> recorder;
    if (lit_) {
      recorder.emplace(program.instructionCount());
      if (!record(program, *recorder)) return;
    }
    Report report;
    if (!arguments_.noFindings) report = lintProgram(context_.settings, input, files);
    sortFindings(report);
    ViewOptions options = options_;
    options.recorder = recorder ? &*recorder : nullptr;
    for (const Finding& finding : report.findings) {
      if (finding.severity >= context_.settings.level()) options.findings.push_back(&finding);
    }
    if (arguments_.form == "awl" && formOf(program.target) != StatementForm::Accumulators) {
      failures_.push_back({"--as awl prints programs of the S7-300 and S7-400 only", files.front(), "write --as stl"});
      return;
    }
    for (const Pou& pou : program.pous) {
      if (!isWanted(pou) || step7::isLibraryBlock(program, pou) || isOfChart(pou)) continue;
      BlockView block{blockHeading(pou), {}};
      if (options.form == Form::Stl && pou.type != BlockType::None)
        block.declarations = step7::declarationLines(program, pou);
      for (const Network& network : pou.networks) {
        if (!isWanted(network) || isHidden(program, network)) continue;
        if (arguments_.form.empty()) options.form = formAsRead(network);
        block.networks.push_back(networkView(program, pou, network, options));
        NetworkView& view = block.networks.back();
        if (formOf(program.target) != StatementForm::Expressions || view.statements.empty() ||
            !view.statements[0].starts_with("["))
          continue;
        if (lit_) markSteps(pou, view);
        if (isSvg_) view.picture = chartPicture(std::exchange(view.statements, {}), lit_.has_value());
      }
      if (!block.networks.empty()) blocks.push_back(std::move(block));
    }
    isFound_ = isFound_ || !blocks.empty() || (ranges_.empty() && arguments_.pous.empty());
  }

  bool isWanted(const Pou& pou) {
    return arguments_.pous.empty() || std::ranges::any_of(arguments_.pous, [&](const std::string& name) {
             return equalsIgnoringCase(name, pou.name) ||
                    (pou.type != BlockType::None && equalsIgnoringCase(name, blockName(pou.number)));
           });
  }
  /// The machinery of a chart, which its picture tells: "MAIN.(transitions)".
  static bool isOfChart(const Pou& pou) {
    return pou.isInstance && (pou.name.ends_with(".(actions)") || pou.name.ends_with(".(transitions)"));
  }
  /// What a chart does and its text does not say.
  static bool isHidden(const Program& program, const Network& network) {
    return formOf(program.target) == StatementForm::Expressions && network.complete && network.span.length == 0;
  }
  /// A star at the steps of a chart that are active at the end of the scan.
  void markSteps(const Pou& pou, NetworkView& view) const {
    for (std::string& line : view.statements) {
      const std::size_t first = line.find_first_not_of('['), end = line.find(']');
      const bool isStep = line.starts_with("[") && end != std::string::npos && first < end;
      const bool isActive =
          isStep &&
          activeSteps_.contains(iec::foldedName(fmt::format("{}.{}.X", pou.name, line.substr(first, end - first))));
      line.insert(0, isActive ? "* " : "  ");
    }
  }
  bool isWanted(const Network& network) const {
    return ranges_.empty() || std::ranges::any_of(ranges_, [&](const NumberRange& range) {
             return range.low <= network.number && network.number <= range.high;
           });
  }
  std::optional<Failure> unusedSelection() const {
    if (isFound_) return std::nullopt;
    return Failure{"no network of the program is selected",
                   {},
                   "see its blocks and networks with 'rungproof show' without --network and --pou"};
  }

  /// Runs the program with the trace as stimulus up to the scan. False: `failures_` says why not.
  bool record(const Program& program, InstructionRecorder& recorder) {
    const std::optional<std::string> text = readFile(context_, lit_->trace, failures_);
    if (!text) return false;
    const TraceImport import = traceImportOf(context_.settings, failures_);
    const Stimulus stimulus = readStimulus(lit_->trace, *text, program, failures_, "old", import);
    if (failures_.empty()) checkRenames(import, lit_->trace, failures_);
    if (!failures_.empty()) return false;
    if (program.main() == nullptr) {
      failures_.push_back(
          {"there is no main program to run", arguments_.files.front(), "give the file that holds the main program"});
      return false;
    }
    SimulatorOptions engine;
    engine.choices = context_.settings.choices();
    engine.seed = static_cast<std::uint64_t>(context_.settings.number(Opt::Seed, 1));
    engine.scanUs = static_cast<std::uint32_t>(scanTimeFor(context_.settings, program).low.count());
    Simulator simulator(program, engine);
    simulator.observe(&recorder);
    StimulusPlayer player(simulator, stimulus);
    while (simulator.scanCount() < lit_->scan) {
      if (!simulator.isRunning()) {
        failures_.push_back({fmt::format("the program stops after scan {}; scan {} does not run it",
                                         simulator.scanCount(), lit_->scan)});
        return false;
      }
      if (const StimulusRow* last = stimulus.rows.empty() ? nullptr : &stimulus.rows.back();
          last == nullptr ||
          (stimulus.isByTime ? simulator.timeUs() > last->timeUs : simulator.scanCount() >= last->scan)) {
        failures_.push_back({fmt::format("the trace ends before scan {}", lit_->scan), lit_->trace,
                             fmt::format("its last scan is {}", simulator.scanCount())});
        return false;
      }
      recorder.beginScan(simulator.scanCount() + 1 == lit_->scan);
      simulator.scan(player.next());
    }
    for (const Symbol& symbol : program.symbols) {
      if (formOf(program.target) == StatementForm::Expressions && symbol.name.ends_with(".X") &&
          simulator.read(symbol.address) != 0)
        activeSteps_.insert(iec::foldedName(symbol.name));
    }
    return true;
  }

  const ShowArguments& arguments_;
  const Context& context_;
  ViewOptions options_;
  bool isSvg_ = false;
  bool isFound_ = false;
  std::vector<NumberRange> ranges_;
  std::optional<LitScan> lit_;
  std::set<std::string> activeSteps_;  ///< "MAIN.FILL.X"
  std::vector<Failure> failures_;
};

Action setUpShow(ArgumentTable& table) {
  auto arguments = std::make_shared<ShowArguments>();
  table.arguments("FILE", arguments->files, "programs, symbol tables and data blocks; '-' is standard input");
  table.word("--as", arguments->form, {"lad", "ladder", "fbd", "stl", "awl"}, "lad|fbd|stl|awl",
             "draw as ladder, function block diagram or statement list (as drawn; lists as lad); awl: a list in "
             "SIMATIC mnemonics");
  table.flag("--svg", arguments->svg, "one SVG document instead of text");
  table.flag("--ascii", arguments->ascii, "text without box-drawing characters");
  table.list("--network", arguments->networks, "N", "only these networks, such as 3 or 2-5; may be repeated");
  table.list("--pou", arguments->pous, "NAME", "only these blocks; may be repeated");
  table.option("-o,--output", arguments->output, "FILE", "write to this file; one that ends in .svg is SVG");
  table.option("--at", arguments->at, "TRACE:SCAN", "light the power flow of a scan of a trace (CSV)");
  table.number("--width", arguments->width, "N", "columns of a page; longer rungs are wrapped (100)", 40, 1000);
  table.flag("--list", arguments->list, "the tree of a STEP 7 project: programs, CPUs, blocks, sources");
  table.flag("--no-findings", arguments->noFindings, "do not mark what lint finds");
  return [arguments](Context& context) { return Show(*arguments, context).run(); };
}

}  // namespace

extern constexpr Command showCommand = {
    .name = "show",
    .usage = "FILE... [--as lad|fbd|stl|awl] [--svg] [--at TRACE:SCAN]",
    .summary = "draw networks as ladder, FBD or STL",
    .details =
        "A network that has no picture in the wanted form is shown as STL with the reason. Findings of lint are\n"
        "marked below the element they are about. With --at the program runs with the trace as stimulus: wires\n"
        "with power are heavy (in ASCII '='), closed contacts and energised coils are filled, and values stand\n"
        "behind the addresses. Active steps of a chart have a star.\n"
        "\n"
        "Examples:\n"
        "    rungproof show press.awl\n"
        "    rungproof show press.awl --as fbd --pou SBR_0 --network 2-5\n"
        "    rungproof show press.awl --svg -o press.svg\n"
        "    rungproof show press.awl --at run.csv:12 --network 3\n",
    .shows = option_group::Reading | option_group::Rules | option_group::Output | option_group::Configuration,
    .formats = "text|svg",
    .takesEachProgram = true,
    .setup = setUpShow,
};

}  // namespace rungproof
