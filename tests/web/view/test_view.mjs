// The view's arithmetic: unpacking, interpolation, colours, scales, bends, cameras, picking, tubes, keys.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { modules } from './modules.mjs';
import { FIELDS, pack, packStates } from './pack.mjs';
import { routeOf } from './scenes.mjs';

const view = await modules(
  'states/packed',
  'states/frames',
  'states/colours',
  'states/scale',
  'states/path',
  'states/bends',
  'scene/cameras',
  'scene/pick',
  'scene/chain_rings',
  'states/playback',
  'desk/keys',
  'scene/labels',
  'states/quantity',
  'scene/sweep',
  'states/model',
  'states/beside',
  '../data',
);

/** The largest distance between two lists of numbers. */
const farthest = (a, b) => {
  assert.equal(a.length, b.length);
  return Array.from(a).reduce((worst, value, i) => Math.max(worst, Math.abs(value - b[i])), 0);
};

/** Numbers that look like chance and are the same in every run. */
function* chance(seed = 1) {
  for (let x = seed; ;) {
    x = (Math.imul(x, 1664525) + 1013904223) >>> 0;
    yield x / 2 ** 32;
  }
}

test('a field comes out of its packing as it went in, to half a step', async () => {
  const random = chance();
  for (const [frames, items, components, reach] of [
    [1, 1, 1, 10],
    [1, 7, 3, 1000],
    [9, 1, 3, 1000],
    [13, 29, 3, 2e6],
    [40, 5, 1, 0.4],
  ]) {
    const values = Array.from({ length: frames * items * components }, () => reach * (2 * random.next().value - 1));
    const step = 0.001;
    const q = await view.unpackField(pack(values, frames, items, components, step), frames, items, components);
    assert.equal(q.length, values.length);
    assert.ok(
      farthest(
        Array.from(q, (n) => n * step),
        values,
      ) <=
        0.5001 * step,
    );
  }
});

test('differences wrap round in 32 bits', async () => {
  const values = [2147483647, -2147483647, 2147483647, -2147483647, 0, 5];
  const q = await view.unpackField(pack(values, 2, 3, 1, 1), 2, 3, 1);
  assert.deepEqual(Array.from(q), values);
});

test('the example of the format, packed by hand', async () => {
  // Frame 0: 5, 7; frame 1: 6, 9. Differences 5, 2; 1, 1; zigzag 10, 4, 2, 2; then three planes of zeros.
  const bytes = Buffer.concat([Buffer.from([10, 4, 2, 2]), Buffer.alloc(12)]);
  const q = await view.unpackField(deflateSync(bytes).toString('base64'), 2, 2, 1);
  assert.deepEqual(Array.from(q), [5, 7, 6, 9]);
});

test('damaged or short fields are refused', async () => {
  const good = pack([1, 2, 3, 4], 2, 2, 1, 1);
  await assert.rejects(view.unpackField(good, 3, 2, 1), /bytes/);
  await assert.rejects(view.unpackField(good.slice(0, 8), 2, 2, 1));
  await assert.rejects(view.unpackField('%%%%', 2, 2, 1));
});

test('between two frames values go linearly, before the first and behind the last they stay', async () => {
  const values = {
    position: [0, 0, 0, 1, 0, 0, 0, 4, 0, 1, 4, 0],
    tension: [100, 200, 300, 600],
  };
  const states = packStates([10, 20], 2, [0, 1], values);
  const frames = await view.unpackFrames(states, () => {});
  const out = new Float32Array(6);
  const tension = new Float32Array(2);
  for (const [time, y, t0] of [
    [10, 0, 100],
    [12.5, 1, 150],
    [20, 4, 300],
    [5, 0, 100],
    [99, 4, 300],
  ]) {
    frames.sample('position', frames.between(time), out, [1, 0, 0]);
    frames.sample('tension', frames.between(time), tension);
    assert.ok(farthest(out, [-1, y, 0, 0, y, 0]) < 1e-6);
    assert.ok(Math.abs(tension[0] - t0) < 1e-4);
  }
  assert.equal(frames.sample('curvature', frames.between(12), tension), false);
});

