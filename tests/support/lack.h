/* Memory that runs out: the k-th allocation fails. lack.c, in each folder's test program, replaces the C library's
 * allocating functions; not under sanitizers, whose they are. */
#ifndef HAWSER_TESTS_SUPPORT_LACK_H
#define HAWSER_TESTS_SUPPORT_LACK_H

/* 0: this build cannot make allocations fail, and the counts below stay 0. */
int lack_works(void);
/* Blocks that have been allocated and not been freed: the same before and after what leaves nothing behind. */
long lack_live(void);
/* Allocations so far. */
long lack_calls(void);

/* From now on `count` allocations succeed and the one after them fails; below 0: none fails. */
void lack_after(long count);
/* What is left of that count. */
long lack_left(void);
/* Whether the allocation that was to fail has been made; and none fails any more. */
int lack_end(void);

#endif
