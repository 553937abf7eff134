/* What is built into the library: the page's program and its style, web/dist/report.js and report.css. */
#ifndef HAWSER_IO_REPORT_BUNDLE_H
#define HAWSER_IO_REPORT_BUNDLE_H

#include <stddef.h>

typedef struct Bundle {
    const char *at;
    size_t size;
} Bundle;

Bundle bundle_script(void);
Bundle bundle_style(void);
/* The SHA-256 of the script, of which the page allows no other to run; 32 bytes into `sum`. */
void bundle_script_sum(unsigned char sum[32]);

#endif