test('far from the origin a millimetre is still a millimetre', async () => {
  const x = 1999999.123;
  const states = packStates([0], 2, [0], {
    position: [x, 0, 0, x + 0.002, 0, 0],
  });
  const frames = await view.unpackFrames(states, () => {});
  const out = new Float32Array(6);
  frames.sample('position', frames.between(0), out, [x, 0, 0]);
  assert.ok(Math.abs(out[3] - out[0] - 0.002) < 1e-6);
});

test('viridis: its ends, its middle, and lightness that only rises', () => {
  assert.deepEqual(view.colourOf(0).map(Math.round), [68, 1, 84]);
  assert.deepEqual(view.colourOf(1).map(Math.round), [253, 231, 37]);
  assert.deepEqual(view.colourOf(-3), view.colourOf(0));
  assert.deepEqual(view.colourOf(NaN), view.colourOf(0));
  // The published map has (33, 145, 140) in its middle; 16 colours of it come within two of 255.
  assert.ok(farthest(view.colourOf(0.5), [33, 145, 140]) < 2.1);
  const row = view.colourRow(256);
  // CIE lightness of a grey as bright.
  const linear = (c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4);
  const lightness = (i) => {
    const y = 0.2126 * linear(row[4 * i]) + 0.7152 * linear(row[4 * i + 1]) + 0.0722 * linear(row[4 * i + 2]);
    return 116 * Math.cbrt(y) - 16;
  };
  for (let i = 0; i + 8 < 256; i += 8) assert.ok(lightness(i + 8) > lightness(i) + 1);
});

test('the scale leaves single peaks and what is on the reel out, and says so', async () => {
  const values = Array.from({ length: 2000 }, (_, i) => i % 100);
  values[777] = 5000;
  const states = packStates([0, 1], 1000, [0, 0], { tension: values });
  const frames = await view.unpackFrames(states, () => {});
  const scale = view.scaleOf(frames, 'tension');
  assert.equal(scale.low, 0);
  assert.equal(scale.beyond, 5000);
  assert.ok(scale.high >= 99 && scale.high < 110, String(scale.high));
  const without = view.scaleOf(frames, 'tension', (item) => item === 777);
  assert.deepEqual(without, { low: 0, high: 99, beyond: null });
  assert.equal(view.scaleOf(frames, 'speed'), null);
});

test('ticks are round and inside', () => {
  assert.deepEqual(view.ticksOf(0, 12.9, 4), [0, 5, 10]);
  assert.deepEqual(view.ticksOf(0, 58.5, 10), [0, 10, 20, 30, 40, 50]);
  assert.deepEqual(view.ticksOf(-0.5, 0.5, 2), [-0.5, 0, 0.5]);
  assert.deepEqual(view.ticksOf(3, 3, 4), []);
});

test('bends of a route: where, how sharp, how far round', () => {
  const degree = Math.PI / 180;
  const { s, curvature } = routeOf(
    [
      { length: 50 },
      { length: 10, turn: 30 * degree },
      { length: 60 },
      { length: 5, rise: -45 * degree },
      { length: 9 },
    ],
    0.5,
  );
  const bends = view.bendsOf(s, curvature);
  assert.equal(bends.length, 2);
  const [a, b] = bends;
  assert.ok(farthest([a.from, a.to, a.angle / degree], [50, 60, 30]) < 1e-6);
  assert.ok(Math.abs(a.radius - 10 / (30 * degree)) < 1e-6);
  assert.ok(farthest([b.from, b.to, b.angle / degree], [120, 125, 45]) < 1e-6);
  assert.deepEqual(view.bendsOf([0, 10], [0, 0]), []);
  const snake = routeOf([{ length: 5 }, { length: 10, turn: 1 }, { length: 6, turn: -0.5 }, { length: 5 }], 0.5);
  const [left, right, ...more] = view.bendsOf(snake.s, snake.curvature, view.turning(snake.position));
  assert.deepEqual(more, [], 'a bend that goes over into one the other way: two');
  assert.ok(Math.abs(left.angle - 1) < 0.06 && Math.abs(right.angle - 0.5) < 0.06, `${left.angle}, ${right.angle}`);
  assert.ok(Math.abs(left.to - 15) < 0.51 && left.to === right.from);
  assert.deepEqual(view.bendsOf([0, 10, 20], [null, 0.1, 0]).length, 1);
});

