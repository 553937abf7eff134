// Small parts that several sections are made of.
import { el, svg } from '../dom';
import type { Value } from '../data';
import { csvTools, tableElement, type DataTable } from '../figure/table';
import type { Standing } from '../run';
import type { UnitSystem } from '../state';
import { scaleOf, show, type Unit } from '../units';

export function section(id: string, heading: string, ...children: (Node | null)[]): HTMLElement {
  const title = el('h2', { id: `${id}-heading` }, heading);
  return el('section', { id, 'aria-labelledby': `${id}-heading` }, title, ...children);
}

export function note(text: string): HTMLElement {
  return el('p', { class: 'note' }, text);
}

const SIGN: Record<Standing, string> = {
  safe: 'M6 12.5l4 4 8-9',
  conditional: 'M9 9.2c0-4.2 6.4-3.6 6 .2-.3 2.4-3 2.3-3 5M12 17.2v.6',
  unsafe: 'M7 7l10 10M17 7L7 17',
  untrusted: 'M12 6v8M12 17.2v.6',
  unjudged: 'M7 12h10',
};

/** A sign that tells the standings apart by its shape. */
export function sign(standing: Standing): SVGSVGElement {
  const circle = svg('circle', { cx: 12, cy: 12, r: 11, fill: 'currentColor' });
  const path = svg('path', {
    d: SIGN[standing],
    fill: 'none',
    stroke: 'var(--surface)',
    'stroke-width': 2.6,
    'stroke-linecap': 'round',
  });
  return svg('svg', { viewBox: '0 0 24 24', class: 'sign', 'aria-hidden': 'true' }, circle, path);
}

/** How much of what is allowed is used, as a bar with a mark at all of it; said in words beside it. */
export function usage(share: number, standing: Standing): HTMLElement {
  const full = 66;
  const width = Math.max(0, Math.min(1.5, share)) * full;
  const bar = svg('rect', { x: 0, y: 3, width, height: 8, class: 'bar', rx: 1 });
  const mark = svg('path', { d: `M${full} 0V14`, class: 'bar-limit' });
  const drawing = svg(
    'svg',
    { viewBox: '0 0 100 14', class: 'usage', 'aria-hidden': 'true', preserveAspectRatio: 'none' },
    bar,
    mark,
  );
  return el('span', { class: `usage-box ${standing}` }, drawing);
}

export interface Field {
  key: string;
  label: string;
  /** None: text. */
  unit?: Unit;
}

type Row = Record<string, Value | string | undefined>;

/** Records as a table in the chosen units, one scale a column, with its CSV. */
export function recordTable(id: string, caption: string, rows: Row[], fields: Field[], units: UnitSystem): HTMLElement {
  const used = fields.filter(({ key }) =>
    rows.some((row) => row[key] !== undefined && row[key] !== null && row[key] !== ''),
  );
  const scales = used.map(({ key, unit }) => {
    const sizes = rows.map((row) => (typeof row[key] === 'number' ? Math.abs(row[key]) : 0));
    return unit ? scaleOf(unit, units, Math.max(0, ...sizes)) : null;
  });
  const table: DataTable = {
    name: `hawser-${id}`,
    columns: used.map(({ label }, i) => ({ label, unit: scales[i]?.symbol ?? '' })),
    rows: rows.map((row) =>
      used.map(({ key }, i) => {
        const value = row[key];
        return typeof value === 'number' ? value * (scales[i]?.factor ?? 1) : value;
      }),
    ),
  };
  return el(
    'div',
    { class: 'record' },
    tableElement(table, caption),
    csvTools(() => table),
  );
}

/** A term and what is said of it, in a list of such. */
export function fact(term: string, text: string | Node, detail: string | Node = ''): HTMLElement {
  return el(
    'div',
    { class: 'fact' },
    el('dt', {}, term),
    el('dd', {}, text),
    detail ? el('dd', { class: 'detail' }, detail) : null,
  );
}

/** A value, and what it may be off by. */
export function withError(value: Value | undefined, error: Value | undefined, unit: Unit, units: UnitSystem): string {
  if (value === null || value === undefined || error === null || error === undefined || value === 0) return '';
  const share = show((100 * error) / Math.abs(value), '%', units, 2);
  return `± ${show(error, unit, units, 2)} (${share})`;
}
