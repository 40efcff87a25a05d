// The page as SVG: block headings, networks, pictures, statements and findings below each other.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/picture/network_view.hpp"
#include "frontend/picture/svg_picture.hpp"
#include "frontend/text/columns.hpp"
#include "frontend/text/excerpt.hpp"

namespace rungproof {

namespace {

constexpr int pageMargin = 16, lineHeight = 18, networkGap = 22;

/// Grows downwards; `y` is the next free place.
class Page {
 public:
  explicit Page(int least = 600) : width_(least) {}

  void line(std::string_view text, std::string_view className, int indent = 0) {
    appendSvgText(body_, pageMargin + indent, y_ + 13, text, className);
    y_ += lineHeight;
    const int letter = className == "rp" ? 12 : className == "rh" ? 10 : svgCellWidth;  // bold headings are wider
    width_ = std::max(width_, pageMargin * 2 + indent + displayWidth(text) * letter);
  }
  void gap(int height) { y_ += height; }
  void picture(const Picture& picture) {
    if (picture.height == 0) return;
    appendSvg(body_, picture, pageMargin, y_);
    y_ += picture.height * svgRowHeight;
    int columns = picture.width;
    for (const PictureLabel& label : picture.labels) columns = std::max(columns, label.x + displayWidth(label.text));
    width_ = std::max(width_, columns * svgCellWidth + 2 * pageMargin);
  }
  void content(const NetworkView& view) {
    if (!view.reason.empty()) line("shown as STL: " + view.reason, "rk");
    if (view.notExecuted) line("not executed in this scan", "rk");
    gap(4);
    picture(view.picture);
    for (const std::string& statement : view.statements) line(statement, "rt", 16);
    for (const ViewNote& note : view.notes) wrappedNote(note);
  }

  std::string document() const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
        "{1}\">\n<style>{2}</style>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{3}</svg>\n",
        width_, y_ + pageMargin, svgStyle(), body_);
  }
  /// Without style sheet, for a page that brings it.
  SizedSvg element() const {
    return {
        fmt::format("<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n{2}</svg>\n", width_, y_ + 4, body_),
        width_, y_ + 4};
  }

 private:
  void wrappedNote(const ViewNote& note) {
    constexpr std::string_view words[] = {"note ", "warning ", "error "};
    std::string text;
    appendParagraph(text, std::string(words[static_cast<std::size_t>(note.severity)]) + note.text, 0);
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      line(text.substr(0, end), "rt", 16);
      text.erase(0, end == std::string::npos ? end : end + 1);
    }
  }

  std::string body_;
  int y_ = pageMargin;
  int width_;
};

}  // namespace

std::string viewSvg(const std::vector<BlockView>& blocks) {
  Page page;
  for (const BlockView& block : blocks) {
    page.gap(6);
    page.line(block.heading, "rp");
    for (const NetworkView& view : block.networks) {
      page.gap(networkGap);
      page.line(view.heading, "rh");
      for (const std::string& comment : view.comments) page.line(comment, "rk");
      page.content(view);
    }
    page.gap(networkGap);
  }
  return page.document();
}

std::string pictureSvg(const NetworkView& view) {
  Page page;
  page.content(view);
  return page.element().element;
}

SizedSvg sizedSvg(const NetworkView& view) {
  Page page(0);
  page.content(view);
  return page.element();
}

}  // namespace rungproof