test('the overview shows every point and comes as near as that allows', () => {
  const { position } = routeOf([{ length: 100 }, { length: 20, turn: 1 }, { length: 300 }], 1);
  for (const [pose, aspect] of [
    [view.overview(position, 2), 2],
    [view.plan(position, 0.6), 0.6],
    [view.profile(position, 3), 3],
  ]) {
    const back = view.direction(view.sub(pose.position, pose.target));
    const right = view.direction(view.cross([0, 0, 1], back));
    const up = view.cross(back, right);
    const tangent = Math.tan((pose.fov * Math.PI) / 360);
    let widest = 0;
    for (const point of position) {
      const r = view.sub(point, pose.position);
      const depth = -view.dot(r, back);
      assert.ok(depth > 0);
      const x = Math.abs(view.dot(r, right)) / (depth * tangent * aspect);
      const y = Math.abs(view.dot(r, up)) / (depth * tangent);
      widest = Math.max(widest, x, y);
    }
    assert.ok(widest < 0.95 && widest > 0.8, String(widest));
  }
});

test('the main axis goes from the start to the end', () => {
  const back = [0, 1, 2, 3].map((x) => [-10 * x, -10 * x + 0.1 * (x % 2), 5]);
  const [x, y, z] = view.mainAxis(back);
  assert.ok(farthest([x, y, z], [-Math.SQRT1_2, -Math.SQRT1_2, 0]) < 0.02);
});

test('along the cable the camera is behind the place and above it', () => {
  const { s, position } = routeOf([{ length: 100, turn: 2 }], 0.25);
  const path = new view.Path(s, position);
  const pose = view.along(path, 50, 3);
  const ahead = path.tangent(50);
  assert.ok(view.dot(view.sub(pose.position, pose.target), ahead) < -2.9);
  assert.ok(pose.position[2] > pose.target[2] + 1);
});

test('places of points on the route', () => {
  const path = new view.Path(
    [0, 10, 20],
    [
      [0, 0, 0],
      [10, 0, 0],
      [10, 10, 0],
    ],
  );
  assert.deepEqual(path.at(15), [10, 5, 0]);
  assert.deepEqual(path.at(-5), [-5, 0, 0]);
  assert.deepEqual(path.at(25), [10, 15, 0]);
  const { s, distance } = path.nearest([11, 4, 2]);
  assert.ok(farthest([s, distance], [14, Math.sqrt(5)]) < 1e-12);
  assert.equal(path.nearest([-3, 0, 0]).s, 0);
});

test('picking on the screen: the nearest in reach, nothing behind the camera', () => {
  const screen = {
    x: [10, 14, 100, 12],
    y: [10, 10, 100, 10],
    depth: [5, 50, 5, -1],
  };
  assert.equal(
    view.pointAt(screen, 11, 10, () => 9),
    0,
  );
  assert.equal(
    view.pointAt(screen, 99, 101, () => 9),
    2,
  );
  assert.equal(
    view.pointAt(screen, 50, 50, () => 9),
    -1,
  );
  const line = { x: [0, 100, 100], y: [0, 0, 100], depth: [1, 1, 1] };
  assert.ok(Math.abs(view.lineAt(line, 25, 4, 8).index - 0.25) < 1e-9);
  assert.ok(Math.abs(view.lineAt(line, 103, 50, 8).index - 1.5) < 1e-9);
  assert.equal(view.lineAt(line, 50, 50, 8), null);
});

