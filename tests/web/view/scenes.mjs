// Made-up pulls in the page's format: the cable slides along a route of straights and bends, tension grows by weight, friction and bends.
import { packStates } from './pack.mjs';

const GRAVITY = 9.81;

/** Route from pieces {length, turn (rad, to the left), rise (rad, upward)}: points every `step` m with place, direction, curvature. */
export function routeOf(pieces, step, start = [0, 0, 0]) {
  const s = [0];
  const position = [[...start]];
  const curvature = [];
  let heading = 0;
  let slope = 0;
  for (const { length, turn = 0, rise = 0 } of pieces) {
    const n = Math.max(1, Math.round(length / step));
    for (let k = 0; k < n; k++) {
      heading += turn / n / 2;
      slope += rise / n / 2;
      const [x, y, z] = position[position.length - 1];
      const h = length / n;
      position.push([
        x + h * Math.cos(heading) * Math.cos(slope),
        y + h * Math.sin(heading) * Math.cos(slope),
        z + h * Math.sin(slope),
      ]);
      s.push(s[s.length - 1] + h);
      curvature.push(Math.hypot(turn * Math.cos(slope), rise) / length);
      heading += turn / n / 2;
      slope += rise / n / 2;
    }
  }
  curvature.push(curvature[curvature.length - 1]);
  return { s, position, curvature };
}

/** A value of a list at a place, linearly; beyond the ends on. */
function at(s, list, x) {
  let low = 0;
  let high = s.length - 2;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (s[middle] <= x) low = middle;
    else high = middle - 1;
  }
  const part = (x - s[low]) / (s[low + 1] - s[low]);
  const [a, b] = [list[low], list[low + 1]];
  return Array.isArray(a)
    ? a.map((value, i) => value + part * (b[i] - value))
    : a + Math.min(1, Math.max(0, part)) * (b - a);
}

/**
 * A run: route of pieces, cable of `segments` x `segment` m and half as much rope ahead, `rollers` under it, pulled from its start to its end in
 * `frames` frames.
 */
