// XML as the graphical formats need it: a tree whose nodes know their byte in the source text, errors with a place,
// and as much of a damaged file as can be saved: what stands before the damage, and every later element of the kinds
// that stand alone (a block). Entities are not expanded; a document type that declares some is refused.
// Tested by tests/graphical/damage_test.cpp.
#pragma once

#include <initializer_list>
#include <memory>
#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "frontend/stl/syntax_sink.hpp"

namespace rungproof {

/// Elements inside elements that are still read; real exports stay below 40.
inline constexpr int deepestXml = 256;

class XmlText {
 public:
  /// Parses the whole text. Errors go to the sink. `restart`: names of elements at which reading goes on behind damage.
  XmlText(const SourceFile& file, SyntaxSink& sink, std::initializer_list<std::string_view> restart);

  struct Part {
    std::unique_ptr<pugi::xml_document> document;
    std::uint32_t base = 0;  ///< offset of the part in the file
    bool isDamaged = false;  ///< the last block of it may be cut off
  };
  /// The whole document, then the blocks that were saved behind damage. Empty if nothing could be read.
  const std::vector<Part>& parts() const { return parts_; }

  /// The start tag of an element; characters and comments: their text.
  Span span(const Part& part, const pugi::xml_node& node) const;

 private:
  void parse(std::uint32_t begin, std::uint32_t end, bool isWhole, std::initializer_list<std::string_view> restart);
  void makeVisible(const Part& part);
  bool declaresEntities();
  void refuseWhatFollows();
  void refuseDepth();

  const SourceFile& file_;
  SyntaxSink& sink_;
  std::vector<Part> parts_;
  bool saysControls_ = false;  ///< once a file is enough
};

/// Whether the text looks like XML: its first character that is not blank is '<'.
bool looksLikeXml(std::string_view text);

/// First child with that name, whatever its namespace prefix ("xhtml:p" is found as "p").
pugi::xml_node childNamed(const pugi::xml_node& node, std::string_view name);
/// The name without its namespace prefix.
std::string_view localName(const pugi::xml_node& node);
/// The node behind `at` in the order of the document within `root`, without recursion; children of `at` only if it
/// `descends`. Empty at the end.
pugi::xml_node nextWithin(const pugi::xml_node& root, pugi::xml_node at, bool descends);
/// Everything below a node in the order of the text, without recursion, as damaged files nest to any depth.
void forEachBelow(const pugi::xml_node& node, const std::function<void(const pugi::xml_node&)>& visit);
/// All characters below a node, in order.
std::string allText(const pugi::xml_node& node);

}  // namespace rungproof
