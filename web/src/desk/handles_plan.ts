/** Handles of a route that is a plan with a profile, as surveyors and files have it: lines, arcs, corners of the profile. */
import { isMap, isSeq } from 'yaml';
import { add, arcOf, clothoidOf, dot, minus, RAD, turned, type Spot } from './arc';
import { plain, read, snapped, together, writtenAt } from './desk';
import type { Along } from './engine';
import { LEAST_RADIUS, nearest, sample, single, type Found, type Handle } from './handles';
import { nodeAt, parsed, setValue, type Change, type Path } from './splice';
import { t } from './words';

const LIST: Path = ['route', 'plan'];
const valueAt = (text: string, path: Path): number | undefined => read(writtenAt(text, path) ?? '')?.value;

/** The curvature at an end of a clothoid, 1/m; undefined: what is written there is not a length that is known here. */
function curvatureAt(text: string, path: Path): number | undefined {
  if (writtenAt(text, path) === undefined) return 0; // straight there
  const radius = valueAt(text, path);
  return radius ? 1 / radius : undefined;
}

/** Lines, arcs and clothoids: where each ends, its length; of arcs the radius and the angle. */
export function planned(text: string, along: Along): Found {
  const list = nodeAt(parsed(text), LIST);
  if (!isSeq(list)) return [];
  let at: Spot = [valueAt(text, ['route', 'start', 0]) ?? 0, valueAt(text, ['route', 'start', 1]) ?? 0];
  let ahead = turned([1, 0], valueAt(text, ['route', 'heading']) ?? 0);
  const found: Found = [];
  for (const [i, item] of list.items.entries()) {
    if (!isMap(item)) return found;
    const path: Path = [...LIST, i];
    const name = writtenAt(text, [...path, 'name']) || `${t('piece')} ${i + 1}`;
    const line = valueAt(text, [...path, 'line']);
    const length = valueAt(text, [...path, 'arc']);
    const radius = valueAt(text, [...path, 'radius']);
    const clothoid = valueAt(text, [...path, 'clothoid']);
    const side = writtenAt(text, [...path, 'turn']) === 'right' ? -1 : 1;
    const [k0, k1] = ['start_radius', 'end_radius'].map((key) => curvatureAt(text, [...path, key]));
    if (line !== undefined) {
      const [begin, way] = [at, ahead];
      at = add(at, ahead, line);
      found.push(
        single(
          {
            kind: 'length',
            view: 'plan',
            label: `${name}: ${t('length')}`,
            at,
            s: nearest(along, at),
            path: [...path, 'line'],
            unit: 'm',
            amount: (to) => dot(minus(to, begin), way),
          },
          text,
          0.1,
          1e6,
        ),
      );
    } else if (length !== undefined && radius) {
      const angle = length / radius / RAD;
      const arc = arcOf(at, ahead, side, radius, angle);
      const next = valueAt(text, [...LIST, i + 1, 'line']) ?? 0;
      found.push(...bend(path, name, arc, radius, angle, next, along, writtenAt(text, [...path, 'radius']) ?? ''));
      [at, ahead] = [arc.end, arc.exit];
    } else if (clothoid !== undefined && k0 !== undefined && k1 !== undefined) {
      const { end, exit } = clothoidOf(at, ahead, clothoid, side * k0, side * k1);
      found.push(
        single(
          {
            kind: 'length',
            view: 'plan',
            label: `${name}: ${t('length')}`,
            at: end,
            s: nearest(along, end),
            path: [...path, 'clothoid'],
            unit: 'm',
            amount: (to) => dot(minus(to, end), exit),
          },
          text,
          0.1,
          1e6,
        ),
      );
      [at, ahead] = [end, exit];
    } else return found;
  }
  return found;
}

