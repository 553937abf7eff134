/* The smallest program against an installed hawser: that its functions link, run and report a wrong case. */
#include <hawser/hawser.h>
#include <stdio.h>
#include <string.h>

int main(void)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_case *wrong = NULL;
    hawser_status status = hawser_case_parse("cables: 3\n", "wrong.yaml", &wrong, &err);
    if (status == HAWSER_OK) status = hawser_case_check(wrong, &err);
    hawser_case_free(wrong);
    if (status != HAWSER_ERR_INPUT || strstr(err.message, "wrong.yaml") == NULL) {
        fprintf(stderr, "consumer: status %d, message '%s'\n", (int)status, err.message);
        return 1;
    }
    puts(hawser_version());
    return 0;
}
