// The guide as a folder of HTML pages without outside references: chapters written by hand, and pages made from the
// tables of the program, so that they are never behind. Tested by tests/guide.
#pragma once

#include <vector>

#include "frontend/guide/man_page.hpp"

namespace rungproof {

/// All pages; index.html is the first.
std::vector<GuideFile> guidePages();

/// Patterns of the property language, each with a run that breaks it (of `reach`: that comes there), as XHTML. The runs
/// are found by the prover on small programs.
std::string patternSection();

/// A page made from tables: its name, title and XHTML.
struct ReferencePage {
  std::string name, title, html;
};
std::vector<ReferencePage> referencePages();

}  // namespace rungproof
