// The page as the program writes it: a run, its report, and the figures of the page against summary.json and the CSV files.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { assertClose, column, openFile, parseCsv, ROOT, savedCsv, stop } from './browser.mjs';

const hawser = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), 'hawser-report-'));
after(async () => {
  await stop();
  rmSync(folder, { recursive: true, force: true });
});

/** Simulates a case of the project with changes; its results folder. */
function simulate(name, label, ...changes) {
  const results = join(folder, label);
  const set = changes.flatMap((change) => ['--set', change]);
  execFileSync(hawser, ['run', join(ROOT, 'cases', `${name}.yaml`), '-q', '-o', results, ...set]);
  return results;
}

function page(...results) {
  const path = join(folder, `${results.length}-${Math.random()}.html`);
  execFileSync(hawser, ['report', ...results, '-q', '-o', path]);
  return path;
}

const table = (results, name) => parseCsv(readFileSync(join(results, name), 'utf8').replaceAll(/\r?\n/g, '\r\n'));

/** Three significant digits of a number, as the page shows them in its unit. */
const near = (text, value) => Math.abs(Number(text) - value) <= 5e-4 * Math.abs(value);

test('a cable that is pushed: the push along the route, and what it is allowed', async () => {
  const results = simulate(
    'conveyors',
    'pushed',
    'run.duration=3 s',
    'run.steady_from=2 s',
    'limits={push: 10 kN}',
    'conveyors=[{name: c, from: 20 m, to: 24 m, clamp: 20 kN, mu: 0.3, factor: 1.05, limit: 3 kN}]',
  );
  const { page: view, heard, close } = await openFile(page(results));
  const figure = view.locator('#figure-push');
  assert.match(await figure.innerText(), /Push along the route/);
  assert.deepEqual(heard, []);
  await close();
});

test('a pull whose bend is too tight: what the page says is what the files say', async () => {
  const results = simulate('limits', 'limits');
  const summary = JSON.parse(readFileSync(join(results, 'summary.json'), 'utf8'));
  const { page: view, heard, close } = await openFile(page(results));
  const verdict = await view.locator('#verdict').innerText();
  assert.match(verdict, /NOT SAFE/);
  const sidewall = summary.limits.find((limit) => limit.name === 'sidewall');
  assert.ok(near(/pressure: ([\d.]+)/.exec(verdict)[1], sidewall.value), verdict);
  assert.match(verdict, /a radius of [\d.]+ m in 'bend'/i, 'what to change');
  const [mean] = await view.locator('#key-figures dd').allInnerTexts();
  assert.ok(near(/[\d.]+/.exec(mean)[0], summary.pull_force.steady_mean_N / 1e3), mean);

  const series = table(results, 'series.csv');
  const force = await savedCsv(view, '#figure-force');
  assertClose(column(force, 'time'), column(series, 'time_s'), 'time');
  assertClose(
    column(force, 'winch,').map((f) => f * 1e3),
    column(series, 'winch_force_N'),
    'winch force',
  );
  const stations = table(results, 'stations.csv');
  const tension = await savedCsv(view, '#figure-tension');
  const means = column(tension, 'simulated, steady mean').filter((value) => value !== null);
  assertClose(
    means.map((f) => f * 1e3),
    column(stations, 'mean_N').filter((value) => value !== null),
    'station means',
  );
  const loads = await savedCsv(view, '#rollers > .tools');
  const peaks = column(table(results, 'rollers.csv'), 'peak_N').sort((a, b) => b - a);
  assertClose(
    column(loads, 'peak').map((f) => f * 1e3),
    peaks,
    'all rollers have one rating: by load',
  );
  const inputs = await savedCsv(view, '#inputs');
  assert.equal(inputs.length, table(results, 'inputs.csv').length);
  assert.deepEqual(heard, []);
  await close();
});

test('the remedy is worth its name: two runs on one page, the second with the radius that the first asks for', async () => {
  const results = [simulate('limits', 'tight'), simulate('limits', 'wide', 'route.pieces.1.radius=12m')];
  const { page: view, heard, close } = await openFile(page(...results));
  const verdicts = await view.locator('#compare tbody').first().innerText();
  assert.match(verdicts, /not safe[\s\S]*safe/);
  await view.locator('#compare thead button').nth(1).click();
  assert.match(await view.locator('#verdict h2').innerText(), /^SAFE/);
  assert.deepEqual(heard, []);
  await close();
});
