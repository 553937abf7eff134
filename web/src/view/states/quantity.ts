// What the chain can be coloured by, and words for places and times.
import type { UnitSystem } from '../../state';
import { scaleOf, type Unit } from '../../units';

export interface Quantity {
  /** Name of the field in the states. */
  field: string;
  title: string;
  unit: Unit;
}

export const QUANTITIES: readonly Quantity[] = [
  { field: 'tension', title: 'Tension', unit: 'N' },
  { field: 'sidewall', title: 'Sidewall pressure', unit: 'N/m' },
  { field: 'curvature', title: 'Curvature', unit: '1/m' },
  { field: 'speed', title: 'Speed', unit: 'm/s' },
  { field: 'contact', title: 'Contact force per length', unit: 'N/m' },
];

/** A place along the route or a distance, to the decimetre. */
export function lengthText(length: number, system: UnitSystem): string {
  const { symbol, factor } = scaleOf('m', system, length);
  return `${(length * factor).toFixed(1).replace('-', '\u2212')}\u00a0${symbol}`;
}

/** Simulated time: seconds, or minutes and hours where the whole is long. */
export function timeText(time: number, whole: number): string {
  if (whole < 600) return `${time.toFixed(1)}\u00a0s`;
  const two = (n: number): string => String(Math.floor(n)).padStart(2, '0');
  const seconds = two(time % 60);
  if (whole < 3600) return `${Math.floor(time / 60)}:${seconds}\u00a0min`;
  return `${Math.floor(time / 3600)}:${two((time / 60) % 60)}:${seconds}\u00a0h`;
}