/** Of an arc, whose length is written: the radius keeps the angle, the angle the radius. Clothoids beside it that have its radius keep it. */
function bend(
  path: Path,
  name: string,
  arc: ReturnType<typeof arcOf>,
  radius: number,
  angle: number,
  next: number,
  along: Along,
  written: string,
): Handle[] {
  const metres = (value: number): string => `${plain(value, 3)} m`;
  const round = (value: number): number => read(snapped(written, Math.max(LEAST_RADIUS, value), 'm'))?.value ?? value;
  const index = Number(path.at(-1));
  const beside: Path[] = [
    [...LIST, index - 1, 'end_radius'],
    [...LIST, index + 1, 'start_radius'],
  ];
  const setRadius = (text: string, value: number): Change | undefined =>
    together(text, [
      (now) => setValue(now, [...path, 'arc'], metres(round(value) * angle * RAD)),
      (now) => setValue(now, [...path, 'radius'], snapped(written, round(value), 'm')),
      ...beside
        .filter(
          (one) => Math.abs((valueAt(text, one) ?? 0) / (valueAt(text, [...path, 'radius']) ?? radius) - 1) < 1e-6,
        )
        .map((one) => (now: string) => setValue(now, one, snapped(writtenAt(text, one) ?? '', round(value), 'm'))),
    ]);
  const setAngle = (text: string, value: number): Change | undefined =>
    setValue(text, [...path, 'arc'], metres(radius * Math.min(360, Math.max(1, Math.round(value))) * RAD));
  const lever = add(arc.end, arc.exit, next / 2);
  return [
    {
      kind: 'radius',
      view: 'plan',
      label: `${name}: ${t('radius')}`,
      at: arc.middle,
      out: arc.out,
      s: nearest(along, arc.middle),
      value: written,
      move: (text, to) => setRadius(text, radius + arc.radiusAt(to) - arc.radiusAt(arc.middle)),
      step: (text, right, up) => setRadius(text, (valueAt(text, [...path, 'radius']) ?? radius) + 0.1 * (right || up)),
    },
    {
      kind: 'angle',
      view: 'plan',
      label: `${name}: ${t('angle')}`,
      at: lever,
      s: nearest(along, lever),
      value: `${plain(angle, 2)} deg`,
      move: (text, to) => setAngle(text, angle + arc.angleAt(to) - arc.angleAt(lever)),
      step: (text, right, up) => setAngle(text, (valueAt(text, [...path, 'arc']) ?? 0) / radius / RAD + (right || up)),
    },
  ];
}

/** Corners of the profile: those between move along, too, the first and the last in height alone. */
export function corners(text: string, along: Along): Found {
  const list = [
    ['route', 'profile'],
    ['route', 'profile', 'corners'],
  ].find((path) => isSeq(nodeAt(parsed(text), path)));
  const node = list && nodeAt(parsed(text), list);
  if (!list || !isSeq(node)) return [];
  const first = valueAt(text, ['route', 'station']) ?? 0;
  let way = first;
  const stations = along.s_m.map((_, i) => {
    if (i > 0)
      way += Math.hypot((along.x_m[i] ?? 0) - (along.x_m[i - 1] ?? 0), (along.y_m[i] ?? 0) - (along.y_m[i - 1] ?? 0));
    return way;
  });
  return node.items.map((_, i) => {
    const path: Path = [...list, i];
    const [station, height] = ['station', 'height'].map((key) => valueAt(text, [...path, key]));
    if (station === undefined || height === undefined) return undefined;
    const before = valueAt(text, [...list, i - 1, 'station']);
    const after = valueAt(text, [...list, i + 1, 'station']);
    const inside = before !== undefined && after !== undefined;
    const s = sample(stations, along.s_m, station);
    const set = (now: string, to: Spot): Change | undefined => {
      const next = Math.min((after ?? station) - 0.1, Math.max((before ?? station) + 0.1, to[0]));
      return together(now, [
        (one) =>
          inside
            ? setValue(one, [...path, 'station'], snapped('', next, 'm'))
            : setValue(one, [...path, 'height'], snapped('', to[1], 'm')),
        (one) => setValue(one, [...path, 'height'], snapped('', to[1], 'm')),
      ]);
    };
    return {
      kind: 'corner',
      view: 'profile',
      label: `${t('Profile')}, ${t('corner')} ${i + 1}`,
      at: [s, height],
      s,
      value: `${plain(station, 2)} m, ${plain(height, 2)} m`,
      move: (now, to) =>
        set(now, [station + sample(along.s_m, stations, to[0]) - sample(along.s_m, stations, s), to[1]]),
      step: (now, right, up) => {
        const [x = station, z = height] = ['station', 'height'].map((key) => valueAt(now, [...path, key]));
        return set(now, [x + 0.1 * right, z + 0.1 * up]);
      },
    } satisfies Handle;
  });
}
