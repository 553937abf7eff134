// The table behind the plan: what stands where, along the route and in space.
import type { Geometry, Point, Value } from '../data';
import type { DataTable } from '../figure/table';
import type { UnitSystem } from '../state';
import { scaleOf } from '../units';

export function standsTable(geometry: Geometry, units: UnitSystem): DataTable {
  const { symbol, factor } = scaleOf('m', units, 1);
  const row = (kind: string, name: string, s: Value, point: Point | undefined): DataTable['rows'][number] => [
    kind,
    name,
    s === null ? null : s * factor,
    ...[0, 1, 2].map((axis) => (point?.[axis] === undefined ? null : point[axis] * factor)),
  ];
  const { route, rollers, conveyors, surfaces, reel, winch } = geometry;
  const ends = (kind: string, name: string, points: Point[], from: Value, to: Value): DataTable['rows'] => [
    row(`${kind}, beginning`, name, from, points[0]),
    row(`${kind}, end`, name, to, points.at(-1)),
  ];
  return {
    name: 'hawser-plan',
    columns: [
      { label: 'what' },
      { label: 'name' },
      { label: 'place along the route', unit: symbol },
      ...['x', 'y', 'z'].map((label) => ({ label, unit: symbol })),
    ],
    rows: [
      ...(reel ? [row('reel', '', null, reel.center_m)] : []),
      ...(winch ? [row('winch', '', null, winch.position_m)] : []),
      ...conveyors.flatMap((c) => ends('conveyor', c.name, c.points_m, c.from_m, c.to_m)),
      ...surfaces.flatMap((s) => ends(s.kind, s.name, s.points_m, s.from_m ?? null, s.to_m ?? null)),
      ...rollers.map((r) => row(r.kind, r.name, r.s_m, r.position_m)),
      ...route.s_m.map((s, i) => row('route', '', s, route.position_m[i])),
    ],
  };
}
