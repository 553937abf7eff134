#include "def/command_def.h"

#include <stddef.h>

#define COMMAND_ROW(...)              {__VA_ARGS__},
#define COMMAND_WORD(kind, word, ...) word,
const CommandKind command_kinds[COMMAND_KINDS] = {COMMANDS(COMMAND_ROW)};
const char *const command_words[] = {COMMANDS(COMMAND_WORD) NULL};

const CommandKind *command_kind(int kind)
{
    for (int k = 0; k < COMMAND_KINDS; ++k) {
        if (command_kinds[k].kind == kind) return &command_kinds[k];
    }
    return NULL;
}
