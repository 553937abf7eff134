// The page in a browser: what it shows, and that it harms nobody.
import assert from 'node:assert/strict';
import test, { after } from 'node:test';
import { assertClose, column, open, savedCsv, stop } from './browser.mjs';
import { HOSTILE, report, run } from './sample.mjs';

after(stop);

const FIGURES = [
  'tension',
  'sidewall',
  'curvature',
  'profile',
  'force',
  'head',
  'speed',
  'rollers',
  'conveyor-force',
  'conveyor-slip',
  'motor-torque',
  'motor-speed',
  'reel-speed',
  'reel-cable',
];

test('opens from disk without a request, an error or a missing part', async () => {
  const { page, heard, close } = await open(report(run()));
  for (const id of FIGURES) assert.equal(await page.locator(`#figure-${id} canvas`).count(), 1, id);
  assert.equal(await page.locator('#figure-plan svg.plan').count(), 1);
  assert.deepEqual(heard, []);
  const spent = await page.evaluate(() => performance.getEntriesByType('navigation')[0].domComplete);
  console.log(`# open after ${spent.toFixed(0)} ms`);
  await close();
});

test('says first whether it is safe, where it is tightest and what to change', async () => {
  const { page, close } = await open(report(run()));
  const verdict = (await page.locator('#verdict').innerText()).replace(/[\u00a0\u202f]/g, ' ');
  for (const part of ['NOT SAFE', '605 N/m', '17.1 m (bend)', '500 N/m', '21 % over', 'a radius of 8.66 m']) {
    assert.ok(verdict.includes(part), `${part} in: ${verdict}`);
  }
  const { y, height } = await page.locator('#verdict').boundingBox();
  assert.ok(y + height < 900, 'on the first screen');
  await close();
});

test('key figures are those of the data; what is not known says so', async () => {
  const { page, close } = await open(report(run()));
  const text = await page.locator('#key-figures').innerText();
  for (const part of ['8\u00a0kN', '± 40\u00a0N (0.5\u202f%)', '9\u00a0kN', '8.1\u00a0kN', '0.1\u00a0m/s']) {
    assert.ok(text.includes(part), `${part} in: ${text}`);
  }
  assert.ok(!/paper|formulas/.test(text), text); // they know no level bends: on request alone
  await close();
  const unknown = run();
  unknown.summary.theory.reference_total_N = null;
  const other = await open(report(unknown));
  const theory = other.page.locator('#key-figures .fact', { hasText: 'theory' }).locator('dd').first();
  assert.equal(await theory.innerText(), 'not known');
  await other.close();
});

test('says of which pass the figures are, and what the other found', async () => {
  const pass = (segments, accuracy, mean, peak) => ({
    accuracy,
    segments,
    v_s_factor: accuracy < 1e-3 ? 0.5 : 1,
    steady_mean_N: mean,
    steady_mean_bar_N: 0.067 * mean,
    peak_N: peak,
    peak_bar_N: 0.1 * peak,
    steps: 10 * segments,
    wall_time_s: 1.5,
  });
  const passes = {
    outcome: 'replaced',
    why: 'the mean pull may be off by 6.7 %, mostly by the mesh',
    says: 'computed twice, with 69 and 138 segments: mean 7900 N and 8000 N; all figures are those of the second pass',
    pass: [pass(69, 1e-3, 7900, 9100), pass(138, 2.5e-4, 8000, 9000)],
  };
  const data = run();
  data.summary.passes = passes;
  const { page, heard, close } = await open(report(data));
  assert.match(await page.locator('#key-figures').innerText(), /those of a second pass with finer settings/);
  const trust = (await page.locator('#trust').innerText()).replace(/[\u00a0\u202f]/g, ' ');
  for (const part of ['may be off by 6.7 %', 'computed twice', 'second, shown', '7.9', '9.1', '138', '0.00025']) {
    assert.ok(trust.includes(part), `${part} in: ${trust}`);
  }
  assert.equal(await page.locator('#trust .record tbody tr').count(), 2);
  assert.deepEqual(heard, []);
  await close();

  data.summary.passes = {
    ...passes,
    pass: [...passes.pass, pass(276, 6.25e-5, 8010, 8990)],
  };
  const three = await open(report(data));
  assert.match(await three.page.locator('#key-figures').innerText(), /those of a third pass/);
  assert.match(await three.page.locator('#trust').innerText(), /third, shown/);
  assert.equal(await three.page.locator('#trust .record tbody tr').count(), 3);
  await three.close();

  data.summary.passes = {
    ...passes,
    outcome: 'declined',
    says: 'a second pass would take about 3 hours',
    pass: [passes.pass[0]],
  };
  const declined = await open(report(data));
  assert.match(await declined.page.locator('#key-figures').innerText(), /what it would take/);
  assert.match(await declined.page.locator('#trust').innerText(), /about 3 hours/);
  assert.equal(await declined.page.locator('#trust .record tbody tr').count(), 1);
  await declined.close();

  delete data.summary.passes;
  const once = await open(report(data));
  assert.doesNotMatch(await once.page.locator('main').innerText(), /second pass/);
  await once.close();
});

