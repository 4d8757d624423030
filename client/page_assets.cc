#include "client/page_assets.h"

// The assembler puts the files into the program: a literal of half a megabyte takes a compiler long.
__asm__(
    ".pushsection .rodata\n"
    "tilemend_page_script:\n.incbin \"" TILEMEND_WEB_DIST
    "/report.js\"\ntilemend_page_script_end:\n"
    "tilemend_page_style:\n.incbin \"" TILEMEND_WEB_DIST
    "/report.css\"\ntilemend_page_style_end:\n"
    ".global tilemend_page_script, tilemend_page_script_end, tilemend_page_style, tilemend_page_style_end\n"
    ".popsection\n");

extern "C" {
extern const char tilemend_page_script[], tilemend_page_script_end[];
extern const char tilemend_page_style[], tilemend_page_style_end[];
}

namespace tilemend {

std::string_view PageScript() {
  return {tilemend_page_script, static_cast<size_t>(tilemend_page_script_end - tilemend_page_script)};
}

std::string_view PageStyle() {
  return {tilemend_page_style, static_cast<size_t>(tilemend_page_style_end - tilemend_page_style)};
}

}  // namespace tilemend
