// Parsing with pugixml, which neither expands entities nor follows references to other files.
#include "frontend/xml/xml_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof {

namespace {

constexpr unsigned parseFlags = pugi::parse_default | pugi::parse_comments | pugi::parse_doctype | pugi::parse_fragment;

std::string_view reasonOf(pugi::xml_parse_status status) {
  switch (status) {
    case pugi::status_bad_start_element: return "a start tag is not well formed";
    case pugi::status_bad_attribute: return "an attribute is not well formed";
    case pugi::status_bad_end_element: return "an end tag is not well formed";
    case pugi::status_end_element_mismatch:
      return "an end tag does not belong to the element that is open, or elements are left open";
    case pugi::status_bad_pi: return "a processing instruction is not well formed";
    case pugi::status_bad_comment: return "a comment is not closed";
    case pugi::status_bad_cdata: return "a CDATA section is not closed";
    case pugi::status_bad_doctype: return "the document type is not well formed";
    case pugi::status_bad_pcdata: return "characters are not well formed";
    case pugi::status_unrecognized_tag: return "a tag begins with a character that no name has";
    default: return "the text is not XML";
  }
}

/// Control characters come by number only, "&#27;"; the text itself has lost them.
bool hasControls(std::string_view text) {
  return std::ranges::any_of(
      text, [](char c) { return (c >= 0 && c < ' ' && c != '\n' && c != '\t' && c != '\r') || c == 0x7F; });
}

bool hasLines(std::string_view text) { return text.find_first_of("\r\n") != std::string_view::npos; }

std::string withBlanks(std::string text, bool onOneLine) {
  for (char& c : text) {
    const bool isLine = c == '\n' || c == '\r';
    if ((isLine && onOneLine) || (!isLine && hasControls({&c, 1}))) c = ' ';
  }
  return text;
}

}  // namespace

