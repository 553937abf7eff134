// What a figure shows, in SI units and without a word about how it is drawn.
import type { Value } from '../data';
import type { Unit } from '../units';

/** What lies along the figure's first axis, and so with which other figures it is linked. */
export type Along = 'place' | 'time' | 'head';

/** Meaning of a curve; colour, dash and width follow from it (palette.ts), so that it looks the same in every figure. */
export type Role =
  | 'simulated'
  | 'peak'
  | 'envelope'
  | 'theory'
  | 'backward'
  | 'paper'
  | 'second'
  | 'third'
  | 'fourth'
  | 'fifth'
  | 'sixth'
  | 'ground'
  | 'route';

export interface Curve {
  label: string;
  role: Role;
  /** Places or times, ascending or not, and the values there; null is a gap. */
  x: Value[];
  y: Value[];
  /** Single points instead of a line. */
  points?: boolean;
  /** A thin edge of a band, without an entry of its own in the legend. */
  quiet?: boolean;
}

export interface Level {
  label: string;
  value: number;
}

export interface Mark {
  x: number;
  label: string;
}

export interface FigureSpec {
  id: string;
  title: string;
  caption: string;
  along: Along;
  xLabel: string;
  yLabel: string;
  yUnit: Unit;
  curves: Curve[];
  /** Indices of the curves between which the figure is filled, and what that is called. */
  band?: { low: number; high: number; label: string };
  levels?: Level[];
  events?: Mark[];
  window?: { from: number; to: number; label: string };
  /** Whether the second axis begins at 0 (forces do; heights do not). */
  fromZero?: boolean;
  /** The second axis shows at least so much, SI. */
  span?: number;
  /** For figures over the head's place: when it was where. */
  clock?: { time: Value[]; head: Value[] };
  height?: number;
}

export const X_UNIT: Record<Along, Unit> = { place: 'm', time: 's', head: 'm' };
