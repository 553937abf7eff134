// The route as a line with arc length: points at a place, and the place of a point.
import { indexAtMost } from './frames';

export type Vec3 = [number, number, number];

export const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const add = (a: Vec3, b: Vec3, times = 1): Vec3 => [
  a[0] + times * b[0],
  a[1] + times * b[1],
  a[2] + times * b[2],
];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const size = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);
/** The direction of a; `otherwise` where a is nothing. */
export function direction(a: Vec3, otherwise: Vec3 = [1, 0, 0]): Vec3 {
  const length = size(a);
  return length > 1e-12 ? [a[0] / length, a[1] / length, a[2] / length] : otherwise;
}

export class Path {
  /** Direction of the piece behind every point but the last. */
  private readonly along: Vec3[];

  constructor(
    readonly s: ArrayLike<number>,
    readonly points: Vec3[],
  ) {
    this.along = points.slice(1).map((point, i) => direction(sub(point, points[i]!)));
  }

  get from(): number {
    return this.s[0] ?? 0;
  }

  get to(): number {
    return this.s[this.points.length - 1] ?? 0;
  }

  private piece(s: number): number {
    return Math.max(0, Math.min(this.points.length - 2, indexAtMost(this.s, s)));
  }

  /** The point at a place; beyond the ends on their tangents. */
  at(s: number): Vec3 {
    const i = this.piece(s);
    const span = this.s[i + 1]! - this.s[i]!;
    const part = (s - this.s[i]!) / span;
    if (part >= 0 && part <= 1) return add(this.points[i]!, sub(this.points[i + 1]!, this.points[i]!), part);
    const end = part < 0 ? i : i + 1;
    return add(this.points[end]!, this.along[i]!, s - this.s[end]!);
  }

  tangent(s: number): Vec3 {
    return this.along[this.piece(s)] ?? [1, 0, 0];
  }

  /** Place and distance of the route's point that is nearest to a point. Without an allocation: it is asked thousands of times. */
  nearest([x, y, z]: Vec3): { s: number; distance: number } {
    const { s, points, along } = this;
    let best = Infinity;
    let place = this.from;
    for (let i = 0; i + 1 < points.length; i++) {
      const a = points[i]!;
      const t = along[i]!;
      const dx = x - a[0];
      const dy = y - a[1];
      const dz = z - a[2];
      const span = s[i + 1]! - s[i]!;
      const reach = Math.min(span, Math.max(0, dx * t[0] + dy * t[1] + dz * t[2]));
      const square = (dx - reach * t[0]) ** 2 + (dy - reach * t[1]) ** 2 + (dz - reach * t[2]) ** 2;
      if (square < best) {
        best = square;
        place = s[i]! + reach;
      }
    }
    return { s: place, distance: Math.sqrt(best) };
  }
}
