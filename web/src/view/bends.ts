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

/** Stretches with curvature by trapezoids between the route's points, in the route's order. */
export function bendsOf(s: readonly number[], curvature: readonly Value[]): Bend[] {
  const bends: Bend[] = [];
  let open: Bend | null = null;
  const close = (): void => {
    if (open && open.angle >= SMALLEST_TURN) bends.push({ ...open, number: bends.length + 1 });
    open = null;
  };
  for (let i = 0; i + 1 < s.length; i++) {
    const a = Math.abs(curvature[i] ?? 0);
    const b = Math.abs(curvature[i + 1] ?? 0);
    const span = s[i + 1]! - s[i]!;
    if (Math.max(a, b) < STRAIGHT) close();
    else if (span > 0) {
      open ??= { number: 0, from: s[i]!, to: s[i]!, radius: Infinity, angle: 0 };
      open.to = s[i + 1]!;
      open.angle += 0.5 * (a + b) * span;
      open.radius = Math.min(open.radius, 1 / Math.max(a, b));
      if (b < STRAIGHT) close();
    }
  }
  close();
  return bends;
}
