// A run as the view needs it: everything about a centre near the scene, so that single precision is enough on the graphics card.
import type { Point, RunData } from '../../data';
import { type Bend, bendsOf, turning } from './bends';
import type { Frames } from './frames';
import { direction, Path, size, sub, type Vec3 } from './path';

export interface ChainDef {
  segments: number;
  length_m: readonly number[];
  diameter_m: readonly number[];
  part: readonly number[];
}

export interface Model {
  run: RunData;
  /** What is taken off all coordinates, m. */
  centre: Vec3;
  /** A point of the data about the centre. */
  at: (point: Point) => Vec3;
  path: Path | null;
  bends: Bend[];
  chain: ChainDef | null;
  /** The cable's foremost segment. */
  head: number;
  /** The cable's diameter, m. */
  diameter: number;
  /** Points that the overview has to show. */
  extent: Vec3[];
}

/** Diameter that stands for one that the data do not have, m. */
const DIAMETER = 0.05;
/** Points of the route that are enough to fit a camera. */
const OUTLINE = 200;

/** Chain of the data, or one of unknown diameters if there are states alone. */
function chainOf(run: RunData): ChainDef | null {
  const n = run.chain?.segments ?? run.states?.segments ?? 0;
  if (n === 0) return null;
  const given = run.chain;
  return {
    segments: n,
    length_m: given?.length_m ?? new Array<number>(n).fill(1),
    diameter_m: given?.diameter_m ?? new Array<number>(n).fill(DIAMETER),
    part: given?.part ?? new Array<number>(n).fill(0),
  };
}

export function modelOf(run: RunData): Model {
  const geometry = run.geometry ?? null;
  const points = geometry?.route.position_m ?? [];
  const middle = (axis: 0 | 1 | 2): number => {
    const values = points.map((point) => point[axis]);
    const low = values.reduce((a, b) => Math.min(a, b), Infinity);
    const high = values.reduce((a, b) => Math.max(a, b), -Infinity);
    return values.length > 0 ? 0.5 * (low + high) : 0;
  };
  const centre: Vec3 = [middle(0), middle(1), middle(2)];
  const at = (point: Point): Vec3 => sub(point, centre);
  const route = points.map(at);
  const chain = chainOf(run);
  const cable = chain ? chain.part.lastIndexOf(0) : -1;
  const stride = Math.max(1, Math.floor(route.length / OUTLINE));
  const extent = route.filter((_, i) => i % stride === 0 || i === route.length - 1);
  if (geometry?.reel) extent.push(at(geometry.reel.center_m));
  if (geometry?.winch && nearRoute(route, at(geometry.winch.position_m))) extent.push(at(geometry.winch.position_m));
  if (extent.length === 0) {
    // a rod without a route begins at the origin, whichever way it points
    const length = chain ? chain.length_m.reduce((a, b) => a + b, 0) : 1;
    extent.push([-length, 0, 0], [length, 0, 0]);
  }
  return {
    run,
    centre,
    at,
    path: geometry && route.length > 1 ? new Path(geometry.route.s_m, route) : null,
    bends: geometry ? bendsOf(geometry.route.s_m, geometry.route.curvature_per_m, turning(route)) : [],
    chain,
    head: chain ? (cable >= 0 ? cable : chain.segments - 1) : 0,
    diameter: chain?.diameter_m[Math.max(0, cable)] ?? DIAMETER,
    extent,
  };
}

/** Whether a point lies within a route's own size of its end: a winch far off would make the route small in the overview. */
function nearRoute(route: readonly Vec3[], point: Vec3): boolean {
  const end = route[route.length - 1];
  return !!end && size(sub(point, end)) < 0.5 * size(sub(end, route[0]!));
}

/** Where there is no route the first state tells where the scene is. Returns its points, thinned, about its own middle. */
export function extentOfStates(frames: Frames, model: Model): void {
  const field = frames.fields.get('position');
  if (!field || model.path) return;
  const points: Vec3[] = [];
  for (let i = 0; i < frames.items; i += Math.max(1, Math.floor(frames.items / OUTLINE)))
    points.push([0, 1, 2].map((x) => field.q[3 * i + x]! * field.meta.step) as Vec3);
  const mean = points.reduce<Vec3>((sum, p) => [sum[0] + p[0], sum[1] + p[1], sum[2] + p[2]], [0, 0, 0]);
  mean.forEach((x, i) => (model.centre[i] = x / points.length));
  model.extent = points.map(model.at);
}

/** Whether a point (about the centre) is in the reel: on its drum or between its flanges. */
export function onReel(model: Model): (x: number, y: number, z: number) => boolean {
  const reel = model.run.geometry?.reel;
  if (!reel) return () => false;
  const [cx, cy, cz] = model.at(reel.center_m);
  const [ax, ay, az] = axisOf(reel.axis);
  return (x, y, z) => {
    const along = (x - cx) * ax + (y - cy) * ay + (z - cz) * az;
    const square = (x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2 - along * along;
    return Math.abs(along) < 0.6 * reel.width_m + 0.2 && square < (1.02 * reel.radius_m) ** 2;
  };
}

/** A unit axis; level and across x where the data have none. */
export const axisOf = (axis: Point): Vec3 => direction(axis, [0, 1, 0]);
