// How pages look, on screen from 400 pixels up and on A4 through the browser's print, and what buttons do. A page
// without scripts shows everything. Looked at by eye; tests/page/browser_test.cpp opens pages in a browser where there
// is one.
#pragma once

#include <string_view>

namespace rungproof {

/// Rules for everything but drawings of networks (svgStyle()).
std::string_view pageStyle();
/// Steps through the scans of each run by buttons and arrow keys.
std::string_view pageScript();

}  // namespace rungproof
