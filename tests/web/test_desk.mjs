// The desk from disk: what it says is what the program says, edits change their own line alone, nothing is asked of a network.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test, { after } from 'node:test';
import { openFile, ROOT, stop } from './browser.mjs';

const hawser = process.argv[2];
after(stop);

/** Until what is on the screen is of the text as it stands. */
const settled = (page) =>
  page.waitForFunction(
    () =>
      document.getElementById('verdict').textContent !== '' &&
      document.getElementById('answer').getAttribute('aria-busy') === 'false' &&
      window.hawserDesk.idle(),
  );

async function desk(options) {
  const opened = await openFile(join(ROOT, 'web/dist/desk.html'), options, settled);
  opened.page.on('dialog', (dialog) => dialog.accept());
  return opened;
}

const textOf = (page) => page.evaluate(() => window.hawserDesk.current());

async function put(page, text) {
  await page.evaluate((words) => window.hawserDesk.open(words), text);
  await settled(page);
}

const read = (path) => readFileSync(join(ROOT, path), 'utf8');

/** Equal texts; numbers within 1e-9 of the larger of two. What is next to nothing (a slope of 1e-15) has no digits. */
function assertSame(got, expected, place = '') {
  if (typeof expected === 'number') {
    const size = Math.max(Math.abs(got), Math.abs(expected));
    assert.ok(Math.abs(got - expected) <= 1e-9 * size + 1e-12, `${place}: ${got} and ${expected}`);
  } else if (expected && typeof expected === 'object') {
    assert.deepEqual(Object.keys(got), Object.keys(expected), place);
    for (const key of Object.keys(expected)) assertSame(got[key], expected[key], `${place}.${key}`);
  } else {
    assert.equal(got, expected, place);
  }
}

test('the first screen: the verdict of the example and its calculation, without a request', async () => {
  const { page, heard, close } = await desk();
  assert.equal(await page.textContent('#verdict'), 'NOT SAFE');
  assert.match(
    await page.textContent('#words'),
    /^Pulled forward 20\.80 kN at the winch\. NOT SAFE: 2 of 9 limits broken/,
  );
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

test('two hundred random edits: the table shows the text, and the program reads it as the desk does', async () => {
  const { page, close } = await desk();
  let seed = 7;
  const draw = (n) => (seed = (seed * 48271) % 2147483647) % n;
  await put(page, read('docs/tutorial/duct.yaml').replace(/ *head_at.*\n/, ''));
  const shown = await page.evaluate(
    (random) => {
      const desk = window.hawserDesk;
      const wrong = [];
      for (const [kind, place, value] of random) {
        document.getElementById('tab-route').click();
        const rows = [...document.querySelectorAll('#route tbody tr')];
        const row = rows[place % rows.length];
        const lines = desk.current().split('\n');
        if (kind < 6) {
          const names = ['name', 'straight', 'bend', 'radius', 'plane', 'slope'];
          const input = row.querySelectorAll('input')[kind];
          if (!input.value) continue; // a straight gets no radius
          const next = {
            name: `p${value}`,
            straight: `${value + 5} m`,
            bend: `${value + 10} deg`,
            radius: `${value + 4} m`,
            plane: value % 2 ? 'left' : 'right',
          }[names[kind]];
          if (!next) continue;
          input.value = next;
          input.dispatchEvent(new Event('change'));
          const now = desk.current().split('\n');
          if (now.length !== lines.length || now.filter((line, i) => line !== lines[i]).length > 1)
            wrong.push(`${names[kind]}: more than a line`);
          if (
            document.querySelectorAll('#route tbody tr')[place % rows.length].querySelectorAll('input')[kind].value !==
            next
          )
            wrong.push(`${names[kind]}: not shown`);
        } else {
          const buttons = row.querySelectorAll('button');
          if (kind === 8 && rows.length < 3) continue;
          buttons[kind - 6].click();
          const change = document.querySelectorAll('#route tbody tr').length - rows.length;
          if (change !== (kind === 8 ? -1 : 1)) wrong.push(`button ${kind}: ${change} rows`);
        }
      }
      return wrong;
    },
    Array.from({ length: 200 }, () => [draw(9), draw(50), draw(60)]),
  );
  assert.deepEqual(shown, []);
  await settled(page);
  const text = await textOf(page);
  const file = join(mkdtempSync(join(tmpdir(), 'hawser-desk-')), 'case.yaml');
  writeFileSync(file, text);
  const said = spawnSync(hawser, ['theory', file, '--format', 'json'], { encoding: 'utf8' });
  rmSync(dirname(file), { recursive: true });
  const got = await page.evaluate((words) => window.hawserDesk.theory(words).catch((why) => why.message), text);
  if (said.status === 0) assertSame(JSON.parse(got), JSON.parse(said.stdout));
  else assert.ok(said.stderr.includes(got.replace(/^case\.yaml/, '')), `${got} and ${said.stderr}`);
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
    return [download.suggestedFilename(), readFileSync(await download.path(), 'utf8')];
  };
  assert.deepEqual(await saved('#save'), ['case.yaml', text]);
  const [name, calculation] = await saved('#save-page');
  assert.equal(name, 'case-calculation.html');
  assert.ok(calculation.includes('<h1>Pulling calculation') && calculation.includes('under the sewer'));
  assert.deepEqual(heard, []);
  await close();
});

test('it can be used on a narrow screen', async () => {
  const { page, close } = await desk({ viewport: { width: 390, height: 844 } });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 390, `${wide} px wide`);
  await close();
});

