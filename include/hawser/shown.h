/* Figures in units for readers: part of hawser/hawser.h, which includes it. The library computes, keeps and writes SI;
 * these functions alone convert it to what a terminal shows. */
#ifndef HAWSER_SHOWN_H
#define HAWSER_SHOWN_H

#include <stddef.h>

#include "hawser/tables.h"

#ifdef __cplusplus
extern "C" {
#endif

/* SI: N and kN, m and mm, N/m, kg, mm2. US: lbf and kip, ft and in, lbf/ft, lb, kcmil and AWG, psi and ksi. */
typedef enum hawser_units { HAWSER_SI, HAWSER_US } hawser_units;

enum { HAWSER_SHOWN_MAX = 48 };

/* Writes a value of an SI unit ("N", "N/m", "m"; "1": a pure number) in four digits with a unit that suits its size:
 * "12.83 kN". An infinite one is "none", an unknown one "-". Returns `text` (HAWSER_SHOWN_MAX bytes). */
const char *hawser_show(double value, const char *unit, hawser_units units, char *text);
/* Writes a machine's figure, whose key ends in its unit: "steady_mean_N" becomes "steady mean 12.83 kN". `text` has
 * twice HAWSER_SHOWN_MAX bytes. Returns `text`. */
const char *hawser_show_figure(const hawser_figure *figure, hawser_units units, char *text);
/* Writes a sentence with every quantity of an SI unit ("0.5 to 1 kN/m", "800 mm2") converted to `units`, with as many
 * digits as it has and at least three; for SI the sentence itself. At most `size` bytes. Returns `text`. */
const char *hawser_show_text(const char *sentence, hawser_units units, char *text, size_t size);

/* Returns which of the n known words was probably meant: up to two letters, and a third of the word's, may be wrong;
 * one that differs in capitals alone is always near. NULL if none is near, or if there is no word. */
const char *hawser_nearest(const char *word, const char *const *known, int n);

struct hawser_sim;

/* Writes the beginning of a report: a line with the verdict, then its reasons, each line " word sentence": the pull
 * against its limit, the worst place, a remedy for each broken limit, and whether the figures can be trusted. At most
 * `size` bytes (HAWSER_ANSWER_MAX is enough). Returns `text`. */
enum { HAWSER_ANSWER_MAX = 8192 };
const char *hawser_sim_answer(struct hawser_sim *s, hawser_units units, char *text, size_t size);

#ifdef __cplusplus
}
#endif

#endif
