// The program that hover, navigation and completion are asked about. Lines are counted from 0.
#pragma once

#include <string>

namespace rungproof::test {

inline const std::string press =
    /* 0 */
    "ORGANIZATION_BLOCK MAIN:OB1\n"
    /* 1 */
    "BEGIN\n"
    /* 2 */
    "Network 1 // Насос\n"
    /* 3 */
    "//@ prove never both: never Q0.0 and Q0.1\n"
    /* 4 */
    "LD I0.0 // grün\n"
    /* 5 */
    "AN Q0.1\n"
    /* 6 */
    "= Q0.0\n"
    /* 7 */
    "Network 2\n"
    /* 8 */
    "LD I0.1\n"
    /* 9 */
    "AN Q0.0\n"
    /* 10 */
    "= Q0.1\n"
    /* 11 */
    "Network 3 // delay\n"
    /* 12 */
    "LD I0.2\n"
    /* 13 */
    "TON T37, +100\n"
    /* 14 */
    "LD T37\n"
    /* 15 */
    "S M0.0, 1\n"
    /* 16 */
    "CALL SBR_0\n"
    /* 17 */
    "Network 4\n"
    /* 18 */
    "LD SM0.1\n"
    /* 19 */
    "JMP 3\n"
    /* 20 */
    "Network 5\n"
    /* 21 */
    "LBL 3\n"
    /* 22 */
    "END_ORGANIZATION_BLOCK\n"
    /* 23 */
    "SUBROUTINE_BLOCK SBR_0:SBR0\n"
    /* 24 */
    "BEGIN\n"
    /* 25 */
    "Network 1 // lamp\n"
    /* 26 */
    "LD M0.0\n"
    /* 27 */
    "= Q0.5\n"
    /* 28 */ "END_SUBROUTINE_BLOCK\n";

}  // namespace rungproof::test