test('a tube goes through the centres, its normals stand on its tangents and do not turn over', () => {
  const n = 200;
  const centres = new Float32Array(3 * n);
  const angle = (i) => 0.05 * i;
  for (let i = 0; i < n; i++) centres.set([Math.cos(angle(i)), Math.sin(angle(i)), 0.3 * angle(i)], 3 * i);
  const ones = (value) => new Array(n).fill(value);
  const rings = new view.ChainRings({
    segments: n,
    length_m: ones(0.05),
    diameter_m: ones(0.1).fill(0.02, 150),
    part: ones(0).fill(1, 150),
  });
  assert.equal(rings.stretches.length, 2);
  rings.update(
    centres,
    Float32Array.from(ones(0), (_, i) => i),
  );
  const texel = (ring, k) => Array.from(rings.texels.subarray(12 * ring + 4 * k, 12 * ring + 4 * k + 4));
  const steps = (rings.stretches[0].last - rings.stretches[0].first) / 150;
  let off = 0;
  for (let i = 2; i < 148; i++) {
    const [x, y, z] = texel(Math.round((i + 0.5) * steps), 0);
    off = Math.max(off, Math.hypot(x - centres[3 * i], y - centres[3 * i + 1], z - centres[3 * i + 2]));
  }
  assert.ok(off < 1e-6, String(off));
  for (const { first, last } of rings.stretches)
    for (let ring = first; ring <= last; ring++) {
      const normal = texel(ring, 1).slice(0, 3);
      const tangent = texel(ring, 2).slice(0, 3);
      assert.ok(Math.abs(view.size(normal) - 1) < 1e-5 && Math.abs(view.size(tangent) - 1) < 1e-5);
      assert.ok(Math.abs(view.dot(normal, tangent)) < 1e-5);
      if (ring > first) assert.ok(view.dot(normal, texel(ring - 1, 1)) > 0.99);
    }
  assert.ok(Math.abs(texel(0, 1)[3] - 0.05) < 1e-7);
  assert.ok(Math.abs(texel(rings.count - 1, 1)[3] - 0.01) < 1e-7);
  assert.ok(Math.abs(texel(rings.count - 1, 2)[3] - 0.05 * n) < 1e-4);
});

test('a tube of one point, as rope in a winch, has no holes in its numbers', () => {
  const n = 5;
  const rings = new view.ChainRings({
    segments: n,
    length_m: [1, 1, 1, 1, 1],
    diameter_m: [1, 1, 1, 1, 1],
    part: [0, 0, 0, 0, 0],
  });
  rings.update(new Float32Array(3 * n), new Float32Array(n));
  assert.ok(rings.texels.every(Number.isFinite));
});

test('playback: real time against simulated, the end, and a start from it', () => {
  const play = new view.Playback(0, 10);
  assert.equal(play.rate, 1);
  assert.equal(play.advance(0.1), false);
  play.toggle();
  play.advance(0.1);
  assert.ok(Math.abs(play.time - 0.1) < 1e-12);
  play.seek(99);
  assert.equal(play.time, 10);
  play.advance(0.1);
  assert.equal(play.playing, false);
  play.toggle();
  assert.equal(play.time, 0);
  assert.equal(view.usualRate(8796), 500);
  assert.equal(view.usualRate(58), 2);
});

test('every key of the help does something, and others nothing', () => {
  const done = [];
  const act = new Proxy(
    {},
    {
      get:
        (_, name) =>
        (...args) =>
          done.push([name, ...args]),
    },
  );
  const press = (key, shift = false) => view.actionOf(key, shift, act)?.();
  for (const key of [' ', 'ArrowLeft', 'ArrowRight', 'Home', 'End', ',', '.', '+', '-', 'w', 'a', 's', 'd']) press(key);
  for (const key of ['1', '4', '5', '9', 'b', 'e', 'f', 'c', 'z', 'Escape']) press(key);
  press('ArrowRight', true);
  press('E', true);
  assert.deepEqual(
    done.map(([name, ...args]) => [name, ...args].join(' ')),
    [
      ...['toggle', 'step -1', 'step 1', 'end false', 'end true', 'faster -1', 'faster 1'],
      ...[`zoom ${1 / 1.3}`, 'zoom 1.3', 'orbit 0 5', 'orbit -5 0', 'orbit 0 -5', 'orbit 5 0'],
      ...[
        'preset 0',
        'preset 3',
        'bend 0',
        'bend 4',
        'nextBend 1',
        'event 1',
        'follow',
        'nextColour',
        'toPlace',
        'leave',
      ],
      ...['step 10', 'event -1'],
    ],
  );
  assert.equal(view.actionOf('q', false, act), null);
  assert.equal(view.actionOf('Tab', false, act), null);
});

