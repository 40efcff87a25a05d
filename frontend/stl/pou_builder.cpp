// Blocks and networks under construction.
#include "frontend/stl/pou_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "frontend/stl/directive.hpp"
#include "frontend/stl/local_layout.hpp"
#include "frontend/stl/rung_split.hpp"

namespace rungproof {

void PouBuilder::reset(Span span) {
  pou_ = Pou{};
  pou_.span = span;
  heading_ = span;
  isOpen_ = true;
  inNetwork_ = hasNetworkLines_ = isLaidOut_ = false;
  damaged_.clear();
  firstFinding_ = program_.findings.size();
  firstDirective_ = program_.directives.size();
}

void PouBuilder::open(Heading heading, Span span, bool isFramed) {
  reset(span);
  isFramed_ = isFramed;
  int& next = nextNumber_[static_cast<std::size_t>(heading.kind)];
  const bool hasNumber = heading.number >= 0;
  if (!hasNumber) {
    heading.number = next;
    if (heading.name.empty()) heading.name = defaultName(heading.kind, heading.number);
  }
  next = std::max(next, heading.number + 1);
  pou_.kind = heading.kind;
  pou_.name = heading.name;
  pou_.number = heading.number;
  pou_.comments = std::move(pending_);
  pending_.clear();
  sink_.setPlace(pou_.name, 0);
  if (!hasNumber) {
    const std::string_view written = text_.substr(span.offset, span.length);
    sink_.report(Syntax::BlockHeading, span,
                 fmt::format("heading \"{}\" has no readable number; {} was taken", excerpt(written), heading.number));
  }
}

void PouBuilder::openMain(std::uint32_t offset) {
  reset(sink_.span(offset, offset));
  isFramed_ = false;
  pou_.kind = PouKind::Main;
  pou_.name = defaultName(PouKind::Main, 1);
  pou_.number = 1;
  isLaidOut_ = true;
  sink_.setPlace(pou_.name, 0);
  startBody(offset);
  network_.comments = std::move(pending_);
  pending_.clear();
}

void PouBuilder::reportOpen(Span heading, std::string_view what) {
  sink_.report(Syntax::BlockOpen, heading, fmt::format("{} has no end", what));
}

void PouBuilder::close(std::uint32_t end) {
  if (!isOpen_) return;
  closeNetwork(end);
  pou_.span.length = end - pou_.span.offset;
  pou_.networks.shrink_to_fit();
  if (!hasNetworkLines_ && pou_.networks.size() == 1) numberRungs(splitIntoRungs(pou_, text_, damaged_));
  checkProtection();
  program_.pous.push_back(std::move(pou_));
  isOpen_ = false;
  hadBlock_ = true;
  sink_.setPlace({}, 0);
}

void PouBuilder::numberRungs(const std::vector<std::uint32_t>& begins) {
  const auto rungAt = [&](std::uint32_t offset) {
    return std::max(1, static_cast<int>(std::upper_bound(begins.begin(), begins.end(), offset) - begins.begin()));
  };
  for (std::size_t i = firstFinding_; i < program_.findings.size(); ++i) {
    Finding& finding = program_.findings[i];
    if (finding.network != 0) finding.network = rungAt(finding.span.offset);
  }
  for (std::size_t i = firstDirective_; i < program_.directives.size(); ++i) {
    Directive& directive = program_.directives[i];
    if (directive.network != 0) directive.network = rungAt(directive.span.offset);
  }
}

void PouBuilder::checkProtection() {
  static constexpr std::string_view mark = "password-protected";
  const bool isEmpty = std::all_of(pou_.networks.begin(), pou_.networks.end(),
                                   [](const Network& network) { return network.instructions.empty(); });
  const auto isMarked = [](const Network& network) { return network.title.find(mark) != std::string::npos; };
  if (!isEmpty || std::none_of(pou_.networks.begin(), pou_.networks.end(), isMarked)) return;
  pou_.protectedBlock = true;
  sink_.setNetwork(0);
  sink_.report(Syntax::ProtectedBlock, heading_,
               fmt::format("block {} is protected by a password; its instructions are not in the text", pou_.name));
}

void PouBuilder::layOutLocalsOnce() {
  if (isLaidOut_) return;
  isLaidOut_ = true;
  const std::uint32_t used = layOutLocals(pou_.locals);
  if (used <= localMemoryBytes) return;
  sink_.report(Syntax::LocalTableFull, heading_,
               fmt::format("the local variables of {} need {} bytes, there are {}", pou_.name, used, localMemoryBytes));
}

void PouBuilder::startBody(std::uint32_t offset) {
  layOutLocalsOnce();
  startNetwork(1, offset);
  isLeadIn_ = true;
  hasNetworkLines_ = false;
}

void PouBuilder::startNetwork(int number, std::uint32_t offset) {
  layOutLocalsOnce();
  closeNetwork(offset);
  network_ = Network{};
  network_.number = number;
  network_.span = sink_.span(offset, offset);
  inNetwork_ = true;
  isLeadIn_ = false;
  hasNetworkLines_ = true;
  sink_.setNetwork(number);
}

void PouBuilder::renumberNetwork(int number) {
  network_.number = number;
  sink_.setNetwork(number);
}

int PouBuilder::nextNetworkNumber() const {
  if (inNetwork_ && !isLeadIn_) return network_.number + 1;
  return pou_.networks.empty() ? 1 : pou_.networks.back().number + 1;
}

void PouBuilder::needNetwork(std::uint32_t offset) {
  if (inNetwork_) return;
  const bool hadLines = hasNetworkLines_;
  startNetwork(nextNetworkNumber(), offset);
  hasNetworkLines_ = hadLines;
}

void PouBuilder::closeNetwork(std::uint32_t end) {
  if (!inNetwork_) return;
  inNetwork_ = false;
  if (isLeadIn_ && instructions_.empty() && network_.complete) {
    pou_.comments.insert(pou_.comments.end(), network_.comments.begin(), network_.comments.end());
    return;
  }
  network_.span.length = end - network_.span.offset;
  network_.instructions.assign(std::make_move_iterator(instructions_.begin()),
                               std::make_move_iterator(instructions_.end()));
  instructions_.clear();
  pou_.networks.push_back(std::move(network_));
}

void PouBuilder::addDamage(std::uint32_t offset) {
  network_.complete = false;
  damaged_.push_back(offset);
}

void PouBuilder::addComment(Span span) {
  if (const auto text = directiveText(text_.substr(span.offset, span.length))) {
    Directive directive;
    directive.text = *text;
    directive.span = span;
    directive.pou = isOpen_ ? static_cast<int>(program_.pous.size()) : -1;
    directive.network = isOpen_ && inNetwork_ ? network_.number : 0;
    program_.directives.push_back(std::move(directive));
  }
  if (!isOpen_) {
    pending_.push_back({span});
  } else {
    (inNetwork_ ? network_.comments : pou_.comments).push_back({span});
  }
}

void PouBuilder::setTitle(std::string_view title) {
  if (inNetwork_ && !isLeadIn_) {
    network_.title = title;
  } else {
    pou_.title = title;
  }
}

void PouBuilder::releaseTrailingComments() {
  if (!isOpen_ || !inNetwork_ || instructions_.empty()) return;
  const Span& last = instructions_.back().span;
  const std::size_t newline = std::min(text_.find('\n', last.offset + last.length), text_.size());
  std::vector<Comment>& comments = network_.comments;
  const auto first = std::find_if(comments.begin(), comments.end(),
                                  [&](const Comment& comment) { return comment.span.offset > newline; });
  pending_.insert(pending_.end(), first, comments.end());
  comments.erase(first, comments.end());
}

void PouBuilder::finish(std::uint32_t end) {
  close(end);
  if (program_.pous.empty()) return;
  std::vector<Comment>& comments = program_.pous.back().comments;
  comments.insert(comments.end(), pending_.begin(), pending_.end());
}

}  // namespace rungproof
