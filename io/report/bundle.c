/* Files of web/dist as read-only data, included by the assembler, so that neither gcc nor clang has to compile half a
 * million numbers. io/CMakeLists.txt gives their places and the script's hash, and builds again when they change. */
#include "io/report/report.h"

#define EMBED(name, file)                                                                                              \
    __asm__(".pushsection .rodata\n"                                                                                   \
            "report_" #name ":\n"                                                                                      \
            ".incbin \"" file "\"\n"                                                                                   \
            "report_" #name "_end:\n"                                                                                  \
            ".byte 0\n"                                                                                                \
            ".popsection\n");                                                                                          \
    extern const char report_##name[] __attribute__((visibility("hidden")));                                           \
    extern const char report_##name##_end[] __attribute__((visibility("hidden")))

EMBED(script, HAWSER_WEB_SCRIPT);
EMBED(style, HAWSER_WEB_STYLE);

Bundle bundle_script(void) { return (Bundle){report_script, (size_t)(report_script_end - report_script)}; }
Bundle bundle_style(void) { return (Bundle){report_style, (size_t)(report_style_end - report_style)}; }

static unsigned digit(char c) { return (unsigned)(c <= '9' ? c - '0' : c - 'a' + 10); }

void bundle_script_sum(unsigned char sum[32])
{
    static const char hex[] = HAWSER_WEB_SCRIPT_SUM;
    for (int k = 0; k < 32; k++) sum[k] = (unsigned char)(16 * digit(hex[2 * k]) + digit(hex[2 * k + 1]));
}
