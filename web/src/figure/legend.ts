// The legend of a figure: what each curve is, its value at the cursor, and a button that hides it.
import { el, svg } from '../dom';
import type { Theme, UnitSystem } from '../state';
import { digits, show, type Scale } from '../units';
import { valueAt, type Aligned } from './align';
import { DASH, palette, WIDTH } from './palette';
import { levelsShown } from './ranges';
import { X_UNIT, type Curve, type FigureSpec } from './spec';

export interface Legend {
  element: HTMLElement;
  /** Shows the values at x (SI); null: none. */
  update(x: number | null): void;
  /** What the legend says at the cursor, in a sentence. */
  sentence(): string;
}

/** A short piece of the curve as it looks in the figure. */
function swatch(curve: Curve, theme: Theme): SVGSVGElement {
  const stroke = palette(theme).curve[curve.role];
  const mark = curve.points
    ? svg('circle', { cx: 13, cy: 6, r: 3, fill: palette(theme).paper, stroke, 'stroke-width': 1.5 })
    : svg('path', {
        d: 'M1 6H25',
        stroke,
        'stroke-width': WIDTH[curve.role],
        'stroke-dasharray': DASH[curve.role].join(' ') || null,
      });
  return svg('svg', { width: 26, height: 12, 'aria-hidden': 'true', class: 'swatch' }, mark);
}

function box(fill: string): SVGSVGElement {
  return svg(
    'svg',
    { width: 26, height: 12, 'aria-hidden': 'true', class: 'swatch' },
    svg('rect', { x: 2, y: 1, width: 22, height: 10, fill }),
  );
}

function rule(stroke: string): SVGSVGElement {
  return svg(
    'svg',
    { width: 26, height: 12, 'aria-hidden': 'true', class: 'swatch' },
    svg('path', { d: 'M1 6H25', stroke, 'stroke-width': 2 }),
  );
}

interface Options {
  theme: Theme;
  units: UnitSystem;
  hidden: Set<number>;
  onToggle: (index: number) => void;
}

export function makeLegend(spec: FigureSpec, aligned: Aligned, yScale: Scale, options: Options): Legend {
  const colours = palette(options.theme);
  const at = el('span', { class: 'legend-at' });
  const values: (HTMLElement | null)[] = [];
  const list = el('ul', { class: 'legend', 'aria-label': 'Curves' });
  spec.curves.forEach((curve, i) => {
    if (curve.quiet) {
      values.push(null);
      return;
    }
    const value = el('span', { class: 'legend-value' });
    values.push(value);
    const shown = !options.hidden.has(i);
    const toggle = el(
      'button',
      { type: 'button', class: 'legend-item', 'aria-pressed': String(shown), onclick: () => options.onToggle(i) },
      swatch(curve, options.theme),
      el('bdi', {}, curve.label),
    );
    list.append(el('li', {}, toggle, value));
  });
  if (spec.band) list.append(el('li', {}, el('span', { class: 'legend-item' }, box(colours.band), spec.band.label)));
  const within = new Set(levelsShown(spec));
  for (const level of spec.levels ?? []) {
    const beyond = within.has(level) ? '' : ' (above the figure)';
    const text = `${level.label}: ${show(level.value, spec.yUnit, options.units)}${beyond}`;
    list.append(el('li', {}, el('span', { class: 'legend-item' }, rule(colours.limit), text)));
  }
  if (spec.window) {
    list.append(el('li', {}, el('span', { class: 'legend-item' }, box(colours.window), spec.window.label)));
  }
  let said = '';
  return {
    element: el('div', { class: 'legend-row' }, list, at),
    update(x) {
      const parts: string[] = [];
      spec.curves.forEach((curve, i) => {
        const value = x === null ? null : valueAt(aligned.x, aligned.y[i] ?? [], x);
        const text = value === null ? '' : `${digits(value * yScale.factor)}\u00a0${yScale.symbol}`.trim();
        const cell = values[i];
        if (cell) cell.textContent = text;
        if (text && cell) parts.push(`${curve.label} ${text}`);
      });
      at.textContent = x === null ? '' : `at ${show(x, X_UNIT[spec.along], options.units)}`;
      said = x === null ? '' : `${at.textContent}: ${parts.join(', ') || 'nothing known'}`;
    },
    sentence: () => said,
  };
}
