// What a person does on the desk from its first screen to an answer, without typing YAML.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { ROOT, stop } from './browser.mjs';
import { assertSame, desk, differing, read, settled, textOf } from './desk.mjs';

const hawser = process.argv[2];
after(stop);

/** Does one thing after the other, and counts them. */
function actions(page) {
  let done = 0;
  const act = async (what) => {
    done++;
    await what;
    await settled(page);
  };
  return { act, count: () => done };
}

/** What the program says of the desk's text. */
async function program(page, ...args) {
  const folder = mkdtempSync(join(tmpdir(), 'hawser-path-'));
  try {
    writeFileSync(join(folder, 'case.yaml'), await textOf(page));
    return execFileSync(hawser, [args[0], join(folder, 'case.yaml'), ...args.slice(1)], { encoding: 'utf8' });
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('the first screen has a picture of each example; one of them, a draft or a file is the case then', async () => {
  const { page, heard, close } = await desk({ start: true });
  await page.waitForFunction(() => document.querySelectorAll('#start .picture .route').length >= 6);
  await page.evaluate(readFileSync(join(ROOT, 'web/node_modules/axe-core/axe.min.js'), 'utf8'));
  const found = await page.evaluate(() => window.axe.run(document, { iframes: false }));
  assert.deepEqual(
    found.violations.filter((one) => ['serious', 'critical'].includes(one.impact)).map((one) => one.id),
    [],
  );
  await page.getByRole('button', { name: 'The tunnel of the paper' }).click();
  await settled(page);
  assert.equal(await textOf(page), read('cases/huangjiahu.yaml'));
  assert.equal(await page.locator('#start').isVisible(), false);
  // the next time the draft is there, and the screen is not in the way
  await page.reload();
  await settled(page);
  assert.equal(await page.locator('#start').isVisible(), false);
  assert.equal(await textOf(page), read('cases/huangjiahu.yaml'));
  await page.click('#new');
  await page.getByRole('button', { name: 'case.yaml', exact: true }).waitFor();
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    page.getByRole('button', { name: /^Drop a case or a route here/ }).click(),
  ]);
  await chooser.setFiles(join(ROOT, 'cases/limits.yaml'));
  await page.waitForFunction(() => document.getElementById('name').textContent === 'limits.yaml');
  assert.equal(await page.locator('#start').isVisible(), false);
  assert.deepEqual(heard, []);
  await close();
});

test('three cables in a duct: cable and duct of the catalogue, friction, a verdict', async () => {
  const { page, heard, close } = await desk({ start: true });
  const { act, count } = actions(page);
  await act(page.getByRole('button', { name: 'Three cables in a duct' }).click());
  const before = await page.textContent('#verdict');
  await act(page.click('#tab-duct'));
  await act(page.selectOption('#duct select[aria-label="Kind"]', 'ducts'));
  await act(page.getByLabel('Search the catalogue').fill('pe-200 sdr11'));
  await act(page.getByRole('button', { name: 'Use pe-200-sdr11' }).click());
  // 1.05 by 161.6 mm of the duct over 41.5 mm of a cable
  assert.match(await page.innerText('#duct .cross'), /jam ratio\s+4\.09 /);
  await act(page.click('#tab-values'));
  for (const [key, value] of [
    ['surfaces.ducts.0.friction.mu', '0.4'],
    ['drive.tail.tension', '3 kN'],
    ['limits.sidewall', '1.9 kN/m'],
  ]) {
    await act(page.getByLabel(key, { exact: true }).fill(value));
    await act(page.keyboard.press('Enter'));
  }
  const said = JSON.parse(await program(page, 'theory', '--format', 'json'));
  const got = JSON.parse(await page.evaluate(() => window.hawserDesk.theory(window.hawserDesk.current())));
  assertSame(got, said);
  assert.equal(said.verdict_code, 'not_safe');
  assert.equal(await page.textContent('#verdict'), 'NOT SAFE', `${before} before`);
  assert.match(await page.textContent('#words'), /sidewall/);
  assert.ok(count() < 25, `${count()} actions`);
  assert.deepEqual(heard, []);
  await close();
});

test('a tunnel with rollers and conveyors: equipment by buttons, the run, its view in three dimensions', async () => {
  const { page, heard, close } = await desk({ start: true });
  const { act, count } = actions(page);
  await act(page.getByRole('button', { name: 'A tunnel with rollers' }).click());
  await act(page.click('#tab-equipment'));
  for (const at of ['10.2 m', '34.2 m']) {
    await act(page.getByLabel('at', { exact: true }).fill(at));
    await act(page.getByLabel('push', { exact: true }).fill('1 kN'));
    await act(page.getByRole('button', { name: 'Add a conveyor' }).click());
  }
  assert.notEqual(await page.textContent('#verdict'), 'NOT A CASE YET', await page.textContent('#words'));
  assert.match(await page.innerText('#equipment .list'), /conveyor\s+conveyor 2/);
  const text = await textOf(page);
  assert.ok(text.startsWith(read('docs/tutorial/tunnel.yaml')) && text.includes('conveyors:'), text);
  await act(page.click('#simulate'));
  await act(page.getByRole('button', { name: 'Start', exact: true }).click());
  await page.waitForFunction(() => /^By the run: /.test(document.getElementById('run-status').textContent));
  assert.ok(count() < 25, `${count()} actions`);
  const frame = page.frameLocator('#run-page');
  const canvas = frame.locator('#view canvas').first();
  await canvas.scrollIntoViewIfNeeded();
  await canvas.waitFor();
  const data = JSON.parse(await frame.locator('#hawser-data').textContent());
  assert.equal(data.runs[0].geometry.conveyors.length, 2);
  // something is drawn: not one colour alone
  const picture = await canvas.screenshot();
  assert.ok(picture.length > 5000, `a picture of ${picture.length} bytes`);
  assert.deepEqual(heard, []);
  await close();
});

