// The view in a real browser, with software WebGL: what is drawn where, and what slider, keys and pointer do.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { inflateSync } from 'node:zlib';
import { pages, settled } from './pages.mjs';
import { small } from './scenes.mjs';

const data = small();
/** A real run's geometry and states, as `hawser report` wrote them: cases/huangjiahu.yaml. */
const real = JSON.parse(readFileSync(new URL('huangjiahu.data', import.meta.url), 'utf8'));
let kit;
let address;
let page;

before(async () => {
  kit = await pages();
  address = kit.write('small', data);
  page = await kit.open(address);
});

after(() => kit.close());

/** Positions [frame][segment][xyz], m: unpacked apart from the view, value by value. */
function positions({ frames, segments, packed, fields }) {
  const planes = inflateSync(Buffer.from(packed.position, 'base64'));
  const n = frames * segments * 3;
  const q = new Array(n);
  const at = (f, i, c) => (f < 0 || i < 0 ? 0 : q[(f * segments + i) * 3 + c]);
  for (let k = 0; k < n; k++) {
    const z = planes[k] + 256 * (planes[n + k] + 256 * (planes[2 * n + k] + 256 * planes[3 * n + k]));
    const [f, i, c] = [Math.floor(k / 3 / segments), Math.floor(k / 3) % segments, k % 3];
    q[k] = (z % 2 ? -(z + 1) / 2 : z / 2) + at(f, i - 1, c) + at(f - 1, i, c) - at(f - 1, i - 1, c);
  }
  return (f, i) => [0, 1, 2].map((c) => at(f, i, c) * fields.position.step);
}

const viewer = (body, argument) =>
  page.evaluate(`(${body})(window.hawser.view.viewer, window.hawser.store, ${JSON.stringify(argument ?? null)})`);

/** Which pixels of the picture the chain covers: drawn with it and without; and the camera. */
async function chainMask() {
  await settled(page);
  return viewer(`({ world, model }) => {
    const { stage } = world;
    const gl = stage.renderer.getContext();
    const [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const picture = (visible) => {
      world.chains[0].mesh.visible = visible;
      stage.renderer.render(stage.scene, stage.camera);
      const pixels = new Uint8Array(4 * w * h);
      gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return pixels;
    };
    const [without, whole] = [picture(false), picture(true)];
    const mask = [];
    for (let i = 0; i < w * h; i++)
      if ([0, 1, 2].some((c) => Math.abs(whole[4 * i + c] - without[4 * i + c]) > 12)) mask.push(i);
    const colours = new Set();
    for (let i = 0; i < w * h; i += 7) colours.add(whole.subarray(4 * i, 4 * i + 3).join());
    const camera = stage.camera;
    return { w, h, mask, colours: colours.size, view: camera.matrixWorldInverse.elements,
             projection: camera.projectionMatrix.elements, centre: model.centre };
  }`);
}

/** A point of the scene in the picture's pixels, y upward, by the camera's matrices. */
function projected({ w, h, view, projection, centre }, point) {
  const times = (m, v) => [0, 1, 2, 3].map((r) => m[r] * v[0] + m[r + 4] * v[1] + m[r + 8] * v[2] + m[r + 12] * v[3]);
  const clip = times(projection, times(view, [...point.map((x, i) => x - centre[i]), 1]));
  return [(0.5 + (0.5 * clip[0]) / clip[3]) * w, (0.5 + (0.5 * clip[1]) / clip[3]) * h];
}

test('the picture is not blank, nothing is asked of a network, nothing complains', async () => {
  const { colours } = await chainMask();
  assert.ok(colours > 200, `${colours} colours`);
  assert.deepEqual(page.complaints, []);
});

