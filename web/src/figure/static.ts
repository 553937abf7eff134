// A figure on paper: the same specification as a drawing of lines, sharp at any size, in the colours for white paper.
import { svg } from '../dom';
import type { UnitSystem } from '../state';
import { align, extent, type Aligned } from './align';
import { DASH, palette, WIDTH } from './palette';
import { axisLabel, scalesOf } from './plot';
import { levelsShown, roomy, shownExtent, tickLabels, ticks } from './ranges';
import type { FigureSpec } from './spec';

const WIDE = 680;
const HIGH = 250;
const LEFT = 58;
const RIGHT = 12;
const TOP = 16;
const BOTTOM = 40;
const INK = palette('light');

type Map1 = (value: number) => number;

/** Lines of a curve as path data: a new piece after every gap, points that fall on the pixel of their neighbour left out. */
function pathOf(aligned: Aligned, curve: number, from: number, to: number, px: Map1, py: Map1): string {
  let path = '';
  let pen = false;
  let lastX = NaN;
  let lastY = NaN;
  aligned.x.forEach((x, i) => {
    const y = aligned.y[curve]?.[i];
    if (y === undefined || x < from || x > to) return;
    if (y === null) {
      pen = false;
      return;
    }
    const [at, up] = [px(x), py(y)];
    if (pen && Math.abs(at - lastX) < 0.25 && Math.abs(up - lastY) < 0.25) return;
    path += `${pen ? 'L' : 'M'}${at.toFixed(1)} ${up.toFixed(1)}`;
    [pen, lastX, lastY] = [true, at, up];
  });
  return path;
}

/** The area between two curves that have their points at the same places. */
function bandOf(aligned: Aligned, low: number, high: number, px: Map1, py: Map1): string {
  const there = aligned.x.map((x, i) => ({ x, low: aligned.y[low]?.[i], high: aligned.y[high]?.[i] }));
  const known = there.filter((p) => typeof p.low === 'number' && typeof p.high === 'number');
  if (known.length < 2) return '';
  const upper = known.map((p) => `${px(p.x).toFixed(1)} ${py(p.high as number).toFixed(1)}`);
  const lower = known.reverse().map((p) => `${px(p.x).toFixed(1)} ${py(p.low as number).toFixed(1)}`);
  return `M${upper.join('L')}L${lower.join('L')}Z`;
}

function text(x: number, y: number, content: string, anchor: string, fill = INK.muted): SVGTextElement {
  return svg('text', { x, y, 'text-anchor': anchor, fill, 'font-size': 11 }, content);
}

function grid(
  spec: FigureSpec,
  units: UnitSystem,
  x: [number, number],
  y: [number, number],
  px: Map1,
  py: Map1,
): Node[] {
  const { xScale, yScale } = scalesOf(spec, units);
  const nodes: Node[] = [];
  const xs = ticks(x[0] * xScale.factor, x[1] * xScale.factor, 8);
  const ys = ticks(y[0] * yScale.factor, y[1] * yScale.factor, 5);
  tickLabels(xs).forEach((label, i) => {
    const at = px((xs[i] as number) / xScale.factor);
    nodes.push(svg('path', { d: `M${at} ${TOP}V${HIGH - BOTTOM}`, stroke: INK.grid }));
    nodes.push(text(at, HIGH - BOTTOM + 14, label, 'middle'));
  });
  tickLabels(ys).forEach((label, i) => {
    const at = py((ys[i] as number) / yScale.factor);
    nodes.push(svg('path', { d: `M${LEFT} ${at}H${WIDE - RIGHT}`, stroke: INK.grid }));
    nodes.push(text(LEFT - 6, at + 4, label, 'end'));
  });
  nodes.push(text((LEFT + WIDE - RIGHT) / 2, HIGH - 6, axisLabel(spec.xLabel, xScale), 'middle'));
  const label = text(0, 0, axisLabel(spec.yLabel, yScale), 'middle');
  label.setAttribute('transform', `translate(12 ${(TOP + HIGH - BOTTOM) / 2}) rotate(-90)`);
  nodes.push(label);
  return nodes;
}

/** The drawing; zoom and hidden curves as on the screen. */
export function drawStatic(
  spec: FigureSpec,
  units: UnitSystem,
  zoom: [number, number] | null,
  hidden: Set<number>,
): SVGSVGElement {
  const aligned = align(spec.curves);
  const x = zoom ?? extent(aligned.x) ?? [0, 1];
  const y = roomy(spec, ...shownExtent(aligned, x[0], x[1], hidden));
  const px: Map1 = (value) => LEFT + ((value - x[0]) / (x[1] - x[0] || 1)) * (WIDE - LEFT - RIGHT);
  const py: Map1 = (value) => HIGH - BOTTOM - ((value - y[0]) / (y[1] - y[0] || 1)) * (HIGH - TOP - BOTTOM);
  const clip = `clip-${spec.id}`;
  const area = { x: LEFT, y: TOP, width: WIDE - LEFT - RIGHT, height: HIGH - TOP - BOTTOM };
  const nodes = grid(spec, units, x, y, px, py);
  const inside = svg('g', { 'clip-path': `url(#${clip})`, fill: 'none' });
  if (spec.window) {
    const from = px(spec.window.from);
    inside.append(
      svg('rect', {
        x: from,
        y: TOP,
        width: Math.max(0, px(spec.window.to) - from),
        height: area.height,
        fill: INK.window,
      }),
    );
  }
  if (spec.band)
    inside.append(svg('path', { d: bandOf(aligned, spec.band.low, spec.band.high, px, py), fill: INK.band }));
  spec.curves.forEach((curve, i) => {
    if (hidden.has(i)) return;
    const stroke = INK.curve[curve.role];
    if (curve.points) {
      curve.x.forEach((at, k) => {
        const up = curve.y[k];
        if (at === null || up === null || up === undefined) return;
        inside.append(svg('circle', { cx: px(at), cy: py(up), r: 2.4, fill: INK.paper, stroke }));
      });
      return;
    }
    const dash = DASH[curve.role].join(' ') || null;
    const d = pathOf(aligned, i, x[0], x[1], px, py);
    inside.append(svg('path', { d, stroke, 'stroke-width': WIDTH[curve.role] * 0.75, 'stroke-dasharray': dash }));
  });
  for (const { value } of levelsShown(spec)) {
    inside.append(svg('path', { d: `M${LEFT} ${py(value)}H${WIDE - RIGHT}`, stroke: INK.limit, 'stroke-width': 1.5 }));
  }
  (spec.events ?? []).forEach((event, i) => {
    if (event.x < x[0] || event.x > x[1]) return;
    inside.append(
      svg('path', { d: `M${px(event.x)} ${TOP}V${HIGH - BOTTOM}`, stroke: INK.event, 'stroke-dasharray': '2 3' }),
    );
    nodes.push(text(px(event.x), TOP - 4, String(i + 1), 'middle', INK.event));
  });
  const box = { viewBox: `0 0 ${WIDE} ${HIGH}`, class: 'paper-figure', role: 'img', 'aria-label': spec.title };
  return svg('svg', box, svg('clipPath', { id: clip }, svg('rect', area)), ...nodes, inside);
}
