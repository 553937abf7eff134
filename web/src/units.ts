// What is shown in which unit: everything in the data is SI; a figure or a number is shown in a unit of its size and of the chosen system.
import type { Value } from './data';
import type { UnitSystem } from './state';

/** SI units of the data; 'mm' are lengths of a cross-section (diameters, clearances), in metres as all lengths. */
export type Unit = 'N' | 'N/m' | 'm' | 'mm' | 'm/s' | 's' | '1' | '%' | 'N m' | 'W' | 'rad/s' | '1/m';

export interface Scale {
  symbol: string;
  /** shown = factor * SI */
  factor: number;
}

const FOOT = 0.3048;
const POUND = 0.45359237 * 9.80665;

/** From the largest to the smallest: the first whose `from` the size reaches. */
const METRIC: Partial<Record<Unit, (Scale & { from: number })[]>> = {
  N: [
    { symbol: 'kN', factor: 1e-3, from: 1000 },
    { symbol: 'N', factor: 1, from: 0 },
  ],
  'N/m': [
    { symbol: 'kN/m', factor: 1e-3, from: 2000 },
    { symbol: 'N/m', factor: 1, from: 0 },
  ],
  mm: [{ symbol: 'mm', factor: 1e3, from: 0 }],
  'N m': [
    { symbol: 'kN m', factor: 1e-3, from: 10000 },
    { symbol: 'N m', factor: 1, from: 0 },
  ],
};

const US: Partial<Record<Unit, Scale>> = {
  N: { symbol: 'lbf', factor: 1 / POUND },
  'N/m': { symbol: 'lbf/ft', factor: FOOT / POUND },
  m: { symbol: 'ft', factor: 1 / FOOT },
  mm: { symbol: 'in', factor: 12 / FOOT },
  'm/s': { symbol: 'ft/min', factor: 60 / FOOT },
  'N m': { symbol: 'lbf ft', factor: 1 / (POUND * FOOT) },
  W: { symbol: 'ft lbf/s', factor: 1 / (POUND * FOOT) },
  '1/m': { symbol: '1/ft', factor: FOOT },
};

/** The unit in which values of this size (SI) are shown. */
export function scaleOf(unit: Unit, system: UnitSystem, size: number): Scale {
  const us = US[unit];
  if (system === 'us' && us) return us;
  const scales = METRIC[unit];
  const scale = scales?.find(({ from }) => Math.abs(size) >= from);
  if (scale) return { symbol: scale.symbol, factor: scale.factor };
  return { symbol: unit === '1' ? '' : unit, factor: 1 };
}

/** A number as text with a thin space between thousands, from 10 000 on, and a true minus. */
export function grouped(text: string): string {
  const [whole = '', part] = text.replace('-', '\u2212').split('.');
  const long = whole.replace(/\D/g, '').length > 4;
  const shown = long ? whole.replace(/\B(?=(\d{3})+$)/g, '\u202f') : whole;
  return part ? `${shown}.${part}` : shown;
}

/** Four significant digits, more only before the point; a thin space between thousands. */
export function digits(value: number, significant = 4): string {
  if (value === 0) return '0';
  const size = Math.floor(Math.log10(Math.abs(value)));
  if (size < -5 || size > 8) return value.toExponential(significant - 1);
  const places = Math.max(0, significant - 1 - size);
  const text = value.toFixed(Math.min(places, 12));
  return grouped(text.includes('.') ? text.replace(/\.?0+$/, '') : text);
}

export const UNKNOWN = 'not known';

/** A value with its unit; what is not known says so. */
export function show(value: Value | undefined, unit: Unit, system: UnitSystem, significant = 4): string {
  if (value === null || value === undefined || Number.isNaN(value)) return UNKNOWN;
  if (unit === '%') return `${digits(value, significant)}\u202f%`;
  const { symbol, factor } = scaleOf(unit, system, value);
  return symbol ? `${digits(value * factor, significant)}\u00a0${symbol}` : digits(value * factor, significant);
}

export function isUnit(text: string): text is Unit {
  return ['N', 'N/m', 'm', 'mm', 'm/s', 's', '1', '%', 'N m', 'W', 'rad/s', '1/m'].includes(text);
}

/** Units as the program words them; the longer before those that begin like them. */
const WORDED = /(-?\d+(?:\.\d+)?(?:e[+-]?\d+)?)\s(kN\/m|N\/m|m\/s|kN m|N m|kN|mm|N|m)(?![\w/])/g;
const PREFIX: Record<string, [Unit, number]> = {
  'kN/m': ['N/m', 1e3],
  'kN m': ['N m', 1e3],
  kN: ['N', 1e3],
  mm: ['mm', 1e-3],
};

/** A sentence of the program with its quantities in the chosen system; names, between quotes, stay what they are. */
export function sentenceText(text: string, system: UnitSystem): string {
  if (system === 'si') return text;
  const convert = (_: string, number: string, symbol: string): string => {
    const [unit, factor] = PREFIX[symbol] ?? [symbol as Unit, 1];
    return show(Number(number) * factor, unit, system);
  };
  return text
    .split(/('[^']*')/)
    .map((part, i) => (i % 2 === 1 ? part : part.replace(WORDED, convert)))
    .join('');
}
