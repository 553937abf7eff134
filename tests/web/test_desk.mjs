// The desk from disk: what it says is what the program says, edits change their own line alone, nothing is asked of a network.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { ROOT, stop } from './browser.mjs';
import { assertSame, desk, differing, drag, put, read, settled, textOf } from './desk.mjs';

const hawser = process.argv[2];
const { unzipSync } = createRequire(join(ROOT, 'web/package.json'))('fflate');
after(stop);

test('the first screen: the verdict of the example and its calculation, without a request', async () => {
  const { page, heard, close } = await desk();
  assert.equal(await page.textContent('#verdict'), 'NOT SAFE');
  assert.match(await page.textContent('#words'), /^Pulled forward 20\.8\skN at the winch\. 2 of 9 limits broken/);
  await page.click('#tab-page');
  const calculation = page.frameLocator('#page');
  assert.match(await calculation.locator('h1').innerText(), /Joint bay A to joint bay B/);
  assert.equal(await calculation.getByText('To be followed by hand').count(), 1);
  assert.deepEqual(heard, []);
  await close();
});

test('theory of cases of every kind is what the program says', async () => {
  const cases = [
    'docs/tutorial/duct',
    'cases/theory/planner',
    'cases/huangjiahu',
    'cases/limits',
    'cases/three-in-a-duct',
    'cases/tray',
  ];
  const { page, heard, close } = await desk();
  for (const name of cases) {
    const said = JSON.parse(
      execFileSync(hawser, ['theory', join(ROOT, `${name}.yaml`), '--format', 'json'], { encoding: 'utf8' }),
    );
    const got = await page.evaluate((text) => window.hawserDesk.theory(text), read(`${name}.yaml`));
    assertSame(JSON.parse(got), said, name);
  }
  assert.deepEqual(heard, []);
  await close();
});

test('a mistake is said at its line, as the program says it', async () => {
  const { page, close } = await desk();
  await put(page, read('docs/tutorial/duct.yaml').replace('radius: 70 mm', 'radius: thick'));
  assert.equal(await page.textContent('#verdict'), 'NOT A CASE YET');
  assert.match(await page.textContent('#words'), /^line 20: key 'surfaces\.ducts\.0\.radius': value 'thick'/);
  assert.equal(await page.locator('.cm-lint-marker-error').count(), 1);
  await close();
});

test('an edit of the table changes one line; undo gives the bytes back; a remedy is written', async () => {
  const { page, close } = await desk();
  const before = `# kept\n${read('docs/tutorial/duct.yaml')}`;
  await put(page, before);
  await page.click('#tab-route');
  await page.getByLabel('Straight, piece 3').fill('120 m');
  await page.keyboard.press('Enter');
  await settled(page);
  const after = await textOf(page);
  assert.equal(after, before.replace('straight: 200 m', 'straight: 120 m'));
  await page.click('#tab-text');
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+z');
  assert.equal(await textOf(page), before);
  await settled(page);
  await page.getByRole('button', { name: 'friction.mu: 0.18' }).click();
  await settled(page);
  assert.equal(await textOf(page), before.replace('{mu: 0.3}', '{mu: 0.18}'));
  assert.equal(await page.textContent('#verdict'), 'SAFE', await page.textContent('#words'));
  await page.click('#tab-values');
  await page.getByLabel('friction.mu').fill('0.5');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.equal(await page.textContent('#verdict'), 'NOT SAFE');
  await close();
});

test('a surveyor’s table becomes the route, the case and the calculation are saved', async () => {
  const { page, heard, close } = await desk();
  await page.setInputFiles('#file', join(ROOT, 'cases/theory/route-table.csv'));
  await page.waitForFunction(() => window.hawserDesk.current().includes('route-table.csv'));
  await settled(page);
  assert.match(await page.textContent('#status'), /route-table\.csv: route-table \(644\.9 m\)/);
  const text = await textOf(page);
  assert.ok(
    text.includes('route: {file: "route-table.csv"}') && text.includes('surfaces:') && !text.includes('pieces:'),
  );
  const saved = async (button) => {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
    return [download.suggestedFilename(), readFileSync(await download.path())];
  };
  const [name, calculation] = await saved('#save-page');
  assert.equal(name, 'case-calculation.html');
  const words = calculation.toString();
  assert.ok(words.includes('<h1>Pulling calculation') && words.includes('under the sewer'));
  const verdict = await page.textContent('#words');

  // the case and its file are one archive, which opens on another desk
  const [archive, bytes] = await saved('#save');
  assert.equal(archive, 'case.zip');
  const inside = unzipSync(bytes);
  assert.deepEqual(Object.keys(inside).sort(), ['case.yaml', 'route-table.csv']);
  assert.equal(Buffer.from(inside['case.yaml']).toString(), text);
  assert.deepEqual(Buffer.from(inside['route-table.csv']), readFileSync(join(ROOT, 'cases/theory/route-table.csv')));
  const other = await desk();
  await other.page.setInputFiles('#file', { name: archive, mimeType: 'application/zip', buffer: bytes });
  await other.page.waitForFunction((one) => window.hawserDesk.current() === one, text);
  await settled(other.page);
  assert.equal(await other.page.textContent('#words'), verdict);

  // the draft has the file as well
  await other.page.reload();
  await settled(other.page);
  assert.equal(await textOf(other.page), text);
  assert.equal(await other.page.textContent('#words'), verdict);

  // a case that names a file of the same name does not get that of the case before, and says which file is missing
  await other.page.setInputFiles('#file', { name: 'b.yaml', mimeType: 'text/yaml', buffer: Buffer.from(text) });
  await other.page.waitForFunction(() => document.getElementById('name').textContent === 'b.yaml');
  await settled(other.page);
  assert.equal(await other.page.textContent('#verdict'), 'NOT A CASE YET');
  const [chooser] = await Promise.all([
    other.page.waitForEvent('filechooser'),
    other.page.getByRole('button', { name: 'Choose the file route-table.csv' }).click(),
  ]);
  await chooser.setFiles(join(ROOT, 'cases/theory/route-table.csv'));
  await other.page.waitForFunction(() => document.getElementById('verdict').textContent !== 'NOT A CASE YET');
  await settled(other.page);
  assert.equal(await other.page.textContent('#words'), verdict);
  assert.deepEqual([...heard, ...other.heard], []);
  await other.close();
  await close();
});

test('a drag of a bend by 20 px changes one line, comments stay, undo gives the bytes back', async () => {
  const { page, heard, close } = await desk();
  const given = `# kept\n${read('docs/tutorial/duct.yaml').replace('straight: 200 m}', 'straight: 200 m}   # under the road')}`;
  await put(page, given);
  for (const [label, dx, dy, changed] of [
    ['corner: radius', 14, -14, /^- \{name: corner, bend: 45 deg, radius: [\d.]+ m, plane: right\}$/],
    ['corner: angle', 0, 20, /^- \{name: corner, bend: \d+ deg, radius: 8 m, plane: right\}$/],
    ['road: length', 20, 20, /^- \{name: road, {3}straight: [\d.]+ m\} {3}# under the road$/],
  ]) {
    await drag(page, label, dx, dy);
    const after = await textOf(page);
    const lines = differing(given, after);
    assert.equal(lines.length, 1, `${label}: ${lines.join(' | ')}`);
    assert.match(lines[0], changed);
    await page.keyboard.press('Control+z');
    assert.equal(await textOf(page), given, label);
    await settled(page);
  }
  assert.deepEqual(heard, []);
  await close();
});
