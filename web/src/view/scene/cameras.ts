// Where the camera stands: overview, plan, profile, along the cable, each bend. Pure geometry; z is up.
import type { Bend } from '../states/bends';
import { add, cross, direction, dot, type Path, size, sub, type Vec3 } from '../states/path';

export interface Pose {
  position: Vec3;
  target: Vec3;
  /** Vertical angle of view, degrees. */
  fov: number;
}

const UP: Vec3 = [0, 0, 1];
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** Horizontal direction in which points stretch farthest (the first axis of their scatter), from the first to the last. */
export function mainAxis(points: readonly Vec3[]): Vec3 {
  const n = Math.max(1, points.length);
  const mean = points.reduce<Vec3>((sum, p) => add(sum, p, 1 / n), [0, 0, 0]);
  let xx = 0;
  let xy = 0;
  let yy = 0;
  for (const p of points) {
    const [x, y] = sub(p, mean);
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const angle = 0.5 * Math.atan2(2 * xy, xx - yy);
  const axis: Vec3 = [Math.cos(angle), Math.sin(angle), 0];
  const run = points.length > 1 ? sub(points[n - 1]!, points[0]!) : axis;
  return dot(run, axis) < 0 ? [-axis[0], -axis[1], 0] : axis;
}

/**
 * The pose that sees all points from a direction (unit, from the target to the camera), as near as the margin allows;
 * `aspect` is width over height, `margin` the share of the picture that stays empty on all sides together.
 */
export function fitPose(points: readonly Vec3[], back: Vec3, fov: number, aspect: number, margin = 0.12): Pose {
  const right = direction(cross(UP, back), [0, 1, 0]);
  const up = cross(back, right);
  const tangent = Math.tan(radians(fov) / 2) * (1 - margin);
  let target = middle(points, [right, up, back]);
  let distance = 0;
  for (let round = 0; round < 4; round++) {
    distance = 1;
    for (const p of points) {
      const r = sub(p, target);
      const reach = Math.max(Math.abs(dot(r, right)) / (tangent * aspect), Math.abs(dot(r, up)) / tangent);
      distance = Math.max(distance, dot(r, back) + reach);
    }
    // The picture's middle: perspective makes what is near larger, so the box on the screen is not that in space.
    const screen = points.map((p) => {
      const r = sub(p, target);
      const depth = Math.max(1e-6, distance - dot(r, back));
      return [dot(r, right) / depth, dot(r, up) / depth] as const;
    });
    const centre = (axis: 0 | 1): number => {
      const values = screen.map((p) => p[axis]);
      return 0.5 * (values.reduce((a, b) => Math.min(a, b)) + values.reduce((a, b) => Math.max(a, b)));
    };
    target = add(add(target, right, centre(0) * distance), up, centre(1) * distance);
  }
  return { position: add(target, back, distance), target, fov };
}

/** The middle of the points' box along three directions. */
function middle(points: readonly Vec3[], axes: readonly Vec3[]): Vec3 {
  return axes.reduce<Vec3>(
    (sum, axis) => {
      const along = points.map((p) => dot(p, axis));
      const low = along.reduce((a, b) => Math.min(a, b), Infinity);
      const high = along.reduce((a, b) => Math.max(a, b), -Infinity);
      return add(sum, axis, 0.5 * (low + high));
    },
    [0, 0, 0],
  );
}

/** Horizontal direction `axis` from left to right in the picture, the camera `elevation` degrees above the horizon. */
function seenFrom(axis: Vec3, elevation: number): Vec3 {
  const level = cross(axis, UP);
  return direction(add([0, 0, Math.sin(radians(elevation))], level, Math.cos(radians(elevation))));
}

export const overview = (points: readonly Vec3[], aspect: number): Pose =>
  fitPose(points, seenFrom(mainAxis(points), 32), 35, aspect);

// Not quite from above: then it is known which way is up in the picture.
export const plan = (points: readonly Vec3[], aspect: number): Pose =>
  fitPose(points, seenFrom(mainAxis(points), 89.9), 20, aspect);

export const profile = (points: readonly Vec3[], aspect: number): Pose =>
  fitPose(points, seenFrom(mainAxis(points), 2), 20, aspect);

/** Behind and above a place, looking along the route. `near` is the distance, m. */
export function along(path: Path, s: number, near: number): Pose {
  const tangent = path.tangent(s);
  const side = direction(cross(tangent, UP), [0, 1, 0]);
  const level = direction([tangent[0], tangent[1], 0], tangent);
  const target = path.at(s);
  const position = add(add(add(target, level, -near), side, 0.35 * near), UP, 0.4 * near);
  return { position, target, fov: 50 };
}

/** A bend with a little of the route on both sides; from the side if it turns up or down, from above if it turns level. */
export function bendPose(path: Path, bend: Bend, aspect: number): Pose {
  const length = bend.to - bend.from;
  const margin = Math.max(0.5, 0.15 * length);
  const from = Math.max(path.from, bend.from - margin);
  const to = Math.min(path.to, bend.to + margin);
  const points = Array.from({ length: 33 }, (_, i) => path.at(from + ((to - from) * i) / 32));
  const turn = sub(path.tangent(bend.to + 1e-6), path.tangent(Math.max(path.from, bend.from - 1e-6)));
  const vertical = Math.abs(turn[2]) > Math.hypot(turn[0], turn[1]);
  const box = size(sub(points[32]!, points[0]!)) * 0.03;
  const padded = points.flatMap((p) => [add(p, UP, box), add(p, UP, -box)]);
  return fitPose(padded, seenFrom(mainAxis(points), vertical ? 12 : 48), 35, aspect);
}

/** A pose between two, `part` of the way with a soft start and end. */
export function poseBetween(a: Pose, b: Pose, part: number): Pose {
  const soft = part * part * (3 - 2 * part);
  return {
    position: add(a.position, sub(b.position, a.position), soft),
    target: add(a.target, sub(b.target, a.target), soft),
    fov: a.fov + (b.fov - a.fov) * soft,
  };
}

/** Same direction of view, at another target and distance. */
export function poseAt(pose: Pose, target: Vec3, distance: number): Pose {
  const back = direction(sub(pose.position, pose.target));
  return { position: add(target, back, distance), target, fov: pose.fov };
}
