/* Small figures as SVG, for documents: a page with frames in it, axes with round numbers, lines, bars, marks and a
 * legend. Everything is placed in pixels of the page; `Axis` converts values to them. Light and dark by the reader's
 * choice. */
#ifndef HAWSER_IO_REPORT_SVG_H
#define HAWSER_IO_REPORT_SVG_H

#include "io/report/text.h"

/* Styles: the colours can be told apart by readers with red-green blindness. */
typedef enum SvgStyle {
    SVG_FIRST,
    SVG_SECOND,
    SVG_THIRD,
    SVG_FOURTH,
    SVG_PALE,
    SVG_LIMIT,
    SVG_GREY,
    SVG_STYLES
} SvgStyle;

typedef struct Axis {
    double from, to;   /* values at both ends */
    double at, length; /* pixels: position of `from`, and distance to `to`; upward axes have a negative length */
    const char *label; /* with its unit */
} Axis;

typedef struct Svg {
    Text out;
    double width, height;
    double legend_x, legend_y; /* place of the next entry */
} Svg;

void svg_begin(Svg *svg, double width, double height, const char *title);
void svg_end(Svg *svg);
/* Ends the figure, moves it into a page and frees it. */
void svg_into(Svg *svg, Text *page);
/* Extends a range of least and largest by the finite ones of n values. */
void range_grow(double range[2], long n, const double *value);
double axis_pixel(const Axis *axis, double value);
/* Chooses the smallest range that holds from..to, with some space at the ends that are not 0. */
void axis_fit(Axis *axis, double from, double to);
/* Fits the axes of a plan to its ranges in x and y, with one scale for both: `wide` pixels from `left`, at most `most`
 * high below `top`. */
void axes_to_scale(double left, double wide, double top, double most, const double range_x[2], const double range_y[2],
                   Axis *x, Axis *y);
/* Draws a frame with grid, numbers and labels. */
void svg_frame(Svg *svg, const Axis *x, const Axis *y);
/* Draws lines, which break where a value is not finite; more points than pixels are thinned to the least and largest of
 * each pixel. */
void svg_line(Svg *svg, const Axis *x, const Axis *y, int n, const double *xs, const double *ys, SvgStyle style);
/* Draws a small circle at each point. */
void svg_marks(Svg *svg, const Axis *x, const Axis *y, int n, const double *xs, const double *ys, SvgStyle style);
/* Writes small text that begins at a place in pixels. */
void svg_words(Svg *svg, double x, double y, const char *words);
/* Draws an arrow's head at a point, in the direction (dx, dy); nothing for a zero length. */
void svg_arrow(Svg *svg, const Axis *x, const Axis *y, double u, double v, double dx, double dy, SvgStyle style);
/* Draws a bar of a round length of the axis, about a fifth of it, that ends at `right`, with its length above it. */
void svg_scale(Svg *svg, const Axis *x, double right, double y, const char *unit);
/* Draws an arrow about a place in pixels that points to north, `angle` (rad) from x toward y, with its word in the
 * middle of its foot. */
void svg_north(Svg *svg, double x, double y, double angle, const char *word);
/* Draws bars from 0, `width` in pixels, shifted to the side by `shift`. */
void svg_bars(Svg *svg, const Axis *x, const Axis *y, int n, const double *xs, const double *ys, double width,
              double shift, SvgStyle style);
/* Draws a line from end to end at a value, with text above its end; across: at a value of x, from top to bottom. */
void svg_level(Svg *svg, const Axis *x, const Axis *y, double value, const char *words, SvgStyle style);
void svg_across(Svg *svg, const Axis *x, const Axis *y, double value, const char *words);
/* Shades a stretch of the frame. */
void svg_shade(Svg *svg, const Axis *x, const Axis *y, double from, double to, const char *words);
void svg_legend_at(Svg *svg, double x, double y);
void svg_legend(Svg *svg, const char *words, SvgStyle style, int bar);

#endif
