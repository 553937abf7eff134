// The bends of a route, from its curvature.
import type { Value } from '../data';

export interface Bend {
  /** Counted from the route's start, from 1. */
  number: number;
  from: number;
  to: number;
  /** Smallest radius in it, m. */
  radius: number;
  /** By how much the route turns in it, rad. */
  angle: number;
}

/** Curvature below which the route counts as straight, 1/m, and the turn below which a curved stretch is no bend, rad. */
const STRAIGHT = 1e-3;
const SMALLEST_TURN = (1.5 * Math.PI) / 180;

/**
 * Stretches of the route that turn, in its order. The curvature of a point holds from there on: at the end of a bend, where
 * a straight begins, it is 0. Between two points of one bend (a spiral) it goes linearly.
 */
export function bendsOf(s: readonly number[], curvature: readonly Value[]): Bend[] {
  const bends: Bend[] = [];
  let open: Bend | null = null;
  for (let i = 0; i < s.length; i++) {
    const here = Math.abs(curvature[i] ?? 0);
    const curved = here >= STRAIGHT && i + 1 < s.length;
    if (!curved) {
      if (open && open.angle >= SMALLEST_TURN) bends.push({ ...open, number: bends.length + 1 });
      open = null;
      continue;
    }
    const next = Math.abs(curvature[i + 1] ?? 0);
    const mean = next >= STRAIGHT ? 0.5 * (here + next) : here;
    open ??= { number: 0, from: s[i]!, to: s[i]!, radius: Infinity, angle: 0 };
    open.to = s[i + 1]!;
    open.angle += mean * (open.to - s[i]!);
    open.radius = Math.min(open.radius, 1 / here);
  }
  return bends;
}
