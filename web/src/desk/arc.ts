/** Bends in the plan: where they lead, and what a spot means for their radius and angle. */
export type Spot = [number, number];

export const RAD = Math.PI / 180;
export const dot = (a: Spot, b: Spot): number => a[0] * b[0] + a[1] * b[1];
export const minus = (a: Spot, b: Spot): Spot => [a[0] - b[0], a[1] - b[1]];
export const add = (a: Spot, b: Spot, k = 1): Spot => [a[0] + k * b[0], a[1] + k * b[1]];
/** A direction turned to the left by an angle, degrees. */
export const turned = ([x, y]: Spot, angle: number): Spot => [
  x * Math.cos(angle * RAD) - y * Math.sin(angle * RAD),
  x * Math.sin(angle * RAD) + y * Math.cos(angle * RAD),
];

export interface Arc {
  middle: Spot;
  /** From the middle away from the centre. */
  out: Spot;
  end: Spot;
  /** Its direction at the end. */
  exit: Spot;
  /** The radius with which its middle would be at the spot, angle and beginning as they are. */
  radiusAt: (to: Spot) => number;
  /** The angle with which the straight behind it would lead through the spot, degrees. */
  angleAt: (to: Spot) => number;
}

/** side: 1 to the left, -1 to the right; the angle in degrees. */
export function arcOf(begin: Spot, ahead: Spot, side: number, radius: number, angle: number): Arc {
  const inward: Spot = [-side * ahead[1], side * ahead[0]];
  const half = (angle * RAD) / 2;
  const reach = add([Math.sin(half) * ahead[0], Math.sin(half) * ahead[1]], inward, 1 - Math.cos(half));
  const centre = add(begin, inward, radius);
  const exit = turned(ahead, side * angle);
  return {
    middle: add(begin, reach, radius),
    out: [
      Math.sin(half) * ahead[0] - Math.cos(half) * inward[0],
      Math.sin(half) * ahead[1] - Math.cos(half) * inward[1],
    ],
    end: add(centre, turned(inward, side * angle), -radius),
    exit,
    radiusAt: (to) => dot(minus(to, begin), reach) / dot(reach, reach),
    angleAt: (to) => {
      // the tangent of the circle through the spot: from the centre to it is R outward and L ahead, L^2 = D^2 - R^2
      const way = minus(to, centre);
      const lever = Math.sqrt(Math.max(0, dot(way, way) - radius * radius));
      const found = (Math.atan2(dot(way, inward), dot(way, ahead)) - Math.atan2(-radius, lever)) / RAD;
      // the way round that is nearer to what it is now
      return found - 360 * Math.round((found - angle) / 360);
    },
  };
}

const STEPS = 64; // even: Simpson's rule

/** Where a clothoid leads: curvature grows evenly from k0 to k1, 1/m, to the left positive; direction turns by k0 s + (k1 - k0) s^2 / 2 L. */
export function clothoidOf(
  begin: Spot,
  ahead: Spot,
  length: number,
  k0: number,
  k1: number,
): { end: Spot; exit: Spot } {
  const direction = (share: number): Spot =>
    turned(ahead, (length * (k0 * share + ((k1 - k0) * share * share) / 2)) / RAD);
  let sum: Spot = [0, 0];
  for (let i = 0; i <= STEPS; i++) sum = add(sum, direction(i / STEPS), i === 0 || i === STEPS ? 1 : i % 2 ? 4 : 2);
  return { end: add(begin, sum, length / (3 * STEPS)), exit: direction(1) };
}