/** Compares the picture of a run with its states at times that are (frame, part of the way to the next). */
async function compareWithStates({ states }, moments) {
  const at = positions(states);
  const { time_s: time, segments, frames } = states;
  await viewer('(viewer) => viewer.preset(2, true)');
  for (const [frame, part] of moments) {
    const next = Math.min(frame + 1, frames - 1);
    const now = (1 - part) * time[frame] + part * time[next];
    await viewer('(viewer, store, t) => viewer.seek(t)', now);
    const shot = await chainMask();
    const covered = new Set(shot.mask);
    let checked = 0;
    for (let i = 3; i < segments - 3; i += 7) {
      const b = at(next, i);
      const [x, y] = projected(
        shot,
        at(frame, i).map((v, c) => v + part * (b[c] - v)),
      );
      if (x < 20 || y < 20 || x > shot.w - 20 || y > shot.h - 20) continue;
      const { n, dx, dy } = middleAround(shot, covered, x, y);
      assert.ok(n > 4, `nothing at segment ${i} at ${now} s`);
      assert.ok(Math.hypot(dx, dy) < 1.5, `segment ${i} is ${dx}, ${dy} px off at ${now} s`);
      checked++;
    }
    assert.ok(checked >= 10, `${checked} points`);
  }
}

/** How many covered pixels there are within 7 px of a point, and how far off their middle is. */
function middleAround({ w }, covered, x, y) {
  let [n, sx, sy] = [0, 0, 0];
  for (let px = Math.round(x) - 7; px <= Math.round(x) + 7; px++)
    for (let py = Math.round(y) - 7; py <= Math.round(y) + 7; py++) {
      if (Math.hypot(px + 0.5 - x, py + 0.5 - y) > 7 || !covered.has(py * w + px)) continue;
      n++;
      sx += px + 0.5 - x;
      sy += py + 0.5 - y;
    }
  return { n, dx: sx / n, dy: sy / n };
}

test('the cable is drawn where its states are, at three times', () =>
  compareWithStates(data.runs[0], [
    [0, 0],
    [16, 0.65],
    [40, 0],
  ]));