test('the drawing that the route came from lies under the plan, also when its line is written into the case', async () => {
  const { page, close } = await desk();
  await page.setInputFiles('#file', join(ROOT, 'cases/routes/tunnel.dxf'));
  await page.waitForFunction(() => window.hawserDesk.current().includes('tunnel.dxf'));
  await settled(page);
  // the centre line and two walls, which are 5 m apart and 30 m long
  await page.waitForFunction(() => document.querySelectorAll('.plan .under').length === 3);
  const shown = () =>
    page.evaluate(() => {
      const spots = (path) =>
        path
          .getAttribute('d')
          .slice(1)
          .split('L')
          .map((pair) => pair.split(' ').map(Number));
      const [route] = [...document.querySelectorAll('.plan .route')].map(spots);
      const [centre, ...walls] = [...document.querySelectorAll('.plan .under')].map(spots);
      const off = Math.max(...centre.map(([x, y]) => Math.min(...route.map(([rx, ry]) => Math.hypot(x - rx, y - ry)))));
      const long = Math.hypot(...[0, 1].map((k) => walls[0].at(-1)[k] - walls[0][0][k]));
      const apart = Math.hypot(...[0, 1].map((k) => walls[0][0][k] - walls[1][0][k]));
      return { off, shape: apart / long };
    });
  const first = await shown();
  assert.ok(first.off < 1 && Math.abs(first.shape - 5 / 30) < 0.01, JSON.stringify(first));
  await page.click('#tab-route');
  await page.getByRole('button', { name: 'Write the line of the file into the case' }).click();
  await page.waitForFunction(() => window.hawserDesk.current().includes('plan:'));
  await settled(page);
  const then = await shown();
  assert.ok(then.off < 1, JSON.stringify(then));
  await page.click('#new');
  await page.getByRole('button', { name: 'A cable in a duct' }).click();
  await settled(page);
  assert.equal(await page.locator('.plan .under').count(), 0);
  await close();
});

test('a plan with clothoids has handles on the line up to its end; clothoids keep to the radius of their arc', async () => {
  const { page, close } = await desk();
  const plan = [
    'route:',
    '  heading: 25 deg',
    '  plan:',
    '    - {line: 30 m}',
    '    - {clothoid: 8 m, end_radius: 20 m, turn: left}   # in',
    '    - {arc: 22 m, radius: 20 m, turn: left}',
    '    - {clothoid: 8 m, start_radius: 20 m, turn: left}',
    '    - {line: 26 m}',
    '    - {clothoid: 9 m, start_radius: 40 m, end_radius: 15 m, turn: right}',
    '    - {arc: 14 m, radius: 15 m, turn: right}',
    '    - {line: 24 m}',
    '',
  ].join('\n');
  const text = read('docs/tutorial/duct.yaml')
    .replace(/chain:\n.*\n/, '')
    .replace(/route:\n( .*\n)+/, plan);
  await page.evaluate((words) => window.hawserDesk.open(words), text);
  await settled(page);
  assert.notEqual(await page.textContent('#verdict'), 'NOT A CASE YET', await page.textContent('#words'));
  const off = await page.evaluate(() => {
    const { x_m, y_m, pieces } = window.hawserDesk.along();
    const path = document.querySelector('.plan .route').getAttribute('d').slice(1).split('L');
    const drawn = path.map((pair) => pair.split(' ').map(Number));
    const scale = (drawn.at(-1)[0] - drawn[0][0]) / (x_m.at(-1) - x_m[0]);
    const pixel = ([x, y]) => [drawn[0][0] + scale * (x - x_m[0]), drawn[0][1] - scale * (y - y_m[0])];
    // lines and clothoids end where these pieces begin, the last one at the route's end
    const ends = [...[1, 2, 4, 5, 6].map((k) => pieces[k].start), [x_m.at(-1), y_m.at(-1)]].map(pixel);
    const spots = [...document.querySelectorAll('.plan .handle.length')].map((one) =>
      /translate\(([-\d.]+) ([-\d.]+)\)/.exec(one.getAttribute('transform')).slice(1).map(Number),
    );
    return { n: spots.length, far: Math.max(...spots.map(([x, y], i) => Math.hypot(ends[i][0] - x, ends[i][1] - y))) };
  });
  assert.ok(off.n === 6 && off.far < 0.3, JSON.stringify(off)); // the drawing has tenths of a pixel
  const press = async (name) => {
    await page.getByRole('slider', { name }).focus();
    await page.keyboard.press('ArrowUp');
    await settled(page);
    return differing(text, await textOf(page));
  };
  assert.deepEqual(await press(/^piece 2: length/), ['- {clothoid: 8.1 m, end_radius: 20 m, turn: left}   # in']);
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.deepEqual(await press(/^piece 3: radius/), [
    '- {clothoid: 8 m, end_radius: 20.1 m, turn: left}   # in',
    '- {arc: 22.11 m, radius: 20.1 m, turn: left}',
    '- {clothoid: 8 m, start_radius: 20.1 m, turn: left}',
  ]);
  await page.keyboard.press('Control+z');
  assert.equal(await textOf(page), text);
  await close();
});
