// Runs on the desk: the estimate, the run while it is computed, Stop, the report; verdict and pull are the program's. No request leaves.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { ROOT, stop } from './browser.mjs';
import { desk, put, read, settled } from './desk.mjs';

const hawser = process.argv[2];
after(stop);

/** summary.json of the program's run. */
function native(name) {
  const folder = mkdtempSync(join(tmpdir(), 'hawser-run-'));
  try {
    execFileSync(hawser, ['run', join(ROOT, name), '-o', join(folder, 'r'), '-q'], { stdio: 'ignore' });
    return JSON.parse(readFileSync(join(folder, 'r/summary.json'), 'utf8'));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const status = (page) => page.textContent('#run-status');

/** Starts the case that is on the desk. */
async function begin(page) {
  await page.click('#simulate');
  await page.getByRole('button', { name: 'Start' }).click();
}

const reported = (page) =>
  page.waitForFunction(() => document.getElementById('run-page').srcdoc.includes('hawser-data'));

test('the tunnel of the paper: estimate, run, report; verdict and pull are those of the program', async () => {
  const { page, heard, close } = await desk();
  await put(page, read('cases/huangjiahu.yaml'));
  await page.click('#simulate');
  await page.waitForFunction(() => /370 segments, 30 s/.test(document.getElementById('run-estimate').textContent));
  await page.getByRole('button', { name: 'Start' }).click();
  await reported(page);
  const frame = page.frameLocator('#run-page');
  await frame.locator('#verdict').waitFor();
  const data = JSON.parse(await frame.locator('#hawser-data').textContent());
  const [run] = data.runs;
  const expected = native('cases/huangjiahu.yaml');
  assert.equal(run.summary.verdict, expected.verdict);
  assert.match(await status(page), new RegExp(`^By the run: ${expected.verdict.split(':')[0]}`));
  const [got, own] = [run.summary.pull_force, expected.pull_force];
  const most = own.steady_mean_error.time_N + got.steady_mean_error.time_N;
  assert.ok(Math.abs(got.steady_mean_N - own.steady_mean_N) <= most, `${got.steady_mean_N} ${own.steady_mean_N}`);
  // the report has its view, with states
  assert.ok(run.states.frames > 10 && run.geometry.rollers.length === 32);
  await frame.locator('canvas').first().waitFor();
  assert.equal(await page.getByRole('button', { name: 'Save the report' }).isDisabled(), false);
  assert.deepEqual(heard, []);
  await close();
});

test('a long run shows force and view while it is computed, the desk can be used, Stop ends it at once', async (t) => {
  const { page, heard, close } = await desk();
  // so many segments that it takes a while
  await put(page, read('cases/huangjiahu.yaml').replaceAll('segment: 500 mm', 'segment: 5 mm'));
  await begin(page);
  const live = page.frameLocator('#run-page');
  await live.locator('#figure-live').waitFor();
  await live.locator('canvas').first().waitFor();
  await page.waitForFunction(() => document.querySelector('#simulation progress').value > 0.01);
  await page.getByRole('button', { name: 'Back to the case' }).click();
  assert.match(await page.textContent('#simulate'), /^Simulating \d+ %$/);
  await page.click('#simulate');
  // from when the browser had the click to when the screen says so
  const took = page.evaluate(
    () =>
      new Promise((resolve) => {
        const said = document.getElementById('run-status');
        let clicked = 0;
        document.addEventListener('click', (event) => (clicked = event.timeStamp), true);
        new MutationObserver(() => {
          if (/^Stopped at /.test(said.textContent)) resolve(performance.now() - clicked);
        }).observe(said, { childList: true, characterData: true, subtree: true });
      }),
  );
  await page.getByRole('button', { name: 'Stop' }).click();
  const ms = await took;
  t.diagnostic(
    `from the click on Stop to the word on the screen: ${ms.toFixed(0)} ms; half a second is what is promised`,
  );
  assert.match(
    await status(page),
    /^Stopped at [\d.]+ s of 30 s\. Until then the winch pulled [\d.]+\sk?N at most, at [\d.]+ s\. .* no verdict of the whole/,
  );
  // the report of what was computed until then, which ended up with none before
  await reported(page);
  await live.locator('#verdict').waitFor();
  const [run] = JSON.parse(await live.locator('#hawser-data').textContent()).runs;
  assert.match(run.summary.verdict, /^NOT TRUSTED: the run ended at [-\d.e]+ s of 30 s/);
  assert.ok(run.summary.sim_time_s > 0 && run.summary.sim_time_s < 30 && run.states.frames > 0);
  await page.waitForFunction(() => document.querySelector('#simulation progress').hidden);
  assert.equal(await page.getByRole('button', { name: 'Save the report' }).isDisabled(), false);
  assert.deepEqual(heard, []);
  await close();
});

test('Simulate by day and by night, on a narrow screen and in three languages, before a run and behind it (axe-core)', async () => {
  const axe = readFileSync(join(ROOT, 'web/node_modules/axe-core/axe.min.js'), 'utf8');
  for (const colorScheme of ['light', 'dark']) {
    const { page, heard, close } = await desk({ colorScheme, viewport: { width: 390, height: 844 } });
    await page.evaluate(axe);
    await put(page, read('cases/huangjiahu.yaml'));
    const good = async (when) => {
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= 390, `${when}: ${wide} px wide`);
      const found = await page.evaluate(() => window.axe.run(document, { iframes: false }));
      const serious = found.violations.filter((one) => ['serious', 'critical'].includes(one.impact));
      assert.deepEqual(
        serious.map((one) => `${when}, ${colorScheme}: ${one.id} ${one.nodes[0].html.slice(0, 120)}`),
        [],
      );
    };
    await page.click('#simulate');
    await page.waitForFunction(() => document.getElementById('run-estimate').textContent !== '');
    assert.equal(await page.locator('#run-page').isVisible(), false);
    await good('before');
    await page.getByRole('button', { name: 'Start', exact: true }).click();
    await reported(page);
    await good('behind');
    const box = await page.locator('#run-page').boundingBox();
    assert.ok(box.height > 600, `the report is ${box.height} px high`);
    for (const language of ['zh', 'de']) {
      await page.selectOption('#language', language);
      await settled(page);
      await page.click('#simulate');
      await page.waitForFunction(() => document.getElementById('run-estimate').textContent !== '');
      await good(language);
    }
    assert.deepEqual(await page.evaluate(() => window.hawserDesk.withoutRow()), []);
    assert.deepEqual(heard, []);
    await close();
  }
});