test('the slider moves time, the sentence and the store with it', async () => {
  const slider = page.getByLabel('Simulated time');
  await slider.evaluate((input) => {
    input.value = 2000;
    input.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await settled(page);
  assert.ok(Math.abs((await viewer('(v, store) => store.get("time")')) - 20) < 1e-6);
  assert.match(
    await page.locator('.view-words p').first().textContent(),
    /^At 20\.0\ss the head is at 3\d\.\d\sm, the largest tension is/,
  );
  assert.equal(await page.locator('.view-reading').textContent(), '20.0\u00a0s');
});

test('play goes on, pause stops, the end stops', async () => {
  await viewer('(viewer) => viewer.seek(10)');
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.waitForFunction(() => window.hawser.store.get('time') > 10.5);
  await page.getByRole('button', { name: 'Pause' }).click();
  const stopped = await viewer('({ playback }) => playback.time');
  await settled(page);
  assert.equal(await viewer('({ playback }) => playback.time'), stopped);
  await viewer('(viewer) => { viewer.seek(39.9); viewer.toggle(); }');
  await page.waitForFunction(() => !window.hawser.view.viewer.playback.playing);
  assert.equal(await viewer('({ playback }) => playback.time'), 40);
});

test('the keyboard: frames, ends, events, play, colour, camera', async () => {
  await page.locator('.view-stage canvas').focus();
  const time = () => viewer('({ playback }) => playback.time');
  const press = async (key) => {
    await page.keyboard.press(key);
    await settled(page);
  };
  await press('Home');
  assert.equal(await time(), 0);
  await press('ArrowRight');
  assert.equal(await time(), 1);
  await press('Shift+ArrowRight');
  assert.equal(await time(), 11);
  await press('ArrowLeft');
  assert.equal(await time(), 10);
  await press('e');
  assert.equal(await time(), 12);
  await press('e');
  assert.equal(await time(), 24);
  await press('Shift+E');
  assert.equal(await time(), 12);
  await press('End');
  assert.equal(await time(), 40);
  await press('Home');
  await press('Space');
  assert.equal(await viewer('({ playback }) => playback.playing'), true);
  await press('Space');
  assert.equal(await viewer('({ playback }) => playback.playing'), false);
  await press('c');
  assert.match(await page.locator('.view-legend-title').textContent(), /^Sidewall pressure/);
  await viewer('(viewer) => viewer.colour("tension")');
  const distance = () => viewer('({ world }) => world.stage.distance');
  await viewer('(viewer) => viewer.preset(0, true)');
  const from = await distance();
  await press('+');
  await page.waitForFunction((far) => window.hawser.view.viewer.world.stage.distance < 0.8 * far, from);
});

test('presets and bends stand where they should', async () => {
  const look = () =>
    viewer(
      `({ world }) => { const { position, target } = world.stage.pose; return position.map((x, i) => x - target[i]); }`,
    );
  await viewer('(viewer) => viewer.preset(2, true)');
  const above = await look();
  assert.ok(above[2] > 50 * Math.hypot(above[0], above[1]));
  await viewer('(viewer) => viewer.preset(3, true)');
  const side = await look();
  assert.ok(Math.hypot(side[0], side[1]) > 20 * Math.abs(side[2]));
  assert.deepEqual(
    await viewer('({ model }) => model.bends.map((bend) => Math.round((bend.angle * 180) / Math.PI))'),
    [60, 15, 15],
  );
  await page.locator('.view-stage canvas').focus();
  await page.keyboard.press('5');
  await page.waitForFunction(() => {
    const { world, model } = window.hawser.view.viewer;
    const middle = model.path.at(18);
    const { target } = world.stage.pose;
    return Math.hypot(...target.map((x, i) => x - middle[i])) < 3;
  });
  await viewer('(viewer) => viewer.preset(1, true)');
  assert.ok(Math.hypot(...(await look())) < 6);
});

/** Where a roller or a place is on the page, CSS pixels. */
const onPage = async (point) => {
  await settled(page);
  const box = await page.locator('.view-stage canvas').boundingBox();
  const at = await viewer(
    `({ world, model }, store, which) => {
    const { centres } = world.rollers;
    world.rollers.place(world.factor);
    const point = 'roller' in which ? [...centres.subarray(3 * which.roller, 3 * which.roller + 3)] : model.path.at(which.place);
    return world.onScreen(point);
  }`,
    point,
  );
  return { x: box.x + at.x, y: box.y + at.y };
};

test('a click on a roller shows its figures and tells the store; Esc takes them away', async () => {
  await viewer('(viewer) => viewer.preset(0, true)');
  const { x, y } = await onPage({ roller: 9 });
  await page.mouse.click(x, y);
  await settled(page);
  assert.equal(await viewer('(v, store) => store.get("roller")'), 9);
  const inspector = page.locator('.view-inspector');
  assert.match(await inspector.textContent(), /R10.*peak 420\sN/s);
  await page.keyboard.press('Escape');
  assert.equal(await viewer('(v, store) => store.get("roller")'), null);
  assert.equal(await inspector.isVisible(), false);
});

test('hover on the cable is a place in the store, a place in the store is a mark in the picture', async () => {
  const { x, y } = await onPage({ place: 27.5 });
  await page.mouse.move(x, y - 1);
  await settled(page);
  assert.ok(Math.abs((await viewer('(v, store) => store.get("place")')) - 27.5) < 0.5);
  await page.mouse.click(x, y - 1);
  await settled(page);
  assert.match(await page.locator('.view-inspector').textContent(), /Place 27\.\d\sm/);
  await page.locator('.view-inspector').getByRole('button', { name: 'Close' }).click();
  await page.mouse.move(5, 5);
  await viewer('(v, store) => store.set("place", 12, null)');
  await settled(page);
  assert.equal(await page.locator('.view-label-place').textContent(), '12.0\u00a0m');
  await viewer('(v, store) => store.set("place", null, null)');
  assert.equal(await page.locator('.view-label-place').count(), 0);
});

test('time from another figure, units and theme are followed', async () => {
  await viewer('(v, store) => store.set("time", 33, "figure")');
  await settled(page);
  assert.equal(await viewer('({ now }) => now.time'), 33);
  await viewer('(v, store) => store.set("units", "us")');
  await settled(page);
  assert.equal(await page.locator('.view-legend-title').textContent(), 'Tension, lbf');
  assert.match(
    await page.locator('.view-words p').first().textContent(),
    /\sft, the largest tension is .*\slbf at .*\sft\.$/,
  );
  await viewer('(v, store) => store.set("theme", "dark")');
  assert.equal(await page.locator('.view3d').getAttribute('data-theme'), 'dark');
  await viewer('(v, store) => { store.set("theme", "light"); store.set("units", "si"); }');
});

test('the exaggeration is said: as suits the view, or as the slider asks', async () => {
  await viewer('(viewer) => viewer.preset(0, true)');
  await settled(page);
  const note = page.locator('.view-legend-note').nth(1);
  assert.match(await note.textContent(), /^diameter × \d/);
  await page.getByLabel('Diameter drawn').evaluate((input) => {
    input.value = 1;
    input.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await settled(page);
  assert.equal(await note.textContent(), 'true diameter');
});

test('words are there for those who do not see: a live sentence, names of all controls', async () => {
  await viewer('(viewer) => viewer.seek(12)');
  await page.waitForFunction(() => /^At 12\.0/.test(document.querySelector('[aria-live=polite]').textContent));
  const nameless = await page.evaluate(
    () =>
      [...document.querySelectorAll('.view3d button, .view3d select, .view3d input')].filter(
        (control) => !(control.getAttribute('aria-label') || control.textContent.trim() || control.labels?.length),
      ).length,
  );
  assert.equal(nameless, 0);
});

test('with reduced motion the camera is there at once', async () => {
  const still = await kit.open(address, { reducedMotion: 'reduce' });
  const moved = await still.evaluate(() => {
    const { viewer } = window.hawser.view;
    viewer.preset(3);
    const { position, target } = viewer.world.stage.pose;
    return Math.abs(position[2] - target[2]) / Math.hypot(position[0] - target[0], position[1] - target[1]);
  });
  assert.ok(moved < 0.05);
  await still.close();
});

test('disposed, it leaves nothing; damaged states are said', async () => {
  await page.evaluate(() => window.hawser.view.dispose());
  assert.equal(await page.locator('#hawser > *').count(), 0);
  assert.deepEqual(page.complaints, []);
  const broken = structuredClone(data);
  broken.runs[0].states.packed.position = broken.runs[0].states.packed.position.slice(0, 400);
  const other = await kit.open(kit.write('broken', broken));
  assert.match(await other.locator('.view-words p').first().textContent(), /^The states cannot be shown/);
  await other.close();
});

test('a real run is drawn where its states are, and its rollers have their loads', async () => {
  const address = kit.write('real', real);
  page = await kit.open(address);
  await compareWithStates(real.runs[0], [
    [0, 0],
    [20, 0.5],
    [60, 0],
  ]);
  await viewer('(viewer) => viewer.inspect({ roller: 14 })');
  await settled(page);
  const text = await page.locator('.view-inspector').textContent();
  const peak = real.runs[0].rollers.peak_N[14];
  assert.ok(text.includes(`peak ${(peak / 1000).toFixed(2)}\u00a0kN`), text);
  assert.equal(await page.locator('.view-inspector canvas').count(), 1);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test('without WebGL there is a sentence, and the clock still goes', async () => {
  const plain = await pages(['--disable-gpu', '--disable-3d-apis', '--no-sandbox']);
  try {
    const blind = await plain.open(plain.write('small', data));
    assert.match(await blind.locator('.view-notice').textContent(), /no WebGL/);
    await blind.evaluate(() => window.hawser.view.viewer.seek(20));
    await settled(blind);
    assert.match(await blind.locator('.view-words p').first().textContent(), /^At 20\.0/);
  } finally {
    await plain.close();
  }
});
