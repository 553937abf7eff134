// What stands on the plan: the route, equipment as marks of the same size at any zoom, and the legend of them.
import type { Geometry, Point } from '../data';
import { el, svg } from '../dom';

export type Plane = (point: Point) => [number, number];

const FIXED = { 'vector-effect': 'non-scaling-stroke' };

/** East to the right and north up; turned by a quarter where the route is higher than wide. */
export function planeOf(geometry: Geometry): Plane {
  const span = (axis: 0 | 1): number => {
    const values = geometry.route.position_m.map((point) => point[axis]);
    return Math.max(...values) - Math.min(...values);
  };
  return span(1) > 1.2 * span(0) ? (point) => [point[1], point[0]] : (point) => [point[0], -point[1]];
}

function line(points: Point[], plane: Plane, name: string): SVGElement {
  const d = points
    .map((point) =>
      plane(point)
        .map((value) => value.toFixed(3))
        .join(' '),
    )
    .join('L');
  return svg('path', { d: `M${d}`, fill: 'none', class: name, ...FIXED });
}

/** Where something is, drawn as a line of hardly any length, whose ends and width make the mark. */
export function markPath([x, y]: [number, number]): string {
  return `M${x} ${y}h0.001`;
}

function mark(at: [number, number], name: string, label: string): SVGElement {
  return svg('path', { d: markPath(at), class: name, ...FIXED }, svg('title', {}, label));
}

/** All of it, what lies below first. */
export function equipment(geometry: Geometry, plane: Plane): SVGElement[] {
  const lines = (things: { points_m: Point[] }[], name: string): SVGElement[] =>
    things.filter(({ points_m: points }) => points.length > 1).map(({ points_m: points }) => line(points, plane, name));
  const parts = [
    ...lines(geometry.surfaces, 'plan-surface'),
    line(geometry.route.position_m, plane, 'plan-route'),
    ...lines(geometry.conveyors, 'plan-conveyor'),
    ...geometry.rollers.map((roller) => mark(plane(roller.position_m), 'plan-roller', roller.name)),
  ];
  if (geometry.reel) parts.push(mark(plane(geometry.reel.center_m), 'plan-reel', 'reel'));
  if (geometry.winch) parts.push(mark(plane(geometry.winch.position_m), 'plan-winch', 'winch'));
  return parts;
}

export function planLegend(geometry: Geometry): HTMLElement {
  const entries: { name: string; label: string; there: boolean; long: boolean }[] = [
    { name: 'route', label: 'route', there: true, long: true },
    { name: 'roller', label: 'rollers', there: geometry.rollers.length > 0, long: false },
    { name: 'conveyor', label: 'conveyors', there: geometry.conveyors.length > 0, long: true },
    { name: 'surface', label: 'ducts, trays, walls', there: geometry.surfaces.length > 0, long: true },
    { name: 'reel', label: 'reel', there: geometry.reel !== null, long: false },
    { name: 'winch', label: 'winch', there: geometry.winch !== null, long: false },
  ];
  const items = entries
    .filter(({ there }) => there)
    .map(({ name, label, long }) => {
      const path = svg('path', { d: long ? 'M2 6H24' : markPath([13, 6]), class: `plan-${name}` });
      const swatch = svg('svg', { width: 26, height: 12, class: 'swatch', 'aria-hidden': 'true' }, path);
      return el('li', {}, el('span', { class: 'legend-item' }, swatch, label));
    });
  return el('ul', { class: 'legend' }, ...items);
}

/** The place along the route nearest to a point of the drawing; null without a route. */
export function placeNear(geometry: Geometry, plane: Plane, x: number, y: number): number | null {
  let best: number | null = null;
  let least = Infinity;
  geometry.route.position_m.forEach((point, i) => {
    const [px, py] = plane(point);
    const away = (px - x) ** 2 + (py - y) ** 2;
    if (away < least) [least, best] = [away, geometry.route.s_m[i] ?? null];
  });
  return best;
}
