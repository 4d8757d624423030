#include "coordinator/web/page_assets.h"

// The assembler puts the files into the program: a literal of a quarter of a megabyte takes a compiler long.
__asm__(
    ".pushsection .rodata\n"
    "tilemend_console_script:\n.incbin \"" TILEMEND_WEB_GZIP
    "/console.js.gz\"\ntilemend_console_script_end:\n"
    "tilemend_console_style:\n.incbin \"" TILEMEND_WEB_GZIP
    "/console.css.gz\"\ntilemend_console_style_end:\n"
    "tilemend_draco_decoder:\n.incbin \"" TILEMEND_WEB_GZIP
    "/draco_decoder.js.gz\"\ntilemend_draco_decoder_end:\n"
    ".global tilemend_console_script, tilemend_console_script_end, tilemend_console_style, tilemend_console_style_end\n"
    ".global tilemend_draco_decoder, tilemend_draco_decoder_end\n"
    ".popsection\n");

extern "C" {
extern const char tilemend_console_script[], tilemend_console_script_end[];
extern const char tilemend_console_style[], tilemend_console_style_end[];
extern const char tilemend_draco_decoder[], tilemend_draco_decoder_end[];
}

namespace tilemend {

std::string_view ConsoleScript() {
  return {tilemend_console_script, static_cast<size_t>(tilemend_console_script_end - tilemend_console_script)};
}

std::string_view ConsoleStyle() {
  return {tilemend_console_style, static_cast<size_t>(tilemend_console_style_end - tilemend_console_style)};
}

std::string_view DracoDecoder() {
  return {tilemend_draco_decoder, static_cast<size_t>(tilemend_draco_decoder_end - tilemend_draco_decoder)};
}

}  // namespace tilemend
