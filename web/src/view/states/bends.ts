// The bends of a route, from its curvature.
import type { Value } from '../../data';
import type { UnitSystem } from '../../state';
import { cross, direction, dot, size, sub, type Vec3 } from './path';
import { lengthText } from './quantity';

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

/** Directions of turning count as the same up to this cosine: a bend that goes over into one the other way is two. */
const SAME_WAY = 0.5;
/** Share of what the curvature says by which the route has to turn at a point for its way to count. */
const CLEAR = 0.4;

/** Which way and how far the route turns at every point: its directions before and behind it crossed; nothing at the ends. */
export function turning(points: readonly Vec3[]): Vec3[] {
  return points.map((point, i) => {
    const [before, behind] = [points[i - 1], points[i + 1]];
    return before && behind ? cross(direction(sub(point, before)), direction(sub(behind, point))) : [0, 0, 0];
  });
}

/**
 * Stretches of the route that turn, in its order. The curvature of a point holds from there on: at the end of a bend, where
 * a straight begins, it is 0. Between two points of one bend (a spiral) it goes linearly.
 */
export function bendsOf(s: readonly number[], curvature: readonly Value[], turns: readonly Vec3[] = []): Bend[] {
  const bends: Bend[] = [];
  let open: Bend | null = null;
  let way: Vec3 | null = null;
  const close = (): void => {
    if (open && open.angle >= SMALLEST_TURN) bends.push({ ...open, number: bends.length + 1 });
    open = way = null;
  };
  for (let i = 0; i < s.length; i++) {
    const here = Math.abs(curvature[i] ?? 0);
    const curved = here >= STRAIGHT && i + 1 < s.length;
    if (!curved) {
      close();
      continue;
    }
    // Where two bends meet the route turns by a part of either, or not at all: that says nothing of its way.
    const ahead = turns[i + 1];
    if (ahead && size(ahead) > CLEAR * here * (s[i + 1]! - s[i]!)) {
      if (way && dot(direction(ahead), way) < SAME_WAY) close();
      way = direction(ahead);
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

export function bendText(bend: Bend, system: UnitSystem): string {
  const degrees = ((bend.angle * 180) / Math.PI).toFixed(0);
  return `Bend ${bend.number}: ${degrees}°, R ${lengthText(bend.radius, system)}`;
}