test('figures have the numbers of the data, in either system of units', async () => {
  const data = run();
  const { page, close } = await open(report(data));
  const pound = 0.45359237 * 9.80665;
  for (const [label, newton, metre] of [
    ['Metric', 1e-3, 1],
    ['US', 1 / pound, 1 / 0.3048],
  ]) {
    await page.getByText(label, { exact: true }).click();
    const force = await savedCsv(page, '#figure-force');
    assertClose(column(force, 'time'), data.series.time_s, 'time');
    assertClose(
      column(force, 'winch,'),
      data.series.winch_force_N.map((f) => f * newton),
      'winch force',
    );
    assertClose(
      column(force, 'winch by the reference'),
      data.series.reference_N.map((f) => f && f * newton),
      'reference',
    );
    const tension = await savedCsv(page, '#figure-tension');
    assertClose(
      column(tension, 'place'),
      data.envelope.place.s_m.map((s) => s * metre),
      'place',
    );
    assertClose(
      column(tension, 'simulated, largest'),
      data.envelope.place.tension_max_N.map((f) => f * newton),
      'envelope',
    );
    assertClose(
      column(tension, 'theory, pulled the other way'),
      data.theory_along.backward_N.map((f) => f * newton),
      'backward',
    );
    const mean = column(tension, 'simulated, steady mean').filter((value) => value !== null);
    assertClose(
      mean,
      data.stations.mean_N.map((f) => f * newton),
      'station means',
    );
    const head = await savedCsv(page, '#figure-head');
    assertClose(
      column(head, 'place').slice(0, 3),
      [10, 10.15, 10.3].map((s) => s * metre),
      'head',
    );
  }
  const axis = await page.locator('#figure-tension').getByRole('group').getAttribute('aria-label');
  assert.match(axis, /lbf/);
  await close();
});

test('the table behind a figure opens and has a row a point', async () => {
  const { page, close } = await open(report(run()));
  const figure = page.locator('#figure-sidewall');
  await figure.getByRole('button', { name: 'Table' }).click();
  assert.equal(await figure.locator('tbody tr').count(), 81);
  assert.match(await figure.locator('thead').innerText(), /place along the route, m/);
  await close();
});

test('rollers stand by margin, the smallest first', async () => {
  const { page, close } = await open(report(run()));
  const names = await page.locator('#rollers tbody th').allInnerTexts();
  assert.deepEqual(names.slice(0, 3), ['R19', 'R18', 'R17']);
  await page.getByRole('button', { name: 'Show all 20 rollers' }).click();
  assert.equal(await page.locator('#rollers tbody tr').count(), 20);
  assert.match(await page.locator('#rollers tbody tr').last().innerText(), /R4.*not given.*not known/s);
  await close();
});

test('hostile names do no harm and are shown as they are', async () => {
  const data = run(HOSTILE.script);
  Object.assign(data.summary, {
    title: HOSTILE.script + HOSTILE.image,
    case: HOSTILE.rightToLeft,
    verdict: `NOT SAFE: ${HOSTILE.quotes}`,
  });
  data.summary.events[0].what = HOSTILE.image;
  data.summary.conveyors[0].name = HOSTILE.long;
  data.summary.limits[1].where = HOSTILE.script;
  data.rollers.name = data.rollers.name.map((_, i) => Object.values(HOSTILE)[i % 6]);
  data.stations.name[0] = HOSTILE.formula;
  data.inputs.push({
    key: HOSTILE.image,
    value: HOSTILE.long,
    origin: HOSTILE.quotes,
    where: HOSTILE.rightToLeft,
  });
  const { page, heard, close } = await open(report(data, run(HOSTILE.long, 2)));
  assert.equal(await page.evaluate(() => globalThis.harmed), undefined);
  assert.equal(await page.locator('main img, main script, bdi *').count(), 0);
  assert.equal(await page.locator('h1').innerText(), HOSTILE.script + HOSTILE.image);
  assert.deepEqual(heard, []);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(wide <= 0, `wider than the window by ${wide}`);
  const rollers = await savedCsv(page, '#rollers > .tools');
  assert.ok(
    rollers.some((row) => row[0] === `'${HOSTILE.formula}`),
    'a formula is no formula in the CSV',
  );
  await close();
});

test('results of an older program: a sentence in place of every missing part', async () => {
  const old = {
    label: 'old',
    summary: {
      title: 'Old results',
      version: '0.1.0',
      theory: { paper_total_N: 1, reference_total_N: null },
    },
  };
  const { page, heard, close } = await open(report(old));
  await page.locator('#view').scrollIntoViewIfNeeded();
  await page.getByText('nothing to play').waitFor();
  const text = await page.locator('main').innerText();
  for (const part of [
    'hold no verdict',
    'no tension along the route',
    'no geometry',
    'nothing over time',
    'no conditions of trust',
    'no list of inputs',
    'nothing to play',
  ]) {
    assert.ok(text.includes(part), part);
  }
  assert.doesNotMatch(text, /NaN|undefined|null|Infinity/);
  assert.deepEqual(heard, []);
  await close();
});

test('a rod, which lies along no route, is played all the same', async () => {
  const rod = run();
  Object.assign(rod.geometry, {
    rollers: [],
    surfaces: [],
    conveyors: [],
    reel: null,
    winch: null,
  });
  rod.geometry.route = { s_m: null, position_m: null, curvature_per_m: null };
  const { page, heard, close } = await open(report(rod));
  await page.locator('#view').scrollIntoViewIfNeeded();
  await page.locator('#view canvas').first().waitFor();
  assert.deepEqual(heard, []);
  await close();
});

test('data of another format are refused with a sentence', async () => {
  const { page, close } = await open({ ...report(run()), format: 99 });
  assert.match(await page.locator('[role=alert]').innerText(), /format 99/);
  await close();
});
