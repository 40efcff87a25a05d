// A network ready to be shown: heading, comments, its picture or its statement list, findings. A network that has no
// picture in the wanted form is shown as STL with the reason. Tested by tests/show/scan_test.cpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/instruction_recorder.hpp"
#include "frontend/picture/picture.hpp"
#include "frontend/picture/text_picture.hpp"
#include "frontend/step7/constant_parser.hpp"
#include "ir/finding.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// FBD stays FBD; statement lists are drawn as ladder.
inline Form formAsRead(const Network& network) { return network.form == Form::Fbd ? Form::Fbd : Form::Ladder; }

struct ViewOptions {
  Form form = Form::Ladder;
  int width = 100;                                ///< columns of a page
  std::vector<const Finding*> findings{};         ///< of the whole program by place; those in the network are taken
  const InstructionRecorder* recorder = nullptr;  ///< a scan to light, or nullptr
  step7::MnemonicSet mnemonics = step7::MnemonicSet::International;  ///< of statements of the S7-300/400
  /// Of a contact: PictureSymbol::seen; may be missing.
  std::function<std::optional<std::pair<bool, bool>>(const Instruction&)> seen{};
};

struct ViewNote {
  Severity severity = Severity::Note;
  std::string text;
};

struct NetworkView {
  std::string heading;                ///< "Network 3  inlet"
  std::vector<std::string> comments;  ///< without their signs
  Picture picture;                    ///< empty if there is none
  std::vector<std::string> statements;
  std::string reason;           ///< why there is no picture; empty: there is one, or STL was asked for
  std::vector<ViewNote> notes;  ///< findings
  bool notExecuted = false;     ///< the scan to be lit did not run it
};

NetworkView networkView(const Program& program, const Pou& pou, const Network& network, const ViewOptions& options);

/// Networks of one block.
struct BlockView {
  std::string heading;  ///< "MAIN (OB1)  Tank filling"
  std::vector<NetworkView> networks;
  std::vector<std::string> declarations{};  ///< lines above the networks
};
std::string blockHeading(const Pou& pou);

/// The lines of one network below its comments: remarks, picture or statements, findings.
std::vector<std::string> contentLines(const NetworkView& view, const TextStyle& style);
std::string viewText(const std::vector<BlockView>& blocks, const TextStyle& style);
/// One SVG document with everything below each other.
std::string viewSvg(const std::vector<BlockView>& blocks);
/// The picture or statements of one network without heading, as an SVG element for an HTML page that brings svgStyle().
std::string pictureSvg(const NetworkView& view);
/// The same no wider than what is in it, with its size in pixels.
struct SizedSvg {
  std::string element;
  int width = 0, height = 0;
};
SizedSvg sizedSvg(const NetworkView& view);

}  // namespace rungproof
