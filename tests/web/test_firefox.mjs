// The desk and a report in Debian's Firefox, from disk: no request leaves, the answer is Chromium's and the program's.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { HANGS, ROOT } from './browser.mjs';
import { assertSame, put, read, settled, textOf } from './desk.mjs';

const hawser = process.argv[2];
const FIREFOX = ['/usr/bin/firefox-esr', '/usr/bin/firefox'].find((path) => existsSync(path));
if (!FIREFOX) {
  console.log('skipped, because there is no firefox-esr: apt-get install firefox-esr');
  process.exit(77);
}
const { firefox } = createRequire(join(ROOT, 'web/package.json'))('playwright-core');

/** A page in a Firefox of its own, which is spoken to by WebDriver BiDi and closed when the test is over. */
async function opened(path, t) {
  const browser = await firefox.launch({ executablePath: FIREFOX, channel: 'moz-firefox', timeout: HANGS });
  t.after(() => browser.close());
  const page = await browser.newPage();
  page.setDefaultTimeout(HANGS);
  const heard = [];
  page.on('request', (request) => /^(https?|wss?):/.test(request.url()) && heard.push(`request of ${request.url()}`));
  page.on('pageerror', (error) => heard.push(error.stack ?? error.message));
  await page.goto(pathToFileURL(path).href);
  return { page, heard };
}

test('the desk: the verdict, an edit of the table, undo, a run with its report', async (t) => {
  const { page, heard } = await opened(join(ROOT, 'web/dist/desk.html'), t);
  await settled(page);
  await page.keyboard.press('Escape');
  assert.equal(await page.textContent('#verdict'), 'NOT SAFE');
  const before = await textOf(page);
  await page.getByLabel('Straight, piece 3').fill('20 m');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.equal(await textOf(page), before.replace('straight: 200 m', 'straight: 20 m'));
  assert.notEqual(await page.textContent('#verdict'), 'NOT SAFE');
  await page.click('#tab-plan');
  await page.keyboard.press('Control+z');
  assert.equal(await textOf(page), before);
  await settled(page);

  const name = 'cases/three-in-a-duct.yaml';
  const said = JSON.parse(execFileSync(hawser, ['theory', join(ROOT, name), '--format', 'json'], { encoding: 'utf8' }));
  assertSame(JSON.parse(await page.evaluate((text) => window.hawserDesk.theory(text), read(name))), said, name);

  await put(page, read('cases/huangjiahu.yaml'));
  await page.click('#simulate');
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await page.waitForFunction(() => /^By the run: SAFE/.test(document.getElementById('run-status').textContent));
  const frame = page.frameLocator('#run-page');
  await frame.locator('.plot canvas').first().waitFor();
  assert.deepEqual(heard, []);
});

test('the page of a report: its figures are drawn', async (t) => {
  const folder = mkdtempSync(join(tmpdir(), 'hawser-firefox-'));
  const path = join(folder, 'report.html');
  execFileSync(hawser, ['run', join(ROOT, 'cases/straight.yaml'), '-o', join(folder, 'r'), '-q'], { stdio: 'ignore' });
  execFileSync(hawser, ['report', join(folder, 'r'), '-o', path], { stdio: 'ignore' });
  const { page, heard } = await opened(path, t);
  await page.locator('.plot canvas').first().waitFor();
  assert.ok((await page.locator('#hawser section').count()) > 5);
  assert.deepEqual(heard, []);
  rmSync(folder, { recursive: true });
});