bool looksLikeXml(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

std::string_view localName(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node childNamed(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_node& child : node.children()) {
    if (localName(child) == name) return child;
  }
  return {};
}

pugi::xml_node nextWithin(const pugi::xml_node& root, pugi::xml_node at, bool descends) {
  if (descends && at.first_child()) return at.first_child();
  while (at && at != root && !at.next_sibling()) at = at.parent();
  return at && at != root ? at.next_sibling() : pugi::xml_node{};
}

void forEachBelow(const pugi::xml_node& node, const std::function<void(const pugi::xml_node&)>& visit) {
  for (pugi::xml_node at = node.first_child(); at; at = nextWithin(node, at, true)) visit(at);
}

std::string allText(const pugi::xml_node& node) {
  std::string text;
  forEachBelow(node, [&](const pugi::xml_node& at) {
    if (at.type() == pugi::node_pcdata || at.type() == pugi::node_cdata) text += at.value();
  });
  return text;
}

XmlText::XmlText(const SourceFile& file, SyntaxSink& sink, std::initializer_list<std::string_view> restart)
    : file_(file), sink_(sink) {
  parse(0, static_cast<std::uint32_t>(file.text().size()), true, restart);
  if (declaresEntities()) {
    parts_.clear();
  } else {
    refuseWhatFollows();
    refuseDepth();
  }
}

void XmlText::parse(std::uint32_t begin, std::uint32_t end, bool isWhole,
                    std::initializer_list<std::string_view> restart) {
  const std::string_view text = file_.text();
  Part part{std::make_unique<pugi::xml_document>(), begin, false};
  const pugi::xml_parse_result result =
      part.document->load_buffer(text.data() + begin, end - begin, parseFlags, pugi::encoding_utf8);
  part.isDamaged = result.status != pugi::status_ok;
  if (result.status == pugi::status_ok && !part.document->first_child()) return;
  const auto at = static_cast<std::uint32_t>(std::clamp<std::ptrdiff_t>(result.offset, 0, end - begin)) + begin;
  parts_.push_back(std::move(part));
  makeVisible(parts_.back());
  if (result.status == pugi::status_ok) return;
  sink_.report(Syntax::XmlDamaged, sink_.span(at, std::min<std::size_t>(at + 1, text.size())),
               fmt::format("{}; reading goes on at the next block", reasonOf(result.status)));
  if (!isWhole) return;
  // Blocks behind the damage, each for itself: every character is parsed at most once more.
  std::size_t from = at;
  while (true) {
    std::size_t next = std::string_view::npos;
    std::string_view name;
    for (const std::string_view candidate : restart) {
      std::size_t found = text.find(fmt::format("<{} ", candidate), from);
      if (found < next) {
        next = found;
        name = candidate;
      }
    }
    if (next == std::string_view::npos) return;
    const std::string close = fmt::format("</{}>", name);
    const std::size_t closing = text.find(close, next);
    const std::size_t stop = closing == std::string_view::npos ? text.size() : closing + close.size();
    parse(static_cast<std::uint32_t>(next), static_cast<std::uint32_t>(stop), false, restart);
    from = stop;
  }
}

void XmlText::makeVisible(const Part& part) {
  forEachBelow(*part.document, [&](pugi::xml_node node) {
    // A comment or a list of statements has lines; a name has one.
    const bool isName = node.type() != pugi::node_element && localName(node.parent()).ends_with("Name");
    bool isForbidden = hasControls(node.value());
    if (isForbidden || (isName && hasLines(node.value()))) node.set_value(withBlanks(node.value(), isName).c_str());
    for (pugi::xml_attribute attribute : node.attributes()) {
      if (!hasControls(attribute.value()) && !hasLines(attribute.value())) continue;
      isForbidden = isForbidden || hasControls(attribute.value());
      attribute.set_value(withBlanks(attribute.value(), true).c_str());
    }
    if (!isForbidden || saysControls_) return;
    saysControls_ = true;
    sink_.report(Syntax::ControlCharacters, span(part, node),
                 "XML has no such control character; it is read as a blank");
  });
}

bool XmlText::declaresEntities() {
  for (const Part& part : parts_) {
    for (const pugi::xml_node& node : part.document->children()) {
      if (node.type() != pugi::node_doctype ||
          std::string_view(node.value()).find("<!ENTITY") == std::string_view::npos)
        continue;
      sink_.report(Syntax::XmlEntities, span(part, node), "the document type declares entities; the file is not read");
      return true;
    }
  }
  return false;
}

/// A document has one element; what stands beside it belongs to nothing and is not read.
void XmlText::refuseWhatFollows() {
  if (parts_.empty() || parts_.front().isDamaged) return;
  const Part& whole = parts_.front();
  bool isThere = false;
  for (pugi::xml_node node = whole.document->first_child(), next; node; node = next) {
    next = node.next_sibling();
    const bool isElement = node.type() == pugi::node_element;
    const bool isText = node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
    if ((isElement && !isThere) || (!isElement && !isText)) {
      isThere = isThere || isElement;
      continue;
    }
    sink_.report(Syntax::XmlDamaged, span(whole, node),
                 isElement ? fmt::format("<{}> stands behind the end of the document and is not read", node.name())
                           : std::string("text stands outside the document and is not read"));
    whole.document->remove_child(node);
  }
}

/// Cuts off what is nested too deeply, so that nobody behind has to think of the depth of a tree.
void XmlText::refuseDepth() {
  for (const Part& part : parts_) {
    pugi::xml_node at = part.document->first_child();
    int depth = 1;
    while (at) {
      if (depth > deepestXml) {
        sink_.report(
            Syntax::XmlTooDeep, span(part, at),
            fmt::format("elements are nested more than {} deep; the rest of this branch is left out", deepestXml));
        pugi::xml_node parent = at.parent();
        // Renamed, not removed: taking a deep tree apart recurses.
        parent.set_name("too-deep");
        at = parent;
        --depth;
      } else if (at.first_child() && std::string_view(at.name()) != "too-deep") {
        at = at.first_child();
        ++depth;
        continue;
      }
      while (at && !at.next_sibling()) {
        at = at.parent();
        --depth;
      }
      if (at) at = at.next_sibling();
    }
  }
}

Span XmlText::span(const Part& part, const pugi::xml_node& node) const {
  const std::ptrdiff_t inPart = node.offset_debug();
  const std::string_view text = file_.text();
  if (inPart < 0) return {sink_.file(), part.base, 0};
  std::size_t offset = part.base + static_cast<std::size_t>(inPart);
  if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata || node.type() == pugi::node_comment) {
    return sink_.span(offset, std::min(offset + std::string_view(node.value()).size(), text.size()));
  }
  if (offset > 0 && node.type() == pugi::node_element) --offset;
  const std::size_t end = std::min(text.find('>', offset), text.size() - 1);
  return sink_.span(offset, end + 1);
}

}  // namespace rungproof
