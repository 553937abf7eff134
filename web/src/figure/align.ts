// Curves with points of their own on one common axis, and what a curve says at a place.
import type { Value } from '../data';
import type { Curve } from './spec';

export interface Aligned {
  x: number[];
  /** A list a curve; undefined where the curve has no point, null where its value is not known. */
  y: (Value | undefined)[][];
}

/** All points of all curves, ascending; of two points of a curve at one place the later counts. */
export function align(curves: Curve[]): Aligned {
  const known = new Set<number>();
  for (const curve of curves) for (const x of curve.x) if (x !== null && Number.isFinite(x)) known.add(x);
  const x = [...known].sort((a, b) => a - b);
  const index = new Map(x.map((value, i) => [value, i]));
  const y = curves.map((curve) => {
    const values = new Array<Value | undefined>(x.length).fill(undefined);
    curve.x.forEach((at, i) => {
      const to = at === null ? undefined : index.get(at);
      if (to !== undefined) values[to] = curve.y[i] ?? null;
    });
    return values;
  });
  return { x, y };
}

/** The last index whose x is at most the value; -1 if none is. x ascending. */
export function floorIndex(x: number[], value: number): number {
  let low = 0;
  let high = x.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((x[middle] as number) <= value) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Value of a curve of aligned data at x, linear between its points; null beyond them and across a gap. */
export function valueAt(x: number[], y: (Value | undefined)[], at: number): Value {
  let left = floorIndex(x, at);
  while (left >= 0 && y[left] === undefined) left -= 1;
  if (left < 0) return null;
  const from = y[left];
  if (from === null || from === undefined) return null;
  const x0 = x[left] as number;
  if (x0 === at) return from;
  let right = left + 1;
  while (right < x.length && y[right] === undefined) right += 1;
  const to = y[right];
  if (to === null || to === undefined) return null;
  return from + ((to - from) * (at - x0)) / ((x[right] as number) - x0);
}

/** y at the x nearest to the value, over pairs in any order; null if no pair is known. */
export function nearest(x: Value[], y: Value[], value: number): Value {
  let best: Value = null;
  let least = Infinity;
  x.forEach((at, i) => {
    const away = at === null ? Infinity : Math.abs(at - value);
    if (away < least && y[i] !== null && y[i] !== undefined) {
      least = away;
      best = y[i];
    }
  });
  return best;
}

/** Least and largest of what is known; null of nothing. */
export function extent(values: Iterable<Value | undefined>): [number, number] | null {
  let least = Infinity;
  let largest = -Infinity;
  for (const value of values) {
    if (value === null || value === undefined || !Number.isFinite(value)) continue;
    least = Math.min(least, value);
    largest = Math.max(largest, value);
  }
  return least > largest ? null : [least, largest];
}
