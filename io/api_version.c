#include "hawser/hawser.h"

#include <stdlib.h>

const char *hawser_version(void) { return HAWSER_VERSION; }

void hawser_text_free(char *text) { free(text); }
