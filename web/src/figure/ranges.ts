// From where to where the axes of a figure go, and what stands at them.
import { grouped } from '../units';
import type { Aligned } from './align';
import { extent } from './align';
import type { FigureSpec, Level } from './spec';

/** Levels up to this many times the largest value of the curves are in the figure; higher ones would flatten the curves. */
const LEVEL_REACH = 2.5;

/** The levels that stand within the figure; the others are named in its legend only. */
export function levelsShown(spec: FigureSpec): Level[] {
  const largest = Math.max(0, ...spec.curves.map((curve) => extent(curve.y)?.[1] ?? 0));
  return (spec.levels ?? []).filter(({ value }) => value <= LEVEL_REACH * largest || largest === 0);
}

/** Range of the second axis over the given part of the first, with room above and below; SI. */
export function rangeOfY(
  spec: FigureSpec,
  aligned: Aligned,
  from: number,
  to: number,
  hidden: Set<number>,
): [number, number] {
  let least = Infinity;
  let largest = -Infinity;
  aligned.y.forEach((values, curve) => {
    if (hidden.has(curve)) return;
    const found = extent(values.filter((_, i) => (aligned.x[i] as number) >= from && (aligned.x[i] as number) <= to));
    if (!found) return;
    least = Math.min(least, found[0]);
    largest = Math.max(largest, found[1]);
  });
  for (const { value } of levelsShown(spec)) {
    largest = Math.max(largest, value);
    least = Math.min(least, value);
  }
  if (least > largest) return [0, 1];
  if (spec.fromZero !== false) {
    least = Math.min(0, least);
    largest = Math.max(0, largest);
  }
  const room = (largest - least || Math.abs(largest) || 1) * 0.06;
  return [least === 0 ? 0 : least - room, largest === 0 ? 0 : largest + room];
}

/** Round numbers between two values, about as many as wanted. */
export function ticks(from: number, to: number, wanted: number): number[] {
  const span = to - from;
  if (!(span > 0)) return [from];
  const raw = span / Math.max(1, wanted);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((n) => n * power).find((n) => n >= raw * 0.999) ?? raw;
  const found: number[] = [];
  for (let i = Math.ceil(from / step - 1e-9); i * step <= to + 1e-9 * span; i += 1) found.push(i * step);
  return found;
}

/** Ticks as text, all with as many decimals as their step needs. */
export function tickLabels(values: number[]): string[] {
  const step = values.length > 1 ? Math.abs((values[1] as number) - (values[0] as number)) : 1;
  const places = Math.max(0, Math.min(8, -Math.floor(Math.log10(step) + 1e-9)));
  return values.map((value) => grouped(Math.abs(value) < step * 1e-6 ? '0' : value.toFixed(places)));
}
