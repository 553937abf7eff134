// Links a figure with all others through the store: the pointer, the arrow keys, and what other figures and the 3-D view point at.
import type { Store } from '../state';
import { nearest } from './align';
import type { Plot } from './plot';
import type { FigureSpec } from './spec';

/** Where the store points, along the figure's first axis; null if nowhere. */
export function pointedAt(spec: FigureSpec, store: Store): number | null {
  if (spec.along === 'place') return store.get('place');
  const time = store.get('time');
  if (spec.along === 'time' || time === null) return time;
  return spec.clock ? nearest(spec.clock.time, spec.clock.head, time) : null;
}

/** Tells the store that the reader points at x of this figure. */
export function pointAt(spec: FigureSpec, store: Store, x: number | null, source: unknown): void {
  if (spec.along === 'place') store.set('place', x, source);
  else if (x !== null && spec.along === 'time') store.set('time', x, source);
  else if (spec.along === 'head') {
    store.set('place', x, source);
    const time = x === null || !spec.clock ? null : nearest(spec.clock.head, spec.clock.time, x);
    if (time !== null) store.set('time', time, source);
  }
}

/** Moves the plot's cursor to x (SI) without telling anyone; null takes it away. */
export function showCursor(plot: Plot, x: number | null): void {
  const { chart, xScale } = plot;
  const left = x === null ? -10 : chart.valToPos(x * xScale.factor, 'x');
  const inside = left >= 0 && left <= chart.over.clientWidth;
  chart.setCursor({ left: inside ? left : -10, top: inside ? 10 : -10 }, false);
}

/** The part of the axis after a zoom by a factor about x, kept within the data. */
export function zoomed(
  view: [number, number],
  reach: [number, number],
  about: number,
  factor: number,
): [number, number] {
  const from = Math.max(reach[0], about - (about - view[0]) * factor);
  const to = Math.min(reach[1], about + (view[1] - about) * factor);
  return to - from < (reach[1] - reach[0]) * 1e-4 ? view : [from, to];
}

export interface Keys {
  view: () => [number, number];
  reach: () => [number, number];
  cursor: () => number | null;
  move: (x: number) => void;
  zoom: (range: [number, number]) => void;
}

/** Arrow keys move the cursor (with Shift ten times as far), + and - zoom about it, 0 shows all, Escape takes the cursor away. */
export function onKey(event: KeyboardEvent, keys: Keys): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const view = keys.view();
  const at = keys.cursor() ?? (view[0] + view[1]) / 2;
  const step = ((view[1] - view[0]) / 100) * (event.shiftKey ? 10 : 1);
  const within = (x: number): number => Math.min(view[1], Math.max(view[0], x));
  const actions: Record<string, () => void> = {
    ArrowLeft: () => keys.move(within(at - step)),
    ArrowRight: () => keys.move(within(at + step)),
    Home: () => keys.move(view[0]),
    End: () => keys.move(view[1]),
    '+': () => keys.zoom(zoomed(view, keys.reach(), within(at), 0.5)),
    '=': () => keys.zoom(zoomed(view, keys.reach(), within(at), 0.5)),
    '-': () => keys.zoom(zoomed(view, keys.reach(), within(at), 2)),
    '0': () => keys.zoom(keys.reach()),
  };
  const action = actions[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}