test('hawser desk CASE has the case in it, whatever stands in its text, and writes over no case', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'hawser-desk-'));
  const [file, page_file] = [join(folder, 'evil.yaml'), join(folder, 'desk.html')];
  const text = `# </script><script>alert(1)</script> <!-- ü \u2028\n${read('cases/limits.yaml')}`;
  writeFileSync(file, text);
  execFileSync(hawser, ['desk', file, '-q', '-o', page_file]);
  const { page, heard, close } = await openFile(page_file, {}, settled);
  assert.equal(await textOf(page), text);
  assert.equal(await page.textContent('#name'), 'evil.yaml');
  assert.equal(await page.textContent('#verdict'), 'NOT SAFE');
  assert.deepEqual(heard, []);
  await close();
  assert.equal(spawnSync(hawser, ['desk', file, '-q', '-o', file]).status, 2);
  assert.equal(readFileSync(file, 'utf8'), text);
  assert.equal(spawnSync(hawser, ['desk', join(folder, 'none.yaml'), '-q', '-o', page_file]).status, 2);
  rmSync(folder, { recursive: true });
});

test('keys that may stand at the cursor are offered, with what they are', async () => {
  const { page, close } = await desk();
  await put(
    page,
    'cables: {c: {d: 80 mm, mass: 9 kg/m}}\nroute: {pieces: [{straight: 100 m}]}\nsurfaces:\n  ducts:\n    - radius: 70 mm\n      \n',
  );
  const offered = async (line) => {
    await page.evaluate((n) => window.hawserDesk.cursor(n), line);
    await page.keyboard.press('Control+Space');
    await page.waitForSelector('.cm-tooltip-autocomplete li');
    const labels = await page.locator('.cm-tooltip-autocomplete .cm-completionLabel').allTextContents();
    await page.keyboard.press('Escape');
    return labels;
  };
  const duct = await offered(6);
  assert.ok(duct.includes('friction') && duct.includes('from') && !duct.includes('cables'), duct.join());
  const top = await offered(7);
  assert.ok(top.includes('limits') && top.includes('theory') && !top.includes('radius'), top.join());
  await close();
});

test('nothing serious for those who hear it or use the keyboard alone (axe-core)', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const { page, close } = await desk({ colorScheme });
    await page.evaluate(readFileSync(join(ROOT, 'web/node_modules/axe-core/axe.min.js'), 'utf8'));
    for (const tab of ['text', 'route', 'values']) {
      await page.click(`#tab-${tab}`);
      const found = await page.evaluate(() => window.axe.run(document, { iframes: false }));
      const serious = found.violations.filter((one) => ['serious', 'critical'].includes(one.impact));
      assert.deepEqual(
        serious.map((one) => `${tab}, ${colorScheme}: ${one.id} ${one.nodes[0].html.slice(0, 120)}`),
        [],
      );
    }
    await close();
  }
});