export function pull({
  pieces,
  segments,
  segment,
  rollers,
  frames,
  duration,
  ducts = [],
  conveyors = [],
  reel = false,
  start,
}) {
  const route = routeOf(pieces, 0.5, start);
  const length = route.s[route.s.length - 1];
  const ropes = Math.floor(segments / 3);
  const cables = segments - ropes;
  const lengths = Array.from({ length: segments }, () => segment);
  const time = Array.from({ length: frames }, (_, k) => (duration * k) / (frames - 1));
  const heads = time.map((t) => 1 + ((length - 2) * t) / duration);
  const position = new Float64Array(3 * segments * frames);
  const [tension, curvature, sidewall, speed] = [0, 1, 2, 3].map(() => new Float64Array(segments * frames));
  const weight = 19.5 * GRAVITY;
  heads.forEach((head, f) => {
    let pulled = 2000;
    for (let i = 0; i < segments; i++) {
      const k = f * segments + i;
      const s = head + (i - cables + 0.5) * segment;
      const wobble = 0.01 * Math.sin(0.9 * s + 0.05 * f);
      const p = at(route.s, route.position, s);
      position.set([p[0], p[1] + wobble, p[2]], 3 * k);
      const inside = s > 0 && s < length;
      curvature[k] = inside ? at(route.s, route.curvature, s) : 0;
      if (inside) pulled += segment * (0.12 * Math.hypot(i < cables ? weight : 7, curvature[k] * pulled));
      tension[k] = pulled;
      sidewall[k] = curvature[k] * pulled;
      speed[k] = ((length - 2) / duration) * Math.min(1, f / 5);
    }
  });
  const names = Array.from({ length: rollers }, (_, i) => `R${i + 1}`);
  const places = names.map((_, i) => (length * (i + 0.5)) / rollers);
  const along = (from, to) => {
    const n = Math.ceil(to - from) + 1;
    return Array.from({ length: n }, (_, k) => at(route.s, route.position, from + ((to - from) * k) / (n - 1)));
  };
  const geometry = {
    origin_m: [0, 0, 0],
    up: [0, 0, 1],
    route: {
      s_m: route.s,
      position_m: route.position,
      curvature_per_m: route.curvature,
    },
    rollers: names.map((name, i) => {
      const a = at(route.s, route.position, places[i] - 0.05);
      const b = at(route.s, route.position, places[i] + 0.05);
      const [x, y, z] = at(route.s, route.position, places[i]);
      const size = Math.hypot(b[0] - a[0], b[1] - a[1]);
      return {
        name,
        s_m: places[i],
        kind: 'roller',
        position_m: [x, y, z - 0.04365 - 0.08],
        axis: [-(b[1] - a[1]) / size, (b[0] - a[0]) / size, 0],
        radius_m: 0.08,
        width_m: 0.4,
        rating_N: 5000,
      };
    }),
    surfaces: [
      ...ducts.map(([from, to]) => ({
        name: `duct ${from}`,
        kind: 'duct',
        points_m: along(from, to),
        diameter_m: 0.16,
      })),
      {
        name: 'floor',
        kind: 'floor',
        points_m: along(0, length).map(([x, y, z]) => [x, y, z - 0.4]),
        width_m: 1.2,
        normal: [0, 0, 1],
      },
    ],
    conveyors: conveyors.map(([from, to]) => ({
      name: `conveyor ${from}`,
      from_m: from,
      to_m: to,
      points_m: along(from, to),
    })),
    reel: reel
      ? {
          center_m: at(route.s, route.position, -4).map((x, i) => x - (i === 2 ? 1.5 : 0)),
          axis: [0, 1, 0],
          radius_m: 1.5,
          width_m: 1.6,
        }
      : null,
    winch: {
      position_m: at(route.s, route.position, length + 3),
      direction: [1, 0, 0],
    },
    obstacles: [],
  };
  return {
    format: 1,
    hawser: '0.0.0',
    runs: [
      {
        label: 'made up',
        summary: {
          title: 'A made-up pull',
          events: [
            { time_s: 0.3 * duration, what: 'the winch trips', pull_N: 9000 },
            {
              time_s: 0.6 * duration,
              what: 'the winch starts again',
              pull_N: 8000,
            },
          ],
        },
        rollers: {
          name: names,
          s_m: places,
          steady_N: places.map(() => 300),
          peak_N: places.map(() => 420),
        },
        geometry,
        chain: {
          segments,
          length_m: lengths,
          diameter_m: lengths.map((_, i) => (i < cables ? 0.0873 : 0.014)),
          part: lengths.map((_, i) => (i < cables ? 0 : 1)),
          part_names: ['power', 'rope'],
        },
        states: packStates(time, segments, heads, {
          position,
          tension,
          curvature,
          sidewall,
          speed,
        }),
      },
    ],
  };
}

const degree = Math.PI / 180;

/** A small pull with everything in it: two bends, a duct, a conveyor, a reel; far from the origin. */
export const small = () =>
  pull({
    pieces: [
      { length: 14 },
      { length: 8, turn: 60 * degree },
      { length: 10 },
      { length: 6, rise: 15 * degree },
      { length: 8 },
      { length: 6, rise: -15 * degree },
      { length: 12 },
    ],
    segments: 240,
    segment: 0.5,
    rollers: 24,
    frames: 41,
    duration: 40,
    ducts: [[44, 60]],
    conveyors: [[3, 6]],
    reel: true,
    start: [50000, 450000, 120],
  });

/** A tunnel of 880 m with 2000 rollers, 1800 segments and 600 states. */
export const large = (frames = 600) =>
  pull({
    pieces: [1, -1, 1, -1, 1, -1].flatMap((sense, i) => [
      { length: 110 },
      { length: 16, turn: sense * 45 * degree },
      { length: 10, rise: 4 * (i % 2 ? -1 : 1) * degree },
      { length: 10 },
    ]),
    segments: 1800,
    segment: 0.75,
    rollers: 2000,
    frames,
    duration: 8796,
    ducts: [[300, 420]],
    conveyors: [
      [100, 104],
      [400, 404],
    ],
    reel: true,
  });
