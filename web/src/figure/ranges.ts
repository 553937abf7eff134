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

/** Range of the second axis for values from least to largest: with what is allowed, from 0 where that is asked for, and some room; SI. */
export function roomy(spec: FigureSpec, least: number, largest: number): [number, number] {
  const all = [least, largest, ...levelsShown(spec).map(({ value }) => value), ...(spec.fromZero === false ? [] : [0])];
  const short = Math.max(0, (spec.span ?? 0) - (Math.max(...all) - Math.min(...all))) / 2;
  const [low, high] = [Math.min(...all) - short, Math.max(...all) + short];
  const room = (high - low || Math.abs(high) || 1) * 0.06;
  return [low === 0 ? 0 : low - room, high === 0 && low < 0 ? 0 : high + room];
}

/** Least and largest shown value over the part of the first axis from..to; [0, 1] if there is none. */
export function shownExtent(aligned: Aligned, from: number, to: number, hidden: Set<number>): [number, number] {
  const inside = (_: unknown, i: number): boolean => (aligned.x[i] as number) >= from && (aligned.x[i] as number) <= to;
  const found = aligned.y.flatMap((values, curve) => (hidden.has(curve) ? [] : (extent(values.filter(inside)) ?? [])));
  return extent(found) ?? [0, 1];
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