test('labels: the heavier stay, the always shown stay whatever', () => {
  const box = (x, weight) => ({ x, y: 0, width: 10, height: 10, weight });
  assert.deepEqual(view.arranged([box(0, 1), box(5, 2), box(30, 1)]), [false, true, true]);
  assert.deepEqual(view.arranged([box(0, 100), box(5, 200)]), [true, true]);
});

test('times and lengths in words', () => {
  assert.equal(view.timeText(12.04, 30), '12.0\u00a0s');
  assert.equal(view.timeText(75, 900), '1:15\u00a0min');
  assert.equal(view.timeText(4000, 8796), '1:06:40\u00a0h');
  assert.equal(view.lengthText(34.21, 'si'), '34.2\u00a0m');
  assert.equal(view.lengthText(30.48, 'us'), '100.0\u00a0ft');
});

test('a swept circle keeps its radius about the line at any slope', () => {
  const line = [
    [0, 0, 0],
    [1, 0, 1],
    [1, 0, 3],
    [1, 1, 4],
  ];
  const ups = line.map(() => [0, 0, 1]);
  for (const { left, above } of view.axesAlong(line, ups)) {
    assert.ok(Math.abs(view.dot(left, above)) < 1e-12);
    assert.ok(farthest([view.size(left), view.size(above)], [1, 1]) < 1e-12);
  }
  const fine = view.refined(line, ups, 0.5);
  assert.equal(fine.line.length, fine.ups.length);
  assert.deepEqual(fine.line[fine.line.length - 1], [1, 1, 4]);
});

test('what is on the reel is told from what hangs beside it', () => {
  const run = {
    summary: {},
    geometry: {
      route: {
        s_m: [0, 10],
        position_m: [
          [0, 0, 0],
          [10, 0, 0],
        ],
        curvature_per_m: [0, 0],
      },
      reel: {
        center_m: [-5, 0, -1],
        axis: [0, 1, 0],
        radius_m: 1.5,
        width_m: 1,
      },
    },
    states: { ...packStates([0], 1, [0], { tension: [1] }), fields: FIELDS },
  };
  const model = view.modelOf(run);
  const inside = view.onReel(model);
  const at = (point) => inside(...model.at(point));
  assert.ok(at([-5, 0, 0.4]));
  assert.ok(!at([-3, 0, 0.5]));
  assert.ok(!at([-5, 3, -1]));
});

test('chains that are pulled together are found by their folders, and stand where the shown one puts its middle', async () => {
  const run = (label, names, x) => ({
    label,
    summary: { chains: names?.map((name) => ({ name })) },
    geometry: {
      route: {
        s_m: [0, 4],
        position_m: [
          [x, 0, 0],
          [x + 4, 0, 0],
        ],
        curvature_per_m: [0, 0],
      },
      rollers: [],
    },
  });
  const rope = run('out/duct', ['rope', 'red', 'blue', 'all'], 100);
  const red = run('out/duct/red', undefined, 100);
  const blue = run('out/duct/blue', undefined, 100.04);
  const other = run('out/other', undefined, 0);
  const all = [other, rope, red, blue];
  assert.deepEqual(view.pulledWith(all, rope), [red, blue]);
  assert.deepEqual(view.pulledWith(all, blue), [rope, red]);
  assert.deepEqual(view.pulledWith(all, other), []);
  assert.deepEqual(view.pulledWith([rope, other], rope), []);
  const own = view.modelOf(rope);
  const beside = new view.Beside([red, blue], own);
  assert.deepEqual(
    beside.models[1].at([102.04, 0, 0]).map((x) => Math.round(100 * x)),
    [4, 0, 0],
  );
  const states = packStates([0, 1], 1, [0, 0], { position: [102, 0, 0, 103, 0, 0] });
  await view.unpackFrames(states, (frames) => beside.arrived(1, frames));
  beside.show(0.5, 'tension');
  assert.equal(beside.nows[0], null);
  assert.ok(Math.abs(beside.nows[1].centre(0)[0] - 0.5) < 1e-3);
});
