#include "hawser/hawser.h"

#include <stdlib.h>

/* The version is the build's, see CMakeLists.txt. */
const char *hawser_version(void) { return HAWSER_VERSION; }

/* Texts may come from another C library's heap than the caller's: they are given back where they were made. */
void hawser_text_free(char *text) { free(text); }
